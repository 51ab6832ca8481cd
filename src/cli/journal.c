/* journal: finished runs of a comparison, one JSON line each, on disk at once. */
#include "cli/compare.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Everything a run's result depends on.  The weights' own bits stand for cloud, grid, training options and seed. */
static json_t *settings(const comparison *t, const et_net_file *net)
{
    const compare_options *o = t->options;
    const cli_refine_options *r = &o->refiner;
    const et_search_options *s = &r->search;
    const size_t nov = et_doublenet_nov(net->net);
    uint64_t hash = 0;
    char seed[24], weights[24];
    json_t *jobs = json_array();

    for (size_t c = 0; c < nov; c++) {
        uint64_t bits[3];
        memcpy(bits, &net->weights[c], sizeof bits);
        for (size_t d = 0; d < 3; d++)
            hash = et_rng_stream(hash ^ bits[d], d);
    }
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)net->seed);
    snprintf(weights, sizeof weights, "%016llx", (unsigned long long)hash);
    for (size_t k = 0; jobs && k < t->njobs; k++) {
        const compare_case *c = &t->cases[t->jobs[k].which];
        cli_json_append(&jobs, json_sprintf("%d %zux%zu %zu %zu %zu", c->faithful, c->control[0], c->control[1], c->method, t->jobs[k].algorithm,
                                           t->jobs[k].run));
    }
    return json_pack("{s:s, s:i, s:s, s:s, s:[i,i], s:i, s:i, s:I, s:[f,f,f,f,f,f,f,f,f,f,f,f], s:[I,I,I,i,i,i], s:[I,f,f,f], s:[I,f], s:o}", "format",
                     "etalon-journal", "version", 2, "seed", seed, "weights", weights, "degree", (int)o->fit.degree[0], (int)o->fit.degree[1], "knots",
                     o->fit.knots, "start", (int)o->start, "generations", (json_int_t)r->generations, "search", s->spread, s->box, o->box, s->crossover,
                     s->swap, s->mutation, s->F, s->CR, s->K, s->c1, s->c2, s->vmax, "counts", (json_int_t)s->population, (json_int_t)s->tournament,
                     (json_int_t)s->group, s->by_coordinate, s->immediate, s->absorb, "ceres", (json_int_t)r->ceres.iterations, r->ceres.tolerance, r->ceres.smooth_start,
                     r->ceres.smooth_end, "optimum", (json_int_t)r->optimum.iterations, r->optimum.gap, "jobs", jobs);
}

static int read_job(comparison *t, const json_t *o)
{
    json_int_t job, evaluations, steps;
    compare_job *j;

    if (json_unpack((json_t *)o, "{s:I, s:I, s:I}", "job", &job, "evaluations", &evaluations, "steps", &steps) != 0 || job < 0
        || (uint64_t)job >= t->njobs || evaluations < 0 || steps < 0)
        return 0;
    j = &t->jobs[job];
    if (json_unpack((json_t *)o, "{s:F, s:F, s:F, s:F, s:F}", "before", &j->before, "after", &j->after, "lower", &j->lower, "gap", &j->gap, "seconds",
                    &j->seconds) != 0)
        return 0;
    j->evaluations = (uint64_t)evaluations;
    j->steps = (size_t)steps;
    j->done = j->kept = 1;
    return 1;
}

/* The lines of an existing journal.  A last line cut short by a kill is dropped: its run is done again. */
static et_status read_lines(comparison *t, FILE *stream, const json_t *mine, const char *text, long *good, et_message *message)
{
    const char *path = t->options->journal;
    char *line = NULL;
    size_t room = 0, number = 0;
    ssize_t length = 0;
    et_status status = ET_OK;

    *good = 0;
    while (status == ET_OK && (length = getline(&line, &room, stream)) > 0 && line[length - 1] == '\n') {
        json_t *o = json_loads(line, 0, NULL);
        number++;
        if (number == 1 && !json_equal(o, mine))
            status = et_status_fail(message, ET_EFORMAT, "%s:1: this journal belongs to a comparison with other settings", path);
        else if (number > 1 && !read_job(t, o))
            status = et_status_fail(message, ET_EFORMAT, "%s:%zu: not a line of a journal", path, number);
        json_decref(o);
        *good += (long)length;
    }
    /* What cannot be read must not be taken for the end: all that follows it would be dropped. */
    if (status == ET_OK && length < 0 && !feof(stream))
        status = et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", path, strerror(errno));
    /* A first line without its end is a journal's only if it is the beginning of ours. */
    if (status == ET_OK && number == 0 && length > 0 && ((size_t)length >= strlen(text) || memcmp(line, text, (size_t)length) != 0))
        status = et_status_fail(message, ET_EFORMAT, "%s:1: not a journal", path);
    free(line);
    return status;
}

static et_status put(comparison *t, json_t *object, et_message *message)
{
    char *text = object ? json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(17)) : NULL;
    et_status status = ET_OK;

    json_decref(object);
    if (!text)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    if (fprintf(t->journal, "%s\n", text) < 0 || fflush(t->journal) != 0 || fsync(fileno(t->journal)) != 0)
        status = et_status_fail(message, ET_EIO, "cannot write %s: %s", t->options->journal, strerror(errno));
    free(text);
    return status;
}

et_status compare_journal_open(comparison *t, const et_net_file *net, et_message *message)
{
    const char *path = t->options->journal;
    json_t *mine;
    struct stat there;
    long good = 0;
    et_status status = ET_OK;

    if (!path)
        return ET_OK;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode))
        return et_status_fail(message, ET_EIO, "%s is not a file that a journal can be kept in", path);
    t->journal = fopen(path, "a+b");
    if (!t->journal)
        return et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot open %s: %s", path, strerror(errno));
    /* The settings pass through text once, so that they compare equal to those read back. */
    mine = settings(t, net);
    char *text = mine ? json_dumps(mine, JSON_COMPACT | JSON_REAL_PRECISION(17)) : NULL;
    json_decref(mine);
    mine = text ? json_loads(text, 0, NULL) : NULL;
    if (!mine) {
        free(text);
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    }
    rewind(t->journal);
    status = read_lines(t, t->journal, mine, text, &good, message);
    free(text);
    if (status == ET_OK && ftruncate(fileno(t->journal), good) != 0)
        status = et_status_fail(message, ET_EIO, "cannot write %s: %s", path, strerror(errno));
    if (status == ET_OK && good == 0)
        status = put(t, json_incref(mine), message);
    json_decref(mine);
    return status;
}

et_status compare_journal_add(comparison *t, size_t job, et_message *message)
{
    compare_job *j = &t->jobs[job];

    if (!t->journal || j->kept)
        return ET_OK;
    j->kept = 1;
    return put(t, json_pack("{s:I, s:f, s:f, s:f, s:f, s:I, s:I, s:f}", "job", (json_int_t)job, "before", j->before, "after", j->after, "lower", j->lower, "gap", j->gap,
                            "evaluations", (json_int_t)j->evaluations, "steps", (json_int_t)j->steps, "seconds", j->seconds), message);
}

void compare_journal_close(comparison *t)
{
    if (t->journal)
        fclose(t->journal);
    t->journal = NULL;
}
