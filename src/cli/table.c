/* table: the rows of a comparison as text, CSV and JSON, and against a baseline. */
#include "cli/compare.h"
#include "etalon/io/file.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *compare_format_name(size_t k)
{
    static const char *const names[] = { "text", "csv", "json" };
    return k < 3 ? names[k] : NULL;
}

/* One contender of one case. */
typedef struct {
    const compare_case *c;
    const char *contender;
    size_t runs;
    double error, least, greatest, non, gap, seconds;   /* error: the average; non: NaN for refiners */
    double counted;                       /* what the source would print: NON for conventional, in the faithful readings */
    uint64_t evaluations;
    double share;                         /* of the possible improvement; NaN where that is not known or has no meaning */
    double lower;                         /* certified, of the optimum; NaN for others */
} line;

static line of_fit(const compare_case *c, size_t a)
{
    const et_fit_error *e = &c->fit[a].error;
    const line l = { c, cli_approach_name(a), 1, e->nov, e->nov, e->nov, e->non, c->fit[a].seam_gap, c->seconds[a],
                     c->faithful && a == ET_FIT_CONVENTIONAL ? e->non : e->nov, 0, NAN, NAN };
    return l;
}

static line of_jobs(const comparison *t, size_t which, size_t algorithm)
{
    line l = { &t->cases[which], cli_algorithm_name(algorithm), 0, 0, INFINITY, -INFINITY, NAN, 0, 0, 0, 0, NAN, NAN };

    for (size_t k = 0; k < t->njobs; k++) {
        const compare_job *j = &t->jobs[k];
        if (j->which != which || j->algorithm != algorithm)
            continue;
        l.runs++;
        l.error += j->after;
        l.seconds += j->seconds;
        l.least = fmin(l.least, j->after);
        l.greatest = fmax(l.greatest, j->after);
        l.gap = fmax(l.gap, j->gap);
        l.evaluations = j->evaluations;
        if (algorithm == CLI_OPTIMUM)
            l.lower = j->lower;
    }
    l.error /= (double)l.runs;
    l.seconds /= (double)l.runs;
    l.counted = l.error;
    return l;
}

static size_t lines_of_case(const comparison *t)
{
    return 3 + t->options->nalgorithms;
}

/* The optimum of a case, where it was asked for. */
static const compare_job *optimum_of(const comparison *t, size_t which)
{
    for (size_t k = 0; k < t->njobs; k++)
        if (t->jobs[k].which == which && t->jobs[k].algorithm == CLI_OPTIMUM)
            return &t->jobs[k];
    return NULL;
}

/* How much of the way from the start to the optimum; of closed surfaces at the same parameters only: the conventional approach and ceres-full have
 * unknowns that the others have not, and may be below the optimum. */
static double share_of(const comparison *t, size_t which, double error)
{
    const compare_job *best = optimum_of(t, which);
    const double start = t->cases[which].fit[t->options->start].error.nov;

    return best && best->after < start ? (start - error) / (start - best->after) : NAN;
}

static line pick(const comparison *t, size_t which, size_t k)
{
    const size_t algorithm = k < 3 ? CLI_ALGORITHMS : t->options->algorithms[k - 3];
    line l = k < 3 ? of_fit(&t->cases[which], k) : of_jobs(t, which, algorithm);

    if (k != ET_FIT_CONVENTIONAL && algorithm != CLI_CERES_FULL)
        l.share = share_of(t, which, l.error);
    return l;
}

static void put_share(FILE *f, double share)
{
    if (isnan(share))
        fprintf(f, "%10s", "-");
    else
        fprintf(f, "%8.3f %%", 100 * share);
}

static void put_certificate(FILE *f, const comparison *t, size_t which)
{
    const compare_job *best = optimum_of(t, which);

    if (best)
        fprintf(f, "  certified: no closed surface of these knots is below %.12g; optimum found %.12g, at most %.3g above it\n", best->lower, best->after,
                best->after - best->lower);
}

static void put_text(FILE *f, const comparison *t, const cli_run *run)
{
    const compare_options *o = t->options;

    fprintf(f, "%s: %zu points, grid %zux%zu, seed %llu, %zu runs of %zu generations, refiners start from %s\n", t->cloud, t->points, o->train.grid[0],
            o->train.grid[1], (unsigned long long)run->seed, o->runs, o->refiner.generations, cli_approach_name(o->start));
    fprintf(f, "error: sum of distances over the NOV classes (Eq. 5.13); NON: every border point twice; share: of the way from the start to the\n"
               "optimum%s\n",
            o->refiner.faithful ? "; the source prints NON for conventional, NOV for the others" : "");
    for (size_t c = 0; c < t->ncases; c++) {
        const compare_case *k = &t->cases[c];
        fprintf(f, "\ncontrol %zux%zu, %s, %s readings\n  %-13s %14s %14s %14s %14s %10s %9s %10s %10s\n", k->control[0], k->control[1],
                cli_method_name(k->method), k->faithful ? "faithful" : "default", "", "error (avg)", "least", "greatest", "over NON", "gap", "CPU s",
                "evals", "share");
        for (size_t m = 0; m < lines_of_case(t); m++) {
            const line l = pick(t, c, m);
            fprintf(f, "  %-13s %14.9f %14.9f %14.9f ", l.contender, l.error, l.least, l.greatest);
            if (m < 3)
                fprintf(f, "%14.9f %10.3g %9.3f %10s ", l.non, l.gap, l.seconds, "");
            else
                fprintf(f, "%14s %10.3g %9.3f %10llu ", "", l.gap, l.seconds, (unsigned long long)l.evaluations);
            put_share(f, l.share);
            fprintf(f, "\n");
        }
        put_certificate(f, t, c);
    }
}

static void put_csv(FILE *f, const comparison *t)
{
    fprintf(f, "readings,control_x,control_y,method,contender,runs,error,least,greatest,error_non,error_as_printed,seam_gap,evaluations,seconds,share,"
               "lower\n");
    for (size_t c = 0; c < t->ncases; c++)
        for (size_t m = 0; m < lines_of_case(t); m++) {
            const line l = pick(t, c, m);
            fprintf(f, "%s,%zu,%zu,%s,%s,%zu,%.17g,%.17g,%.17g,", l.c->faithful ? "faithful" : "default", l.c->control[0], l.c->control[1],
                    cli_method_name(l.c->method), l.contender, l.runs, l.error, l.least, l.greatest);
            if (m < 3)
                fprintf(f, "%.17g", l.non);
            fprintf(f, ",%.17g,%.17g,%llu,%.6f,", l.counted, l.gap, (unsigned long long)l.evaluations, l.seconds);
            if (!isnan(l.share))
                fprintf(f, "%.17g", l.share);
            if (isnan(l.lower))
                fprintf(f, ",\n");
            else
                fprintf(f, ",%.17g\n", l.lower);
        }
}

static json_t *row_of(const line *l, int is_fit)
{
    json_t *o = json_pack("{s:s, s:[I,I], s:s, s:s, s:I, s:f, s:f, s:f, s:f, s:f, s:I, s:f}", "readings", l->c->faithful ? "faithful" : "default",
                          "control", (json_int_t)l->c->control[0], (json_int_t)l->c->control[1], "method", cli_method_name(l->c->method), "contender",
                          l->contender, "runs", (json_int_t)l->runs, "error", l->error, "least", l->least, "greatest", l->greatest, "error_as_printed",
                          l->counted, "seam_gap", l->gap, "evaluations", (json_int_t)l->evaluations, "seconds", l->seconds);
    if (o && is_fit)
        cli_json_add(&o, "error_non", json_real(l->non));
    if (o && !isnan(l->share))
        cli_json_add(&o, "share", json_real(l->share));
    if (o && !isnan(l->lower)) {
        cli_json_add(&o, "lower", json_real(l->lower));
        cli_json_add(&o, "certified_gap", json_real(l->error - l->lower));
    }
    return o;
}

static json_t *to_json(const comparison *t, const cli_run *run)
{
    json_t *rows = json_array();

    for (size_t c = 0; rows && c < t->ncases; c++)
        for (size_t m = 0; m < lines_of_case(t); m++) {
            const line l = pick(t, c, m);
            cli_json_append(&rows, row_of(&l, m < 3));
        }
    return json_pack("{s:s, s:i, s:o, s:I, s:o, s:O, s:s, s:I, s:o}", "format", "etalon-comparison", "version", 1, "cloud", cli_json_text(t->cloud), "points",
                     (json_int_t)t->points, "seed", json_sprintf("%llu", (unsigned long long)run->seed), "som", t->som, "start",
                     cli_approach_name(t->options->start), "generations", (json_int_t)t->options->refiner.generations, "rows", rows);
}

/* ---- baseline ------------------------------------------------------------------------------------------------------------ */

/* Ceres is not of the bit-for-bit class: its figures may move by this share. */
static const double ceres_tolerance = 1e-6;

static int same_number(double a, double b, double tolerance)
{
    return fabs(a - b) <= tolerance * fmax(fabs(a), fabs(b));
}

/* The first member, but for processor times, in which two objects differ; null if none.  loose: numbers may differ by ceres_tolerance. */
static const char *object_differs(const json_t *now, const json_t *then, int loose)
{
    const char *key;
    json_t *value;

    json_object_foreach((json_t *)now, key, value) {
        const json_t *other = json_object_get(then, key);
        if (strcmp(key, "seconds") == 0 || (loose && strcmp(key, "evaluations") == 0))
            continue;
        if (loose && json_is_real(value)
                ? !json_is_number(other) || !same_number(json_real_value(value), json_number_value(other), ceres_tolerance)
                : !json_equal(value, other))
            return key;
    }
    json_object_foreach((json_t *)then, key, value)
        if (!json_object_get(now, key))
            return key;
    return NULL;
}

static const char *row_differs(const json_t *now, const json_t *then)
{
    return object_differs(now, then, strncmp(json_string_value(json_object_get(now, "contender")), "ceres", 5) == 0);
}

/* Everything above the rows; not the cloud's name, for a file may be moved, and not times. */
static const char *head_differs(const json_t *now, const json_t *then)
{
    static const char *const members[] = { "format", "version", "points", "seed", "start", "generations" };

    for (size_t k = 0; k < sizeof members / sizeof members[0]; k++)
        if (!json_equal(json_object_get(now, members[k]), json_object_get(then, members[k])))
            return members[k];
    return object_differs(json_object_get(now, "som"), json_object_get(then, "som"), 0) ? "som" : NULL;
}

et_status compare_baseline_read(comparison *t, et_message *message)
{
    const char *path = t->options->baseline;
    et_status status;

    if (!path)
        return ET_OK;
    status = cli_json_load(&t->baseline, path, message);
    if (status != ET_OK)
        return status;
    if (!json_is_array(json_object_get(t->baseline, "rows")))
        return et_status_fail(message, ET_EFORMAT, "%s: no table of a comparison", path);
    return ET_OK;
}

static et_status against_baseline(const json_t *table, const json_t *then, const char *path, et_message *message)
{
    const json_t *a = json_object_get(table, "rows"), *b = json_object_get(then, "rows");
    const char *head;
    size_t different = 0;

    if ((head = head_differs(table, then)) != NULL) {
        different++;
        fprintf(stderr, "etalon compare: %s differs from the baseline\n", head);
    }
    for (size_t k = 0; k < json_array_size(a) || k < json_array_size(b); k++) {
        const json_t *x = json_array_get(a, k), *y = json_array_get(b, k);
        const char *what = x && y ? row_differs(x, y) : "existence";
        if (what) {
            different++;
            fprintf(stderr, "etalon compare: row %zu differs from the baseline in its %s\n", k + 1, what);
        }
    }
    return different ? et_status_fail(message, ET_EDIFFER, "%zu entries differ from %s", different, path) : ET_OK;
}

/* ---- delivery ------------------------------------------------------------------------------------------------------------ */

et_status compare_deliver(const comparison *t, const cli_run *run, et_message *message)
{
    const compare_options *o = t->options;
    json_t *table = to_json(t, run);
    et_file file;
    et_status status;

    if (!table)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    if (o->format == COMPARE_JSON && strcmp(o->output, "-") == 0) {
        status = cli_print(table, message);
    } else if (o->format == COMPARE_JSON) {
        status = cli_write_json(o->output, table, message);
    } else {
        status = et_file_create(&file, o->output, message);
        if (status == ET_OK) {
            if (o->format == COMPARE_CSV)
                put_csv(file.stream, t);
            else
                put_text(file.stream, t, run);
            status = et_file_commit(&file, message);
        }
    }
    if (status == ET_OK && o->baseline)
        status = against_baseline(table, t->baseline, o->baseline, message);
    json_decref(table);
    return status;
}
