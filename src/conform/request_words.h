/* request_words: words of a line of the conformance protocol, for request.c, reply.c and peer.c. */
#ifndef CONFORM_REQUEST_WORDS_H
#define CONFORM_REQUEST_WORDS_H
#include "etalon/base/status.h"
#include <locale.h>
#include <stddef.h>
#include <stdint.h>

/* What is left of a line. */
typedef struct { const char *at; } request_words;

/* A growing string; failed: memory was short, and nothing was written since. */
typedef struct { char *text; size_t length, room; int failed; } request_line;

/* The next word and its length (0: the line has ended); words are separated by blanks, tabs, and what ends a line. */
size_t request_words_next(const char **word, request_words *words);
/* 1 and the value, or 0.  Count: decimal digits, at most 2^53.  Real: what strtod reads in the "C" locale, to the nearest double. */
int request_words_count(uint64_t *value, const char *word, size_t length);
int request_words_real(double *value, const char *word, size_t length);
/* A number is written with a point, whatever the locale of the program.  ET_ENOMEM. */
et_status request_words_point(locale_t *c, locale_t *before);
void request_words_point_end(locale_t c, locale_t before);

void request_line_text(request_line *line, const char *text);
void request_line_count(request_line *line, uint64_t value);
/* As C's %a prints it, whatever the locale. */
void request_line_real(request_line *line, double x);
/* The string, or ET_ENOMEM (and nothing leaked). */
et_status request_line_end(char **text, request_line *line);
#endif
