#include "etalon/fit/knotrule.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>

static const char *const names[] = {"piegl", "faithful", "uniform", "averaging"};

const char *et_knotrule_name(et_knotrule_kind kind)
{
    return (unsigned)kind < sizeof names / sizeof *names ? names[kind] : NULL;
}

/* Interior knot j of Eqs. 9.68, 9.69 for `spans` = n - p + 1 spans; j d = i + alpha is split in integers, so i is never off by one.  The clamp undoes
 * what rounding may add: the result lies in [t_{i-1}, t_i], within 3u t_i of the formula. */
/*@ requires place:   1 <= j < spans <= nt && spans*spans <= SIZE_MAX;
    requires valid:   \valid_read(t + (0 .. nt - 1));
    requires finite:  \forall integer i; 0 <= i < nt ==> \is_finite(t[i]);
    requires sorted:  \forall integer a, b; 0 <= a <= b < nt ==> t[a] <= t[b];
    assigns  \nothing;
    ensures  inside:  1 <= knotrule_place(nt, spans, j) < nt;
    ensures  finite:  \is_finite(\result);
    ensures  between: t[knotrule_place(nt, spans, j) - 1] <= \result <= t[knotrule_place(nt, spans, j)];
*/
static double piegl(const double *t, size_t nt, size_t j, size_t spans)
{
    //@ ghost fact_product(j, spans, nt % spans);
    //@ ghost fact_product(nt % spans, spans, spans);
    //@ ghost fact_place(j, nt / spans, nt % spans, j * (nt % spans) / spans, j * (nt % spans) % spans, spans, nt);
    const size_t whole = nt / spans, rest = j * (nt % spans), i = j * whole + rest / spans;
    //@ assert place: i == knotrule_place(nt, spans, j);
    const double alpha = (double)(rest % spans) / (double)spans;

    return fmin(fmax((1 - alpha) * t[i - 1] + alpha * t[i], t[i - 1]), t[i]);
}

/*@ requires place:   1 <= j < spans && spans*spans <= SIZE_MAX && et_knotrule_known(kind);
    requires degree:  1 <= p && (kind != ET_KNOTRULE_UNIFORM ==> spans + p <= nt);
    requires valid:   \valid_read(t + (0 .. nt - 1));
    requires finite:  \forall integer i; 0 <= i < nt ==> \is_finite(t[i]);
    requires sorted:  \forall integer a, b; 0 <= a <= b < nt ==> t[a] <= t[b];
    assigns  \nothing;
    ensures  inside:  kind == ET_KNOTRULE_PIEGL ==> 1 <= knotrule_place(nt, spans, j) < nt;
    ensures  finite:  kind == ET_KNOTRULE_PIEGL ==> \is_finite(\result);
    ensures  between: kind == ET_KNOTRULE_PIEGL ==> t[knotrule_place(nt, spans, j) - 1] <= \result <= t[knotrule_place(nt, spans, j)];
*/
static double interior(const double *t, size_t nt, size_t p, size_t j, size_t spans, et_knotrule_kind kind)
{
    if (kind == ET_KNOTRULE_UNIFORM)
        return (double)j / (double)spans;
    if (kind == ET_KNOTRULE_PIEGL)
        return piegl(t, nt, j, spans);
    /* Eq. 2.10 and Eq. 9.8 are one formula: they differ in how many parameters there are besides the first h + 1. */
    return et_real_sum(t + j, p) / (double)p;
}

et_status et_knotrule_make(double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind)
{
    size_t control, spans, square;

    if (p < 1 || nu / 2 <= p || nt < 2 || et_knotrule_name(kind) == NULL)
        return ET_EINVAL;
    control = nu - p - 1;
    spans = control - p;
    if ((kind == ET_KNOTRULE_AVERAGING && control != nt) || (kind != ET_KNOTRULE_UNIFORM && nt < control))
        return ET_EINVAL;
    if (et_size_mul(&square, spans, spans) != ET_OK)
        return ET_ENOMEM;
    /*@ loop invariant place: 0 <= j <= p + 1;
        loop invariant first: \forall integer a; 0 <= a < j ==> u[a] == 0.0;
        loop invariant last:  \forall integer a; control <= a < control + j ==> u[a] == 1.0;
        loop assigns j, u[0 .. nu - 1];
        loop variant p - j;
    */
    for (size_t j = 0; j <= p; j++) {
        u[j] = 0;
        u[control + j] = 1;
    }
    /*@ loop invariant place:   1 <= j <= spans;
        loop invariant data:    \forall integer a; 0 <= a < nt ==> \is_finite(t[a]) && 0.0 <= t[a] <= 1.0;
        loop invariant first:   \forall integer a; 0 <= a <= p ==> u[a] == 0.0;
        loop invariant last:    \forall integer a; control <= a < nu ==> u[a] == 1.0;
        loop assigns j, u[p + 1 .. control - 1];
        loop variant spans - j;
    */
    for (size_t j = 1; j < spans; j++)
        u[p + j] = interior(t, nt, p, j, spans, kind);
    return ET_OK;
}
