/* refine/search: any sequence of runs, stops, saves and returns to what was saved stays on one path: what a search is after k generations depends on
 * nothing but k. */
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/pso.h"
#include "refine/probe.h"

enum { GENERATIONS = 12, CALLS = 10 };

/* The state after each number of generations, where it has been. */
typedef struct { et_search search; uint64_t draws; bool known; } point;
typedef struct { size_t told, stop_at; } listener;

static et_status listen(void *context, size_t done, size_t total)
{
    listener *const l = context;

    l->told = done;
    return done == l->stop_at && done < total ? ET_ESTOPPED : ET_OK;
}

/* The first time a number of generations is reached the state is kept; every other time it is the same. */
static bool on_path(gen *g, point *path, const trial *t)
{
    point *const p = &path[t->search.generation];

    if (!p->known) {
        *p = (point){ clone(&t->search, NULL), et_rng_tell(t->rng), true };
        return true;
    }
    return gen_check(g, same_search(&p->search, &t->search) && p->draws == et_rng_tell(t->rng), "another state after %zu generations", t->search.generation);
}

/* Some of the way, or until told to stop. */
static bool run_on(gen *g, trial *t, et_search_step step)
{
    const size_t from = t->search.generation, n = (size_t)gen_upto(g, GENERATIONS - from);
    listener ear = { 0, (size_t)gen_upto(g, GENERATIONS) };
    const et_task task = { listen, &ear };
    const bool stops = ear.stop_at > 0 && ear.stop_at < n;
    size_t made = 99;
    double history[GENERATIONS];
    const et_status status = et_search_run(&t->search, &made, history, n, step, t->rng, &task);
    bool ok = gen_check(g, status == (stops ? ET_ESTOPPED : ET_OK), "status %s", et_status_text(status));

    gen_label(g, stops ? "stopped" : "run");
    ok = ok && gen_check(g, made == (stops ? ear.stop_at : n) && t->search.generation == from + made, "%zu generations made", made);
    for (size_t k = 1; ok && k < made; k++)
        ok = gen_check(g, history[k] <= history[k - 1], "history rises");
    return ok;
}

/* Back, or on, to a state kept before, with another generator and other memory. */
static bool go_to(gen *g, trial *t, point *path, uint64_t seed)
{
    const size_t k = (size_t)gen_upto(g, GENERATIONS);
    et_rng *rng = NULL;

    if (!path[k].known)
        return true;
    gen_label(g, k < t->search.generation ? "back" : "on");
    if (!gen_check(g, et_rng_new(&rng, seed) == ET_OK, "no generator"))
        return false;
    et_rng_seek(rng, path[k].draws);
    et_search_free(&t->search);
    et_rng_free(t->rng);
    t->search = clone(&path[k].search, &t->probe);
    t->rng = rng;
    return true;
}

verdict prop_search_run_sequence(gen *g)
{
    static const et_search_step steps[] = { et_de_step, et_ga_step, et_pso_step };
    const problem q = gen_problem(g);
    const size_t which = (size_t)gen_upto(g, 2);
    point path[GENERATIONS + 1];
    trial t;

    memset(path, 0, sizeof path);
    bool ok = trial_start(&t, &q, which == 2) && on_path(g, path, &t);
    for (uint64_t calls = 1 + gen_upto(g, CALLS - 1); ok && calls > 0; calls--)
        ok = (gen_upto(g, 1) ? go_to(g, &t, path, q.seed) : run_on(g, &t, steps[which])) && on_path(g, path, &t);
    trial_end(&t);
    for (size_t k = 0; k <= GENERATIONS; k++)
        if (path[k].known)
            et_search_free(&path[k].search);
    return ok ? PASS : FAIL;
}
