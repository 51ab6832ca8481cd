/* dd_parts: the operations of dd in place, for loops and for the elementary functions; bounds and ranges as in etalon/base/dd.h. */
#ifndef BASE_DD_PARTS_H
#define BASE_DD_PARTS_H
#include "etalon/base/dd.h"
#include <math.h>

/* a + b exactly for |a| >= |b|, or a = 0, or a a multiple of ulp(b) (Dekker's Fast2Sum). */
/*@ assigns \nothing; */
static inline et_dd dd_fast_two_sum(double a, double b)
{
    const double s = a + b;

    return (et_dd){s, b - (s - a)};
}

/*@ assigns \nothing; */
static inline et_dd dd_two_sum(double a, double b)
{
    const double s = a + b, b1 = s - a, a1 = s - b1;

    return (et_dd){s, (a - a1) + (b - b1)};
}

/* The upper 26 bits of a; the lower part, a less these, has at most 26 bits too (Veltkamp). */
/*@ assigns \nothing; */
static inline double dd_upper(double a)
{
    const double c = 0x1.0000002p+27 * a;

    return c - (c - a);
}

/*@ assigns \nothing; */
static inline et_dd dd_two_product(double a, double b)
{
    const double p = a * b, a1 = dd_upper(a), a2 = a - a1, b1 = dd_upper(b), b2 = b - b1;

    return (et_dd){p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

/*@ assigns \nothing; */
static inline et_dd dd_add(et_dd a, et_dd b)
{
    const et_dd s = dd_two_sum(a.hi, b.hi), t = dd_two_sum(a.lo, b.lo), v = dd_fast_two_sum(s.hi, s.lo + t.hi);

    return dd_fast_two_sum(v.hi, t.lo + v.lo);
}

/*@ assigns \nothing; */
static inline et_dd dd_negative(et_dd a)
{
    return (et_dd){-a.hi, -a.lo};
}

/* a + b within 2u^2 (JMP 4, DWPlusFP). */
/*@ assigns \nothing; */
static inline et_dd dd_add_double(et_dd a, double b)
{
    const et_dd s = dd_two_sum(a.hi, b);

    return dd_fast_two_sum(s.hi, a.lo + s.lo);
}

/*@ assigns \nothing; */
static inline et_dd dd_mul(et_dd a, et_dd b)
{
    const et_dd p = dd_two_product(a.hi, b.hi);

    return dd_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a b within 3/2 u^2 + 4u^3 (JMP 7, DWTimesFP1). */
/*@ assigns \nothing; */
static inline et_dd dd_mul_double(et_dd a, double b)
{
    const et_dd p = dd_two_product(a.hi, b), t = dd_fast_two_sum(p.hi, a.lo * b);

    return dd_fast_two_sum(t.hi, t.lo + p.lo);
}

/*@ assigns \nothing; */
static inline et_dd dd_div(et_dd a, et_dd b)
{
    const double q = a.hi / b.hi;
    const et_dd r = dd_mul_double(b, q);

    return dd_fast_two_sum(q, ((a.hi - r.hi) + (a.lo - r.lo)) / b.hi);
}

/*@ assigns \nothing;
    ensures zero: \is_finite(a.hi) && a.hi == 0.0 ==> \result.hi == 0.0 && \result.lo == 0.0;
*/
static inline et_dd dd_sqrt(et_dd a)
{
    const double s = sqrt(a.hi);
    const et_dd p = dd_two_product(s, s);

    if (a.hi == 0)
        return (et_dd){s, 0};
    return dd_fast_two_sum(s, (((a.hi - p.hi) - p.lo) + a.lo) / (2 * s));
}
#endif
