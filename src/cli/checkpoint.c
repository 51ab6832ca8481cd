/* checkpoint: a search on disk (JSON), so that N runs of one generation equal one run of N. */
#include "cli/cli.h"
#include "etalon/base/size.h"
#include "etalon/io/file.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Settings that a search must be resumed with as it was begun: the numbers of et_search_options in order. */
enum { SETTINGS = 17 };
static void settings(double out[SETTINGS], const et_search_options *o)
{
    const double all[SETTINGS] = { (double)o->population, o->spread, o->box, (double)o->group, (double)o->tournament, o->crossover, o->swap,
                                   o->mutation, o->F, o->CR, (double)o->by_coordinate, o->K, o->c1, o->c2, o->vmax,
                                   (double)o->immediate, (double)o->absorb };
    memcpy(out, all, sizeof all);
}

static json_t *reals(const double *x, size_t n)
{
    json_t *array = json_array();

    for (size_t k = 0; array && k < n; k++)
        if (json_array_append_new(array, json_real(x[k])) != 0) {
            json_decref(array);
            return NULL;
        }
    return array;
}

static json_t *word(uint64_t value)
{
    char text[24];
    snprintf(text, sizeof text, "%" PRIu64, value);
    return json_string(text);
}

et_status cli_checkpoint_write(const char *path, const et_search *s, const et_rng *rng, cli_algorithm algorithm, uint64_t seed, const double *history,
                               et_message *message)
{
    const size_t m = s->options.population;
    double set[SETTINGS];
    json_t *o;
    et_status status;

    settings(set, &s->options);
    o = json_pack("{s:s, s:i, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:f, s:o}", "format", "etalon-search", "version", 1, "algorithm",
                  cli_algorithm_name(algorithm), "seed", word(seed), "draws", word(et_rng_tell(rng)), "generation", word(s->generation),
                  "evaluations", word(s->evaluations), "settings", reals(set, SETTINGS), "x0", reals(s->x0, s->n), "x", reals(s->x, m * s->n),
                  "value", reals(s->value, m), "best", reals(s->best, s->n), "best_value", s->best_value, "history", reals(history, s->generation));
    if (o && s->velocity
        && (json_object_set_new(o, "velocity", reals(s->velocity, m * s->n)) || json_object_set_new(o, "memory", reals(s->memory, m * s->n))
            || json_object_set_new(o, "remembered", reals(s->remembered, m)))) {
        json_decref(o);
        o = NULL;
    }
    if (!o)
        return et_status_fail(message, ET_EFORMAT, "%s cannot be written: a value is not finite, and JSON has no name for it", path);
    status = cli_write_json(path, o, message);
    json_decref(o);
    return status;
}

/* The n finite reals of an array member; 0 if there is anything else. */
static int take_reals(double *x, size_t n, const json_t *o, const char *key)
{
    const json_t *array = json_object_get(o, key);

    if (!json_is_array(array) || json_array_size(array) != n)
        return 0;
    for (size_t k = 0; k < n; k++) {
        const json_t *v = json_array_get(array, k);
        if (!json_is_number(v) || !isfinite(json_number_value(v)))
            return 0;
        if (x)
            x[k] = json_number_value(v);
    }
    return 1;
}

static int take_word(uint64_t *value, const json_t *o, const char *key)
{
    const char *text = json_string_value(json_object_get(o, key));
    char *end;

    if (!text || text[0] < '0' || text[0] > '9')
        return 0;
    *value = strtoull(text, &end, 10);
    return *end == '\0';
}

static const char *what_differs(const json_t *o, const et_search *s, cli_algorithm algorithm, uint64_t seed)
{
    double now[SETTINGS], then[SETTINGS];
    const char *name = json_string_value(json_object_get(o, "algorithm"));
    uint64_t old;

    if (!name || strcmp(name, cli_algorithm_name(algorithm)) != 0)
        return "algorithm";
    if (!take_word(&old, o, "seed") || old != seed)
        return "seed";
    settings(now, &s->options);
    if (!take_reals(then, SETTINGS, o, "settings") || memcmp(now, then, sizeof now) != 0)
        return "settings";
    return NULL;
}

/* Every value must be the objective's at its point: a checkpoint is not believed. */
static int honest(const et_search *s, const double *x, const double *value, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        double f;
        if (s->fn(&f, x + k * s->n, s->n, s->context) != ET_OK || f != value[k])
            return 0;
    }
    return 1;
}

/* The generator is run to its place: a file must not make that take ages.  A coordinate takes a few draws, an individual a tournament's. */
static int made_so_many(const et_search *s, uint64_t draws, uint64_t generation)
{
    const double individual = (double)s->n + (double)s->options.tournament + 1;

    return (double)draws <= 64 * ((double)generation + 1) * (double)s->options.population * individual;
}

static const char short_of_memory[] = "memory is short";

static const char *restore(et_search *s, et_rng *rng, double **history, size_t more, const json_t *o)
{
    const size_t m = s->options.population, all = m * s->n;
    uint64_t draws, generation, evaluations;
    double *x0 = et_size_array(s->n, sizeof *x0), *grown = NULL;
    const char *bad = NULL;

    if (!x0)
        return short_of_memory;
    if (!take_reals(x0, s->n, o, "x0") || memcmp(x0, s->x0, s->n * sizeof *x0) != 0)
        bad = "it was begun from another surface";
    else if (!take_word(&draws, o, "draws") || !take_word(&generation, o, "generation") || !take_word(&evaluations, o, "evaluations")
             || !json_is_number(json_object_get(o, "best_value")) || !take_reals(NULL, all, o, "x") || !take_reals(NULL, m, o, "value")
             || !take_reals(NULL, s->n, o, "best") || !take_reals(NULL, (size_t)generation, o, "history"))
        bad = "a member is missing or malformed";
    else if (s->velocity && (!take_reals(NULL, all, o, "velocity") || !take_reals(NULL, all, o, "memory") || !take_reals(NULL, m, o, "remembered")))
        bad = "a member of the swarm is missing or malformed";
    else if (!made_so_many(s, draws, generation))
        bad = "it tells of more draws than its generations make";
    else if (!(grown = et_size_array((size_t)generation + more, sizeof *grown)))
        bad = short_of_memory;
    free(x0);
    if (bad)
        return bad;
    take_reals(s->x, all, o, "x");
    take_reals(s->value, m, o, "value");
    take_reals(s->best, s->n, o, "best");
    if (s->velocity) {
        take_reals(s->velocity, all, o, "velocity");
        take_reals(s->memory, all, o, "memory");
        take_reals(s->remembered, m, o, "remembered");
    }
    take_reals(grown, (size_t)generation, o, "history");
    free(*history);
    *history = grown;
    s->best_value = json_number_value(json_object_get(o, "best_value"));
    s->generation = (size_t)generation;
    s->evaluations = evaluations;
    et_rng_seek(rng, draws);
    if (!honest(s, s->x, s->value, m) || !honest(s, s->best, &s->best_value, 1) || (s->velocity && !honest(s, s->memory, s->remembered, m)))
        return "its values are not those of its points";
    return NULL;
}

et_status cli_checkpoint_read(et_search *search, et_rng *rng, double **history, cli_algorithm algorithm, uint64_t seed, size_t more, const char *path,
                              et_message *message)
{
    json_t *o;
    const char *bad;
    et_status status = ET_OK;

    status = cli_json_load(&o, path, message);
    if (status != ET_OK)
        return status;
    if (!json_is_object(o) || !json_string_value(json_object_get(o, "format"))
        || strcmp(json_string_value(json_object_get(o, "format")), "etalon-search") != 0)
        status = et_status_fail(message, ET_EFORMAT, "%s: not a checkpoint of a search", path);
    else if (json_integer_value(json_object_get(o, "version")) != 1)
        status = et_status_fail(message, ET_EFORMAT, "%s: version: only version 1 is known", path);
    else if ((bad = what_differs(o, search, algorithm, seed)) != NULL)
        status = et_status_fail(message, ET_EFORMAT, "%s: the %s of the checkpoint differ from this run's", path, bad);
    else if ((bad = restore(search, rng, history, more, o)) != NULL)
        status = et_status_fail(message, bad == short_of_memory ? ET_ENOMEM : ET_EFORMAT, "%s: %s", path, bad);
    json_decref(o);
    return status;
}
