/* conform/request: what is put into a request comes out of it, through a line, too. */
#include "etalon/conform/request.h"
#include "gen.h"
#include <stdlib.h>
#include <string.h>

enum { MOST = 160 };

static void draw(gen *g, double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        x[i] = gen_chance(g, 8) ? -0.0 : gen_real(g, -1, 1) * 0x1p-7;
}

static bool same(const double *a, const double *b, size_t n)
{
    return n == 0 || memcmp(a, b, n * sizeof *a) == 0;
}

/* r printed and read again. */
static bool again(gen *g, et_request *read, const et_request *r)
{
    char *line = NULL;
    const bool ok = gen_check(g, et_request_print(&line, r) == ET_OK && et_request_parse(read, line, NULL) == ET_OK, "not read: %s",
            line ? line : "");

    free(line);
    return ok;
}

verdict prop_request_curve_back(gen *g)
{
    const size_t p = (size_t)gen_upto(g, 4), n = p + 1 + (size_t)gen_upto(g, 6), nw = gen_upto(g, 1) ? n : 0;
    double u[MOST], P[MOST], w[MOST];
    et_request r[2];

    draw(g, u, n + p + 1);
    draw(g, P, 3 * n);
    draw(g, w, nw);
    if (et_request_new(&r[0], ET_OP_CURVE_POINT) != ET_OK)
        return FAIL;
    bool ok = et_request_set(&r[0], 0, p, NULL) == ET_OK && et_request_set(&r[0], 1, n + p + 1, u) == ET_OK && et_request_set(&r[0], 2, n,
            P) == ET_OK &&
              et_request_set(&r[0], 3, nw, w) == ET_OK;
    const bool read = gen_check(g, ok, "not set") && again(g, &r[1], &r[0]);
    ok = read;
    for (int k = 0; ok && k < 2; k++) {
        et_curve c;
        ok = gen_check(g, et_request_curve(&c, &r[k], 0) == ET_OK && c.p == p && c.n == n && !c.weights == (nw == 0), "no curve, or another");
        ok = ok && gen_check(g, same(c.u, u, n + p + 1) && same(&c.points[0].x, P, 3 * n) && same(c.weights, w, nw), "other numbers");
    }
    et_request_free(&r[0]);
    if (read)
        et_request_free(&r[1]);
    return ok ? PASS : FAIL;
}

verdict prop_request_surface_back(gen *g)
{
    const size_t p = (size_t)gen_upto(g, 3), q = (size_t)gen_upto(g, 3), nu = p + 1 + (size_t)gen_upto(g, 2), nv = q + 1 + (size_t)gen_upto(g, 2),
            n = nu * nv;
    const size_t nw = gen_upto(g, 1) ? n : 0;
    double u[MOST], v[MOST], P[MOST], w[MOST];
    et_request r[2];

    draw(g, u, nu + p + 1);
    draw(g, v, nv + q + 1);
    draw(g, P, 3 * n);
    draw(g, w, nw);
    if (et_request_new(&r[0], ET_OP_SURFACE_POINT) != ET_OK)
        return FAIL;
    bool ok = et_request_set(&r[0], 0, p, NULL) == ET_OK && et_request_set(&r[0], 1, q, NULL) == ET_OK && et_request_set(&r[0], 2, nu + p + 1,
            u) == ET_OK;
    ok = ok && et_request_set(&r[0], 3, nv + q + 1, v) == ET_OK && et_request_set(&r[0], 4, n, P) == ET_OK && et_request_set(&r[0], 5, nw,
            w) == ET_OK;
    const bool read = gen_check(g, ok, "not set") && again(g, &r[1], &r[0]);
    ok = read;
    for (int k = 0; ok && k < 2; k++) {
        et_surface s;
        ok = gen_check(g, et_request_surface(&s, &r[k], 0) == ET_OK && s.p == p && s.q == q && s.nu == nu && s.nv == nv, "no surface, or another");
        ok = ok && gen_check(g, same(s.u, u, nu + p + 1) && same(s.v, v, nv + q + 1) && same(&s.points[0].x, P, 3 * n) && same(s.weights, w, nw),
                "other numbers");
    }
    et_request_free(&r[0]);
    if (read)
        et_request_free(&r[1]);
    return ok ? PASS : FAIL;
}

/* A copy prints the same line. */
verdict prop_request_copy_back(gen *g)
{
    const double x[3] = {gen_real(g, -1, 1), 0.5, -0.0};
    et_request r, copy, read;
    bool ok = et_request_new(&r, ET_OP_MULTIPLICITY) == ET_OK && et_request_set(&r, 0, 3, x) == ET_OK && et_request_set(&r, 1, 0, x) == ET_OK;

    if (!gen_check(g, ok && et_request_copy(&copy, &r) == ET_OK, "no copy"))
        return FAIL;
    et_request_free(&r);
    if (!again(g, &read, &copy))
        return FAIL;
    ok = gen_check(g, read.arg[0].count == 3 && same(read.arg[0].x, x, 3) && same(read.arg[1].x, x, 1), "another line");
    et_request_free(&copy);
    et_request_free(&read);
    return ok ? PASS : FAIL;
}
