#include "base/real_parts.h"
#include <mpfr.h>

/* MPFR's range of exponents is set to that of doubles while it works, so that it rounds once, subnormal results too; the caller's settings and flags
 * come back, and no cache stays behind. */
typedef struct {
    mpfr_t x, y, r;
    mpfr_exp_t least, greatest;
    mpfr_flags_t flags;
} work;

static void begin(work *w, double x, double y)
{
    w->least = mpfr_get_emin();
    w->greatest = mpfr_get_emax();
    w->flags = mpfr_flags_save();
    mpfr_set_emin(-1073); /* of 2^-1074 in MPFR's form, 1/2 <= m < 1 */
    mpfr_set_emax(1024);
    mpfr_inits2(53, w->x, w->y, w->r, (mpfr_ptr)0);
    mpfr_set_d(w->x, x, MPFR_RNDN);
    mpfr_set_d(w->y, y, MPFR_RNDN);
}

/* inexact: what the operation on r returned. */
static double end(work *w, int inexact)
{
    double r;

    mpfr_subnormalize(w->r, inexact, MPFR_RNDN);
    r = mpfr_get_d(w->r, MPFR_RNDN);
    mpfr_clears(w->x, w->y, w->r, (mpfr_ptr)0);
    mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);
    mpfr_set_emin(w->least);
    mpfr_set_emax(w->greatest);
    mpfr_flags_restore(w->flags, MPFR_FLAGS_ALL);
    return r;
}

double real_mpfr_exp(double x)
{
    work w;

    begin(&w, x, 0);
    return end(&w, mpfr_exp(w.r, w.x, MPFR_RNDN));
}

double real_mpfr_log(double x)
{
    work w;

    begin(&w, x, 0);
    return end(&w, mpfr_log(w.r, w.x, MPFR_RNDN));
}

double real_mpfr_pow(double x, double y)
{
    work w;

    begin(&w, x, y);
    return end(&w, mpfr_pow(w.r, w.x, w.y, MPFR_RNDN));
}

double real_mpfr_sin(double x)
{
    work w;

    begin(&w, x, 0);
    return end(&w, mpfr_sin(w.r, w.x, MPFR_RNDN));
}

double real_mpfr_cos(double x)
{
    work w;

    begin(&w, x, 0);
    return end(&w, mpfr_cos(w.r, w.x, MPFR_RNDN));
}
