#include "etalon/base/real.h"
#include "etalon/fit/seam.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <string.h>

enum { SIDE = 6, DEGREE = 3, SAMPLES = 4, MOST = 2 * (SIDE + 1) * (SAMPLES + 1) };

static void draw(gen *g, et_shell *s, bool closed)
{
    const size_t p = gen_between(g, 1, DEGREE), q = gen_between(g, 1, DEGREE);
    const et_doublenet c = {gen_between(g, p + 1, SIDE), gen_between(g, q + 1, SIDE)};
    const size_t nov = et_doublenet_nov(c);
    et_vec3 points[2 * SIDE * SIDE];

    et_shell_new(s, p, q, c, (int)gen_upto(g, 1));
    for (size_t w = 0; w < 2; w++) {
        gen_knots(g, s->view[w].u, c.nx + p + 1, p);
        gen_knots(g, s->view[w].v, c.ny + q + 1, q);
        gen_points(g, &s->view[w].points[0].x, c.nx * c.ny);
        for (size_t i = 0; s->view[w].weights != NULL && i < c.nx * c.ny; i++)
            s->view[w].weights[i] = 0.5 + gen_real(g, 0, 2);
    }
    if (!closed)
        return;
    memcpy(s->view[1].u, s->view[0].u, (c.nx + p + 1) * sizeof(double));
    memcpy(s->view[1].v, s->view[0].v, (c.ny + q + 1) * sizeof(double));
    et_shell_gather(points, nov, s);
    for (size_t i = 0, k = c.nx * c.ny; i < c.nx; i++)
        for (size_t j = 0; j < c.ny; j++)
            if (i > 0 && j > 0 && i + 1 < c.nx && j + 1 < c.ny)
                points[k++] = s->view[1].points[i * c.ny + j];
            else if (s->view[0].weights != NULL)
                s->view[1].weights[i * c.ny + j] = s->view[0].weights[i * c.ny + j];
    et_shell_scatter(s, points, nov);
}

/* All sample parameters of one direction by definition: for each pair of neighbouring distinct knots, found by search. */
static size_t samples_of(double *t, const double *a, const double *b, size_t na, size_t nb, size_t samples)
{
    size_t n = 0;
    double x = 0;

    t[n++] = 0;
    while (x < 1) {
        double next = 1;
        for (size_t i = 0; i < na; i++)
            next = a[i] > x && a[i] < next ? a[i] : next;
        for (size_t i = 0; i < nb; i++)
            next = b[i] > x && b[i] < next ? b[i] : next;
        for (size_t i = 1; i <= samples; i++)
            t[n++] = x + (next - x) * ((double)i / (double)(samples + 1));
        t[n++] = next;
        x = next;
    }
    return n;
}

static double at(const et_shell *s, double u, double v)
{
    double work[1024];
    const size_t nwork = et_surface_work(&s->view[0]);

    return nwork > 1024 ? NAN : et_vec3_distance(et_surface_point(&s->view[0], u, v, work, nwork), et_surface_point(&s->view[1], u, v, work, nwork));
}

static double brute(const et_shell *s, size_t samples)
{
    const et_surface *a = &s->view[0], *b = &s->view[1];
    double t[MOST], greatest = 0;
    size_t n = samples_of(t, a->u, b->u, a->nu + a->p + 1, b->nu + b->p + 1, samples);

    for (size_t i = 0; i < n; i++)
        greatest = fmax(greatest, fmax(at(s, t[i], 0), at(s, t[i], 1)));
    n = samples_of(t, a->v, b->v, a->nv + a->q + 1, b->nv + b->q + 1, samples);
    for (size_t i = 0; i < n; i++)
        greatest = fmax(greatest, fmax(at(s, 0, t[i]), at(s, 1, t[i])));
    return greatest;
}

static bool on_border(double u, double v)
{
    return u == 0 || u == 1 || v == 0 || v == 1;
}

verdict prop_seam_gap(gen *g)
{
    const bool closed = gen_upto(g, 1) == 0;
    const size_t samples = gen_upto(g, SAMPLES);
    et_shell s;
    et_seam gap = {5, 6, 7};
    bool ok;

    draw(g, &s, closed);
    gen_label(g, closed ? "closed" : "open");
    ok = gen_check(g, et_seam_gap(&gap, &s, samples) == ET_OK, "measured");
    if (closed)
        ok = gen_check(g, gap.distance == 0 && gap.u == 0 && gap.v == 0, "a gap of %g in a closed shell", gap.distance) && ok;
    const double expect = brute(&s, samples);
    ok = gen_check(g, gap.distance == expect, "gap %a, not %a", gap.distance, expect) && ok;
    ok = gen_check(g, on_border(gap.u, gap.v) && at(&s, gap.u, gap.v) == gap.distance, "not where it is told: %a %a", gap.u, gap.v) && ok;
    /* At the corners stand control points. */
    for (size_t k = 0; k < 4; k++) {
        const size_t c = (k & 1 ? (s.view[0].nu - 1) * s.view[0].nv : 0) + (k & 2 ? s.view[0].nv - 1 : 0);
        const et_vec3 a = s.view[0].points[c], b = s.view[1].points[c];
        const double d = et_vec3_distance(a, b), size = fmax(fmax(fabs(a.x), fabs(a.y)), fabs(a.z)) + fmax(fmax(fabs(b.x), fabs(b.y)), fabs(b.z));
        /* A weight multiplied and divided away: 2u of each coordinate. */
        ok = gen_check(g, gap.distance >= d - 16 * ET_UNIT * size, "less than a corner's gap %g", d) && ok;
    }
    gap = (et_seam){5, 6, 7};
    ok = gen_check(g, et_seam_gap(&gap, &s, (size_t)-1) == ET_ENOMEM && gap.distance == 5 && gap.u == 6 && gap.v == 7, "too many samples") && ok;
    et_surface *view = &s.view[gen_upto(g, 1)];
    double *end = gen_upto(g, 1) ? view->u + view->nu : view->v + view->nv;
    for (size_t i = 0; i <= (end == view->u + view->nu ? view->p : view->q); i++)
        end[i] = 2;
    ok = gen_check(g, et_seam_gap(&gap, &s, samples) == ET_EINVAL && gap.distance == 5, "a domain that is not [0,1]") && ok;
    view->points[0].x = NAN;
    ok = gen_check(g, et_seam_gap(&gap, &s, samples) == ET_EINVAL && gap.distance == 5 && gap.u == 6 && gap.v == 7, "an invalid shell") && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

/* Rows: p q nu nv samples, interior knots in u and v of both views (u bottom, v bottom, u top, v top), points of both views; wanted: distance u v. */
verdict gold_seam_gap(const row *r)
{
    const size_t p = row_size(r, 0), q = row_size(r, 1), nu = row_size(r, 2), nv = row_size(r, 3);
    et_shell s;
    et_seam gap = {0, 0, 0};
    size_t k = 5;
    bool ok;

    if (et_shell_new(&s, p, q, (et_doublenet){nu, nv}, 0) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < nu + p + 1; i++)
            s.view[w].u[i] = i <= p ? 0 : i >= nu ? 1 : row_real(r, k++);
        for (size_t i = 0; i < nv + q + 1; i++)
            s.view[w].v[i] = i <= q ? 0 : i >= nv ? 1 : row_real(r, k++);
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < nu * nv; i++, k += 3)
            s.view[w].points[i] = (et_vec3){row_real(r, k), row_real(r, k + 1), row_real(r, k + 2)};
    ok = et_seam_gap(&gap, &s, row_size(r, 4)) == ET_OK;
    ok = ok && row_is(r, 0, gap.distance) && row_is(r, 1, gap.u) && row_is(r, 2, gap.v);
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}
