#include "exact/exact_sums_parts.h"

double et_exact_real_sum(const double *x, size_t n)
{
    slong e = WORD_MAX;
    fmpz_t t;
    fmpq_t sum;
    for (size_t k = 0; k < n; k++) {
        e = exact_place(e, x[k]);
    }
    if (e == WORD_MAX) {                  /* nothing but zeros */
        return 0.0;
    }
    fmpz_init(t);
    fmpq_init(sum);
    for (size_t k = 0; k < n; k++) {
        exact_integer(t, x[k], e);
        fmpz_add(fmpq_numref(sum), fmpq_numref(sum), t);
    }
    exact_scale(sum, e);
    double s = exact_round(sum);
    fmpz_clear(t);
    fmpq_clear(sum);
    return s;
}

/* q = a - b. */
static void difference(fmpq_t q, double a, double b)
{
    fmpq_t t;
    fmpq_init(t);
    exact_set(q, a);
    exact_set(t, b);
    fmpq_sub(q, q, t);
    fmpq_clear(t);
}

double et_exact_vec3_distance(et_vec3 a, et_vec3 b)
{
    fmpq_t d, square;
    fmpq_init(d);
    fmpq_init(square);
    difference(d, a.x, b.x);
    fmpq_mul(square, d, d);
    difference(d, a.y, b.y);
    fmpq_addmul(square, d, d);
    difference(d, a.z, b.z);
    fmpq_addmul(square, d, d);
    double r = exact_round_sqrt(square);
    fmpq_clear(d);
    fmpq_clear(square);
    return r;
}

/* (own - offset) / scale. */
static double to_unit(double own, double offset, double scale)
{
    fmpq_t q, s;
    fmpq_init(q);
    fmpq_init(s);
    difference(q, own, offset);
    exact_set(s, scale);
    fmpq_div(q, q, s);
    double unit = exact_round(q);
    fmpq_clear(q);
    fmpq_clear(s);
    return unit;
}

/* offset + scale unit. */
static double from_unit(double unit, double offset, double scale)
{
    fmpq_t q, s, t;
    fmpq_init(q);
    fmpq_init(s);
    fmpq_init(t);
    exact_set(q, offset);
    exact_set(s, scale);
    exact_set(t, unit);
    fmpq_addmul(q, s, t);
    double own = exact_round(q);
    fmpq_clear(q);
    fmpq_clear(s);
    fmpq_clear(t);
    return own;
}

void et_exact_frame_to_unit(et_vec3 *points, size_t n, const et_frame *frame)
{
    et_vec3 o = frame->offset, s = frame->scale;
    for (size_t k = 0; k < n; k++) {
        et_vec3 P = points[k];
        points[k] = (et_vec3){to_unit(P.x, o.x, s.x), to_unit(P.y, o.y, s.y), to_unit(P.z, o.z, s.z)};
    }
}

void et_exact_frame_from_unit(et_vec3 *points, size_t n, const et_frame *frame)
{
    et_vec3 o = frame->offset, s = frame->scale;
    for (size_t k = 0; k < n; k++) {
        et_vec3 P = points[k];
        points[k] = (et_vec3){from_unit(P.x, o.x, s.x), from_unit(P.y, o.y, s.y), from_unit(P.z, o.z, s.z)};
    }
}
