/* rows: running one line of a golden table, for the engine only. */
#ifndef TESTS_ROWS_H
#define TESTS_ROWS_H
#include "golden.h"

enum { ROW_WHAT = 256 };

/* line is cut in place; what: the row's function and reason, for the report. */
verdict row_run(const char *file, size_t lineno, char *line, char what[ROW_WHAT]);
#endif
