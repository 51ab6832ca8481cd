/* generate: the four clouds of the source, at any size, with noise and outliers. */
#include "cli/cli.h"
#include "etalon/base/size.h"
#include "etalon/io/cloud.h"
#include "etalon/io/primitive.h"
#include <stdlib.h>
#include <string.h>

static const char *kind_name(size_t k)
{
    return et_primitive_name((et_primitive_kind)k);
}

static const char *format_name(size_t k)
{
    return et_cloud_name((et_cloud_format)k);
}

typedef struct {
    const char *output;
    size_t size[2];
    double noise, outliers;
    int format;
} generate_options;

static et_status make(et_vec3 *points, size_t count, et_primitive_kind kind, const generate_options *o, uint64_t seed)
{
    et_rng *rng = NULL;
    et_status status = et_primitive_make(points, count, kind, o->size[0], o->size[1]);

    if (status == ET_OK && (o->noise > 0 || o->outliers > 0)) {
        status = et_rng_new(&rng, et_rng_stream(seed, 0));
        if (status == ET_OK)
            status = et_primitive_disturb(points, count, o->noise, o->outliers, rng);
        et_rng_free(rng);
    }
    return status;
}

static et_status run(et_primitive_kind kind, const generate_options *o, const cli_run *run, et_message *message)
{
    size_t count;
    et_vec3 *points;
    et_status status = et_primitive_count(&count, kind, o->size[0], o->size[1]);

    if (status != ET_OK)
        return et_status_fail(message, status, "--size %zux%zu cannot make a %s: %s", o->size[0], o->size[1], et_primitive_name(kind),
                              status == ET_ENOMEM ? "too many points" : "too small");
    points = et_size_array(count, sizeof *points);
    if (!points)
        return et_status_fail(message, ET_ENOMEM, "not enough memory for %zu points", count);
    status = make(points, count, kind, o, run->seed);
    if (status != ET_OK)
        et_status_fail(message, status, "cannot make the cloud: %s", et_status_text(status));
    if (status == ET_OK)
        status = cli_check(message);
    if (status == ET_OK)
        status = et_cloud_write(o->output, points, count, (et_cloud_format)o->format, message);
    free(points);
    if (status == ET_OK && run->json && strcmp(o->output, "-") != 0) {
        json_t *object = json_pack("{s:s, s:I, s:f, s:f, s:o}", "cloud", et_primitive_name(kind), "points", (json_int_t)count, "noise", o->noise,
                                   "outliers", o->outliers, "file", cli_json_text(o->output));
        status = cli_print(object, message);
        json_decref(object);
    } else if (status == ET_OK) {
        cli_say(run, "%zu points of the %s", count, et_primitive_name(kind));
    }
    return status;
}

et_status cli_generate(int argc, char **argv, et_message *message)
{
    generate_options o = { "-", { 0, 0 }, 0, 0, -1 };
    cli_run state = cli_run_defaults();
    const char *positional[1];
    size_t n, kind = 0;
    cli_option options[5 + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &o.output, "FILE", "where to; - is standard output (default -)", NULL },
        { "size", 0, CLI_PAIR, &o.size, "AxB", "cube: N points an edge; else A rings of B points (default: the source's)", NULL },
        { "noise", 0, CLI_REAL, &o.noise, "SIGMA", "Gaussian noise on every coordinate (default 0)", NULL },
        { "outliers", 0, CLI_REAL, &o.outliers, "FRACTION", "share of the points put anywhere in [-0.1, 1.1]^3 (default 0)", NULL },
        { "format", 0, CLI_NAME, &o.format, "WORD", "file format; by default .ply files are ply, others xyz", format_name },
    };
    const cli_help help = { "generate", "etalon generate cube|sphere|spindle|oiltank [options]", "Generate one of the four test clouds.",
                            "  etalon generate sphere -o sphere.xyz\n  etalon generate cube --size 100 --noise 0.01 --outliers 0.02 --seed 7 -o cube.ply\n",
                            1, 1 };

    cli_common(options + 5, &state);
    const et_status status = cli_parse(positional, &n, argc, argv, options, 5 + CLI_COMMON, &help, message);
    if (status != ET_OK || state.help)
        return status;
    cli_end_at_once();
    while (kind_name(kind) && strcmp(kind_name(kind), positional[0]) != 0)
        kind++;
    if (!kind_name(kind))
        return et_status_fail(message, ET_EINVAL, "there is no cloud '%s'; there are cube, sphere, spindle, oiltank", positional[0]);
    if (kind == ET_PRIMITIVE_CUBE && o.size[0] != o.size[1])
        return et_status_fail(message, ET_EINVAL, "--size %zux%zu: a cube has as many points along every edge", o.size[0], o.size[1]);
    if (!(o.noise >= 0) || !(o.outliers >= 0 && o.outliers <= 1))
        return et_status_fail(message, ET_EINVAL, "--noise must not be negative, --outliers must be in [0, 1]");
    if (o.format < 0) {
        const size_t length = strlen(o.output);
        o.format = length > 4 && strcmp(o.output + length - 4, ".ply") == 0 ? ET_CLOUD_PLY_LITTLE : ET_CLOUD_XYZ;
    }
    return run((et_primitive_kind)kind, &o, &state, message);
}
