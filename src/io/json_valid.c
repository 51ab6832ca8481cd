/* What a file may hold: the names of the choices, and which values. */
#include "io/json_parts.h"

const char *json_file_view_name(size_t w)
{
    return w == ET_BOTTOM ? "bottom" : "top";
}

const char *json_file_approach_name(int k)
{
    return k >= 0 && k <= ET_FIT_JOINT ? et_fit_name((et_fit_approach)k) : NULL;
}

const char *json_file_method_name(int k)
{
    return k >= 0 && k <= ET_PARAM_EXPONENTIAL ? et_param_name((et_param_method)k) : NULL;
}

const char *json_file_knots_name(int k)
{
    return k >= 0 && k <= ET_KNOTRULE_AVERAGING ? et_knotrule_name((et_knotrule_kind)k) : NULL;
}

const char *json_file_algebra_name(int k)
{
    return k >= 0 && k <= ET_LINALG_SVD ? et_linalg_name((et_linalg_method)k) : NULL;
}

const char *json_file_corners_name(int k)
{
    static const char *const name[] = { "default", "free", "interpolated" };
    return k >= 0 && k <= ET_CORNERS_INTERPOLATED ? name[k] : NULL;
}

int json_file_reals_valid(const double *x, size_t n, double lo, double hi)
{
    for (size_t k = 0; k < n; k++) {
        if (!(x[k] >= lo && x[k] <= hi))
            return 0;
    }
    return 1;
}

static int frame_valid(const et_frame *f)
{
    double scale[3] = { f->scale.x, f->scale.y, f->scale.z };
    return et_vec3_finite(&f->offset, 1) && json_file_reals_valid(scale, 3, 0x1p-1074, 0x1.fffffffffffffp1023);
}

static int quality_valid(const et_som_quality *q)
{
    double x[3] = { q->qe, q->min_error, q->max_error };
    return json_file_reals_valid(x, 3, 0, 0x1.fffffffffffffp1023) && json_file_reals_valid(&q->te, 1, 0, 1) && q->min_error <= q->max_error &&
           q->steps <= json_file_greatest_count;
}

static int som_options_valid(const et_som_options *o)
{
    return o->iterations >= 1 && o->iterations <= json_file_greatest_count && json_file_reals_valid(&o->alpha0, 1, 0x1p-1074, 1) &&
           json_file_reals_valid(&o->sigma0, 1, 0, 0x1.fffffffffffffp1023);
}

int json_file_net_valid(const et_net_file *n)
{
    return et_doublenet_valid(n->net) && n->weights && et_vec3_finite(n->weights, et_doublenet_nov(n->net)) && frame_valid(&n->frame) &&
           som_options_valid(&n->options) && quality_valid(&n->training) && quality_valid(&n->final);
}

int json_file_parameters_valid(const double *t, size_t n)
{
    for (size_t k = 1; t && k < n; k++) {
        if (!(t[k - 1] <= t[k]))
            return 0;
    }
    return t && json_file_reals_valid(t, n, 0, 1);
}

static int fit_options_valid(const et_fit_options *o)
{
    return json_file_approach_name((int)o->approach) && json_file_method_name((int)o->method) && json_file_knots_name((int)o->knots) &&
           json_file_algebra_name((int)o->algebra) && json_file_corners_name((int)o->corners) && o->p >= 1 && o->q >= 1 &&
           et_doublenet_valid(o->control) && o->p < o->control.nx && o->q < o->control.ny && o->control.nx <= json_file_greatest_count &&
           o->control.ny <= json_file_greatest_count;
}

int json_file_surface_valid(const et_surface_file *s)
{
    const et_fit *f = &s->fit;
    double e[5] = { s->error.nov, s->error.non, s->error.greatest, s->error.corner, s->seam_gap };
    if (!et_shell_valid(&f->shell) || f->shell.view[ET_BOTTOM].p < 1 || f->shell.view[ET_BOTTOM].q < 1 || !et_doublenet_valid(f->data) ||
        f->flat > json_file_greatest_count)
        return 0;
    for (size_t w = 0; w < 2; w++) {
        if (!json_file_parameters_valid(f->s[w], f->data.nx) || !json_file_parameters_valid(f->r[w], f->data.ny))
            return 0;
    }
    return fit_options_valid(&s->options) && frame_valid(&s->frame) && json_file_reals_valid(e, 5, 0, 0x1.fffffffffffffp1023) &&
           (!s->uv || json_file_reals_valid(s->uv, 2 * et_doublenet_nov(f->data), 0, 1));
}
