/* The surface file, read. */
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "io/json_parts.h"
#include <string.h>

static et_status read_options(const json_file_source *d, et_fit_options *o, const json_file_place *top)
{
    json_file_place at;
    int approach = 0, method = 0, knots = 0, algebra = 0, corners = 0;
    et_status status = json_file_member(d, &at, top, "fit");
    if (!status)
        status = json_file_get_choice(d, &approach, &at, "approach", json_file_approach_name);
    if (!status)
        status = json_file_get_choice(d, &method, &at, "parameters", json_file_method_name);
    if (!status)
        status = json_file_get_choice(d, &knots, &at, "knots", json_file_knots_name);
    if (!status)
        status = json_file_get_choice(d, &algebra, &at, "algebra", json_file_algebra_name);
    if (!status)
        status = json_file_get_choice(d, &corners, &at, "corners", json_file_corners_name);
    if (!status)
        status = json_file_get_sides(d, &o->control, &at);
    if (!status)
        status = json_file_get_count(d, &o->p, &at, "p", 1);
    if (!status)
        status = json_file_get_count(d, &o->q, &at, "q", 1);
    if (!status && (o->p >= o->control.nx || o->q >= o->control.ny))
        status = json_file_wrong(d, &at, "the degrees p, q are not below the sides nx, ny");
    o->approach = (et_fit_approach)approach;
    o->method = (et_param_method)method;
    o->knots = (et_knotrule_kind)knots;
    o->algebra = (et_linalg_method)algebra;
    o->corners = (et_fit_corners)corners;
    return status;
}

static et_status read_error(const json_file_source *d, et_surface_file *s, const json_file_place *top)
{
    json_file_place at;
    double most = 0x1.fffffffffffffp1023;
    et_status status = json_file_member(d, &at, top, "error");
    if (!status)
        status = json_file_get_real(d, &s->error.nov, &at, "nov", 0, most);
    if (!status)
        status = json_file_get_real(d, &s->error.non, &at, "non", 0, most);
    if (!status)
        status = json_file_get_real(d, &s->error.greatest, &at, "greatest", 0, most);
    if (!status)
        status = json_file_get_real(d, &s->error.corner, &at, "corner", 0, most);
    if (!status)
        status = json_file_get_real(d, &s->seam_gap, top, "seam_gap", 0, most);
    return status;
}

static et_status read_parameters(const json_file_source *d, double **t, size_t n, const json_file_place *view, const char *name)
{
    json_file_place at;
    et_status status = json_file_get_array(d, &at, view, name, n);
    if (status)
        return status;
    *t = et_size_array(n, sizeof **t);
    if (!*t)
        return json_file_no_memory(d);
    if ((status = json_file_fill_reals(d, *t, &at, 0, 1)) != ET_OK)
        return status;
    return json_file_parameters_valid(*t, n) ? ET_OK : json_file_wrong(d, &at, "decreases");
}

static et_status read_uv(const json_file_source *d, et_surface_file *s, const json_file_place *data)
{
    json_file_place at;
    size_t nov = et_doublenet_nov(s->fit.data);
    et_status status = json_file_member(d, &at, data, "uv");
    if (status || json_is_null(at.value))
        return status;
    if ((status = json_file_get_array(d, &at, data, "uv", nov)) != ET_OK)
        return status;
    s->uv = et_size_array(nov, 2 * sizeof *s->uv);
    return s->uv ? json_file_fill_pairs(d, s->uv, &at) : json_file_no_memory(d);
}

static et_status read_data(const json_file_source *d, et_surface_file *s, const json_file_place *top)
{
    json_file_place at, view;
    et_fit *f = &s->fit;
    et_status status = json_file_member(d, &at, top, "data");
    if (!status)
        status = json_file_get_sides(d, &f->data, &at);
    if (!status)
        status = json_file_get_count(d, &f->flat, &at, "flat", 0);
    for (size_t w = 0; w < 2 && !status; w++) {
        status = json_file_member(d, &view, &at, json_file_view_name(w));
        if (!status)
            status = read_parameters(d, &f->s[w], f->data.nx, &view, "s");
        if (!status)
            status = read_parameters(d, &f->r[w], f->data.ny, &view, "r");
    }
    return status ? status : read_uv(d, s, &at);
}

/* Sizes of a view, and that the document holds what they promise before anything of that size is allocated. */
static et_status read_shape(const json_file_source *d, et_surface *s, json_file_place array[4], const json_file_place *view, int *rational)
{
    size_t count;
    et_status status = json_file_get_count(d, &s->nu, view, "nu", 2);
    if (!status)
        status = json_file_get_count(d, &s->nv, view, "nv", 2);
    if (!status)
        status = json_file_get_count(d, &s->p, view, "p", 1);
    if (!status)
        status = json_file_get_count(d, &s->q, view, "q", 1);
    if (!status && (s->p >= s->nu || s->q >= s->nv))
        status = json_file_wrong(d, view, "the degrees p, q are not below the sizes nu, nv");
    if (!status && et_size_mul(&count, s->nu, s->nv) != ET_OK)
        status = json_file_wrong(d, view, "has too many control points");
    if (!status)
        status = json_file_get_array(d, &array[0], view, "u", s->nu + s->p + 1);
    if (!status)
        status = json_file_get_array(d, &array[1], view, "v", s->nv + s->q + 1);
    if (!status)
        status = json_file_get_array(d, &array[2], view, "points", s->nu * s->nv);
    if (!status)
        status = json_file_member(d, &array[3], view, "weights");
    *rational = !status && !json_is_null(array[3].value);
    return *rational ? json_file_get_array(d, &array[3], view, "weights", s->nu * s->nv) : status;
}

static et_status read_view(const json_file_source *d, et_surface *s, const json_file_place *views, const char *name)
{
    json_file_place view, array[4];
    et_surface shape;
    int rational = 0;
    const double most = 0x1.fffffffffffffp1023;
    memset(&shape, 0, sizeof shape);
    et_status status = json_file_member(d, &view, views, name);
    if (!status)
        status = read_shape(d, &shape, array, &view, &rational);
    if (status)
        return status;
    if ((status = et_surface_new(s, shape.p, shape.q, shape.nu, shape.nv, rational)) != ET_OK)
        return status == ET_ENOMEM ? json_file_no_memory(d) : json_file_wrong(d, &view, "has sizes that no surface has");
    status = json_file_fill_reals(d, s->u, &array[0], -most, most);
    if (!status && !et_knots_valid(s->u, s->nu + s->p + 1, s->p))
        status = json_file_wrong(d, &array[0], "is no knot vector: it decreases, or its domain is empty");
    if (!status)
        status = json_file_fill_reals(d, s->v, &array[1], -most, most);
    if (!status && !et_knots_valid(s->v, s->nv + s->q + 1, s->q))
        status = json_file_wrong(d, &array[1], "is no knot vector: it decreases, or its domain is empty");
    if (!status)
        status = json_file_fill_points(d, s->points, &array[2]);
    if (!status && rational)
        status = json_file_fill_reals(d, s->weights, &array[3], 0x1p-1074, most);
    return status;
}

static et_status read_views(const json_file_source *d, et_surface_file *s, const json_file_place *top)
{
    json_file_place at, closed = { json_object_get(top->value, "closed"), "closed" };
    et_status status = json_file_member(d, &at, top, "views");
    for (size_t w = 0; w < 2 && !status; w++)
        status = read_view(d, &s->fit.shell.view[w], &at, json_file_view_name(w));
    if (!status && !et_shell_valid(&s->fit.shell))
        status = json_file_wrong(d, &at, "bottom and top differ in degrees, in sizes, or in being rational");
    if (!status && closed.value && !json_is_boolean(closed.value))
        status = json_file_wrong(d, &closed, "is neither true nor false");
    if (!status && closed.value && json_is_true(closed.value) != (et_shell_closed(&s->fit.shell) != 0))
        status = json_file_wrong(d, &closed, "does not fit the views");
    return status;
}

et_status json_file_read_surface(const json_file_source *d, et_surface_file *s, const json_file_place *top)
{
    et_status status = read_options(d, &s->options, top);
    if (!status)
        status = read_error(d, s, top);
    if (!status)
        status = json_file_get_frame(d, &s->frame, top);
    if (!status)
        status = read_data(d, s, top);
    if (!status)
        status = read_views(d, s, top);
    return status;
}
