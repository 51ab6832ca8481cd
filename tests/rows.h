/* rows: running one line of a golden table, for the engine only. */
#ifndef TESTS_ROWS_H
#define TESTS_ROWS_H
#include "golden.h"

enum { ROW_WHAT = 256, ROW_ALTERED = 64 };

/* Against which computation: the function itself, as the row's class says, or the exact layer, bit for bit. */
typedef enum { ROW_GOLDEN, ROW_TRUTH } row_judge;

/* line is cut in place; what: the row's function and reason, for the report.  SKIP: the exact layer has no such function, and the row's class is one
 * that notices every ulp anyhow. */
verdict row_run(const char *file, size_t lineno, char *line, row_judge judge, char what[ROW_WHAT]);

/* Do the comparisons bite?  Each wanted value of the row is altered as little as the judge must notice; how many were, and how many of them were let
 * through. */
size_t row_bite(const char *file, size_t lineno, char *line, row_judge judge, size_t *missed);
#endif
