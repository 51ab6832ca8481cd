/* report: what the tests of conform read off a report. */
#ifndef TESTS_CONFORM_REPORT_H
#define TESTS_CONFORM_REPORT_H
#include "etalon/conform/conform.h"

static inline size_t count_of(const et_conform_report *r, et_request_op op, et_verdict v)
{
    size_t n = 0;

    for (int c = 0; c < ET_CATEGORIES; c++)
        n += r->count[op][c][v];
    return n;
}

static inline size_t bad_of(const et_conform_report *r)
{
    size_t n = 0;

    for (int op = 0; op < ET_OPS; op++)
        for (int v = 0; v < ET_VERDICTS; v++)
            n += et_judge_bad((et_verdict)v) ? count_of(r, (et_request_op)op, (et_verdict)v) : 0;
    return n;
}

/* How often a task is told how far a run is, and after which call it says that the run ends. */
typedef struct { size_t calls, most; } patience;

static inline et_status step(void *at, size_t done, size_t total)
{
    patience *p = at;

    return done <= total && p->calls++ < p->most ? ET_OK : ET_ESTOPPED;
}

#endif
