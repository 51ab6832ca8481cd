/* result: what the subcommands print and write, as JSON and CSV (docs/files.md). */
#include "cli/cli.h"
#include "etalon/io/file.h"
#include <stdlib.h>

static json_t *quality(const et_som_quality *q)
{
    return json_pack("{s:f, s:f, s:f, s:f, s:I}", "qe", q->qe, "te", q->te, "min_error", q->min_error, "max_error", q->max_error, "steps",
                     (json_int_t)q->steps);
}

json_t *cli_json_som(const et_net_file *net, double seconds)
{
    const et_som_quality *q = &net->training;

    return json_pack("{s:[I,I], s:I, s:I, s:I, s:f, s:f, s:f, s:f, s:I, s:f, s:o}", "grid", (json_int_t)net->net.nx, (json_int_t)net->net.ny, "non",
                     (json_int_t)et_doublenet_non(net->net), "nov", (json_int_t)et_doublenet_nov(net->net), "nor",
                     (json_int_t)et_doublenet_nor(net->net), "qe", q->qe, "te", q->te, "min_error", q->min_error, "max_error", q->max_error,
                     "iterations", (json_int_t)net->options.iterations, "seconds", seconds, "final", quality(&net->final));
}

json_t *cli_json_fit(const et_surface_file *s, double overshoot)
{
    const et_fit_options *o = &s->options;
    const double faithful = o->approach == ET_FIT_CONVENTIONAL ? s->error.non : s->error.nov;

    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:[I,I], s:[I,I], s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:I}", "approach", et_fit_name(o->approach),
                     "method", et_param_name(o->method), "knots", et_knotrule_name(o->knots), "algebra", et_linalg_name(o->algebra), "corners",
                     cli_corners_name((size_t)o->corners), "degree", (json_int_t)o->p, (json_int_t)o->q, "control", (json_int_t)o->control.nx,
                     (json_int_t)o->control.ny, "surface_error", s->error.nov, "surface_error_non", s->error.non, "surface_error_faithful", faithful,
                     "greatest_error", s->error.greatest, "seam_gap", s->seam_gap, "corner_error", s->error.corner, "overshoot", overshoot, "flat_lines",
                     (json_int_t)s->fit.flat);
}

json_t *cli_json_refined(const cli_refined *r)
{
    json_t *o = json_pack("{s:s, s:I, s:I, s:f, s:f, s:f, s:f, s:b}", "algorithm", cli_algorithm_name(r->algorithm), "evaluations",
                     (json_int_t)r->evaluations, "steps", (json_int_t)r->steps, "before", r->before, "after", r->after, "seam_gap",
                     r->surface.seam_gap, "seconds", r->seconds, "stopped", r->stopped);

    if (o && r->algorithm == CLI_OPTIMUM) {
        cli_json_add(&o, "value", json_real(r->optimum.value));
        cli_json_add(&o, "lower", json_real(r->optimum.lower));
        cli_json_add(&o, "gap", json_real(r->optimum.gap));
        cli_json_add(&o, "relative_gap", json_real(r->optimum.value > 0 ? r->optimum.gap / r->optimum.value : 0));
    }
    if (o)
        cli_json_add(&o, "surface_error", json_real(r->surface.error.nov));
    return o;
}

et_status cli_write_certificate(const char *path, const cli_refined *r, et_message *message)
{
    const et_doublenet net = r->surface.fit.data;
    json_t *dual = json_array();
    et_status status;

    for (size_t c = 0; dual && c < et_doublenet_nov(net); c++)
        cli_json_append(&dual, json_pack("[f, f, f]", r->dual[c].x, r->dual[c].y, r->dual[c].z));
    json_t *o = json_pack("{s:s, s:i, s:[I,I], s:f, s:f, s:f, s:o}", "format", "etalon-certificate", "version", 1, "grid", (json_int_t)net.nx,
                          (json_int_t)net.ny, "value", r->optimum.value, "lower", r->optimum.lower, "gap", r->optimum.gap, "dual", dual);
    status = cli_write_json(path, o, message);
    json_decref(o);
    return status;
}

et_status cli_write_json(const char *path, const json_t *object, et_message *message)
{
    et_file file;
    et_status status;

    if (!object)
        return et_status_fail(message, ET_ENOMEM, "not enough memory for %s", path);
    status = et_file_create(&file, path, message);
    if (status != ET_OK)
        return status;
    /* A short write sets the stream's error flag, which et_file_commit looks at. */
    if (json_dumpf(object, file.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) == 0)
        fputc('\n', file.stream);
    return et_file_commit(&file, message);
}

et_status cli_write_history(const char *path, const cli_refined *results, size_t n, et_message *message)
{
    et_file file;
    const et_status status = et_file_create(&file, path, message);

    if (status != ET_OK)
        return status;
    fprintf(file.stream, "algorithm,step,value\n");
    for (size_t k = 0; k < n; k++) {
        fprintf(file.stream, "%s,0,%.17g\n", cli_algorithm_name(results[k].algorithm), results[k].before);
        for (size_t g = 0; g < results[k].steps; g++)
            fprintf(file.stream, "%s,%zu,%.17g\n", cli_algorithm_name(results[k].algorithm), g + 1, results[k].history[g]);
    }
    return et_file_commit(&file, message);
}
