/* judge_shape: the verdict of replies that are curves and surfaces. */
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void wrong(et_judgement *j, double got, double want, const char *what)
{
    j->got = got;
    j->want = want;
    j->ratio = INFINITY;
    judge_say(j, ET_VERDICT_WRONG, "%s is %.17g, should be %.17g", what, got, want);
}

/* 1 if the numbers from `at` on are one curve or surface and nothing else; ET_ENOMEM. */
static et_status read_shape(judge_shape *f, const et_reply *reply, size_t at, int curve)
{
    memset(f, 0, sizeof *f);
    f->curve = curve;
    et_status status = curve ? et_reply_get_curve(&f->c, &at, reply) : et_reply_get_surface(&f->s, &at, reply);
    if (status == ET_OK && at != reply->count) {
        judge_shape_free(f);
        status = ET_EFORMAT;
    }
    return status;
}

static et_status put_shape(et_reply *reply, const judge_shape *f)
{
    return f->curve ? et_reply_put_curve(reply, &f->c) : et_reply_put_surface(reply, &f->s);
}

static double **weights_of(judge_shape *f)
{
    return f->curve ? &f->c.weights : &f->s.weights;
}

/* Degrees and sizes; 1 if they are the same. */
static int same_sizes(et_judgement *j, const judge_shape *got, const judge_shape *want)
{
    const size_t g[4] = { got->curve ? got->c.p : got->s.p, got->s.q, got->curve ? got->c.n : got->s.nu, got->s.nv };
    const size_t w[4] = { want->curve ? want->c.p : want->s.p, want->s.q, want->curve ? want->c.n : want->s.nu, want->s.nv };
    static const char *const names[4] = { "the degree", "the degree in v", "the number of control points", "the number of control points in v" };

    for (size_t k = 0; k < 4; k++)
        if (g[k] != w[k]) {
            wrong(j, (double)g[k], (double)w[k], names[k]);
            return 0;
        }
    return 1;
}

/* The factor that weights have in common beside those wanted, by the greatest, is taken out of them. */
static void take_factor(double *got, const double *want, size_t n)
{
    size_t greatest = 0;

    for (size_t i = 1; i < n; i++)
        if (want[i] > want[greatest])
            greatest = i;
    const double g = got[greatest], w = want[greatest], f = g / w;
    if (!(g > 0 && isfinite(g)) || f == 1)
        return;
    /* Where the factor itself would lose digits, or be none, it is taken out in two steps. */
    for (size_t i = 0; i < n; i++)
        got[i] = f >= 0x1p-1000 && f <= 0x1p1000 ? got[i] / f : got[i] / g * w;
}

/* The same weights, or all equal and none. */
static et_status match_weights(judge_shape *got, const judge_shape *want, double tolerance)
{
    const size_t n = judge_shape_size(want);
    double **w = weights_of(got);
    const double *wanted = judge_shape_weights(want);

    if (wanted && !*w) {
        *w = et_size_array(n, sizeof **w);
        if (!*w)
            return ET_ENOMEM;
        for (size_t i = 0; i < n; i++)
            (*w)[i] = 1;
    }
    if (wanted) {
        take_factor(*w, wanted, n);
        return ET_OK;
    }
    for (size_t i = 0; *w && i < n; i++)
        if (!((*w)[i] > 0 && isfinite((*w)[0]) && fabs((*w)[i] / (*w)[0] - 1) <= tolerance))
            return ET_EFORMAT;
    free(*w);
    *w = NULL;
    return ET_OK;
}

/* got becomes a reply in the order of want. */
static et_status compare_shapes(et_judgement *j, const et_request *request, const et_truth *truth, judge_shape *got, const judge_shape *want)
{
    et_reply aligned = { ET_REPLY_OK, 0, NULL, "" };
    judge_shape f;
    judge_editing e;

    judge_edit_of(&f, &e, request);
    et_status status = match_weights(got, want, 2 * judge_edit_k(&f, &e) * ET_UNIT);
    if (status == ET_EFORMAT) {
        j->ratio = INFINITY;
        judge_say(j, ET_VERDICT_WRONG, "weights of a polynomial that are not all equal");
        return ET_OK;
    }
    if (status == ET_OK)
        status = put_shape(&aligned, got);
    if (status == ET_OK && aligned.count == truth->count)
        judge_compare(j, request, aligned.x, truth->want, truth->bound, truth->count);
    et_reply_free(&aligned);
    return status;
}

/* The wanted numbers as the curve or surface that they are. */
static et_status wanted_shape(judge_shape *f, const et_truth *truth, size_t at, int curve)
{
    const et_reply want = { ET_REPLY_OK, truth->count, truth->want, "" };
    const et_status status = read_shape(f, &want, at, curve);

    return status == ET_EFORMAT ? ET_EINVAL : status;
}

static et_status no_shape(et_judgement *j, const et_reply *reply, et_status status)
{
    if (status == ET_EFORMAT) {
        j->ratio = INFINITY;
        judge_say(j, ET_VERDICT_WRONG, "%zu numbers that are not what was asked for", reply->count);
        status = ET_OK;
    }
    return status;
}

et_status judge_edit(et_judgement *j, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    const int curve = request->op == ET_OP_CURVE_INSERT || request->op == ET_OP_CURVE_ELEVATE;
    judge_shape got, want;
    et_status status = wanted_shape(&want, truth, 0, curve);

    if (status != ET_OK)
        return status;
    status = read_shape(&got, reply, 0, curve);
    if (status == ET_OK) {
        if (same_sizes(j, &got, &want))
            status = compare_shapes(j, request, truth, &got, &want);
        judge_shape_free(&got);
    } else {
        status = no_shape(j, reply, status);
    }
    judge_shape_free(&want);
    return status;
}

/* ---- removal ---- */

typedef struct {
    judge_shape f;                        /* the original, in the request's memory */
    judge_editing e;
    const double *u;                      /* its knots in the direction */
    size_t p, nu, n, t;
    double allowed, slack;                /* tol + K u max |c|, and K u max |c| */
} removal;

static void removal_of(removal *r, const et_request *request)
{
    double most = 0;

    judge_edit_of(&r->f, &r->e, request);
    const int v = !r->f.curve && r->e.along == ET_ALONG_V;
    r->u = r->f.curve ? r->f.c.u : v ? r->f.s.v : r->f.s.u;
    r->p = r->f.curve ? r->f.c.p : v ? r->f.s.q : r->f.s.p;
    r->n = r->f.curve ? r->f.c.n : v ? r->f.s.nv : r->f.s.nu;
    r->nu = r->n + r->p + 1;
    for (size_t i = 0; i < judge_shape_size(&r->f); i++)
        for (size_t c = 0; c < 3; c++)
            most = fmax(most, fabs(judge_coordinate(&judge_shape_points(&r->f)[i], c)));
    r->slack = judge_edit_k(&r->f, &r->e) * ET_UNIT * most;
    r->allowed = r->e.tolerance + r->slack;
}

/* t and what knots are left; 1 if all is as it must be. */
static int knots_left(et_judgement *j, const removal *r, const judge_shape *got, size_t least)
{
    const int v = !r->f.curve && r->e.along == ET_ALONG_V;
    const double *u = got->curve ? got->c.u : v ? got->s.v : got->s.u;
    judge_shape want = r->f;
    size_t multiplicity = 0, skipped = 0;

    for (size_t i = 0; i < r->nu; i++)
        multiplicity += r->u[i] == r->e.x;
    if (r->t < least || r->t > r->e.r || r->t > multiplicity) {
        wrong(j, (double)r->t, (double)(r->t < least ? least : r->e.r < multiplicity ? r->e.r : multiplicity),
              r->t < least ? "t, the least that is possible without any change," : "t");
        return 0;
    }
    *(got->curve ? &want.c.n : v ? &want.s.nv : &want.s.nu) -= r->t;
    if (!same_sizes(j, got, &want))
        return 0;
    for (size_t i = 0; i + r->t < r->nu; i++) {
        while (skipped < r->t && r->u[i + skipped] == r->e.x)
            skipped++;
        if (u[i] != r->u[i + skipped]) {
            wrong(j, u[i], r->u[i + skipped], "a knot");
            return 0;
        }
    }
    const double *across = got->curve ? NULL : v ? got->s.u : got->s.v, *kept = got->curve ? NULL : v ? r->f.s.u : r->f.s.v;
    const size_t n = got->curve ? 0 : v ? r->f.s.nu + r->f.s.p + 1 : r->f.s.nv + r->f.s.q + 1;
    for (size_t i = 0; i < n; i++)
        if (across[i] != kept[i]) {
            wrong(j, across[i], kept[i], "a knot");
            return 0;
        }
    return 1;
}

/* Not finite, or a weight that is not positive. */
static int usable(et_judgement *j, const judge_shape *got)
{
    const size_t n = judge_shape_size(got);
    const double *w = judge_shape_weights(got);

    if (!et_vec3_finite(judge_shape_points(got), n)) {
        judge_say(j, ET_VERDICT_NON_FINITE, "a control point is not finite");
        return 0;
    }
    for (size_t i = 0; w && i < n; i++)
        if (!(w[i] > 0 && isfinite(w[i]))) {
            judge_say(j, isfinite(w[i]) ? ET_VERDICT_WRONG : ET_VERDICT_NON_FINITE, "weight %zu is %g", i, w[i]);
            j->ratio = INFINITY;
            return 0;
        }
    return 1;
}

static double box(const judge_shape *f)
{
    double side[3];

    for (size_t c = 0; c < 3; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < judge_shape_size(f); i++) {
            lo = fmin(lo, judge_coordinate(&judge_shape_points(f)[i], c));
            hi = fmax(hi, judge_coordinate(&judge_shape_points(f)[i], c));
        }
        side[c] = hi - lo;
    }
    return judge_length(side);
}

/* The knot put back, exactly: no point of the curve has moved further than the control points about it, weights apart.  moved[i]: control point i. */
static et_status moved_points(double *moved, const removal *r, const judge_shape *got)
{
    judge_shape back = { .curve = got->curve };
    const size_t n = judge_shape_size(&r->f);
    const double *w = judge_shape_weights(&r->f), size = box(&r->f);
    const et_status status = got->curve ? et_exact_curve_insert(&back.c, &got->c, r->e.x, r->t)
                                        : et_exact_surface_insert(&back.s, &got->s, r->e.along, r->e.x, r->t);
    size_t heaviest = 0;

    for (size_t i = 0; i < n; i++)
        moved[i] = INFINITY;
    if (status != ET_OK)
        return status == ET_ENOMEM ? status : ET_OK;
    const double *b = judge_shape_weights(&back);
    for (size_t i = 0; w && i < n; i++)
        heaviest = w[i] > w[heaviest] ? i : heaviest;
    const double f = (b ? b[heaviest] : 1) / (w ? w[heaviest] : 1);
    for (size_t i = 0; i < n; i++) {
        const et_vec3 P = judge_shape_points(&back)[i], Q = judge_shape_points(&r->f)[i];
        const double by[3] = { P.x - Q.x, P.y - Q.y, P.z - Q.z };
        moved[i] = judge_length(by) + judge_times(2 * fabs((b ? b[i] : 1) / (f * (w ? w[i] : 1)) - 1), size);
    }
    judge_shape_free(&back);
    return ET_OK;
}

static et_status point(et_vec3 *P, const judge_shape *f, const double x[2], const int left[2])
{
    const et_side s[2] = { left[0] ? ET_SIDE_LEFT : ET_SIDE_RIGHT, left[1] ? ET_SIDE_LEFT : ET_SIDE_RIGHT };

    return f->curve ? et_exact_curve_ders_side(P, 0, &f->c, x[0], s[0]) : et_exact_surface_partials(P, 0, &f->s, x[0], x[1], s[0], s[1]);
}

/* Two points, correctly rounded: how far they are apart.  0 where that cannot be told: it proves nothing; *memory becomes ET_ENOMEM for want of it. */
static double apart(et_status *memory, const judge_shape *a, const judge_shape *b, const double x[2], const int left[2])
{
    et_vec3 A, B;
    const et_status s = point(&A, a, x, left), t = point(&B, b, x, left);

    if (s == ET_ENOMEM || t == ET_ENOMEM)
        *memory = ET_ENOMEM;
    return s == ET_OK && t == ET_OK ? et_exact_vec3_distance(A, B) : 0;
}

/* Sample i of a span [a,b]: 0 its left end, from inside, 2p + 2 its right end. */
static double sample(int *left, double a, double b, size_t i, size_t p)
{
    *left = i == 2 * p + 2;
    return i == 0 ? a : *left ? b : a + (b - a) * ((double)i / (double)(2 * p + 2));
}

/* The other direction: of a curve one span of one function. */
typedef struct { const double *t; size_t q, n; } across;

static across across_of(const removal *r)
{
    const int v = !r->f.curve && r->e.along == ET_ALONG_V;

    if (r->f.curve)
        return (across){ NULL, 0, 1 };
    return v ? (across){ r->f.s.u, r->f.s.p, r->f.s.nu } : (across){ r->f.s.v, r->f.s.q, r->f.s.nv };
}

/* 1 if a control point of the span (k, l) has moved too far. */
static int suspect(const removal *r, const across *a, const double *moved, size_t k, size_t l)
{
    const int v = !r->f.curve && r->e.along == ET_ALONG_V;

    for (size_t i = k - r->p; i <= k; i++)
        for (size_t j = l - a->q; j <= l; j++)
            if (!(moved[v ? j * r->n + i : i * a->n + j] <= r->allowed))
                return 1;
    return 0;
}

/* The greatest distance at the samples of a span. */
static double sample_span(et_status *memory, const removal *r, const across *a, const judge_shape *got, size_t k, size_t l)
{
    const int v = !r->f.curve && r->e.along == ET_ALONG_V;
    double most = 0;

    for (size_t i = 0; i <= 2 * r->p + 2; i++)
        for (size_t j = 0; j <= (a->t ? 2 * a->q + 2 : 0); j++) {
            int along, other = 0;
            const double x = sample(&along, r->u[k], r->u[k + 1], i, r->p), y = a->t ? sample(&other, a->t[l], a->t[l + 1], j, a->q) : 0;
            const double at[2] = { v ? y : x, v ? x : y };
            const int left[2] = { v ? other : along, v ? along : other };
            most = fmax(most, apart(memory, &r->f, got, at, left));
        }
    return most;
}

/* The greatest distance seen in the spans where control points have moved too far, until one is proved. */
static double moved_at_least(et_status *memory, const removal *r, const judge_shape *got, const double *moved)
{
    const across a = across_of(r);
    double most = 0;

    for (size_t k = r->p; k < r->n; k++)
        for (size_t l = a.q; l < a.n && most <= r->allowed + r->slack; l++)
            if (r->u[k] < r->u[k + 1] && (!a.t || a.t[l] < a.t[l + 1]) && suspect(r, &a, moved, k, l))
                most = fmax(most, sample_span(memory, r, &a, got, k, l));
    return most;
}

static et_status proofs(et_judgement *j, const removal *r, const judge_shape *got, double *moved)
{
    double most = 0;
    et_status status = moved_points(moved, r, got);

    for (size_t i = 0; i < judge_shape_size(&r->f); i++)
        most = fmax(most, isnan(moved[i]) ? INFINITY : moved[i]);
    if (status != ET_OK)
        return status;
    j->bound = r->allowed;
    j->verdict = ET_VERDICT_WITHIN_BOUND;
    j->ratio = most > 0 ? fmin(most / r->allowed, 1) : 0;
    if (most <= r->allowed)
        return ET_OK;
    const double least = moved_at_least(&status, r, got, moved);
    if (status == ET_OK && least > r->allowed + r->slack) {
        j->ratio = (least - r->e.tolerance) / r->slack;
        j->got = least;
        judge_say(j, j->ratio <= 0x1p20 ? ET_VERDICT_INACCURATE : ET_VERDICT_WRONG, "after removal a point is %.6g away, allowed are %.6g", least,
                  r->allowed);
    }
    return status;
}

/* Whether it is, to the bit, the exact result. */
static int equals_want(const et_truth *truth, const et_reply *reply)
{
    if (reply->count != truth->count)
        return 0;
    for (size_t i = 0; i < truth->count; i++)
        if (reply->x[i] != truth->want[i])
            return 0;
    return 1;
}

et_status judge_removal(et_judgement *j, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    removal r = { .t = 0 };
    judge_shape got;

    removal_of(&r, request);
    j->verdict = ET_VERDICT_CORRECTLY_ROUNDED;
    if (equals_want(truth, reply))
        return ET_OK;
    const double t = reply->count > 0 ? reply->x[0] : -1;
    if (!(t >= 0 && t <= 0x1p31 && floor(t) == t))
        return no_shape(j, reply, ET_EFORMAT);
    r.t = (size_t)t;
    et_status status = read_shape(&got, reply, 1, r.f.curve);
    if (status != ET_OK)
        return no_shape(j, reply, status);
    double *moved = et_size_array(judge_shape_size(&r.f), sizeof *moved);
    /* Where the tolerance is less than what rounding may cost, nobody can be sure that a knot goes. */
    if (!moved)
        status = ET_ENOMEM;
    else if (knots_left(j, &r, &got, r.e.tolerance >= r.slack ? (size_t)truth->want[0] : 0) && usable(j, &got))
        status = proofs(j, &r, &got, moved);
    free(moved);
    judge_shape_free(&got);
    return status;
}

/* ---- nearest points, approximations ---- */

/* A curve as a surface: straight and of no length across. */
static et_status ruled(et_surface *s, const et_curve *c)
{
    const et_status status = et_surface_new(s, c->p, 1, c->n, 2, c->weights != NULL);

    if (status != ET_OK)
        return status;
    memcpy(s->u, c->u, (c->n + c->p + 1) * sizeof *s->u);
    s->v[2] = s->v[3] = 1;
    for (size_t i = 0; i < 2 * c->n; i++) {
        s->points[i] = c->points[i / 2];
        if (c->weights)
            s->weights[i] = c->weights[i / 2];
    }
    return ET_OK;
}

/* The distance at the parameters, rounded once; at knots from the sides where it is least (there from points that are rounded themselves). */
static et_status distance_to(double *distance, const et_surface *s, const double x[2], const et_vec3 *P)
{
    double sum;
    et_status status = et_exact_surface_error(&sum, distance, s, x, 1, x + 1, 1, P);

    for (int side = 1; status == ET_OK && side < 4; side++) {
        const et_side u = side & 1 ? ET_SIDE_LEFT : ET_SIDE_RIGHT, v = side & 2 ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
        et_vec3 S;
        if (((side & 1) && !judge_jumps(s->u, s->nu + s->p + 1, s->p, x, 1)) || ((side & 2) && !judge_jumps(s->v, s->nv + s->q + 1, s->q, x + 1, 1)))
            continue;
        status = et_exact_surface_partials(&S, 0, s, x[0], x[1], u, v);
        if (status == ET_OK)
            *distance = fmin(*distance, et_exact_vec3_distance(S, *P));
    }
    return status;
}

et_status judge_distance_at(double *distance, const et_request *request, const double *x)
{
    const double at[2] = { x[0], request->op == ET_OP_CURVE_NEAREST ? 0 : x[1] };
    const et_curve c = judge_curve_of(request);
    et_surface s = judge_surface_of(request, 0);

    if (request->op == ET_OP_SURFACE_NEAREST)
        return distance_to(distance, &s, at, (const et_vec3 *)request->arg[6].x);
    et_status status = ruled(&s, &c);
    if (status != ET_OK)
        return status;
    status = distance_to(distance, &s, at, (const et_vec3 *)request->arg[4].x);
    et_surface_free(&s);
    return status;
}

static int in_domain(et_judgement *j, const et_request *request, const double *x)
{
    const int curve = request->op == ET_OP_CURVE_NEAREST;

    for (size_t k = 0; k < (curve ? 1u : 2u); k++) {
        const et_request_value *u = &request->arg[(curve ? 1 : 2) + k];
        const size_t p = request->arg[k].count;
        j->at = k;
        if (!isfinite(x[k])) {
            judge_say(j, ET_VERDICT_NON_FINITE, "the parameter is %a", x[k]);
            return 0;
        }
        if (!(u->x[p] <= x[k] && x[k] <= u->x[u->count - p - 1])) {
            j->got = x[k];
            j->ratio = INFINITY;
            judge_say(j, ET_VERDICT_WRONG, "the parameter %a (%.17g) is outside the domain", x[k], x[k]);
            return 0;
        }
    }
    return 1;
}

et_status judge_nearest(et_judgement *j, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    const size_t n = truth->count - 1;
    const double least = truth->want[n];
    double here, own;

    if (reply->count != truth->count) {
        judge_say(j, ET_VERDICT_WRONG, "%zu numbers instead of %zu", reply->count, truth->count);
        j->ratio = INFINITY;
        return ET_OK;
    }
    if (!in_domain(j, request, reply->x))
        return ET_OK;
    const double got = reply->x[n];
    const et_status status = judge_distance_at(&here, request, reply->x);
    if (status != ET_OK)
        return status;
    judge_nearest_bound(&own, request, least);
    const double off = here > least ? (here - least) / truth->bound[n] : 0, false_by = got == here ? 0 : fabs(got - here) / judge_bound(here, own);
    j->at = n;
    j->got = got;
    j->want = least;
    j->bound = truth->bound[n];
    j->ratio = fmax(off, false_by);
    j->verdict = !isfinite(got)                 ? ET_VERDICT_NON_FINITE
               : got == here && here <= least   ? ET_VERDICT_CORRECTLY_ROUNDED
               : j->ratio <= 1                  ? ET_VERDICT_WITHIN_BOUND
               : j->ratio <= 0x1p20             ? ET_VERDICT_INACCURATE
                                                : ET_VERDICT_WRONG;
    if (!isfinite(got))
        judge_say(j, j->verdict, "the distance is %a, should be %a (%.17g)", got, least, least);
    else if (et_judge_bad(j->verdict) && false_by > off)
        judge_say(j, j->verdict, "the distance is said to be %a, at that parameter it is %a (%.17g instead of %.17g): %.3g bounds off", got, here,
                  got, here, j->ratio);
    else if (et_judge_bad(j->verdict))
        judge_say(j, j->verdict, "a point %a (%.17g) away, the nearest is %a (%.17g): %.3g bounds off", here, here, least, least, j->ratio);
    return ET_OK;
}

/* A surface of the sizes asked for, over [0,1]^2. */
et_status judge_approximate(et_judgement *j, const et_request *request, const et_reply *reply)
{
    const et_request_value *a = request->arg;
    judge_shape got, want;
    const et_status status = read_shape(&got, reply, 0, 0);

    if (status != ET_OK)
        return no_shape(j, reply, status);
    memset(&want, 0, sizeof want);
    want.s = (et_surface){ a[0].count, a[1].count, a[2].count, a[3].count, NULL, NULL, NULL, NULL };
    const et_surface *s = &got.s;
    j->verdict = ET_VERDICT_WITHIN_BOUND;
    if (same_sizes(j, &got, &want) && usable(j, &got)
        && (!et_surface_valid(s) || s->u[s->p] != 0 || s->v[s->q] != 0 || s->u[s->nu] != 1 || s->v[s->nv] != 1)) {
        j->ratio = INFINITY;
        judge_say(j, ET_VERDICT_WRONG, "the knots are not those of a surface over [0,1]^2");
    }
    judge_shape_free(&got);
    return ET_OK;
}
