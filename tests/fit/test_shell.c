#include "etalon/fit/seam.h"
#include "etalon/fit/shell.h"
#include "gen.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { SIDE = 5, DEGREE = 3 };

/* A closed shell of given shape and drawn knots, points and weights; freed by the caller. */
static void draw_shape(gen *g, et_shell *s, size_t p, size_t q, et_doublenet c, int rational)
{
    et_vec3 points[2 * (SIDE + 1) * (SIDE + 1)];
    const size_t nov = et_doublenet_nov(c);

    et_shell_new(s, p, q, c, rational);
    gen_knots(g, s->view[0].u, c.nx + p + 1, p);
    gen_knots(g, s->view[0].v, c.ny + q + 1, q);
    memcpy(s->view[1].u, s->view[0].u, (c.nx + p + 1) * sizeof(double));
    memcpy(s->view[1].v, s->view[0].v, (c.ny + q + 1) * sizeof(double));
    gen_points(g, &points[0].x, nov);
    et_shell_scatter(s, points, nov);
    for (size_t i = 0; rational && i < c.nx * c.ny; i++)
        s->view[0].weights[i] = s->view[1].weights[i] = 0.5 + gen_real(g, 0, 2);
}

static void draw(gen *g, et_shell *s)
{
    const size_t p = gen_between(g, 1, DEGREE), q = gen_between(g, 1, DEGREE);
    const et_doublenet c = {gen_between(g, p + 1, SIDE), gen_between(g, q + 1, SIDE)};

    draw_shape(g, s, p, q, c, (int)gen_upto(g, 1));
}

verdict prop_shell_valid(gen *g)
{
    et_shell s, t;
    bool ok;

    draw(g, &s);
    const et_surface *a = &s.view[0];
    const size_t differs = gen_upto(g, 5);
    const size_t p = differs == 1 && a->p > 1 ? a->p - 1 : a->p, q = differs == 2 && a->q > 1 ? a->q - 1 : a->q;
    const et_doublenet c = {a->nu + (differs == 3), a->nv + (differs == 4)};
    draw_shape(g, &t, p, q, c, differs == 5 ? a->weights == NULL : a->weights != NULL);
    ok = gen_check(g, et_shell_valid(&s) == 1, "a good shell");
    const bool same = p == a->p && q == a->q && differs < 3;
    et_shell mixed = {{s.view[0], t.view[1]}};
    ok = gen_check(g, et_shell_valid(&mixed) == same, "views of %s shape", same ? "one" : "unlike") && ok;
    et_surface *view = &s.view[gen_upto(g, 1)];
    view->points[0].y = NAN;
    ok = gen_check(g, et_shell_valid(&s) == 0, "a point that is no number") && ok;
    /* A net one control point wide is a surface of degree 0 in that direction, but no double net. */
    et_shell thin = {{{0, 0, 0, 0, NULL, NULL, NULL, NULL}, {0, 0, 0, 0, NULL, NULL, NULL, NULL}}};
    for (size_t w = 0; w < 2; w++)
        if (et_surface_new(&thin.view[w], 0, 1, 1, 2, 0) == ET_OK)
            thin.view[w].u[1] = thin.view[w].v[2] = thin.view[w].v[3] = 1;
    ok = gen_check(g, et_surface_valid(&thin.view[0]) && !et_shell_valid(&thin), "a net of side 1") && ok;
    et_shell_free(&thin);
    et_shell_free(&s);
    et_shell_free(&t);
    return ok ? PASS : FAIL;
}

/* One number of a shell, which when changed must or must not open it. */
static double *a_number(gen *g, et_surface *b, bool *border)
{
    const size_t i = gen_upto(g, b->nu - 1), j = gen_upto(g, b->nv - 1), at = i * b->nv + j;

    *border = i == 0 || j == 0 || i + 1 == b->nu || j + 1 == b->nv;
    switch (gen_upto(g, 3)) {
    case 0:
        return &b->points[at].x;
    case 1:
        return &b->points[at].y;
    case 2:
        return &b->points[at].z;
    default:
        return b->weights != NULL ? &b->weights[at] : &b->points[at].x;
    }
}

verdict prop_shell_glued(gen *g)
{
    et_shell s;
    bool border, ok;

    draw(g, &s);
    et_surface *b = &s.view[gen_upto(g, 1)];
    ok = gen_check(g, et_shell_glued(&s) == 1, "a glued shell");
    double *x = a_number(g, b, &border), was = *x;
    *x = nextafter(*x, 1e300);
    ok = gen_check(g, et_shell_glued(&s) == !border, "one ulp on the %s", border ? "border" : "inside") && ok;
    *x = was;
    gen_label(g, border ? "border" : "inside");
    if (b->nu > b->p + 1) {
        x = &b->u[b->p + 1];
        was = *x;
        *x = nextafter(*x, *x < b->u[b->p + 2] ? 1 : 0);
        ok = gen_check(g, !et_shell_glued(&s), "a knot in u moved by an ulp") && ok;
        *x = was;
    }
    if (b->nv > b->q + 1) {
        x = &b->v[b->nv - 1];
        was = *x;
        *x = nextafter(*x, *x > b->v[b->nv - 2] ? 0 : 1);
        ok = gen_check(g, !et_shell_glued(&s), "a knot in v moved by an ulp") && ok;
        *x = was;
    }
    s.view[0].points[0].x = 0;
    s.view[1].points[0].x = -0.0;
    ok = gen_check(g, !et_shell_glued(&s), "0 and -0") && ok;
    s.view[1].points[0].x = 0;
    b->points[0].x = NAN;
    ok = gen_check(g, !et_shell_glued(&s), "an invalid shell") && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

/* The knot at `at` from the first (end 0, 2) or last (end 1, 3) of u (0, 1) or v (2, 3), of both views. */
static void set_knot(et_shell *s, int end, size_t at, double x)
{
    for (size_t w = 0; w < 2; w++) {
        const et_surface *a = &s->view[w];
        double *t = end < 2 ? a->u : a->v;
        t[end % 2 == 0 ? at : (end < 2 ? a->nu + a->p : a->nv + a->q) - at] = x;
    }
}

/* Glued, and yet not closed: at one end a knot less than clamped, or one more. */
static bool opens(gen *g, et_shell *s, int end)
{
    const et_surface *a = &s->view[0];
    const size_t p = end < 2 ? a->p : a->q, n = end < 2 ? a->nu : a->nv;
    const double *t = end < 2 ? a->u : a->v, at = end % 2 == 0 ? t[0] : t[n + p], inner = end % 2 == 0 ? t[p + 1] : t[n - 1];
    bool ok;

    set_knot(s, end, 0, end % 2 == 0 ? at - 0.5 : at + 0.5);
    ok = gen_check(g, et_shell_glued(s) && !et_shell_closed(s), "one knot too few at end %d", end);
    set_knot(s, end, 0, at);
    if (n > p + 1) {
        set_knot(s, end, p + 1, at);
        ok = gen_check(g, et_shell_glued(s) && !et_shell_closed(s), "one knot too many at end %d", end) && ok;
        set_knot(s, end, p + 1, inner);
    }
    return gen_check(g, et_shell_closed(s), "closed again") && ok;
}

/* What is glued and clamped is closed, and has no gap at all; what is not glued is not. */
verdict prop_shell_closed(gen *g)
{
    et_shell s;
    et_seam gap = {-1, -1, -1};
    bool border, ok;

    draw(g, &s);
    ok = gen_check(g, et_shell_closed(&s) == 1, "a closed shell") &&
         gen_check(g, et_seam_gap(&gap, &s, 2) == ET_OK && gap.distance == 0, "a closed shell with a gap of %a", gap.distance);
    for (int end = 0; end < 4; end++)
        ok = opens(g, &s, end) && ok;
    double *x = a_number(g, &s.view[gen_upto(g, 1)], &border);
    *x = nextafter(*x, 1e300);
    ok = gen_check(g, et_shell_closed(&s) == et_shell_glued(&s), "one ulp on the %s", border ? "border" : "inside") && ok;
    s.view[0].points[0].x = NAN;
    ok = gen_check(g, !et_shell_closed(&s), "an invalid shell") && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_shell_net(gen *g)
{
    et_shell s;

    draw(g, &s);
    const et_doublenet c = et_shell_net(&s);
    const bool ok = gen_check(g, c.nx == s.view[0].nu && c.ny == s.view[0].nv && c.nx == s.view[1].nu && c.ny == s.view[1].nv, "the net");
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

static bool all_zero(const et_surface *s)
{
    bool zero = true;

    for (size_t i = 0; i < s->nu * s->nv; i++)
        zero = zero && s->points[i].x == 0 && s->points[i].y == 0 && s->points[i].z == 0 && (s->weights == NULL || s->weights[i] == 1);
    for (size_t i = 0; i < s->nu + s->p + 1; i++)
        zero = zero && s->u[i] == 0;
    for (size_t i = 0; i < s->nv + s->q + 1; i++)
        zero = zero && s->v[i] == 0;
    return zero;
}

verdict prop_shell_new(gen *g)
{
    const size_t p = gen_upto(g, DEGREE), q = gen_upto(g, DEGREE), nx = gen_upto(g, SIDE), ny = gen_upto(g, SIDE);
    const bool rational = gen_upto(g, 1), good = p >= 1 && q >= 1 && p < nx && q < ny;
    et_shell s, was;
    bool ok;

    memset(&s, 0x55, sizeof s);
    was = s;
    const et_status status = et_shell_new(&s, p, q, (et_doublenet){nx, ny}, rational);
    gen_label(g, good ? "good" : "bad");
    ok = gen_check(g, et_shell_new(&was, 1, 1, (et_doublenet){SIZE_MAX, SIZE_MAX}, 0) != ET_OK, "too large");
    if (!good)
        return gen_check(g, status == ET_EINVAL && memcmp(&s, &was, sizeof s) == 0, "bad shape: %d", (int)status) && ok ? PASS : FAIL;
    if (!gen_check(g, status == ET_OK, "status %d", (int)status))
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &s.view[w];
        ok = gen_check(g, v->p == p && v->q == q && v->nu == nx && v->nv == ny && (v->weights != NULL) == rational, "shape of view %zu", w) && ok;
        ok = gen_check(g, all_zero(v), "storage not zero") && ok;
    }
    ok = gen_check(g, s.view[0].points != s.view[1].points && s.view[0].u != s.view[1].u && s.view[0].v != s.view[1].v, "shared storage") && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

static bool same_view(const et_surface *a, const et_surface *b)
{
    return a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv && memcmp(a->u, b->u, (a->nu + a->p + 1) * sizeof *a->u) == 0 &&
           memcmp(a->v, b->v, (a->nv + a->q + 1) * sizeof *a->v) == 0 && memcmp(a->points, b->points, a->nu * a->nv * sizeof *a->points) == 0 &&
           (a->weights == NULL ? b->weights == NULL : memcmp(a->weights, b->weights, a->nu * a->nv * sizeof *a->weights) == 0);
}

verdict prop_shell_copy(gen *g)
{
    et_shell s, t;
    bool ok;

    draw(g, &s);
    s.view[1].points[0].x += 1;
    if (!gen_check(g, et_shell_copy(&t, &s) == ET_OK, "copied"))
        return FAIL;
    ok = gen_check(g, same_view(&s.view[0], &t.view[0]) && same_view(&s.view[1], &t.view[1]), "the copy differs");
    for (size_t w = 0; w < 2; w++)
        ok = gen_check(g, s.view[w].u != t.view[w].u && s.view[w].v != t.view[w].v && s.view[w].points != t.view[w].points, "shared storage") && ok;
    et_shell_free(&s);
    ok = gen_check(g, et_surface_valid(&t.view[0]) && et_surface_valid(&t.view[1]), "the copy lives on") && ok;
    et_shell_free(&t);
    return ok ? PASS : FAIL;
}

/* Leaks are the sanitizer's and valgrind's to find; what is left must be empty, and freeing it again must do nothing. */
verdict prop_shell_free(gen *g)
{
    et_shell s;
    bool ok = true;

    draw(g, &s);
    et_shell_free(&s);
    for (size_t w = 0; w < 2; w++)
        ok = gen_check(g, s.view[w].u == NULL && s.view[w].v == NULL && s.view[w].points == NULL && s.view[w].weights == NULL && s.view[w].nu == 0,
                       "view %zu is left", w) &&
             ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

static bool is_point(et_vec3 p, double x, double y, double z)
{
    return p.x == x && p.y == y && p.z == z;
}

/* Every node carries (i, j, view); the classes' index vectors, computed from the numbering's definition, say which node is read. */
verdict prop_shell_gather(gen *g)
{
    et_shell s;
    et_vec3 points[2 * SIDE * SIDE + 1];
    bool ok = true;
    size_t c = 0;

    draw(g, &s);
    const et_doublenet n = et_shell_net(&s);
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++)
                s.view[w].points[i * n.ny + j] = (et_vec3){(double)i, (double)j, (double)w};
    const size_t nov = et_doublenet_nov(n);
    points[nov].x = 77;
    et_shell_gather(points, nov, &s);
    for (size_t w = 0; w < 2; w++)
        for (size_t i = w; i < n.nx - w; i++)
            for (size_t j = w; j < n.ny - w; j++, c++)
                ok = gen_check(g, is_point(points[c], (double)i, (double)j, (double)w), "class %zu", c + 1) && ok;
    ok = gen_check(g, c == nov && points[nov].x == 77, "%zu classes, not %zu", nov, c) && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_shell_scatter(gen *g)
{
    et_shell s;
    et_vec3 points[2 * SIDE * SIDE], back[2 * SIDE * SIDE];
    bool ok;

    draw(g, &s);
    const et_doublenet n = et_shell_net(&s);
    const size_t nov = et_doublenet_nov(n);
    gen_points(g, &points[0].x, nov);
    et_shell_scatter(&s, points, nov);
    et_shell_gather(back, nov, &s);
    ok = gen_check(g, memcmp(points, back, nov * sizeof *points) == 0, "gathered again: other points") &&
         gen_check(g, et_shell_closed(&s), "not closed");
    for (size_t i = 0, c = n.nx * n.ny; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++) {
            const bool border = i == 0 || j == 0 || i + 1 == n.nx || j + 1 == n.ny;
            const et_vec3 a = points[i * n.ny + j], b = border ? a : points[c++];
            ok = gen_check(g, is_point(s.view[0].points[i * n.ny + j], a.x, a.y, a.z), "bottom %zu %zu", i, j) && ok;
            ok = gen_check(g, is_point(s.view[1].points[i * n.ny + j], b.x, b.y, b.z), "top %zu %zu", i, j) && ok;
        }
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}
