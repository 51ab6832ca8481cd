/* cli/checkpoint: any bytes as the file that a search is taken up from. */
#include "cli/cli.h"
#include "etalon/refine/pso.h"
#include "io/raw.h"
#include <math.h>

enum { N = 2, POPULATION = 4, MORE = 3 };

static et_status bowl(double *value, const double *x, size_t n, void *context)
{
    (void)context;
    *value = 0.0;
    for (size_t k = 0; k < n; k++)
        *value = *value + x[k] * x[k];
    return ET_OK;
}

static bool begin(et_search *s, et_rng **rng)
{
    static const double x0[N] = { 0.5, -0.25 };
    et_search_options o = et_search_defaults();

    o.population = POPULATION;
    o.spread = o.box = o.vmax = 0.25;
    return et_rng_new(rng, 1) == ET_OK && et_search_start(s, x0, N, &o, 1, bowl, NULL, *rng) == ET_OK;
}

/* What the search writes after two generations. */
static const sample *samples(void)
{
    static char *text;
    static sample some[2];
    double history[2];
    char path[RAW_PATH];
    size_t made, n = 0;
    et_search s;
    et_rng *rng = NULL;

    if (!text && begin(&s, &rng) && et_search_run(&s, &made, history, 2, et_pso_step, rng, NULL) == ET_OK &&
        cli_checkpoint_write(some_path(path, ".state"), &s, rng, CLI_PSO, 1, history, NULL) == ET_OK) {
        text = whole_file(path, &n);
        some[0] = (sample){ text, n };
        unlink(path);
        et_search_free(&s);
        et_rng_free(rng);
    }
    return some;
}

/* What was taken up goes on: no value rises, every value is its point's. */
static bool goes_on(gen *g, et_search *s, et_rng *rng, double *history)
{
    const double before = s->best_value;
    size_t made = 0;
    double value;
    bool ok = gen_check(g, et_search_run(s, &made, history + s->generation, MORE, et_pso_step, rng, NULL) == ET_OK && made == MORE, "it does not go on");

    ok = ok && gen_check(g, s->best_value <= before, "the best has risen");
    bowl(&value, s->best, N, NULL);
    return ok && gen_check(g, value == s->best_value, "the best is not its point's value");
}

/* One case in 2. */
verdict prop_search_run_checkpoint_raw(gen *g)
{
    static raw_file f;
    et_search s;
    et_rng *rng = NULL;
    double *history = NULL;
    et_message message = { "" };

    if (!begin(&s, &rng) || !raw_draw(g, &f, ".state", samples()))
        return FAIL;
    const et_status status = cli_checkpoint_read(&s, rng, &history, CLI_PSO, 1, MORE, f.path, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK)
        ok = ok && goes_on(g, &s, rng, history);
    else
        ok = ok && raw_told(g, &f, &message);
    unlink(f.path);
    free(history);
    et_search_free(&s);
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}
