/* exact/exact_edit: golden rows, written as the functions' own tests read them. */
#include "exact/edited.h"

/* ---- golden rows, written as the functions' own tests read them ---- */

static bool are_reals(const row *r, size_t *at, const double *x, size_t n)
{
    bool ok = true;
    for (size_t i = 0; ok && i < n; i++, ++*at) {
        ok = row_is(r, *at, x[i]);
    }
    return ok;
}

static bool are_sizes(const row *r, size_t *at, const size_t *x, size_t n)
{
    bool ok = true;
    for (size_t i = 0; ok && i < n; i++, ++*at) {
        ok = *at < r->nwant && strtod(r->want[*at], NULL) == (double)x[i];
    }
    return ok;
}

/* Points, and weights if there are any: the last of what is wanted. */
static bool are_points(const row *r, size_t *at, const et_vec3 *P, const double *w, size_t n)
{
    return are_reals(r, at, &P->x, 3 * n) && (w == NULL || are_reals(r, at, w, n)) && *at == r->nwant;
}

static bool is_curve(const row *r, size_t at, const et_curve *c)
{
    size_t sizes[] = {c->p, c->n, c->weights != NULL};
    return are_sizes(r, &at, sizes, 3) && are_reals(r, &at, c->u, knots_of(c)) && are_points(r, &at, c->points, c->weights, c->n);
}

static bool is_surface(const row *r, size_t at, const et_surface *s)
{
    size_t sizes[] = {s->p, s->q, s->nu, s->nv, s->weights != NULL};
    return are_sizes(r, &at, sizes, 5) && are_reals(r, &at, s->u, s->nu + s->p + 1) && are_reals(r, &at, s->v, s->nv + s->q + 1) &&
           are_points(r, &at, s->points, s->weights, s->nu * s->nv);
}

verdict true_knots_greville(const row *r)
{
    double u[REF_KNOTS], G[REF_KNOTS];
    size_t nu = r->nargs - 1, p = row_size(r, 0), n = nu - p - 1, at = 0;
    if (nu > REF_KNOTS) {
        return FAIL;
    }
    read_knots(r, u, nu, 1);
    return knots_greville(G, n, u, nu, p) == ET_OK && are_reals(r, &at, G, n) && at == r->nwant ? PASS : FAIL;
}

verdict true_curve_ders_side(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = at > 0 ? row_size(r, at) : 32, from = 0;
    bool ok = k < 32 && et_exact_curve_ders_side(D, k, &c, row_real(r, at + 1), row_size(r, at + 2) ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK &&
              are_points(r, &from, D + k, NULL, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

static et_status insert_as_told(et_curve *t, const row *r)
{
    et_curve c;
    size_t at = read_curve(r, &c);
    et_status status = at > 0 ? curve_insert(t, &c, row_real(r, at), row_size(r, at + 1)) : ET_EINTERNAL;
    et_curve_free(&c);
    return status;
}

verdict true_curve_insert(const row *r)
{
    et_curve t = {0, 0, NULL, NULL, NULL};
    bool ok = insert_as_told(&t, r) == ET_OK && is_curve(r, 0, &t);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_curve_insert_status(const row *r)
{
    et_curve t = {0, 0, NULL, NULL, NULL};
    bool ok = row_is_size(r, 0, (size_t)insert_as_told(&t, r));
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_curve_elevate(const row *r)
{
    et_curve c, t = {0, 0, NULL, NULL, NULL};
    size_t at = read_curve(r, &c);
    bool ok = at > 0 && curve_elevate(&t, &c, row_size(r, at)) == ET_OK && is_curve(r, 0, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* The tolerance of the row is for what rounds: exactly, too, a knot goes or does not. */
verdict true_curve_remove(const row *r)
{
    et_curve c, t = {0, 0, NULL, NULL, NULL};
    size_t at = read_curve(r, &c), removed = 0, from = 0;
    bool ok = at > 0 && curve_remove(&t, &removed, &c, row_real(r, at), row_size(r, at + 1)) == ET_OK && are_sizes(r, &from, &removed, 1) &&
              is_curve(r, 1, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_insert(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && surface_insert(&t, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2)) == ET_OK &&
              is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_elevate(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && surface_elevate(&t, &s, (et_direction)row_size(r, at), row_size(r, at + 1)) == ET_OK && is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_remove(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s), removed = 0, from = 0;
    bool ok = at > 0 && surface_remove(&t, &removed, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2)) == ET_OK &&
              are_sizes(r, &from, &removed, 1) && is_surface(r, 1, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_partials(const row *r)
{
    et_surface s;
    et_vec3 D[91];                                          /* up to order 12 */
    size_t at = read_surface(r, &s), a = at > 0 ? row_size(r, at) : 12, b = at > 0 ? row_size(r, at + 1) : 12, d = a + b, from = 0;
    bool ok = d <= 12 &&
              et_exact_surface_partials(D, d, &s, row_real(r, at + 2), row_real(r, at + 3), row_size(r, at + 4) ? ET_SIDE_LEFT : ET_SIDE_RIGHT,
                                        row_size(r, at + 5) ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK &&
              are_points(r, &from, D + d * (d + 1) / 2 + b, NULL, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_normal(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s), from = 0;
    bool ok = at > 0 && et_exact_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1)) == ET_OK && are_points(r, &from, &n, NULL, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_normal_status(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && row_is_size(r, 0, (size_t)et_exact_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1)));
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
