/* exact_fit_solve: the control points of a fit, by balls at a precision that is doubled until each rounds to one double, else by rationals. */
#include "exact/exact_fit_parts.h"

/* Beyond this many bits, where zeros among the results have been told from the least subnormal, what is left undecided is mostly ties. */
enum { MOST_BITS = 2048, GREATEST_BITS = 1 << 20 };

typedef struct {
    const exact_fit *f;
    size_t own;                           /* views with sides of their own: 2 (conventional), else 1 */
    exact_side side[2][2];
    slong bits;
} pass;

static int on_border(et_doublenet n, size_t i, size_t j)
{
    return i == 0 || i == n.nx - 1 || j == 0 || j == n.ny - 1;
}

static size_t views_apart(const exact_fit *f)
{
    return f->approach == ET_FIT_CONVENTIONAL ? 2 : 1;
}

/* Corners as constraints, not put in afterwards. */
static int constrained(const exact_fit *f)
{
    return f->fixed && f->approach != ET_FIT_IMPROVED;
}

/* Whether the ends in a direction are fixed altogether: corners are, and across there is nothing between them. */
static int ends_fixed(const exact_fit *f, size_t direction)
{
    return constrained(f) && (direction == 0 ? f->control.ny : f->control.nx) == 2;
}

/* Whether the end functions are 1 at the end parameters: unless inner knots have fallen on an end; there the end function vanishes throughout. */
static int ends_seen(const fmpq_mat_t A)
{
    return fmpq_is_one(fmpq_mat_entry(A, 0, 0)) && fmpq_is_one(fmpq_mat_entry(A, fmpq_mat_nrows(A) - 1, fmpq_mat_ncols(A) - 1));
}

static double *coordinate(et_vec3 *P, size_t e)
{
    return e == 0 ? &P->x : e == 1 ? &P->y : &P->z;
}

/* ---- rank ---- */

/* The problem has one solution if and only if A has full rank in both directions; where the ends are fixed, its inner columns. */
static et_status check_direction(const exact_fit *f, size_t w, size_t direction, et_message *message)
{
    static const char *const views[] = {"bottom view", "top view"}, *const directions[] = {"u", "v"};
    const fmpq_mat_struct *A = &f->A[w][direction];
    const slong ends = ends_fixed(f, direction) ? 1 : 0;
    const size_t unknowns = (size_t)(fmpq_mat_ncols(A) - 2 * ends);
    fmpq_mat_t inner;
    size_t rank;

    fmpq_mat_window_init(inner, A, 0, ends, fmpq_mat_nrows(A), fmpq_mat_ncols(A) - ends);
    rank = exact_rank(inner);
    fmpq_mat_window_clear(inner);
    if (rank == unknowns)
        return ET_OK;
    return et_status_fail(message, ET_ERANK, "%s, direction %s: the %zu parameters determine only %zu of %zu %scontrol points",
                          f->approach == ET_FIT_JOINT ? "both views" : views[w], directions[direction], (size_t)fmpq_mat_nrows(A), rank, unknowns,
                          ends ? "interior " : "");
}

static et_status check_rank(const exact_fit *f, et_message *message)
{
    et_status status = ET_OK;

    for (size_t w = 0; w < views_apart(f); w++)
        for (size_t direction = 0; status == ET_OK && direction < 2; direction++)
            status = check_direction(f, w, direction, message);
    return status;
}

/* ---- one coordinate ---- */

typedef struct {
    exact_mat D[2], X[2], P[2];           /* data, control points in the sides' coordinates, control points */
} plane;

static void plane_init(plane *p, const pass *s, size_t e)
{
    const et_doublenet n = s->f->data, c = s->f->control;

    for (size_t w = 0; w < 2; w++) {
        exact_mat_init(&p->D[w], n.nx, n.ny, s->bits);
        exact_mat_init(&p->X[w], c.nx, c.ny, s->bits);
        exact_mat_init(&p->P[w], c.nx, c.ny, s->bits);
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++) {
                et_vec3 D = s->f->D[et_doublenet_class(n, w, i, j) - 1];
                exact_mat_put_double(&p->D[w], i, j, *coordinate(&D, e));
            }
    }
}

static void plane_clear(plane *p)
{
    for (size_t w = 0; w < 2; w++) {
        exact_mat_clear(&p->D[w]);
        exact_mat_clear(&p->X[w]);
        exact_mat_clear(&p->P[w]);
    }
}

static void put_corners(exact_mat *X, const exact_mat *D)
{
    for (size_t a = 0; a < 2; a++)
        for (size_t b = 0; b < 2; b++)
            exact_mat_copy(X, a * (X->rows - 1), b * (X->columns - 1), D, a * (D->rows - 1), b * (D->columns - 1));
}

static void share_border(exact_mat X[2])
{
    const et_doublenet n = {X[0].rows, X[0].columns};

    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            if (on_border(n, i, j))
                exact_mat_mean(&X[0], &X[1], i, j);
}

static void share_all(exact_mat D[2])
{
    for (size_t i = 0; i < D[0].rows; i++)
        for (size_t j = 0; j < D[0].columns; j++)
            exact_mat_mean(&D[0], &D[1], i, j);
}

/* The corners of the glued problem, from the views' mean data. */
static int joint_corners(plane *p, const exact_side *u, const exact_side *v)
{
    exact_mat C;
    int ok;

    exact_mat_init(&C, 2, 2, p->X[0].bits);
    ok = exact_fit_twice(&C, &u->Q, &v->Q, &p->D[0]);
    for (size_t w = 0; ok && w < 2; w++)
        for (size_t a = 0; a < 2; a++)
            for (size_t b = 0; b < 2; b++)
                exact_mat_copy(&p->X[w], a * (u->n - 1), b * (v->n - 1), &C, a, b);
    exact_mat_clear(&C);
    return ok;
}

/* Where end functions vanish, control points can be told apart only between fixed corners of a net two wide: all of them at once. */
static int joint_strip(plane *p, const exact_side *u, const exact_side *v)
{
    const int along_u = v->n == 2;
    const exact_mat *U = along_u ? &u->Ai : &u->Q, *V = along_u ? &v->Q : &v->Ai;
    exact_mat C, S, X;
    int ok;

    exact_mat_init(&C, 2, 2, p->D[0].bits);
    exact_mat_init(&S, u->m, v->m, p->D[0].bits);
    exact_mat_init(&X, U->columns, V->columns, p->D[0].bits);
    put_corners(&C, &p->D[0]);
    exact_mat_sandwich(&S, &u->Q, &C, &v->Q);
    exact_mat_sub(&S, &p->D[0], &S);
    ok = exact_fit_twice(&X, U, V, &S);
    for (size_t w = 0; ok && w < 2; w++)
        for (size_t i = 0; i < X.rows; i++)
            for (size_t j = 0; j < X.columns; j++)
                exact_mat_copy(&p->X[w], along_u ? i + 1 : i, along_u ? j : j + 1, &X, i, j);
    exact_mat_clear(&C);
    exact_mat_clear(&S);
    exact_mat_clear(&X);
    return ok;
}

/* Both views' X: the border is shared, inside each has its own. */
static int glue(plane *p, const pass *s)
{
    const exact_side *u = &s->side[0][0], *v = &s->side[0][1];

    share_border(p->X);
    share_all(p->D);
    if (!s->f->fixed)
        return joint_corners(p, u, v);
    return (ends_seen(&s->f->A[0][0]) && ends_seen(&s->f->A[0][1])) || joint_strip(p, u, v);
}

static int plane_solve(plane *p, const pass *s)
{
    const exact_fit *f = s->f;

    for (size_t w = 0; w < 2; w++) {
        const exact_side *side = s->side[w % s->own];
        exact_mat_sandwich(&p->X[w], &side[0].Y, &p->D[w], &side[1].Y);
        if (constrained(f))
            put_corners(&p->X[w], &p->D[w]);
    }
    if (f->approach == ET_FIT_JOINT && !glue(p, s))
        return 0;
    for (size_t w = 0; w < 2; w++)
        exact_mat_sandwich(&p->P[w], &s->side[w % s->own][0].F, &p->X[w], &s->side[w % s->own][1].F);
    if (f->approach == ET_FIT_IMPROVED)
        share_border(p->P);
    for (size_t w = 0; w < 2; w++)
        if (f->approach == ET_FIT_IMPROVED && f->fixed)
            put_corners(&p->P[w], &p->D[w]);
    return 1;
}

/* 1 if all of the coordinate is decided. */
static int plane_round(const plane *p, const exact_fit *f, size_t e)
{
    const size_t columns = f->control.ny;
    int all = 1;

    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < f->control.nx * columns; at++)
            all = exact_mat_round(coordinate(&f->P[w][at], e), &p->P[w], at / columns, at % columns) && all;
    return all;
}

/* ---- passes ---- */

static void sides_clear(pass *s, size_t made)
{
    for (size_t k = 0; k < made; k++)
        exact_side_clear(&s->side[k / 2][k % 2]);
}

/* 0 if balls are too wide, and then nothing is held. */
static int sides_init(pass *s)
{
    const exact_fit *f = s->f;

    for (size_t k = 0; k < 2 * s->own; k++)
        if (!exact_side_init(&s->side[k / 2][k % 2], &f->A[k / 2][k % 2], f->approach == ET_FIT_JOINT, ends_fixed(f, k % 2), s->bits)) {
            sides_clear(s, k);
            return 0;
        }
    return 1;
}

static size_t count(const int decided[3])
{
    return (size_t)(decided[0] + decided[1] + decided[2]);
}

/* All that is not yet decided, at so many bits (0: by rationals). */
static et_status run_pass(const exact_fit *f, int decided[3], slong bits, const et_task *task)
{
    pass s;
    et_status status = et_task_step(task, count(decided), 3);

    s.f = f;
    s.own = views_apart(f);
    s.bits = bits;
    if (status != ET_OK || !sides_init(&s))
        return status;
    for (size_t e = 0; status == ET_OK && e < 3; e++) {
        plane p;
        if (decided[e])
            continue;
        plane_init(&p, &s, e);
        decided[e] = plane_solve(&p, &s) && plane_round(&p, f, e);
        plane_clear(&p);
        status = et_task_step(task, count(decided), 3);
    }
    sides_clear(&s, 2 * s.own);
    return status;
}

et_status exact_fit_run(exact_fit *f, size_t *bits, const et_task *task, et_message *message)
{
    int decided[3] = {0, 0, 0};
    slong b = *bits == 0 ? EXACT_BITS : *bits < GREATEST_BITS ? (slong)*bits : GREATEST_BITS, last = 0;
    et_status status = check_rank(f, message);

    if (status != ET_OK)
        return status;
    for (; status == ET_OK && count(decided) < 3 && (last == 0 || b <= MOST_BITS); b *= 2) {
        last = b;
        status = run_pass(f, decided, b, task);
    }
    if (status == ET_OK && count(decided) < 3)
        status = run_pass(f, decided, 0, task);
    if (status == ET_OK && count(decided) < 3)
        status = ET_EINTERNAL;
    if (status != ET_OK)
        return et_status_fail(message, status, "exact control points: %s", et_status_text(status));
    *bits = (size_t)last;
    return ET_OK;
}
