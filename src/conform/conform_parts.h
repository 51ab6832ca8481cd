/* conform_parts: what the parts of the module conform share. */
#ifndef CONFORM_CONFORM_PARTS_H
#define CONFORM_CONFORM_PARTS_H
#include "etalon/conform/conform.h"

/* Requests asked one after the other, then all again in the reverse order. */
enum { CONFORM_BLOCK = 32 };

/* One request, what came of it, and what is thought of that. */
typedef struct {
    et_request request;
    et_category category;
    const et_vector *vector;              /* or null */
    int asked, twice;                     /* once; again, too */
    et_asked how, how_again;
    et_reply reply;                       /* of ET_ASKED_REPLY; else empty */
    int same;                             /* the second reply is the first */
    et_judgement judgement;
    et_status judged;                     /* of judging: ET_OK, or why there is no judgement */
    et_message text;                      /* what came instead of a reply */
} conform_case;

typedef struct {
    et_conform_report *report;
    et_peer *peer;
    const et_conform_options *options;
    const et_hello *hello;
    const et_task *task;
    et_message *message;
    conform_case block[CONFORM_BLOCK];
    size_t n, done, total;
    size_t told_size;                     /* findings that report->finding has room for */
    unsigned timeouts[ET_OPS], crashes[ET_OPS], hung;     /* in a row; hung: timeouts whatever the operation */
    size_t starts, hangs;                 /* requests asked while shrinking what crashes (or talks out of order), and what hangs */
    size_t answered[ET_OPS], declined[ET_OPS];      /* replies, and those of them that were `unsupported` */
    et_category category[ET_OPS];         /* the first one asked */
    et_request worst[ET_OPS];             /* what had the greatest error / bound of those that are right */
    double worst_ratio[ET_OPS];
    et_category worst_category[ET_OPS];
    int has_worst[ET_OPS], changed;
} conform_run;

/* ---- conform_case.c ---- */

/* The operation timed out or crashed too often in a row. */
int conform_given_up(const conform_run *run, et_request_op op);
/* The request, which is the run's from here on, joins the block; a full block is worked off. */
et_status conform_add(conform_run *run, et_request *request, et_category category, const et_vector *vector);
/* What is in the block is asked, judged, counted and told. */
et_status conform_flush(conform_run *run);
/* One request asked and, twice != 0, asked again; c->text says what came instead of a reply.  Not counted. */
et_status conform_ask(conform_run *run, conform_case *c, int twice);
/* What was asked is judged, by truth or, where that is null, by the exact layer. */
void conform_judge(conform_case *c, const et_truth *truth);
void conform_free_case(conform_case *c);
/* A verdict is counted. */
void conform_count(conform_run *run, et_request_op op, et_category category, et_verdict verdict);

/* ---- conform_told.c ---- */

/* The finding of a case is told, its request made small; nothing where enough of its kind are told.  relation may be null. */
et_status conform_tell(conform_run *run, const conform_case *c, const char *relation);
#endif
