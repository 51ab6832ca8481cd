/* The elementary functions, next to the C library's: seconds for a million calls.  The column of residuals is the share of arguments for which the C
 * library's value is another one than ours, which is correctly rounded. */
#include "bench.h"
#include "etalon/base/real.h"
#include "etalon/base/rng.h"
#include <math.h>
#include <stdio.h>

enum { CALLS = 1000000 };

typedef double (*function)(double x);

typedef struct { function f; double x[CALLS]; } job;

static double our_chord(double x)
{
    return et_real_pow(x, 0.8);
}

static double chord(double x)
{
    return pow(x, 0.8);
}

static double run(void *context)
{
    const job *j = context;
    double sum = 0;

    for (size_t i = 0; i < CALLS; i++)
        sum += j->f(j->x[i]);
    return sum;
}

static double apart(const job *j, function a, function b)
{
    double n = 0;

    for (size_t i = 0; i < CALLS; i++)
        n += a(j->x[i]) != b(j->x[i]);
    return n / CALLS;
}

int main(void)
{
    static const struct { const char *item, *size; function ours, theirs; double low, high; } table[] = {
        {"real_exp", "-20..0", et_real_exp, exp, -20, 0}, {"real_log", "0..1", et_real_log, log, 0, 1},
        {"real_pow", "0..1^0.8", our_chord, chord, 0, 1}, {"real_sin", "-10..10", et_real_sin, sin, -10, 10},
        {"real_cos", "-10..10", et_real_cos, cos, -10, 10}};
    static job j;
    et_rng *rng;

    if (et_rng_new(&rng, 1)) {
        fputs("bench_real: out of memory\n", stderr);
        return 1;
    }
    bench_head();
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        double ours, theirs;
        for (size_t i = 0; i < CALLS; i++)
            j.x[i] = table[k].low + (table[k].high - table[k].low) * et_rng_uniform(rng);
        j.f = table[k].theirs;
        theirs = bench_min(run, &j, 10, NULL);
        j.f = table[k].ours;
        ours = bench_min(run, &j, 10, NULL);
        bench_row(table[k].item, table[k].size, "libm", theirs, ours, 0, apart(&j, table[k].ours, table[k].theirs));
    }
    et_rng_free(rng);
    return 0;
}
