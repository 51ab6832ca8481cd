#include "etalon/spline/knots.h"
#include <float.h>
#include <math.h>
#include <stdint.h>

int et_knots_valid(const double *u, size_t nu, size_t p)
{
    if (p > SIZE_MAX / 2 - 1 || nu < 2 * p + 2) {
        return 0;
    }
    /*@ loop invariant place:  i <= nu;
        loop invariant finite: \forall integer k; 0 <= k < i ==> \is_finite(u[k]);
        loop invariant sorted: \forall integer a, b; 0 <= a <= b < i ==> u[a] <= u[b];
        loop assigns i;
        loop variant nu - i;
    */
    for (size_t i = 0; i < nu; i++) {
        if (!isfinite(u[i]) || (i > 0 && !(u[i - 1] <= u[i]))) {
            return 0;
        }
        if (i > 0 && u[i - 1] < u[i] && u[i] - u[i - 1] < DBL_MIN) {
            return 0;
        }
    }
    return isfinite(u[nu - 1] - u[0]) && u[p] < u[nu - p - 1];
}

int et_knots_clamped(const double *u, size_t nu, size_t p)
{
    return u[0] == u[p] && u[nu - p - 1] == u[nu - 1];
}

int et_knots_interpolating(const double *u, size_t nu, size_t p)
{
    return et_knots_clamped(u, nu, p) && u[p] < u[p + 1] && u[nu - p - 2] < u[nu - p - 1];
}

size_t et_knots_span(const double *u, size_t nu, size_t p, double x)
{
    size_t lo = p, hi = nu - p - 1;
    double end = u[hi];
    x = x < u[lo] ? u[lo] : x;
    /*@ loop invariant range: p <= lo < hi <= nu - p - 1;
        loop invariant inner: x < end ==> u[lo] <= x < u[hi];
        loop invariant outer: !(x < end) ==> u[lo] < end <= u[hi];
        loop assigns lo, hi;
        loop variant hi - lo;
    */
    while (hi - lo > 1) {     /* u[lo] <= x < u[hi], or, at the end of the domain, u[lo] < end <= u[hi] */
        size_t mid = lo + (hi - lo) / 2;
        int right = x < end ? u[mid] <= x : u[mid] < end;
        if (right) {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    return lo;
}

size_t et_knots_span_side(const double *u, size_t nu, size_t p, double x, et_side side)
{
    size_t lo = p, hi = nu - p - 1;
    if (side == ET_SIDE_RIGHT || x <= u[lo]) {
        return et_knots_span(u, nu, p, x);
    }
    x = x < u[hi] ? x : u[hi];
    /*@ loop invariant range:  p <= lo < hi <= nu - p - 1;
        loop invariant inside: u[lo] < x <= u[hi];
        loop assigns lo, hi;
        loop variant hi - lo;
    */
    while (hi - lo > 1) {     /* u[lo] < x <= u[hi] */
        size_t mid = lo + (hi - lo) / 2;
        if (u[mid] < x) {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    return lo;
}

size_t et_knots_multiplicity(const double *u, size_t nu, double x)
{
    size_t count = 0;
    /*@ loop invariant place: i <= nu;
        loop invariant range: 0 <= count <= i;
        loop invariant none:  count == 0 <==> \forall integer k; 0 <= k < i ==> u[k] != x;
        loop assigns i, count;
        loop variant nu - i;
    */
    for (size_t i = 0; i < nu; i++) {
        count += u[i] == x;
    }
    return count;
}

/* From the first knot on, so that no sum overflows: a difference's and a quotient's rounding, p - 2 of the sum; the last addition. */
void et_knots_greville(double *g, size_t n, const double *u, size_t nu, size_t p)
{
    (void)nu;
    /*@ loop invariant place: i <= n;
        loop assigns i, g[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++) {
        size_t first = p == 0 ? i : i + 1, last = p == 0 ? i + 1 : i + p;
        double mean = 0.0, count = p == 0 ? 2.0 : (double)p;
        /*@ loop invariant place: first <= j <= last + 1;
            loop assigns j, mean;
            loop variant last - j;
        */
        for (size_t j = first; j <= last; j++) {
            mean += (u[j] - u[first]) / count;
        }
        mean += u[first];
        g[i] = mean < u[last] ? mean : u[last];
    }
}
