/* fit/fit: fits against dense least squares, planted surfaces, data scaled, moved and turned, hard data, what is refused. */
#include "fit/fits.h"

/* ---- a second way: Cox and de Boor's recursion, dense matrices ---- */

static double deboor(const double *u, size_t i, size_t p, double x, double end)
{
    double a = 0, b = 0;

    if (p == 0)
        return (u[i] <= x && x < u[i + 1]) || (x == end && u[i] < end && u[i + 1] == end) ? 1 : 0;
    if (u[i + p] > u[i])
        a = (x - u[i]) / (u[i + p] - u[i]) * deboor(u, i, p - 1, x, end);
    if (u[i + p + 1] > u[i + 1])
        b = (u[i + p + 1] - x) / (u[i + p + 1] - u[i + 1]) * deboor(u, i + 1, p - 1, x, end);
    return a + b;
}

/* A (m x n): basis functions at the parameters. */
static void basis_matrix(double *A, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++)
            A[i * n + j] = deboor(u, j, p, t[i], 1);
}

typedef struct {
    size_t rows, columns;
    double A[CLASSES * CLASSES];
    double rhs[CLASSES * 3];
    et_vec3 *unknown[CLASSES]; /* where each unknown stands in the fit, in the first view that has it */
} system_;

static int inside(et_doublenet n, size_t i, size_t j)
{
    return i > 0 && j > 0 && i + 1 < n.nx && j + 1 < n.ny;
}

/* The system of one view (views 1, `first` says which) or of both glued (views 2); fixed corners are moved to the right. */
static void assemble(system_ *s, const problem *c, et_fit *f, size_t first, size_t views, int fixed)
{
    const et_doublenet n = c->net, k = c->options.control;
    double U[NODES], V[NODES];
    size_t number[2][NODES], at_row = 0;
    const et_surface *v = &f->shell.view[first];

    memset(s, 0, sizeof *s);
    for (size_t w = 0; w < views; w++)
        for (size_t a = 0; a < k.nx; a++)
            for (size_t b = 0; b < k.ny; b++) {
                if (w == 1 && !inside(k, a, b))
                    number[1][a * k.ny + b] = number[0][a * k.ny + b];
                else if (fixed && corner_node(k, a, b))
                    number[w][a * k.ny + b] = CLASSES;
                else {
                    s->unknown[s->columns] = &f->shell.view[first + w].points[a * k.ny + b];
                    number[w][a * k.ny + b] = s->columns++;
                }
            }
    basis_matrix(U, f->s[first], n.nx, v->u, k.nx, v->p);
    basis_matrix(V, f->r[first], n.ny, v->v, k.ny, v->q);
    for (size_t w = 0; w < views; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++) {
                if (w == 1 && !inside(n, i, j))
                    continue;
                const et_vec3 d = c->data[et_doublenet_class(n, first + w, i, j) - 1];
                double *rhs = s->rhs + 3 * at_row;
                rhs[0] = d.x;
                rhs[1] = d.y;
                rhs[2] = d.z;
                for (size_t a = 0; a < k.nx; a++)
                    for (size_t b = 0; b < k.ny; b++) {
                        const double x = U[i * k.nx + a] * V[j * k.ny + b];
                        const size_t at = number[w][a * k.ny + b];
                        if (at < CLASSES) {
                            s->A[at_row * s->columns + at] += x;
                            continue;
                        }
                        const et_vec3 e = c->data[(a ? (n.nx - 1) * n.ny : 0) + (b ? n.ny - 1 : 0)];
                        rhs[0] -= x * e.x;
                        rhs[1] -= x * e.y;
                        rhs[2] -= x * e.z;
                    }
                at_row++;
            }
    s->rows = at_row;
}

static double norm(const double *x, size_t n)
{
    double sum = 0, most = 0;

    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    for (size_t i = 0; i < n; i++)
        sum += most > 0 ? (x[i] / most) * (x[i] / most) : 0;
    return most * sqrt(sum);
}

/* 1 / sigma_min of A (m x n) from above, by the inverse of A'A (Gauss and Jordan); infinite where a pivot vanishes. */
static double inverse_norm(const double *A, size_t m, size_t n)
{
    static double G[CLASSES][2 * CLASSES];
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            G[i][j] = 0;
            G[i][n + j] = i == j;
            for (size_t e = 0; e < m; e++)
                G[i][j] += A[e * n + i] * A[e * n + j];
        }
    for (size_t c = 0; c < n; c++) {
        size_t pivot = c;
        for (size_t i = c; i < n; i++)
            pivot = fabs(G[i][c]) > fabs(G[pivot][c]) ? i : pivot;
        for (size_t j = 0; j < 2 * n; j++) {
            const double x = G[pivot][j];
            G[pivot][j] = G[c][j];
            G[c][j] = x;
        }
        if (!(fabs(G[c][c]) > 0x1p-48))
            return HUGE_VAL;
        for (size_t i = 0; i < n; i++) {
            const double x = i == c ? 0 : G[i][c] / G[c][c];
            for (size_t j = 0; x != 0 && j < 2 * n; j++)
                G[i][j] -= x * G[c][j];
        }
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            sum += G[i][n + j] / G[i][i] * (G[i][n + j] / G[i][i]);
    return sqrt(sqrt(sum));
}

/* |A'(A x - b)| of the fit's own control points, and what rounding may leave of it: every solver of the house is backward stable in its steps (the
 * constant is the number of entries it touches), so that the gradient is at most c u |A| (|b| + |A| |x|), where between the two directions of
 * a separable solution stands Nu+ D, of length at most |D| / sigma. */
static bool stationary(gen *g, const system_ *s, double inverse)
{
    const double a = norm(s->A, s->rows * s->columns), c = 64 * (double)((s->rows + 8) * (s->columns + 8)) * ET_UNIT;

    for (size_t e = 0; e < 3; e++) {
        double r[CLASSES], x[CLASSES], slope[CLASSES] = {0}, b[CLASSES];
        for (size_t i = 0; i < s->columns; i++)
            x[i] = e == 0 ? s->unknown[i]->x : e == 1 ? s->unknown[i]->y : s->unknown[i]->z;
        for (size_t i = 0; i < s->rows; i++) {
            r[i] = b[i] = s->rhs[3 * i + e];
            for (size_t j = 0; j < s->columns; j++)
                r[i] -= s->A[i * s->columns + j] * x[j];
            for (size_t j = 0; j < s->columns; j++)
                slope[j] += s->A[i * s->columns + j] * r[i];
        }
        const double bound = c * a * (norm(b, s->rows) * (1 + a * inverse) + a * norm(x, s->columns)) + 0x1p-1000; /* the last for underflow */
        if (!gen_check(g, norm(slope, s->columns) <= bound, "gradient %g, bound %g", norm(slope, s->columns), bound))
            return false;
    }
    return true;
}

/* Schoenberg and Whitney: parameters can be chosen, in order, one where each basis function is not zero. */
static bool interlaced(const double *u, size_t control, size_t p, const double *t, size_t nt)
{
    size_t j = 0;

    for (size_t i = 0; i < nt && j < control; i++)
        j += deboor(u, j, p, t[i], 1) > 0;
    return j == control;
}

/* Parameters and knots as the options ask for them, in a shell of zeros. */
static bool frame_of(et_fit *f, const problem *c)
{
    const et_fit_options *o = &c->options;
    bool ok = et_fit_parameters(f, c->data, c->nov, c->net, o->approach, o->method) == ET_OK;

    ok = ok && et_shell_new(&f->shell, o->p, o->q, o->control, 0) == ET_OK;
    for (size_t w = 0; ok && w < 2; w++) {
        et_surface *v = &f->shell.view[w];
        ok = et_knotrule_make(v->u, o->control.nx + o->p + 1, o->p, f->s[w], c->net.nx, o->knots) == ET_OK &&
             et_knotrule_make(v->v, o->control.ny + o->q + 1, o->q, f->r[w], c->net.ny, o->knots) == ET_OK;
    }
    return ok;
}

static bool same_frame(gen *g, const et_fit *a, const et_fit *b, const problem *c)
{
    const et_fit_options *o = &c->options;
    bool ok = a->data.nx == c->net.nx && a->data.ny == c->net.ny && a->flat == b->flat;

    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &a->shell.view[w], *x = &b->shell.view[w];
        ok = ok && v->p == o->p && v->q == o->q && v->nu == o->control.nx && v->nv == o->control.ny && v->weights == NULL;
        ok = ok && memcmp(v->u, x->u, (v->nu + v->p + 1) * sizeof(double)) == 0 && memcmp(v->v, x->v, (v->nv + v->q + 1) * sizeof(double)) == 0;
        ok = ok && memcmp(a->s[w], b->s[w], c->net.nx * sizeof(double)) == 0 && memcmp(a->r[w], b->r[w], c->net.ny * sizeof(double)) == 0;
    }
    return gen_check(g, ok, "parameters, knots or shape are not the options'");
}

static int corners_fixed(const et_fit_options *o)
{
    return o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
}

static bool corners_stand(gen *g, const et_fit *f, const problem *c)
{
    const et_doublenet n = c->net, k = c->options.control;

    for (size_t w = 0; w < 2; w++)
        for (size_t e = 0; e < 4; e++) {
            const et_vec3 d = c->data[(e & 1 ? (n.nx - 1) * n.ny : 0) + (e & 2 ? n.ny - 1 : 0)];
            const et_vec3 p = f->shell.view[w].points[(e & 1 ? (k.nx - 1) * k.ny : 0) + (e & 2 ? k.ny - 1 : 0)];
            if (!gen_check(g, p.x == d.x && p.y == d.y && p.z == d.z, "corner %zu of view %zu", e, w))
                return false;
        }
    return true;
}

/* How far a solver's answer may be from another's: c u times condition times (1 + condition), squared once more for normal equations. */
static double spread_of(const system_ *s, double inverse, et_linalg_method algebra)
{
    const double condition = norm(s->A, s->rows * s->columns) * inverse, c = 64 * (double)((s->rows + 8) * (s->columns + 8)) * ET_UNIT;

    return c * (1 + condition) * (1 + condition) * (algebra == ET_LINALG_CHOLESKY ? 1 + condition : 1) * inverse * norm(s->rhs, 3 * s->rows);
}

/* The improved fit by its definition: each view's dense least squares, then means and corners. */
static bool improved_agrees(gen *g, const problem *c, et_fit *f)
{
    static system_ s;
    const et_doublenet k = c->options.control, n = c->net;
    double X[2][CLASSES * 3];
    size_t rank;
    double bound = 0;

    for (size_t w = 0; w < 2; w++) {
        assemble(&s, c, f, w, 1, 0);
        const double inverse = inverse_norm(s.A, s.rows, s.columns);
        if (!(inverse < HUGE_VAL) || et_linalg_lsq(X[w], &rank, s.A, s.rows, s.columns, s.rhs, 3, ET_LINALG_SVD) != ET_OK)
            return true;
        bound = fmax(bound, spread_of(&s, inverse, c->options.algebra));
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < 3 * k.nx * k.ny; at++) {
            const size_t i = at / 3 / k.ny, j = at / 3 % k.ny;
            double expect = inside(k, i, j) ? X[w][at] : X[0][at] / 2 + X[1][at] / 2;
            if (corner_node(k, i, j) && corners_fixed(&c->options))
                expect = (&c->data[(i ? (n.nx - 1) * n.ny : 0) + (j ? n.ny - 1 : 0)].x)[at % 3];
            const double got = (&f->shell.view[w].points[at / 3].x)[at % 3];
            if (!gen_check(g, fabs(got - expect) <= bound, "view %zu (%zu,%zu): %g, by definition %g, bound %g", w, i, j, got, expect, bound))
                return false;
        }
    return true;
}

static bool optimal(gen *g, const problem *c, et_fit *f)
{
    static system_ s;
    const int fixed = corners_fixed(&c->options);

    if (c->options.approach == ET_FIT_IMPROVED)
        return improved_agrees(g, c, f);
    for (size_t w = 0; w < (c->options.approach == ET_FIT_JOINT ? 1u : 2u); w++) {
        assemble(&s, c, f, w, c->options.approach == ET_FIT_JOINT ? 2 : 1, fixed);
        const double inverse = s.columns > 0 ? inverse_norm(s.A, s.rows, s.columns) : 0;
        if (inverse < HUGE_VAL && !stationary(g, &s, inverse))
            return false;
    }
    return true;
}

/* Deficient systems must be told, well-conditioned ones solved: a condition number below 1e5 is far from every solver's limit (Cholesky's is near
 * 1e7). */
static bool status_right(gen *g, et_status status, const et_message *message, const problem *c, et_fit *frame)
{
    static system_ s;
    const et_fit_options *o = &c->options;
    /* A basis function that vanishes at all parameters may belong to corners only, which need no data where they are fixed. */
    const bool spared = corners_fixed(o) && o->approach != ET_FIT_IMPROVED;
    bool whole = true, good = true;

    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &frame->shell.view[w];
        whole = whole && interlaced(v->u, v->nu, v->p, frame->s[w], c->net.nx) && interlaced(v->v, v->nv, v->q, frame->r[w], c->net.ny);
        assemble(&s, c, frame, o->approach == ET_FIT_JOINT ? 0 : w, o->approach == ET_FIT_JOINT ? 2 : 1, 0);
        good = good && norm(s.A, s.rows * s.columns) * inverse_norm(s.A, s.rows, s.columns) < 1e5;
    }
    if (status == ET_ERANK)
        return gen_check(g, !good, "refused though well conditioned: %s", message->text) &&
               gen_check(g, o->algebra != ET_LINALG_SVD && strstr(message->text, "only ") != NULL && strstr(message->text, "view") != NULL,
                         "message: %s", message->text);
    return gen_check(g, status == ET_OK, "status %d: %s", (int)status, message->text) &&
           gen_check(g, strcmp(message->text, "untouched") == 0, "a message without a failure: %s", message->text) &&
           gen_check(g, whole || spared || o->algebra == ET_LINALG_SVD, "solved though Schoenberg and Whitney's condition fails");
}

static bool fit_right(gen *g, problem *c, et_fit *f, et_fit *frame)
{
    et_seam gap;
    bool ok = same_frame(g, f, frame, c) && gen_check(g, et_shell_valid(&f->shell), "the shell is not valid");

    if (ok && c->options.approach != ET_FIT_CONVENTIONAL)
        ok = gen_check(g, et_shell_glued(&f->shell), "not glued") &&
             gen_check(g, et_seam_gap(&gap, &f->shell, 2) == ET_OK && gap.distance == 0, "a gap");
    if (ok && corners_fixed(&c->options))
        ok = corners_stand(g, f, c);
    return ok && optimal(g, c, f);
}

verdict prop_fit_make(gen *g)
{
    problem c;
    et_fit f, frame;
    et_message message = {"untouched"};
    bool ok;

    draw_problem(g, &c);
    if (!gen_check(g, frame_of(&frame, &c), "parameters and knots"))
        return FAIL;
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;
    const et_status status = et_fit_make(&f, c.data, c.nov, c.net, &c.options, &message);
    gen_label(g, et_fit_name(c.options.approach));
    gen_label(g, status == ET_OK ? "solved" : "deficient");
    ok = status_right(g, status, &message, &c, &frame);
    if (status != ET_OK)
        ok = gen_check(g, memcmp(&f, &was, sizeof f) == 0, "the fit changed") && ok;
    else {
        ok = ok && fit_right(g, &c, &f, &frame);
        et_fit_free(&f);
    }
    et_fit_free(&frame);
    return ok ? PASS : FAIL;
}

/* ---- joint is the least of all gap-free shells ---- */

static double squares(const problem *c, const et_fit *f)
{
    et_fit_error error;
    double d[CLASSES], sum = 0;

    if (et_fit_measure(&error, d, c->nov, f, c->data) != ET_OK)
        return NAN;
    for (size_t i = 0; i < c->nov; i++)
        sum += d[i] * d[i];
    return sum;
}

verdict prop_fit_make_joint(gen *g)
{
    static system_ s;
    problem c;
    et_fit joint, other;
    et_vec3 P[CLASSES];
    size_t rank;
    bool ok = true;

    draw_options(g, &c);
    draw_pillow(g, &c);
    c.options.knots = ET_KNOTRULE_PIEGL;
    c.options.approach = ET_FIT_JOINT;
    if (et_fit_make(&joint, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    const int fixed = corners_fixed(&c.options);
    assemble(&s, &c, &joint, 0, 2, fixed);
    const double inverse = s.columns > 0 ? inverse_norm(s.A, s.rows, s.columns) : 0, bound = spread_of(&s, inverse, c.options.algebra);
    if (inverse < HUGE_VAL && s.columns > 0 && et_linalg_lsq(&P[0].x, &rank, s.A, s.rows, s.columns, s.rhs, 3, ET_LINALG_SVD) == ET_OK)
        for (size_t i = 0; ok && i < s.columns; i++)
            ok = gen_check(g, fabs(P[i].x - s.unknown[i]->x) + fabs(P[i].y - s.unknown[i]->y) + fabs(P[i].z - s.unknown[i]->z) <= 3 * bound,
                           "unknown %zu: not the dense solution's", i);
    /* Rounding of one residual: both shells' points within 40u of the control net's size (degree 3 twice), here below 2^6: a sum of squares is off by
     * at most 2 |r| |dr|, with |r| < 2^6 and |dr| < 2^-40 over 52 classes. */
    const double least = squares(&c, &joint), slack = 0x1p-26;
    c.options.approach = ET_FIT_IMPROVED;
    c.options.corners = fixed ? ET_CORNERS_INTERPOLATED : ET_CORNERS_FREE;
    if (ok && et_fit_make(&other, c.data, c.nov, c.net, &c.options, NULL) == ET_OK) {
        ok = gen_check(g, inverse > 64 || least <= squares(&c, &other) + slack, "improved is better: %g < %g", squares(&c, &other), least);
        et_fit_free(&other);
    }
    const size_t nov = et_doublenet_nov(c.options.control);
    et_shell_gather(P, nov, &joint.shell);
    const double step = ldexp(1, -(int)gen_upto(g, 20));
    for (size_t i = 0; i < nov; i++) {
        const et_index x = et_doublenet_index(c.options.control, i + 1);
        if (fixed && corner_node(c.options.control, x.i, x.j))
            continue;
        P[i].x += gen_real(g, -1, 1) * step;
        P[i].y += gen_real(g, -1, 1) * step;
        P[i].z += gen_real(g, -1, 1) * step;
    }
    et_shell_scatter(&joint.shell, P, nov);
    ok = gen_check(g, inverse > 64 || least <= squares(&c, &joint) + slack, "a neighbour is better: %g < %g", squares(&c, &joint), least) && ok;
    et_fit_free(&joint);
    return ok ? PASS : FAIL;
}

/* ---- planted surfaces come back ---- */

verdict prop_fit_make_planted(gen *g)
{
    static system_ s;
    problem c;
    et_fit f, frame;
    et_vec3 planted[CLASSES], found[CLASSES], S[NODES];
    bool ok;

    draw_options(g, &c);
    c.options.method = ET_PARAM_UNIFORM; /* so that the parameters do not depend on the data */
    c.options.knots = gen_upto(g, 1) ? ET_KNOTRULE_UNIFORM : ET_KNOTRULE_PIEGL;
    memset(c.data, 0, sizeof c.data);
    if (!frame_of(&frame, &c))
        return FAIL;
    const size_t nov = et_doublenet_nov(c.options.control);
    for (size_t i = 0; i < nov; i++)
        planted[i] = (et_vec3){(double)gen_upto(g, 16) - 8, (double)gen_upto(g, 16) - 8, (double)gen_upto(g, 16) - 8};
    et_shell_scatter(&frame.shell, planted, nov);
    for (size_t w = 2; w-- > 0;) {
        et_surface_grid(S, &frame.shell.view[w], frame.s[w], c.net.nx, frame.r[w], c.net.ny);
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++)
                c.data[et_doublenet_class(c.net, w, i, j) - 1] = S[i * c.net.ny + j];
    }
    assemble(&s, &c, &frame, 0, 1, 0);
    const double inverse = inverse_norm(s.A, s.rows, s.columns);
    et_fit_free(&frame);
    if (!(inverse < HUGE_VAL) || et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    /* Both views share the border: half of each one's share of the sum of squares, so sigma may be less by sqrt 2; a view's right-hand side is at
     * least half of both. */
    const double bound = 4 * spread_of(&s, 2 * inverse, c.options.algebra) + 64 * ET_UNIT * 8 * inverse * (double)s.rows;
    ok = true;
    et_shell_gather(found, nov, &f.shell);
    for (size_t i = 0; ok && i < nov; i++)
        ok = gen_check(g, et_vec3_distance(planted[i], found[i]) <= bound, "class %zu is off by %g, bound %g", i + 1,
                       et_vec3_distance(planted[i], found[i]), bound);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* The same at sizes beyond every block, tile and strip inside; conditions are those of the two directions, multiplied. */
/* One case in 2. */
verdict prop_fit_make_planted_large(gen *g)
{
    enum { NX = 40, NY = 24, CX = 24, CY = 20 };
    const et_doublenet net = {gen_between(g, 17, NX), gen_between(g, 3, NY)};
    et_fit_options o = et_fit_defaults();
    static et_vec3 data[2 * NX * NY], planted[2 * CX * CY], found[2 * CX * CY];
    double A[NX * CX], d2 = 0;
    et_fit frame, f;
    bool ok = true;

    o.control = (et_doublenet){gen_between(g, 4, net.nx < CX ? net.nx : CX), gen_between(g, 2, net.ny < CY ? net.ny : CY)};
    o.q = o.control.ny > 3 ? 3 : o.control.ny - 1;
    o.approach = (et_fit_approach)gen_upto(g, 2);
    o.method = ET_PARAM_UNIFORM;
    const size_t nov = et_doublenet_nov(net), knov = et_doublenet_nov(o.control);
    memset(data, 0, sizeof data);
    if (et_fit_make(&frame, data, nov, net, &o, NULL) != ET_OK)
        return FAIL;
    for (size_t i = 0; i < knov; i++)
        planted[i] = (et_vec3){(double)((i * 7) % 17) - 8, (double)gen_upto(g, 16) - 8, (double)((i * i) % 13) - 8};
    o.algebra = o.approach == ET_FIT_JOINT ? ET_LINALG_QR : (et_linalg_method)gen_upto(g, 1);
    et_shell_scatter(&frame.shell, planted, knov);
    for (size_t w = 2; w-- > 0;) {
        static et_vec3 S[NX * NY];
        et_surface_grid(S, &frame.shell.view[w], frame.s[w], net.nx, frame.r[w], net.ny);
        for (size_t i = 0; i < net.nx * net.ny; i++) {
            data[et_doublenet_class(net, w, i / net.ny, i % net.ny) - 1] = S[i];
            d2 += S[i].x * S[i].x + S[i].y * S[i].y + S[i].z * S[i].z;
        }
    }
    basis_matrix(A, frame.s[0], net.nx, frame.shell.view[0].u, o.control.nx, o.p);
    double inverse = inverse_norm(A, net.nx, o.control.nx), condition = inverse * norm(A, net.nx * o.control.nx);
    basis_matrix(A, frame.r[0], net.ny, frame.shell.view[0].v, o.control.ny, o.q);
    const double across = inverse_norm(A, net.ny, o.control.ny);
    condition *= across * norm(A, net.ny * o.control.ny);
    inverse *= 2 * across;
    et_fit_free(&frame);
    if (!(inverse < HUGE_VAL) || et_fit_make(&f, data, nov, net, &o, NULL) != ET_OK)
        return SKIP;
    const double c = 64 * (double)((net.nx + 8) * (net.ny + 8)) * ET_UNIT;
    const double bound = c * (1 + condition) * (o.algebra == ET_LINALG_CHOLESKY ? 1 + condition : 1) * inverse * sqrt(d2);
    et_shell_gather(found, knov, &f.shell);
    for (size_t i = 0; ok && i < knov; i++)
        ok = gen_check(g, et_vec3_distance(planted[i], found[i]) <= bound, "class %zu is off by %g, bound %g", i + 1,
                       et_vec3_distance(planted[i], found[i]), bound);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- scaled, moved, turned data ---- */

static bool scaled(gen *g, const problem *c, const et_fit *f, int k)
{
    problem d = *c;
    et_fit h;
    bool ok = true;

    for (size_t i = 0; i < c->nov; i++)
        d.data[i] = (et_vec3){ldexp(c->data[i].x, k), ldexp(c->data[i].y, k), ldexp(c->data[i].z, k)};
    if (!gen_check(g, et_fit_make(&h, d.data, d.nov, d.net, &d.options, NULL) == ET_OK, "scaled: not solved"))
        return false;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c->options.control.nx * c->options.control.ny; i++) {
            const et_vec3 a = f->shell.view[w].points[i], b = h.shell.view[w].points[i];
            ok = gen_check(g, b.x == ldexp(a.x, k) && b.y == ldexp(a.y, k) && b.z == ldexp(a.z, k), "scaled by 2^%d: (%a, %a, %a) from (%a, %a, %a)", k, b.x,
                           b.y, b.z, a.x, a.y, a.z) && ok;
        }
    et_fit_free(&h);
    return ok;
}

static bool moved(gen *g, const problem *c, const et_fit *f, double bound)
{
    problem d = *c;
    et_fit h;
    bool ok = true;

    for (size_t i = 0; i < c->nov; i++)
        d.data[i] = (et_vec3){c->data[i].x + 4, c->data[i].y - 8, c->data[i].z + 2};
    if (!gen_check(g, et_fit_make(&h, d.data, d.nov, d.net, &d.options, NULL) == ET_OK, "moved: not solved"))
        return false;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c->options.control.nx * c->options.control.ny; i++) {
            const et_vec3 a = f->shell.view[w].points[i], b = h.shell.view[w].points[i], e = {a.x + 4, a.y - 8, a.z + 2};
            ok =
                gen_check(g, et_vec3_distance(e, b) <= bound, "moved: control point %zu off by %g, bound %g", i, et_vec3_distance(e, b), bound) && ok;
        }
    et_fit_free(&h);
    return ok;
}

static bool turned(gen *g, const problem *c, const et_fit *f, double bound)
{
    problem d = *c;
    et_fit h;
    const size_t nx = c->net.nx, ny = c->net.ny, kx = c->options.control.nx, ky = c->options.control.ny;
    bool ok = true;

    d.net = (et_doublenet){ny, nx};
    d.options.control = (et_doublenet){ky, kx};
    d.options.p = c->options.q;
    d.options.q = c->options.p;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < nx; i++)
            for (size_t j = 0; j < ny; j++)
                d.data[et_doublenet_class(d.net, w, j, i) - 1] = c->data[et_doublenet_class(c->net, w, i, j) - 1];
    if (!gen_check(g, et_fit_make(&h, d.data, d.nov, d.net, &d.options, NULL) == ET_OK, "turned: not solved"))
        return false;
    for (size_t w = 0; w < 2; w++) {
        ok = gen_check(g, memcmp(f->s[w], h.r[w], nx * sizeof(double)) == 0 && memcmp(f->r[w], h.s[w], ny * sizeof(double)) == 0,
                       "turned parameters") &&
             ok;
        for (size_t i = 0; i < kx; i++)
            for (size_t j = 0; j < ky; j++) {
                const double off = et_vec3_distance(f->shell.view[w].points[i * ky + j], h.shell.view[w].points[j * kx + i]);
                ok = gen_check(g, off <= bound, "turned: control point (%zu,%zu) off by %g, bound %g", i, j, off, bound) && ok;
            }
    }
    et_fit_free(&h);
    return ok;
}

verdict prop_fit_make_symmetry(gen *g)
{
    static system_ s;
    problem c;
    et_fit f;
    double bound = 0;

    draw_options(g, &c);
    draw_pillow(g, &c); /* coordinates need few bits, so that moving them is exact: see below */
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){floor(256 * c.data[i].x) / 256, floor(256 * c.data[i].y) / 256, floor(256 * c.data[i].z) / 256};
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    for (size_t w = 0; w < 2; w++) {
        assemble(&s, &c, &f, w, 1, 0);
        const double inverse = inverse_norm(s.A, s.rows, s.columns);
        if (!(inverse < HUGE_VAL)) {
            et_fit_free(&f);
            return SKIP;
        }
        for (size_t i = 0; i < 3 * s.rows; i++)
            s.rhs[i] = fabs(s.rhs[i]) + 8;
        bound = fmax(bound, 8 * spread_of(&s, 2 * inverse, c.options.algebra));
    }
    /* LAPACK's SVD driver scales right-hand sides only at the ends of the exponent range, so all methods commute with powers of two. */
    const bool ok = scaled(g, &c, &f, (int)gen_between(g, 1, 60) - 30) && moved(g, &c, &f, bound) && turned(g, &c, &f, bound);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- hard data: all one point, a plane, a line ---- */

static void flatten(gen *g, problem *c)
{
    const size_t kind = gen_upto(g, 3);

    for (size_t i = 0; i < c->nov; i++) {
        if (kind == 0)
            c->data[i] = c->data[0];
        if (kind == 1)
            c->data[i].z = 0.5;
        if (kind == 2)
            c->data[i].y = c->data[i].z = -1;
        if (kind == 3 && gen_upto(g, 1))
            c->data[i] = c->data[i / 2];
    }
    gen_label(g, kind == 0 ? "a point" : kind == 1 ? "a plane" : kind == 2 ? "a line" : "coincident");
}

verdict prop_fit_make_degenerate(gen *g)
{
    static system_ s;
    problem c;
    et_fit f, frame;
    et_message message = {"untouched"};
    bool ok;

    draw_options(g, &c);
    draw_pillow(g, &c);
    flatten(g, &c);
    if (!frame_of(&frame, &c))
        return FAIL;
    const et_status status = et_fit_make(&f, c.data, c.nov, c.net, &c.options, &message);
    ok = status_right(g, status, &message, &c, &frame);
    et_fit_free(&frame);
    if (status != ET_OK)
        return ok ? PASS : FAIL;
    ok = ok && gen_check(g, et_shell_valid(&f.shell), "not a shell");
    /* A coordinate constant in the data is constant in the control points, as far as the system determines them. */
    assemble(&s, &c, &f, 0, 1, 0);
    const double inverse = inverse_norm(s.A, s.rows, s.columns);
    assemble(&s, &c, &f, 1, 1, 0);
    const double bound = 8 * spread_of(&s, 2 * fmax(inverse, inverse_norm(s.A, s.rows, s.columns)), c.options.algebra);
    bool constant = true;
    for (size_t i = 0; i < c.nov; i++)
        constant = constant && c.data[i].z == c.data[0].z;
    for (size_t i = 0; constant && bound < HUGE_VAL && i < c.options.control.nx * c.options.control.ny; i++)
        ok = gen_check(g, fabs(f.shell.view[1].points[i].z - c.data[0].z) <= bound, "off its plane by %g, bound %g",
                       fabs(f.shell.view[1].points[i].z - c.data[0].z), bound) &&
             ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- what is refused ---- */

static bool refused(gen *g, const problem *c, const et_fit_options *o, size_t nov, et_doublenet net, const char *word)
{
    et_message message = {""};
    et_fit f;
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;
    const et_status status = et_fit_make(&f, c->data, nov, net, o, &message);

    return gen_check(g, status == ET_EINVAL && memcmp(&f, &was, sizeof f) == 0, "%s: status %d", word, (int)status) &&
           gen_check(g, strstr(message.text, word) != NULL, "message: %s (no \"%s\")", message.text, word) &&
           gen_check(g, et_fit_make(&f, c->data, nov, net, o, NULL) == ET_EINVAL, "without a message");
}

verdict prop_fit_make_refuses(gen *g)
{
    problem c;
    et_fit_options o;
    bool ok;

    draw_options(g, &c);
    draw_pillow(g, &c);
    const et_fit_options good = c.options;
    ok = refused(g, &c, &good, c.nov + 1, c.net, "classes");
    ok = refused(g, &c, &good, c.nov, (et_doublenet){1, c.net.ny}, "classes") && ok;
    for (size_t k = 0; k < 13; k++) {
        static const char *const words[] = {"enumeration", "enumeration", "enumeration", "enumeration", "enumeration", "larger",   "larger",
                                            "degrees",     "degrees",     "degrees",     "degrees",     "too small",   "too small"};
        o = good;
        o.approach = k == 0 ? (et_fit_approach)3 : o.approach;
        o.method = k == 1 ? (et_param_method)4 : o.method;
        o.knots = k == 2 ? (et_knotrule_kind)4 : o.knots;
        o.algebra = k == 3 ? (et_linalg_method)3 : o.algebra;
        o.corners = k == 4 ? (et_fit_corners)3 : o.corners;
        o.control.nx = k == 5 ? c.net.nx + 1 : k == 11 ? 1 : o.control.nx;
        o.control.ny = k == 6 ? c.net.ny + 1 : k == 12 ? 1 : o.control.ny;
        o.p = k == 7 ? 0 : k == 8 ? o.control.nx : o.p;
        o.q = k == 9 ? 0 : k == 10 ? o.control.ny : o.q;
        ok = refused(g, &c, &o, c.nov, c.net, words[k]) && ok;
    }
    o = good;
    o.knots = ET_KNOTRULE_AVERAGING;
    if (o.control.nx < c.net.nx || o.control.ny < c.net.ny)
        ok = refused(g, &c, &o, c.nov, c.net, "averaged") && ok;
    return ok ? PASS : FAIL;
}
