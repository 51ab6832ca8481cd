#include "etalon/refine/search.h"
#include "etalon/fit/fit.h"
#include "etalon/fit/seam.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include "golden.h"
#include "refine/probe.h"
#include "refine/replay.h"

static const et_search_step steps[] = { et_de_step, et_ga_step, et_pso_step };

verdict prop_search_defaults(gen *g)
{
    const et_search_options o = et_search_defaults();
    bool ok = gen_check(g, o.population == 40 && o.spread == 5e-6 && o.box == 5e-6 && o.group == 1, "common settings");
    ok = ok && gen_check(g, o.tournament == 4 && o.crossover == 0.7 && o.swap == 0.5 && o.mutation == 0.01, "ga");
    ok = ok && gen_check(g, o.F == 0.3 && o.CR == 0.8 && o.by_coordinate == 0, "de");
    ok = ok && gen_check(g, o.K == 0.729 && o.c1 == 2.05 && o.c2 == 2.05 && o.vmax == 5e-6 && o.immediate == 0 && o.absorb == 0, "pso");
    return ok ? PASS : FAIL;
}

/* ---- start ---- */

static bool starts_as_told(gen *g, const trial *t, const problem *q, int velocities)
{
    const et_search *s = &t->search;
    et_rng *rng = NULL;
    bool ok = et_rng_new(&rng, q->seed) == ET_OK;
    double least = INFINITY;
    for (size_t i = 0; i < q->options.population && ok; i++) {
        for (size_t k = 0; k < q->n; k++) {
            const double want = into_box(about(q->x0[k], q->options.spread, rng), q->x0[k], q->options.box);
            ok = ok && gen_check(g, same_bits(&want, &s->x[i * q->n + k], 1), "individual %zu, coordinate %zu", i, k);
        }
        least = fmin(least, s->value[i]);
    }
    ok = ok && gen_check(g, least == s->best_value, "the best of the start");
    ok = ok && gen_check(g, s->evaluations == q->options.population && t->probe.calls == q->options.population && s->generation == 0, "counts");
    ok = ok && gen_check(g, et_rng_tell(t->rng) == q->n * q->options.population, "draws");
    ok = ok && gen_check(g, same_bits(s->x0, q->x0, q->n), "x0");
    ok = ok && gen_check(g, (velocities == 0) == (s->velocity == NULL && s->memory == NULL && s->remembered == NULL), "memory asked for");
    for (size_t k = 0; k < q->n * q->options.population && ok && velocities; k++)
        ok = gen_check(g, s->velocity[k] == 0.0 && s->memory[k] == s->x[k], "velocities and memory at the start");
    for (size_t i = 0; i < q->options.population && ok && velocities; i++) ok = gen_check(g, s->remembered[i] == s->value[i], "remembered value");
    et_rng_free(rng);
    return ok;
}

verdict prop_search_start(gen *g)
{
    const problem q = gen_problem(g);
    const int velocities = (int)gen_upto(g, 1);
    trial t;
    bool ok = gen_check(g, trial_start(&t, &q, velocities), "did not start");
    ok = ok && starts_as_told(g, &t, &q, velocities) && consistent(g, &t.search, &t.probe);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

/* The call that fails: its status comes back, and the search is as it was. */
verdict prop_search_start_fails(gen *g)
{
    const problem q = gen_problem(g);
    probe p = probe_of(q.kind, q.x0, q.options.box);
    et_search s, old;
    et_rng *rng = NULL;
    memset(&s, 0x5a, sizeof s);
    memcpy(&old, &s, sizeof s);
    p.fail_at = gen_between(g, 1, q.options.population);
    p.failure = gen_upto(g, 1) ? ET_OK : ET_EFORMAT;
    const et_status want = p.failure == ET_OK ? ET_EINVAL : ET_EFORMAT;
    bool ok = et_rng_new(&rng, q.seed) == ET_OK;
    ok = ok && gen_check(g, et_search_start(&s, q.x0, q.n, &q.options, (int)gen_upto(g, 1), probe_call, &p, rng) == want, "status");
    ok = ok && gen_check(g, memcmp(&s, &old, sizeof s) == 0, "the search changed");
    ok = ok && gen_check(g, p.calls == p.fail_at, "calls after the failing one");
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* One argument wrong in each of these ways. */
static void spoil(et_search_options *o, size_t *n, uint64_t how)
{
    double *const probabilities[] = { &o->crossover, &o->swap, &o->mutation, &o->CR };
    double *const constants[] = { &o->F, &o->K, &o->c1, &o->c2, &o->vmax, &o->box, &o->spread };
    if (how < 4) *probabilities[how] = 1.0 + 0x1p-52;
    else if (how < 8) *probabilities[how - 4] = -0x1p-1074;
    else if (how < 12) *probabilities[how - 8] = NAN;
    else if (how < 19) *constants[how - 12] = INFINITY;
    else if (how < 26) *constants[how - 19] = NAN;
    else if (how == 26) o->population = 3;
    else if (how == 27) o->group = 0;
    else if (how == 28) o->group = *n + 1;
    else if (how == 29) o->tournament = 0;
    else if (how == 30) o->spread = -0x1p-1074;
    else if (how == 31) *n = 0;
    else o->population = 0;
}

verdict prop_search_start_invalid(gen *g)
{
    problem q = gen_problem(g);
    probe p = probe_of(q.kind, q.x0, q.options.box);
    et_search s, old;
    et_rng *rng = NULL;
    const uint64_t how = gen_upto(g, 37);
    memset(&s, 0x5a, sizeof s);
    memcpy(&old, &s, sizeof s);
    if (how <= 32) spoil(&q.options, &q.n, how);
    bool ok = et_rng_new(&rng, q.seed) == ET_OK;
    const et_status status = et_search_start(how == 37 ? NULL : &s, how == 33 ? NULL : q.x0, q.n, how == 34 ? NULL : &q.options, 0, how == 35 ? NULL : probe_call, &p,
                                             how == 36 ? NULL : rng);
    ok = ok && gen_check(g, status == ET_EINVAL, "fault %zu was accepted", (size_t)how);
    ok = ok && gen_check(g, memcmp(&s, &old, sizeof s) == 0 && p.calls == 0 && et_rng_tell(rng) == 0, "something happened");
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* A population that no memory holds. */
verdict prop_search_start_too_large(gen *g)
{
    problem q = gen_problem(g);
    probe p = probe_of(q.kind, q.x0, q.options.box);
    et_search s;
    et_rng *rng = NULL;
    q.options.population = SIZE_MAX - gen_upto(g, 3) * (SIZE_MAX / 8);
    q.options.group = 1;
    q.n = PROBE_COORDINATES;
    if (gen_upto(g, 1)) {                 /* or as many coordinates, none of which is read */
        q.options.population = 4;
        q.n = SIZE_MAX;
    }
    bool ok = et_rng_new(&rng, 1) == ET_OK;
    ok = ok && gen_check(g, et_search_start(&s, q.x0, q.n, &q.options, 1, probe_call, &p, rng) == ET_ENOMEM && p.calls == 0, "status");
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict prop_search_free(gen *g)
{
    const problem q = gen_problem(g);
    static const et_search zero;
    trial t;
    bool ok = trial_start(&t, &q, (int)gen_upto(g, 1));
    et_search_free(&t.search);
    ok = ok && gen_check(g, memcmp(&t.search, &zero, sizeof zero) == 0, "something is left");
    trial_end(&t);                        /* a zeroed search may be freed */
    return ok ? PASS : FAIL;
}

/* ---- points ---- */

verdict prop_search_draw(gen *g)
{
    const problem q = gen_problem(g);
    trial t;
    bool ok = trial_start(&t, &q, 0);
    const size_t first = gen_upto(g, q.n - 1), count = gen_upto(g, q.n - first);
    const double radius = gen_real(g, 0.0, 2.0), guard = 77.0;
    const uint64_t from = ok ? et_rng_tell(t.rng) : 0;
    double x[PROBE_COORDINATES + 1];
    for (size_t k = 0; k <= PROBE_COORDINATES; k++) x[k] = guard;
    if (ok) et_search_draw(x, &t.search, first, count, radius, t.rng);
    if (ok) et_rng_seek(t.rng, from);
    for (size_t k = 0; k < count && ok; k++) {
        const double want = about(q.x0[first + k], radius, t.rng);
        ok = gen_check(g, same_bits(&want, &x[k], 1), "coordinate %zu", k);
        ok = ok && gen_check(g, x[k] >= q.x0[first + k] - radius && x[k] <= q.x0[first + k] + radius, "outside");
    }
    for (size_t k = count; k <= PROBE_COORDINATES && ok; k++) ok = gen_check(g, x[k] == guard, "written beyond the end");
    trial_end(&t);
    return ok ? PASS : FAIL;
}

verdict prop_search_clamp(gen *g)
{
    const problem q = gen_problem(g);
    const double box = q.options.box;
    trial t;
    bool ok = trial_start(&t, &q, 0);
    double x[PROBE_COORDINATES], y[PROBE_COORDINATES];
    for (size_t k = 0; k < q.n; k++) {
        const uint64_t kind = gen_upto(g, 4);
        x[k] = kind == 0 ? q.x0[k] : kind == 1 ? q.x0[k] + box : kind == 2 ? q.x0[k] - box : gen_real(g, -4.0, 4.0);
        if (kind == 4) x[k] = nextafter(q.x0[k] + box, x[k]);
        y[k] = x[k];
    }
    if (ok) et_search_clamp(y, &t.search);
    for (size_t k = 0; k < q.n && ok; k++) {
        const double lo = q.x0[k] - box, hi = q.x0[k] + box, want = box <= 0.0 || (x[k] >= lo && x[k] <= hi) ? x[k] : x[k] < lo ? lo : hi;
        ok = gen_check(g, same_bits(&want, &y[k], 1), "coordinate %zu: %a, not %a", k, y[k], want);
    }
    trial_end(&t);
    return ok ? PASS : FAIL;
}

/* At an end of the box that is 0 a coordinate -0 is within, and stays -0. */
verdict prop_search_clamp_zeros(gen *g)
{
    problem q = gen_problem(g);
    trial t;
    double x[PROBE_COORDINATES];
    const double zero = -0.0;
    q.options.box = 0.5;
    for (size_t k = 0; k < q.n; k++) {
        q.x0[k] = gen_upto(g, 1) ? -0.5 : 0.5;
        x[k] = zero;
    }
    bool ok = trial_start(&t, &q, 0);
    if (ok) et_search_clamp(x, &t.search);
    for (size_t k = 0; k < q.n && ok; k++) ok = gen_check(g, same_bits(&zero, &x[k], 1), "coordinate %zu of %zu: %a", k, q.n, x[k]);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

verdict prop_search_eval(gen *g)
{
    const problem q = gen_problem(g);
    trial t;
    bool ok = trial_start(&t, &q, 0);
    for (size_t e = gen_between(g, 1, 6); e > 0 && ok; e--) {
        double x[PROBE_COORDINATES], value = -1.0;
        const bool fails = gen_chance(g, 4);
        et_search old = clone(&t.search, &t.probe);
        for (size_t k = 0; k < q.n; k++) x[k] = into_box(gen_real(g, -1.0, 1.0), q.x0[k], q.options.box);
        t.probe.fail_at = fails ? t.probe.calls + 1 : 0;
        t.probe.failure = gen_upto(g, 1) ? ET_OK : ET_EIO;
        const et_status want = !fails ? ET_OK : t.probe.failure == ET_OK ? ET_EINVAL : ET_EIO;
        ok = gen_check(g, et_search_eval(&value, &t.search, x) == want, "status");
        ok = ok && gen_check(g, fails ? value == -1.0 : value == probe_value(q.kind, x, q.n), "value");
        ok = ok && gen_check(g, !fails || same_search(&old, &t.search), "a failed evaluation changed something");
        ok = ok && gen_check(g, t.search.evaluations == old.evaluations + !fails, "count");
        ok = ok && consistent(g, &t.search, &t.probe);
        et_search_free(&old);
    }
    trial_end(&t);
    return ok ? PASS : FAIL;
}

/* ---- runs ---- */

typedef struct { size_t told, stop_at, total; bool right; } listener;

static et_status listen(void *context, size_t done, size_t total)
{
    listener *l = context;
    l->told++;
    l->right = l->right && done == l->told && total == l->total;
    return l->told == l->stop_at ? ET_ESTOPPED : ET_OK;
}

/* `one` steps of one generation each, saved and restored in between; history as one run of as many writes it. */
static bool stepwise(gen *g, trial *t, et_search_step step, size_t generations, const double *history, uint64_t seed)
{
    bool ok = true;
    for (size_t k = 0; k < generations && ok; k++) {
        et_rng *rng = NULL;
        probe again = t->probe;
        et_search restored = clone(&t->search, &again);
        ok = et_rng_new(&rng, seed) == ET_OK;
        if (ok) et_rng_seek(rng, et_rng_tell(t->rng));
        ok = ok && gen_check(g, step(&restored, rng) == ET_OK && restored.generation == k + 1, "step %zu", k);
        ok = ok && gen_check(g, same_bits(&history[k], &restored.best_value, 1), "history %zu", k);
        et_search_free(&t->search);
        et_rng_free(t->rng);
        t->search = restored;
        t->rng = rng;
        t->probe = again;
        t->search.context = &t->probe;
    }
    return ok;
}

verdict prop_search_run(gen *g)
{
    const problem q = gen_problem(g);
    const size_t which = gen_upto(g, 2), generations = gen_upto(g, 6);
    const et_search_step step = steps[which];
    listener ear = { 0, 0, generations, true };
    const et_task task = { listen, &ear };
    trial a, b;
    double history[8];
    size_t made = 99;
    bool ok = trial_start(&a, &q, which == 2), started = trial_start(&b, &q, which == 2);
    const et_task *told = gen_upto(g, 1) ? &task : NULL;
    ok = ok && started && gen_check(g, et_search_run(&a.search, &made, history, generations, step, a.rng, told) == ET_OK, "status");
    ok = ok && gen_check(g, made == generations && a.search.generation == generations, "generations made");
    ok = ok && gen_check(g, ear.right && (ear.told == 0 || ear.told == generations), "what the task was told");
    for (size_t k = 1; k < generations && ok; k++) ok = gen_check(g, history[k] <= history[k - 1], "history rises");
    ok = ok && consistent(g, &a.search, &a.probe) && stepwise(g, &b, step, generations, history, q.seed);
    ok = ok && gen_check(g, same_search(&a.search, &b.search) && et_rng_tell(a.rng) == et_rng_tell(b.rng), "one run is not as many steps");
    trial_end(&a);
    trial_end(&b);
    return ok ? PASS : FAIL;
}

verdict prop_search_run_stopped(gen *g)
{
    const problem q = gen_problem(g);
    const size_t which = gen_upto(g, 2), generations = gen_between(g, 1, 6), at = gen_between(g, 1, generations);
    listener ear = { 0, at, generations, true };
    const et_task task = { listen, &ear };
    trial a, b;
    double history[8] = { -1, -1, -1, -1, -1, -1, -1, -1 };     /* no value is negative */
    size_t made = 99, rest = 99;
    bool ok = trial_start(&a, &q, which == 2), started = trial_start(&b, &q, which == 2);
    ok = ok && started && gen_check(g, et_search_run(&a.search, &made, history, generations, steps[which], a.rng, &task) == ET_ESTOPPED, "status");
    ok = ok && gen_check(g, made == at && a.search.generation == at && ear.right && ear.told == at, "made %zu", made);
    for (size_t k = at; k < 8 && ok; k++) ok = gen_check(g, history[k] == -1.0, "history beyond the stop");
    ok = ok && gen_check(g, history[at - 1] == a.search.best_value, "history at the stop");
    ok = ok && et_search_run(&a.search, &rest, NULL, generations - at, steps[which], a.rng, NULL) == ET_OK && rest == generations - at;
    ok = ok && et_search_run(&b.search, &made, NULL, generations, steps[which], b.rng, NULL) == ET_OK;
    ok = ok && gen_check(g, same_search(&a.search, &b.search), "a stopped and resumed run took another path");
    trial_end(&a);
    trial_end(&b);
    return ok ? PASS : FAIL;
}

verdict prop_search_run_fails(gen *g)
{
    const problem q = gen_problem(g);
    const size_t which = gen_upto(g, 2), generations = 3, a_generation = which == 1 ? 2 : q.options.population;
    const size_t at = gen_between(g, 1, generations * a_generation);
    trial t;
    double history[3] = { -1, -1, -1 };
    size_t made = 99;
    bool ok = trial_start(&t, &q, which == 2);
    t.probe.fail_at = t.probe.calls + at;
    t.probe.failure = ET_ENOCONV;
    ok = ok && gen_check(g, et_search_run(&t.search, &made, history, generations, steps[which], t.rng, NULL) == ET_ENOCONV, "status");
    ok = ok && gen_check(g, made == (at - 1) / a_generation && t.search.generation == made, "made %zu", made);
    for (size_t k = 0; k < 3 && ok; k++) ok = gen_check(g, (history[k] == -1.0) == (k >= made), "history %zu", k);
    ok = ok && gen_check(g, t.search.evaluations == q.options.population + at - 1, "evaluations");
    ok = ok && consistent(g, &t.search, &t.probe);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

/* Without a box the sphere function is brought down by each algorithm; how far, the rows tell. */
verdict prop_search_run_descends(gen *g)
{
    const double x0[6] = { 0.5, -0.25, 0.75, -0.5, 0.25, 1.0 };
    et_search_options o = et_search_defaults();
    const size_t which = gen_upto(g, 2), generations = which == 1 ? 400 : 30;
    probe p = probe_of(PROBE_SPHERE, x0, 0.0);
    et_search s;
    et_rng *rng = NULL;
    size_t made = 0;
    o.box = 0.0;
    o.spread = 1.0;
    o.vmax = 0.5;
    bool ok = et_rng_new(&rng, gen_upto(g, 0xffff)) == ET_OK && et_search_start(&s, x0, 6, &o, which == 2, probe_call, &p, rng) == ET_OK;
    const double start = ok ? s.best_value : 0.0;
    ok = ok && et_search_run(&s, &made, NULL, generations, steps[which], rng, NULL) == ET_OK;
    ok = ok && gen_check(g, s.best_value < start && consistent(g, &s, &p), "from %g to %g", start, s.best_value);
    if (ok || made > 0) et_search_free(&s);
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* ---- a closed shell stays closed ---- */

static bool small_fit(gen *g, et_fit *fit, et_vec3 *data, et_doublenet net)
{
    et_fit_options o = et_fit_defaults();
    const size_t nov = et_doublenet_nov(net);
    o.approach = gen_upto(g, 1) ? ET_FIT_JOINT : ET_FIT_IMPROVED;
    o.control = (et_doublenet){ gen_between(g, 4, net.nx), gen_between(g, 4, net.ny) };
    for (size_t c = 1; c <= nov; c++) {   /* a lens: bottom below, top above, the border at height 0 */
        const et_index v = et_doublenet_index(net, c);
        const double x = (double)v.i / (double)(net.nx - 1), y = (double)v.j / (double)(net.ny - 1),
                     h = ((double)v.k - 1.0) * x * (1 - x) * y * (1 - y);
        data[c - 1] = (et_vec3){ x + gen_real(g, 0.0, 0.02), y + gen_real(g, 0.0, 0.02), 4.0 * h + gen_real(g, 0.0, 0.02) };
    }
    return et_fit_make(fit, data, nov, net, &o, NULL) == ET_OK;
}

verdict prop_search_run_seam(gen *g)
{
    const et_doublenet net = { gen_between(g, 5, 7), gen_between(g, 5, 7) };
    const size_t which = gen_upto(g, 2), nov = et_doublenet_nov(net);
    et_vec3 data[84];
    et_fit fit;
    if (!small_fit(g, &fit, data, net)) return SKIP;
    const size_t classes = et_doublenet_nov(et_shell_net(&fit.shell));
    et_vec3 points[84];
    double x0[252];
    et_objective *f = NULL;
    et_search s;
    et_rng *rng = NULL;
    et_search_options o = et_search_defaults();
    et_fit_error before, after;
    et_seam gap = { 1.0, 0.0, 0.0 };
    size_t made = 0;
    o.group = 3;
    et_shell_gather(points, classes, &fit.shell);
    memcpy(x0, points, 3 * classes * sizeof *x0);
    bool ok = et_fit_measure(&before, NULL, nov, &fit, data) == ET_OK && et_rng_new(&rng, gen_upto(g, 999)) == ET_OK;
    ok = ok && et_objective_new(&f, &fit, data, nov) == ET_OK;
    ok = ok && et_search_start(&s, x0, 3 * classes, &o, which == 2, et_objective_eval, f, rng) == ET_OK;
    ok = ok && et_search_run(&s, &made, NULL, 3, steps[which], rng, NULL) == ET_OK;
    if (ok) {
        memcpy(points, s.best, 3 * classes * sizeof *x0);
        et_shell_scatter(&fit.shell, points, classes);
        ok = et_fit_measure(&after, NULL, nov, &fit, data) == ET_OK;
        ok = ok && gen_check(g, same_bits(&after.nov, &s.best_value, 1), "the shell's error is not the search's best");
        ok = ok && gen_check(g, et_shell_glued(&fit.shell), "the shell opened");
        ok = ok && gen_check(g, et_seam_gap(&gap, &fit.shell, 3) == ET_OK && gap.distance == 0.0, "a gap of %g", gap.distance);
        et_search_free(&s);
    }
    et_objective_free(f);
    et_rng_free(rng);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* ---- rows ---- */

verdict gold_search_start(const row *r)
{
    return replay(r, NULL, 0);
}

verdict gold_search_defaults(const row *r)
{
    const et_search_options o = et_search_defaults();
    const double real[] = { o.spread, o.box, o.crossover, o.swap, o.mutation, o.F, o.CR, o.K, o.c1, o.c2, o.vmax };
    bool ok = row_is_size(r, 0, o.population) && row_is_size(r, 1, o.group) && row_is_size(r, 2, o.tournament);
    for (size_t k = 0; k < sizeof real / sizeof *real; k++) ok = row_is(r, 3 + k, real[k]) && ok;
    return ok ? PASS : FAIL;
}

/* Arguments: box, then pairs of x0 and x; wanted: the x. */
verdict gold_search_clamp(const row *r)
{
    double x0[16], x[16];
    const size_t n = (r->nargs - 1) / 2;
    et_search s;
    bool ok = n <= 16 && r->nwant == n;
    memset(&s, 0, sizeof s);
    s.n = n;
    s.options.box = row_real(r, 0);
    s.x0 = x0;
    for (size_t k = 0; k < n && ok; k++) {
        x0[k] = row_real(r, 1 + 2 * k);
        x[k] = row_real(r, 2 + 2 * k);
    }
    if (ok) et_search_clamp(x, &s);
    for (size_t k = 0; k < n && ok; k++) ok = row_is(r, k, x[k]);
    return ok ? PASS : FAIL;
}
