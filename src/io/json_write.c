/* Writing: by the line, so that a large net needs no second copy in memory. */
#include "io/json_parts.h"
#include <stdio.h>
#include <string.h>

/* 17 significant digits are read as the same double; a point or an exponent keeps it a real, and -0 negative. */
static void put_real(FILE *out, double x)
{
    char text[40];
    (void)snprintf(text, sizeof text - 2, "%.17g", x);
    if (!strpbrk(text, ".e"))
        strcat(text, ".0");
    fputs(text, out);
}

static void put_member(FILE *out, const char *name, double x, const char *after)
{
    fprintf(out, "\"%s\": ", name);
    put_real(out, x);
    fputs(after, out);
}

static void put_list(FILE *out, const double *x, size_t n)
{
    putc('[', out);
    for (size_t k = 0; k < n; k++) {
        fputs(k ? ", " : "", out);
        put_real(out, x[k]);
    }
    putc(']', out);
}

static void put_vector(FILE *out, et_vec3 p)
{
    double x[3] = { p.x, p.y, p.z };
    put_list(out, x, 3);
}

static void put_points(FILE *out, const char *indent, const et_vec3 *points, size_t n)
{
    fputs("[\n", out);
    for (size_t k = 0; k < n && !ferror(out); k++) {
        fprintf(out, "%s  ", indent);
        put_vector(out, points[k]);
        fputs(k + 1 < n ? ",\n" : "\n", out);
    }
    fprintf(out, "%s]", indent);
}

static void put_frame(FILE *out, const et_frame *frame)
{
    fputs("  \"frame\": {\"offset\": ", out);
    put_vector(out, frame->offset);
    fputs(", \"scale\": ", out);
    put_vector(out, frame->scale);
    fputs("}", out);
}

static void put_quality(FILE *out, const char *name, const et_som_quality *q)
{
    fprintf(out, "    \"%s\": {", name);
    put_member(out, "qe", q->qe, ", ");
    put_member(out, "te", q->te, ", ");
    put_member(out, "min_error", q->min_error, ", ");
    put_member(out, "max_error", q->max_error, ", ");
    fprintf(out, "\"steps\": %zu}", q->steps);
}

void json_file_put_net(FILE *out, const et_net_file *n)
{
    fprintf(out, "  \"net\": {\"nx\": %zu, \"ny\": %zu, \"non\": %zu, \"nov\": %zu, \"nor\": %zu},\n", n->net.nx, n->net.ny,
            et_doublenet_non(n->net), et_doublenet_nov(n->net), et_doublenet_nor(n->net));
    fprintf(out, "  \"training\": {\"iterations\": %zu, ", n->options.iterations);
    put_member(out, "alpha0", n->options.alpha0, ", ");
    put_member(out, "sigma0", n->options.sigma0, ", ");
    fprintf(out, "\"seed\": \"%llu\"},\n  \"quality\": {\n", (unsigned long long)n->seed);
    put_quality(out, "training", &n->training);
    fputs(",\n", out);
    put_quality(out, "final", &n->final);
    fputs("\n  },\n", out);
    put_frame(out, &n->frame);
    fputs(",\n  \"weights\": ", out);
    put_points(out, "  ", n->weights, et_doublenet_nov(n->net));
    fputs("\n}\n", out);
}

static void put_view(FILE *out, const char *name, const et_surface *s)
{
    fprintf(out, "    \"%s\": {\n      \"p\": %zu, \"q\": %zu, \"nu\": %zu, \"nv\": %zu,\n      \"u\": ", name, s->p, s->q, s->nu, s->nv);
    put_list(out, s->u, s->nu + s->p + 1);
    fputs(",\n      \"v\": ", out);
    put_list(out, s->v, s->nv + s->q + 1);
    fputs(",\n      \"points\": ", out);
    put_points(out, "      ", s->points, s->nu * s->nv);
    fputs(",\n      \"weights\": ", out);
    if (s->weights)
        put_list(out, s->weights, s->nu * s->nv);
    else
        fputs("null", out);
    fputs("\n    }", out);
}

static void put_data(FILE *out, const et_surface_file *s)
{
    const et_fit *f = &s->fit;
    fprintf(out, "  \"data\": {\n    \"nx\": %zu, \"ny\": %zu, \"flat\": %zu,\n", f->data.nx, f->data.ny, f->flat);
    for (size_t w = 0; w < 2; w++) {
        fprintf(out, "    \"%s\": {\n      \"s\": ", json_file_view_name(w));
        put_list(out, f->s[w], f->data.nx);
        fputs(",\n      \"r\": ", out);
        put_list(out, f->r[w], f->data.ny);
        fputs("\n    },\n", out);
    }
    fputs("    \"uv\": ", out);
    if (s->uv) {
        size_t nov = et_doublenet_nov(f->data);
        fputs("[\n", out);
        for (size_t c = 0; c < nov; c++) {
            fputs("      ", out);
            put_list(out, s->uv + 2 * c, 2);
            fputs(c + 1 < nov ? ",\n" : "\n    ]", out);
        }
    } else {
        fputs("null", out);
    }
    fputs("\n  },\n", out);
}

void json_file_put_surface(FILE *out, const et_surface_file *s)
{
    const et_fit_options *o = &s->options;
    fprintf(out, "  \"fit\": {\"approach\": \"%s\", \"parameters\": \"%s\", \"knots\": \"%s\", \"algebra\": \"%s\", \"corners\": \"%s\",\n",
            json_file_approach_name((int)o->approach), json_file_method_name((int)o->method), json_file_knots_name((int)o->knots),
            json_file_algebra_name((int)o->algebra), json_file_corners_name((int)o->corners));
    fprintf(out, "    \"p\": %zu, \"q\": %zu, \"nx\": %zu, \"ny\": %zu},\n", o->p, o->q, o->control.nx, o->control.ny);
    fputs("  \"error\": {", out);
    put_member(out, "nov", s->error.nov, ", ");
    put_member(out, "non", s->error.non, ", ");
    put_member(out, "greatest", s->error.greatest, ", ");
    put_member(out, "corner", s->error.corner, "},\n  ");
    put_member(out, "seam_gap", s->seam_gap, ",\n");
    fprintf(out, "  \"closed\": %s,\n", et_shell_closed(&s->fit.shell) ? "true" : "false");
    put_frame(out, &s->frame);
    fputs(",\n", out);
    put_data(out, s);
    fputs("  \"views\": {\n", out);
    put_view(out, json_file_view_name(0), &s->fit.shell.view[0]);
    fputs(",\n", out);
    put_view(out, json_file_view_name(1), &s->fit.shell.view[1]);
    fputs("\n  }\n}\n", out);
}
