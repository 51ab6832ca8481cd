/* rows: running one line of a golden table, for the engine only. */
#ifndef TESTS_ROWS_H
#define TESTS_ROWS_H
#include "golden.h"

enum { ROW_WHAT = 256, ROW_ALTERED = 64 };

/* line is cut in place; what: the row's function and reason, for the report. */
verdict row_run(const char *file, size_t lineno, char *line, char what[ROW_WHAT]);

/* Do the comparisons bite?  Each wanted value of the row is altered as little as its class must notice; how many were, and how many of them the
 * golden check let through. */
size_t row_bite(const char *file, size_t lineno, char *line, size_t *missed);
#endif
