#include "etalon/base/real.h"
#include "etalon/fit/knotrule.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <string.h>

enum { P_MOST = 4, CONTROL = 10, PARAMETERS = 24, KNOTS = CONTROL + P_MOST + 2 };

verdict prop_knotrule_name(gen *g)
{
    static const char *const names[] = {"piegl", "faithful", "uniform", "averaging"};
    const size_t k = gen_upto(g, 6);
    const char *name = et_knotrule_name((et_knotrule_kind)k);

    return gen_check(g, k < 4 ? name != NULL && strcmp(name, names[k]) == 0 : name == NULL, "name %zu", k) &&
                   gen_check(g, et_knotrule_name((et_knotrule_kind)-1) == NULL, "name of -1")
               ? PASS
               : FAIL;
}

verdict gold_knotrule_name(const row *r)
{
    const char *name = et_knotrule_name((et_knotrule_kind)row_size(r, 0));

    return strcmp(name == NULL ? "null" : name, r->want[0]) == 0 ? PASS : FAIL;
}

/* Parameters as multiples of 1/1024, so that short sums are exact; steps of zero come often.  *simple: strictly increasing. */
static void draw_parameters(gen *g, double *t, size_t nt, bool *simple)
{
    uint64_t at[PARAMETERS] = {0};

    *simple = true;
    for (size_t i = 1; i < nt; i++) {
        const uint64_t step = gen_upto(g, 3) ? gen_upto(g, 1000) + 1 : gen_upto(g, 1);
        at[i] = at[i - 1] + step;
    }
    for (size_t i = 0; i < nt; i++) {
        t[i] = i == 0 ? 0 : i == nt - 1 ? 1 : at[nt - 1] == 0 ? 0 : floor(1024 * (double)at[i] / (double)at[nt - 1]) / 1024;
        *simple = *simple && (i == 0 || t[i] > t[i - 1]);
    }
}

/* Interior knot j of `spans`, in another way: i by search, alpha by one division, the chord's form of the line. */
static double second(const double *t, size_t nt, size_t p, size_t j, size_t spans, et_knotrule_kind kind)
{
    size_t i = 0;
    double sum = 0;

    if (kind == ET_KNOTRULE_UNIFORM)
        return (double)j / (double)spans;
    if (kind != ET_KNOTRULE_PIEGL) {
        for (size_t k = j + p; k-- > j;)
            sum += 1024 * t[k];
        return sum / (double)(1024 * p);
    }
    while ((i + 1) * spans <= j * nt)
        i++;
    return t[i - 1] + (double)(j * nt - i * spans) / (double)spans * (t[i] - t[i - 1]);
}

/* Schoenberg and Whitney: parameters can be chosen, in order, one inside the support of each basis function (the end ones sit at the ends). */
static bool interlaced(const double *u, size_t control, size_t p, const double *t, size_t nt)
{
    size_t j = 0;

    for (size_t i = 0; i < nt && j < control; i++) {
        const bool inside = u[j] < t[i] && t[i] < u[j + p + 1];
        if (inside || (j == 0 && t[i] == 0) || (j == control - 1 && t[i] == 1))
            j++;
    }
    return j == control;
}

static bool spans_hold(const double *u, size_t control, size_t p, const double *t, size_t nt)
{
    for (size_t k = p; k < control; k++) {
        bool held = false;
        for (size_t i = 0; i < nt; i++)
            held = held || (u[k] <= t[i] && t[i] <= u[k + 1]);
        if (!held)
            return false;
    }
    return true;
}

static bool refuses(gen *g, size_t p, const double *t, size_t nt, size_t nu)
{
    double u[KNOTS + 2], was[KNOTS + 2];
    bool ok = true;

    for (size_t i = 0; i < KNOTS + 2; i++)
        u[i] = was[i] = 5;
    ok = ok && et_knotrule_make(u, nu, 0, t, nt, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_knotrule_make(u, 2 * p + 1, p, t, nt, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_knotrule_make(u, 1, p, t, nt, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_knotrule_make(u, nu, p, t, 1, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_knotrule_make(u, nu, p, t, nt, (et_knotrule_kind)4) == ET_EINVAL;
    ok = ok && (nt == nu - p - 1 || et_knotrule_make(u, nu, p, t, nt, ET_KNOTRULE_AVERAGING) == ET_EINVAL);
    ok = ok && et_knotrule_make(u, nu, p, t, nu - p - 2, ET_KNOTRULE_PIEGL) == ET_EINVAL;
    ok = ok && et_knotrule_make(u, nu, p, t, nu - p - 2, ET_KNOTRULE_FAITHFUL) == ET_EINVAL;
    return gen_check(g, ok && memcmp(u, was, sizeof u) == 0, "bad arguments");
}

static bool knots_right(gen *g, const double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind)
{
    const size_t control = nu - p - 1, spans = control - p;

    for (size_t i = 0; i <= p; i++)
        if (!gen_check(g, u[i] == 0 && u[nu - 1 - i] == 1, "clamped at %zu", i))
            return false;
    for (size_t i = 1; i < nu; i++)
        if (!gen_check(g, u[i - 1] <= u[i], "knots %zu: %a, %a", i, u[i - 1], u[i]))
            return false;
    for (size_t j = 1; j < spans; j++) {
        const double expect = second(t, nt, p, j, spans, kind);
        /* PIEGL: each form errs by at most 3u of t_i.  The others: sums of multiples of 1/1024 are exact, one rounding is left. */
        const double bound = kind == ET_KNOTRULE_PIEGL ? 6 * ET_UNIT * expect : 0;
        if (!gen_check(g, fabs(u[p + j] - expect) <= bound, "knot %zu is %a, not %a", p + j, u[p + j], expect))
            return false;
    }
    return true;
}

verdict prop_knotrule_make(gen *g)
{
    const size_t p = gen_between(g, 1, P_MOST), control = gen_between(g, p + 1, CONTROL), nu = control + p + 1;
    const et_knotrule_kind kind = (et_knotrule_kind)gen_upto(g, 3);
    const size_t nt = kind == ET_KNOTRULE_AVERAGING ? control : gen_between(g, control, PARAMETERS);
    double t[PARAMETERS], u[KNOTS + 1], v[KNOTS + 1];
    bool simple;

    draw_parameters(g, t, nt, &simple);
    u[nu] = 5;
    if (!refuses(g, p, t, nt, nu) || !gen_check(g, et_knotrule_make(u, nu, p, t, nt, kind) == ET_OK && u[nu] == 5, "made"))
        return FAIL;
    if (!knots_right(g, u, nu, p, t, nt, kind))
        return FAIL;
    if (kind == ET_KNOTRULE_PIEGL && !gen_check(g, spans_hold(u, control, p, t, nt), "a span without a parameter"))
        return FAIL;
    if (simple && (kind == ET_KNOTRULE_PIEGL || kind == ET_KNOTRULE_AVERAGING) &&
        !gen_check(g, interlaced(u, control, p, t, nt), "Schoenberg-Whitney, %zu of %zu, degree %zu", control, nt, p))
        return FAIL;
    /* The source's rule looks at the first parameters only. */
    if (kind == ET_KNOTRULE_FAITHFUL &&
        !gen_check(g, et_knotrule_make(v, nu, p, t, control, ET_KNOTRULE_AVERAGING) == ET_OK && memcmp(u, v, nu * sizeof *u) == 0,
                   "first h + 1 only"))
        return FAIL;
    gen_label(g, et_knotrule_name(kind));
    return PASS;
}

/* Rounded parameters of any kind: what must hold holds as rounded, and spacings of one ulp too. */
verdict prop_knotrule_make_rounded(gen *g)
{
    const size_t p = gen_between(g, 1, P_MOST), control = gen_between(g, p + 1, CONTROL), nu = control + p + 1;
    const size_t nt = gen_between(g, control, PARAMETERS);
    double t[PARAMETERS], u[KNOTS];

    t[0] = 0;
    for (size_t i = 1; i < nt; i++) {
        const uint64_t kind = gen_upto(g, 3);
        t[i] = kind == 0 ? t[i - 1] : kind == 1 ? nextafter(t[i - 1], 2) : t[i - 1] + (1 - t[i - 1]) * gen_real(g, 0, 1);
        t[i] = fmin(t[i], 1);
    }
    t[nt - 1] = 1;
    for (size_t k = 0; k < 3; k++) {
        if (!gen_check(g, et_knotrule_make(u, nu, p, t, nt, (et_knotrule_kind)k) == ET_OK, "made"))
            return FAIL;
        for (size_t i = 1; i < nu; i++)
            if (!gen_check(g, u[i - 1] <= u[i] && u[i] <= 1, "rule %zu: knots %a, %a", k, u[i - 1], u[i]))
                return FAIL;
    }
    return PASS;
}

/* Rows: kind p nu nt, then t; wanted: interior knots. */
verdict gold_knotrule_make(const row *r)
{
    const size_t p = row_size(r, 1), nu = row_size(r, 2), nt = row_size(r, 3);
    double t[64], u[64];
    bool ok;

    for (size_t i = 0; i < nt; i++)
        t[i] = row_real(r, 4 + i);
    ok = et_knotrule_make(u, nu, p, t, nt, (et_knotrule_kind)row_size(r, 0)) == ET_OK;
    for (size_t i = p + 1; ok && i < nu - p - 1; i++)
        ok = row_is(r, i - p - 1, u[i]);
    return ok ? PASS : FAIL;
}

/* kind p nu nt t, too many of them or too few. */
verdict gold_knotrule_make_status(const row *r)
{
    const size_t nu = row_size(r, 2), nt = row_size(r, 3);
    double t[64] = {0}, u[64];

    if (nu > 64 || nt > 64 || r->nargs != 4 + nt)
        return FAIL;
    for (size_t i = 0; i < nt; i++)
        t[i] = row_real(r, 4 + i);
    return row_is_size(r, 0, (size_t)et_knotrule_make(u, nu, row_size(r, 1), t, nt, (et_knotrule_kind)row_size(r, 0))) ? PASS : FAIL;
}
