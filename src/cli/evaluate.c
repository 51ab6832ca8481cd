/* evaluate: points and derivatives of a surface file's views, as other programs can be checked with. */
#include "cli/cli.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/io/file.h"
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { OWN = 5, FAST_ORDER = 2 };

typedef struct { const char *output; int view, hex, exact; size_t order; } evaluation;
typedef struct { double *uv; size_t n, room; } parameters;

static const char *view_name(size_t k)
{
    return k == ET_BOTTOM ? "bottom" : k == ET_TOP ? "top" : NULL;
}

/* ---- parameters ------------------------------------------------------------------------------------------------------- */

static et_status add(parameters *p, double u, double v)
{
    if (p->n == p->room) {
        const size_t room = p->room ? 2 * p->room : 256;
        double *more = room > SIZE_MAX / (2 * sizeof *more) ? NULL : realloc(p->uv, 2 * room * sizeof *more);
        if (!more)
            return ET_ENOMEM;
        p->uv = more;
        p->room = room;
    }
    p->uv[2 * p->n] = u;
    p->uv[2 * p->n + 1] = v;
    p->n++;
    return ET_OK;
}

/* "u v" or "u,v"; 0 for a blank or comment line, -1 for anything else. */
static int two_numbers(double uv[2], char *line)
{
    char *at = line + (strncmp(line, "\xef\xbb\xbf", 3) == 0 ? 3 : 0);      /* some editors begin a file with a byte order mark */

    at += strspn(at, " \t\r\n");
    if (*at == '\0' || *at == '#')
        return 0;
    for (size_t k = 0; k < 2; k++) {
        char *end;
        uv[k] = strtod(at, &end);
        if (end == at || !isfinite(uv[k]))
            return -1;
        at = end + strspn(end, " \t\r\n");
        if (k == 0 && *at == ',')
            at++;
    }
    return *at == '\0' ? 1 : -1;
}

static et_status read_parameters(parameters *p, const char *path, et_message *message)
{
    const int standard = strcmp(path, "-") == 0;
    FILE *stream = standard ? stdin : fopen(path, "r");
    char *line = NULL;
    size_t room = 0, number = 0;
    ssize_t length;
    et_status status = ET_OK;

    if (!stream)
        return et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", path, strerror(errno));
    while (status == ET_OK && (length = getline(&line, &room, stream)) >= 0) {
        double uv[2];
        const int found = strlen(line) == (size_t)length ? two_numbers(uv, line) : -1;
        number++;
        if (found < 0)
            status = et_status_fail(message, ET_EFORMAT, "%s:%zu: not two finite numbers, u and v", path, number);
        else if (found > 0 && add(p, uv[0], uv[1]) != ET_OK)
            status = et_status_fail(message, ET_ENOMEM, "not enough memory for the parameters in %s", path);
    }
    if (status == ET_OK && !feof(stream))          /* also when there is no memory for a line */
        status = et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", path, strerror(errno));
    if (status == ET_OK && p->n == 0)
        status = et_status_fail(message, ET_EFORMAT, "%s: no parameters", path);
    free(line);
    if (!standard)
        fclose(stream);
    return status;
}

/* ---- values ------------------------------------------------------------------------------------------------------------ */

/* D of (order+1)(order+2)/2 entries, in the layout of et_exact_surface_ders. */
static et_status values(et_vec3 *D, const evaluation *e, const et_surface *s, double u, double v, double *work, size_t nwork)
{
    et_vec3 all[6];

    if (e->exact)
        return et_exact_surface_ders(D, e->order, s, u, v);
    if (e->order == 0) {
        D[0] = et_surface_point(s, u, v, work, nwork);
        return ET_OK;
    }
    et_surface_ders(all, s, u, v, work, nwork);
    memcpy(D, all, (e->order == 1 ? 3 : 6) * sizeof *D);
    return ET_OK;
}

static void put_row(FILE *f, const double uv[2], const et_vec3 *D, size_t count, int hex)
{
    fprintf(f, hex ? "%a,%a" : "%.17g,%.17g", uv[0], uv[1]);
    for (size_t m = 0; m < count; m++)
        fprintf(f, hex ? ",%a,%a,%a" : ",%.17g,%.17g,%.17g", D[m].x, D[m].y, D[m].z);
    fputc('\n', f);
}

/* Null without memory, or where a value is not finite. */
static json_t *json_row(const double uv[2], const et_vec3 *D, size_t count)
{
    json_t *row = json_pack("[f, f]", uv[0], uv[1]);
    int bad = row == NULL;

    for (size_t m = 0; !bad && m < count; m++)
        bad = json_array_append_new(row, json_real(D[m].x)) || json_array_append_new(row, json_real(D[m].y))
              || json_array_append_new(row, json_real(D[m].z));
    if (bad)
        json_decref(row);
    return bad ? NULL : row;
}

static void put_header(FILE *f, size_t order)
{
    fprintf(f, "u,v");
    for (size_t total = 0; total <= order; total++)
        for (size_t b = 0; b <= total; b++)
            for (size_t d = 0; d < 3; d++) {
                fprintf(f, ",%c", "xyz"[d]);
                for (size_t k = 0; k < total; k++)
                    fputc(k < total - b ? 'u' : 'v', f);
            }
    fprintf(f, "\n");
}

/* To the file, or, without one, to rows. */
static et_status put_all(FILE *f, json_t *rows, const evaluation *e, const et_surface *s, const parameters *p, const et_task *task, et_message *message)
{
    const size_t nwork = et_surface_work(s);
    size_t count = 0;
    const et_status fits = e->order < SIZE_MAX - 1 ? et_size_mul(&count, e->order + 1, e->order + 2) : ET_ENOMEM;
    et_vec3 *D = fits == ET_OK ? et_size_array(count /= 2, sizeof *D) : NULL;
    double *work = et_size_array(nwork, sizeof *work);
    et_status status = D && work ? ET_OK : ET_ENOMEM;

    if (f && status == ET_OK)
        put_header(f, e->order);
    for (size_t k = 0; status == ET_OK && k < p->n; k++) {
        const double *uv = p->uv + 2 * k;
        status = values(D, e, s, uv[0], uv[1], work, nwork);
        if (status == ET_OK && f)
            put_row(f, uv, D, count, e->hex);
        else if (status == ET_OK && json_array_append_new(rows, json_row(uv, D, count)) != 0)
            status = et_status_fail(message, ET_EFORMAT, "a value is not finite: JSON has no name for it; leave --json out");
        if (status == ET_OK)
            status = et_task_step(task, k + 1, p->n);
    }
    free(D);
    free(work);
    return status == ET_OK || status == ET_EFORMAT
               ? status : et_status_fail(message, status, status == ET_ESTOPPED ? "interrupted; nothing was written" : "%s", et_status_text(status));
}

/* ---- the command -------------------------------------------------------------------------------------------------------- */

static et_status to_file(const evaluation *e, const et_surface *s, const parameters *p, const et_task *task, et_message *message)
{
    et_file file;
    et_status status = et_file_create(&file, e->output, message);

    if (status != ET_OK)
        return status;
    status = put_all(file.stream, NULL, e, s, p, task, message);
    if (status == ET_OK)
        return et_file_commit(&file, message);
    et_file_abandon(&file);
    return status;
}

static et_status to_json(const evaluation *e, const et_surface *s, const parameters *p, const et_task *task, et_message *message)
{
    json_t *rows = json_array();
    et_status status = rows ? put_all(NULL, rows, e, s, p, task, message) : ET_ENOMEM;

    if (status == ET_OK) {
        json_t *o = json_pack("{s:s, s:I, s:b, s:O}", "view", view_name((size_t)e->view), "order", (json_int_t)e->order, "exact", e->exact, "values", rows);
        status = cli_print(o, message);
        json_decref(o);
    }
    json_decref(rows);
    return status;
}

static et_status run_it(const char *surface, const char *path, const evaluation *e, cli_run *run, et_message *message)
{
    et_surface_file s;
    parameters p = { NULL, 0, 0 };
    et_status status = et_json_read_surface(&s, surface, message);

    if (status != ET_OK)
        return status;
    status = read_parameters(&p, path, message);
    if (status == ET_OK) {
        const et_task task = cli_task(run, "evaluating");
        status = (run->json ? to_json : to_file)(e, &s.fit.shell.view[e->view], &p, &task, message);
        cli_task_end(run);
    }
    free(p.uv);
    et_json_free_surface(&s);
    return status;
}

et_status cli_evaluate(int argc, char **argv, et_message *message)
{
    evaluation e = { "-", ET_BOTTOM, 0, 0, 0 };
    cli_run run = cli_run_defaults();
    const char *positional[2];
    size_t n;
    cli_option options[OWN + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &e.output, "FILE", "where the table goes (CSV; default -: standard output)", NULL },
        { "view", 0, CLI_NAME, &e.view, "WORD", "which surface (default bottom)", view_name },
        { "order", 0, CLI_SIZE, &e.order, "D", "all partial derivatives up to this order (default 0; above 2 with --exact)", NULL },
        { "exact", 0, CLI_FLAG, &e.exact, NULL, "correctly rounded values", NULL },
        { "hex", 0, CLI_FLAG, &e.hex, NULL, "numbers as C99 hex floats", NULL },
    };
    const cli_help help = { "evaluate", "etalon evaluate SURFACE UV [options]",
                            "Points and derivatives of a surface at the parameters in UV (lines `u v`; - is standard input), in the unit cube.",
                            "  etalon evaluate surface.json uv.txt --view top -o points.csv\n"
                            "  echo 0.25 0.75 | etalon evaluate surface.json - --order 3 --exact --hex\n", 2, 2 };

    cli_common(options + OWN, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, OWN + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    cli_end_at_once();                    /* a derivative of high order is long in the making */
    if (e.order > FAST_ORDER && !e.exact)
        return et_status_fail(message, ET_EINVAL, "--order %zu: derivatives above the second want --exact", e.order);
    if (run.json && strcmp(e.output, "-") != 0)
        return et_status_fail(message, ET_EINVAL, "--json prints the values: without --output");
    return run_it(positional[0], positional[1], &e, &run, message);
}
