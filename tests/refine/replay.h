/* replay: a row of golden/ga.tsv, de.tsv or pso.tsv run again.
 *
 * Arguments: seed, population, n, group, generations; spread, box; tournament, crossover, swap, mutation; F, CR, by_coordinate; K, c1, c2, vmax,
 * immediate, absorb; x0[n].  Objective: sum of (x_k - k/8)^2, added from k = 0 on.  Wanted: draws made, evaluations, best value, best[n], every individual's value. */
#ifndef TESTS_REFINE_REPLAY_H
#define TESTS_REFINE_REPLAY_H
#include "etalon/refine/search.h"
#include "golden.h"

enum { REPLAY_HEAD = 20 };

static inline et_status replay_call(double *value, const double *x, size_t n, void *context)
{
    double f = 0.0;
    (void)context;
    for (size_t k = 0; k < n; k++) {
        const double d = x[k] - (double)k * 0.125;
        f = f + d * d;
    }
    *value = f;
    return ET_OK;
}

static inline et_search_options replay_options(const row *r)
{
    et_search_options o = { .population = row_size(r, 1), .group = row_size(r, 3), .spread = row_real(r, 5), .box = row_real(r, 6),
                            .tournament = row_size(r, 7), .crossover = row_real(r, 8), .swap = row_real(r, 9), .mutation = row_real(r, 10),
                            .F = row_real(r, 11), .CR = row_real(r, 12), .by_coordinate = (int)row_size(r, 13),
                            .K = row_real(r, 14), .c1 = row_real(r, 15), .c2 = row_real(r, 16), .vmax = row_real(r, 17),
                            .immediate = (int)row_size(r, 18), .absorb = (int)row_size(r, 19) };
    return o;
}

static inline verdict replay(const row *r, et_search_step step, int velocities)
{
    const et_search_options o = replay_options(r);
    const size_t n = row_size(r, 2), generations = row_size(r, 4);
    double x0[32];
    et_search s;
    et_rng *rng = NULL;
    size_t made = 0;
    if (n > 32 || r->nargs != REPLAY_HEAD + n || r->nwant != 3 + n + o.population) return FAIL;
    for (size_t k = 0; k < n; k++) x0[k] = row_real(r, REPLAY_HEAD + k);
    if (et_rng_new(&rng, row_size(r, 0)) != ET_OK) return FAIL;
    bool ok = et_search_start(&s, x0, n, &o, velocities, replay_call, NULL, rng) == ET_OK;
    if (ok) {
        ok = generations == 0 || et_search_run(&s, &made, NULL, generations, step, rng, NULL) == ET_OK;
        ok = row_is_size(r, 0, et_rng_tell(rng)) && ok;
        ok = row_is_size(r, 1, s.evaluations) && ok;
        ok = row_is(r, 2, s.best_value) && ok;
        for (size_t k = 0; k < n; k++) ok = row_is(r, 3 + k, s.best[k]) && ok;
        for (size_t i = 0; i < o.population; i++) ok = row_is(r, 3 + n + i, s.value[i]) && ok;
        et_search_free(&s);
    }
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}
#endif
