/* The second computation of an enclosure: the four approaches made of systems, and when parameters are too few. */
#include "fit/enclosure_again.h"
#include <stdio.h>
#include <string.h>

/* ---- approaches ---- */

static const char *const names[3] = { "bottom view", "top view", "both views" };

bool again_on_border(et_doublenet n, size_t i, size_t j)
{
    return i == 0 || j == 0 || i + 1 == n.nx || j + 1 == n.ny;
}

bool again_at_corner(et_doublenet n, size_t i, size_t j)
{
    return (i == 0 || i + 1 == n.nx) && (j == 0 || j + 1 == n.ny);
}

/* The datum at the corner of the node (i, j) of the control net; all corners are border, and the bottom view's. */
static double corner_datum(const enclosure_job *k, size_t i, size_t j, size_t c)
{
    return k->D[0][3 * ((i ? k->data.nx - 1 : 0) * k->data.ny + (j ? k->data.ny - 1 : 0)) + c];
}

static et_status unbounded(again_answer *x, size_t name, double norm, double inverse)
{
    snprintf(x->text, sizeof x->text, "%s: no bound can be given in twice the working precision; the condition number is about %.1g", names[name],
             norm * inverse);
    return ET_ENOCONV;
}

static void norms_of(again_answer *x, double norm, double inverse)
{
    x->norm = fmax(x->norm, norm);
    x->inverse = fmax(x->inverse, inverse);
}

static void both_directions(again_system *U, again_system *V, const enclosure_job *k, size_t w, bool inner)
{
    const et_surface *s = &k->fit->shell.view[w];

    again_direction(U, k->fit->s[w], k->data.nx, s->u, s->nu, s->p, inner);
    again_direction(V, k->fit->r[w], k->data.ny, s->v, s->nv, s->q, inner);
}

/* P = U+ D (V+)' for a grid of data, direction u first. */
static et_status by_directions(et_dd *P, double *radius, again_answer *x, const enclosure_job *k, size_t w, bool inner, const et_dd *D, const double *error)
{
    static again_system U, V;
    static et_dd X[3 * NODES];
    static double e[3 * NODES];
    et_dd d[NODES], p[NODES];
    double off[NODES], r[NODES];
    const size_t name = inner ? 2 : w;
    bool finite = true;

    both_directions(&U, &V, k, w, inner);
    if (again_verify(&U) != ET_OK)
        return unbounded(x, name, U.norm, U.inverse);
    if (again_verify(&V) != ET_OK)
        return unbounded(x, name, U.norm * (V.norm > 0 ? V.norm : 1), U.inverse * (V.inverse > 0 ? V.inverse : 1));
    for (size_t j = 0; j < V.rows; j++)
        for (size_t c = 0; c < 3; c++) {
            for (size_t i = 0; i < U.rows; i++) {
                d[i] = D[3 * (i * V.rows + j) + c];
                off[i] = error[3 * (i * V.rows + j) + c];
            }
            again_column(p, r, &U, d, off);
            for (size_t a = 0; a < U.columns; a++) {
                X[3 * (a * V.rows + j) + c] = p[a];
                e[3 * (a * V.rows + j) + c] = r[a];
                finite = finite && isfinite(r[a]) && isfinite(p[a].hi);
            }
        }
    for (size_t a = 0; finite && a < U.columns; a++)
        for (size_t c = 0; c < 3; c++) {
            for (size_t j = 0; j < V.rows; j++) {
                d[j] = X[3 * (a * V.rows + j) + c];
                off[j] = e[3 * (a * V.rows + j) + c];
            }
            again_column(p, r, &V, d, off);
            for (size_t b = 0; b < V.columns; b++) {
                P[3 * (a * V.columns + b) + c] = p[b];
                radius[3 * (a * V.columns + b) + c] = r[b];
                finite = finite && isfinite(r[b]) && isfinite(p[b].hi);
            }
        }
    if (!finite)
        return unbounded(x, name, U.norm * V.norm, U.inverse * V.inverse);
    norms_of(x, U.norm * V.norm, U.inverse * V.inverse);
    return ET_OK;
}

/* What the corners that stand take from the data, and what it may be off. */
static void without_corners(et_dd *d, double *error, const enclosure_job *k, const again_system *U, const again_system *V, size_t c)
{
    for (size_t i = 0; i < k->data.nx; i++)
        for (size_t j = 0; j < k->data.ny; j++)
            for (int e = 0; e < 4; e++) {
                const size_t a = e & 1 ? U->columns - 1 : 0, b = e & 2 ? V->columns - 1 : 0, at = i * k->data.ny + j;
                const double P = corner_datum(k, a, b, c);
                et_dd Nu = whole(0), Nv = whole(0);
                for (size_t l = U->width; l-- > 0;)
                    Nu = U->at[i * U->width + l] == a ? U->a[i * U->width + l] : Nu;
                for (size_t l = V->width; l-- > 0;)
                    Nv = V->at[j * V->width + l] == b ? V->a[j * V->width + l] : Nv;
                const et_dd N = et_dd_mul(Nu, Nv);
                const double size = fabs(d[at].hi) + N.hi * fabs(P);
                if (N.hi != 0 && (P != 0 || k->lost[c] != 0)) {
                    d[at] = et_dd_sub(d[at], et_dd_mul(N, whole(P)));
                    error[at] = (error[at] + ((U->relative + V->relative + 20 * U2) * size + k->lost[c] + 4 * TINY)) * (1 + 0x1p-50);
                }
            }
}

/* All control points of a view at once, or of half the sum of both (w = 2). */
static et_status at_once(again_answer *x, const enclosure_job *k, size_t w)
{
    static again_system U, V, S;
    size_t number[NODES] = { 0 }, count = 0;
    et_dd d[NODES], p[NODES];
    double error[NODES], r[NODES];
    const et_doublenet n = k->data, f = k->control;
    bool finite = true;

    both_directions(&U, &V, k, w & 1, false);
    for (size_t at = 0; at < f.nx * f.ny; at++)
        number[at] = k->fixed && again_at_corner(f, at / f.ny, at % f.ny) ? LEFT_OUT : count++;
    again_product(&S, &U, &V, number, count);
    for (size_t at = 0; w == 2 && at < n.nx * n.ny; at++)
        S.weight[at] = again_on_border(n, at / n.ny, at % n.ny) ? 1 : 2;
    for (size_t at = 0; w == 2 && at < f.nx * f.ny; at++)
        if (!again_on_border(f, at / f.ny, at % f.ny))
            S.share[number[at]] = 2;
    if (count > 0 && again_verify(&S) != ET_OK)
        return unbounded(x, w, S.norm, S.inverse);
    for (size_t c = 0; c < 3; c++) {
        for (size_t at = 0; at < n.nx * n.ny; at++) {
            const et_dd sum = et_dd_two_sum(k->D[0][3 * at + c], k->D[1][3 * at + c]);
            d[at] = w == 2 ? (et_dd){ sum.hi / 2, sum.lo / 2 } : whole(k->D[w][3 * at + c]);
            error[at] = k->lost[c];
        }
        if (k->fixed)
            without_corners(d, error, k, &U, &V, c);
        again_column(p, r, &S, d, error);
        for (size_t at = 0; at < f.nx * f.ny; at++) {
            const bool stands = number[at] == LEFT_OUT;
            x->x[w & 1][3 * at + c] = stands ? whole(corner_datum(k, at / f.ny, at % f.ny, c)) : p[number[at]];
            x->radius[w & 1][3 * at + c] = stands ? k->lost[c] : r[number[at]];
            finite = finite && isfinite(x->radius[w & 1][3 * at + c]) && isfinite(x->x[w & 1][3 * at + c].hi);
        }
    }
    if (!finite)
        return unbounded(x, w, S.norm, S.inverse);
    norms_of(x, S.norm, S.inverse);
    return ET_OK;
}

/* Half the sum and half the difference of two views that share their border. */
static et_status glued(again_answer *x, const enclosure_job *k)
{
    const et_doublenet n = k->data, f = k->control;
    static et_dd D[3 * NODES], T[3 * NODES];
    static double error[3 * NODES], r[3 * NODES];
    et_status status = at_once(x, k, 2);

    if (status == ET_OK && f.nx > 2 && f.ny > 2) {
        for (size_t i = 1; i + 1 < n.nx; i++)
            for (size_t e = 3; e + 3 < 3 * n.ny; e++) {
                const et_dd d = et_dd_two_sum(k->D[0][3 * i * n.ny + e], -k->D[1][3 * i * n.ny + e]);
                D[3 * (i - 1) * (n.ny - 2) + e - 3] = (et_dd){ d.hi / 2, d.lo / 2 };
                error[3 * (i - 1) * (n.ny - 2) + e - 3] = k->lost[e % 3];
            }
        status = by_directions(T, r, x, k, 0, true, D, error);
    }
    memcpy(x->x[1], x->x[0], sizeof x->x[0]);
    memcpy(x->radius[1], x->radius[0], sizeof x->radius[0]);
    for (size_t at = 0; at < 3 * f.nx * f.ny; at++) {
        const size_t i = at / 3 / f.ny, j = at / 3 % f.ny;
        if (again_on_border(f, i, j))
            continue;
        const et_dd s = x->x[0][at], t = T[3 * ((i - 1) * (f.ny - 2) + j - 1) + at % 3];
        const double both = x->radius[0][at] + r[3 * ((i - 1) * (f.ny - 2) + j - 1) + at % 3];
        x->x[0][at] = et_dd_add(s, t);
        x->x[1][at] = et_dd_sub(s, t);
        x->radius[0][at] = x->radius[1][at] = (both + 4 * U2 * (fabs(s.hi) + fabs(t.hi))) * (1 + 0x1p-50);
    }
    return status;
}

static void means(again_answer *x, const enclosure_job *k)
{
    const et_doublenet f = k->control;

    for (size_t at = 0; at < 3 * f.nx * f.ny; at++) {
        const size_t i = at / 3 / f.ny, j = at / 3 % f.ny;
        const et_dd sum = et_dd_add(x->x[0][at], x->x[1][at]);
        const double r = x->radius[0][at] + x->radius[1][at] + 4 * U2 * fabs(sum.hi);
        if (!again_on_border(f, i, j))
            continue;
        x->x[0][at] = x->x[1][at] = (et_dd){ sum.hi / 2, sum.lo / 2 };
        x->radius[0][at] = x->radius[1][at] = r / 2 * (1 + 0x1p-50);
        if (k->fixed && again_at_corner(f, i, j)) {
            x->x[0][at] = x->x[1][at] = whole(corner_datum(k, i, j, at % 3));
            x->radius[0][at] = x->radius[1][at] = k->lost[at % 3];
        }
    }
}

/* ---- rank: the most functions that parameters of their own make positive, by augmenting paths ---- */

static bool augment(size_t *owner, bool *seen, bool positive[SIDE][SIDE], size_t j, size_t m)
{
    for (size_t i = 0; i < m; i++)
        if (positive[j][i] && !seen[i]) {
            seen[i] = true;
            if (owner[i] == LEFT_OUT || augment(owner, seen, positive, owner[i], m)) {
                owner[i] = j;
                return true;
            }
        }
    return false;
}

size_t again_rank(const double *t, size_t m, const double *u, size_t n, size_t p, bool inner)
{
    bool positive[SIDE][SIDE] = { { false } };
    size_t owner[SIDE], rank = 0;

    for (size_t i = 0; i < m; i++)
        owner[i] = LEFT_OUT;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < m; i++)
            positive[j][i] = (i == 0 || t[i - 1] < t[i]) && ((u[j] < t[i] && t[i] < u[j + p + 1]) || again_alone(u, n, p, t[i]) == j);
    for (size_t j = inner; j + inner < n; j++) {
        bool seen[SIDE] = { false };
        rank += augment(owner, seen, positive, j, m);
    }
    return rank;
}

static et_status rank(again_answer *x, const enclosure_job *k)
{
    const bool fixed = k->fixed && k->options->approach != ET_FIT_IMPROVED;

    for (size_t e = 0; e < 4; e++) {
        const size_t w = e / 2;
        const et_surface *s = &k->fit->shell.view[w];
        const bool inner = fixed && (e % 2 ? k->control.nx : k->control.ny) == 2;
        const size_t n = e % 2 ? s->nv : s->nu, m = e % 2 ? k->data.ny : k->data.nx, wanted = n - 2 * inner;
        const size_t got = again_rank(e % 2 ? k->fit->r[w] : k->fit->s[w], m, e % 2 ? s->v : s->u, n, e % 2 ? s->q : s->p, inner);
        if (got < wanted) {
            snprintf(x->text, sizeof x->text, "%s, direction %s: the %zu parameters determine only %zu of %zu control points", names[w],
                     e % 2 ? "v" : "u", m, got, wanted);
            return ET_ERANK;
        }
    }
    return ET_OK;
}

et_status again_solve(again_answer *x, const enclosure_job *k)
{
    const et_fit_approach approach = k->options->approach;
    et_status status;

    memset(x, 0, sizeof *x);
    status = rank(x, k);
    if (status != ET_OK)
        return status;
    if (approach == ET_FIT_JOINT)
        return glued(x, k);
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        et_dd D[3 * NODES];
        double error[3 * NODES];
        for (size_t at = 0; at < 3 * k->data.nx * k->data.ny; at++) {
            D[at] = whole(k->D[w][at]);
            error[at] = k->lost[at % 3];
        }
        status = k->fixed && approach == ET_FIT_CONVENTIONAL ? at_once(x, k, w) : by_directions(x->x[w], x->radius[w], x, k, w, false, D, error);
    }
    if (status == ET_OK && approach == ET_FIT_IMPROVED)
        means(x, k);
    return status;
}
