/* conform: what the parts of `etalon conform` share. */
#ifndef ETALON_CLI_CONFORM_H
#define ETALON_CLI_CONFORM_H
#include "cli/cli.h"
#include "etalon/conform/conform.h"

/* Where a program was not even greeted: what came instead of its hello, counted as one verdict of no operation. */
typedef struct {
    et_conform_report report;
    et_conform_options options;
    et_hello hello;
    const char *adapter;                  /* the command */
    int greeted;
    et_verdict greeting;                  /* not greeted: crash, timeout or wrong */
    et_message text;                      /* and the sentence */
    json_t *baseline;                     /* "operation/category/verdict" of what is known, or null */
    int stopped;
} conform_result;

enum { CONFORM_KEY = 96 };
/* "operation/category/verdict". */
void conform_key(char key[CONFORM_KEY], et_request_op op, et_category category, et_verdict verdict);
/* 1 if there is a baseline, and the verdict is in it. */
int conform_known(const conform_result *r, et_request_op op, et_category category, et_verdict verdict);
/* How many kinds of bad verdicts are new (all without a baseline), and how many requests got them. */
size_t conform_new(const conform_result *r, size_t *requests);
size_t conform_total(const conform_result *r, et_verdict verdict);
size_t conform_of(const conform_result *r, et_request_op op, et_verdict verdict);
/* Text from outside, fit for a terminal, for JSON and for XML: what is no UTF-8 and what is no character becomes '?'. */
enum { CONFORM_TEXT = 1024 };
const char *conform_clean(char clean[CONFORM_TEXT], const char *text);

/* The report for people. */
/* 1 if the adapter is several commands, which a pipe must have in brackets. */
int conform_compound(const char *adapter);
void conform_print(FILE *out, const conform_result *r);
json_t *conform_json(const conform_result *r);
/* What `--baseline` reads: the list of all bad verdicts. */
json_t *conform_bad_list(const conform_result *r);
et_status conform_read_baseline(json_t **known, const char *path, et_message *message);
et_status conform_write_junit(const char *path, const conform_result *r, et_message *message);
#endif
