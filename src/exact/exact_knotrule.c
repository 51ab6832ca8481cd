/* exact_knotrule: interior knots from parameters, correctly rounded. */
#include "etalon/base/size.h"
#include "exact/exact_parts.h"

/* x = a/b. */
static void quotient(fmpq_t x, size_t a, size_t b)
{
    fmpz_set_ui(fmpq_numref(x), (ulong)a);
    fmpz_set_ui(fmpq_denref(x), (ulong)b);
    fmpq_canonicalise(x);
}

/* x = t_{i-1} + alpha (t_i - t_{i-1}), j nt/spans = i + alpha. */
static void piegl(fmpq_t x, const double *t, size_t nt, size_t j, size_t spans)
{
    const size_t whole = nt / spans, rest = j * (nt % spans), i = j * whole + rest / spans;
    fmpq_t a, b;

    fmpq_init(a);
    fmpq_init(b);
    exact_set(a, t[i - 1]);
    exact_set(b, t[i]);
    fmpq_sub(b, b, a);
    quotient(x, rest % spans, spans);
    fmpq_mul(x, x, b);
    fmpq_add(x, x, a);
    fmpq_clear(a);
    fmpq_clear(b);
}

static void mean(fmpq_t x, const double *t, size_t n)
{
    fmpq_t a;

    fmpq_init(a);
    fmpq_zero(x);
    for (size_t i = 0; i < n; i++) {
        exact_set(a, t[i]);
        fmpq_add(x, x, a);
    }
    quotient(a, 1, n);
    fmpq_mul(x, x, a);
    fmpq_clear(a);
}

static double interior(const double *t, size_t nt, size_t p, size_t j, size_t spans, et_knotrule_kind kind)
{
    double knot;
    fmpq_t x;

    fmpq_init(x);
    if (kind == ET_KNOTRULE_UNIFORM)
        quotient(x, j, spans);
    else if (kind == ET_KNOTRULE_PIEGL)
        piegl(x, t, nt, j, spans);
    else
        mean(x, t + j, p);
    knot = exact_round(x);
    fmpq_clear(x);
    return knot;
}

et_status et_exact_knotrule_make(double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind)
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
    for (size_t j = 0; j <= p; j++) {
        u[j] = 0;
        u[control + j] = 1;
    }
    for (size_t j = 1; j < spans; j++)
        u[p + j] = interior(t, nt, p, j, spans, kind);
    return ET_OK;
}
