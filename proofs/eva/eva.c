#include "eva.h"
#include "etalon/base/rng.h"
#include "lapacke.h"

double any(void) { return Frama_C_double_interval(-0x1.fffffffffffffp1023, 0x1.fffffffffffffp1023); }

void fill(double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        x[i] = any();
}

/* Of the requests for memory any one fails, or none; before any_memory() none does.  Which one is not chosen beforehand, so that what succeeds before is
 * analysed once; the states that follow are kept apart by its number. */
static int may_fail, made, failing;

void any_memory(void)
{
    may_fail = 1;
}

/* Frama-C's own contract of this function has no allocation. */
int posix_memalign(void **memory, size_t alignment, size_t size)
{
    if (may_fail) {
        made++;
        if (!failing && Frama_C_interval(0, 1)) {
            failing = made;
            //@ split failing;
            return 12;
        }
    }
    *memory = malloc(size);
    return 0;
}

int make_curve(et_curve *c, size_t p, int rational)
{
    if (et_curve_new(c, p, counts[p], rational) != ET_OK)
        return 0;
    for (size_t i = 0; i < counts[p] + p + 1; i++)
        c->u[i] = knots[p][i];
    fill(&c->points[0].x, 3 * counts[p]);
    if (rational)
        for (size_t i = 0; i < counts[p]; i++)
            c->weights[i] = Frama_C_double_interval(0x1p-1074, 0x1.fffffffffffffp1023);
    return 1;
}

static void data(et_surface *s)
{
    for (size_t i = 0; i < s->nu + s->p + 1; i++)
        s->u[i] = knots[s->p][i];
    for (size_t i = 0; i < s->nv + s->q + 1; i++)
        s->v[i] = knots[s->q][i];
    fill(&s->points[0].x, 3 * s->nu * s->nv);
    if (s->weights)
        for (size_t i = 0; i < s->nu * s->nv; i++)
            s->weights[i] = Frama_C_double_interval(0x1p-1074, 0x1.fffffffffffffp1023);
}

int make_surface(et_surface *s, size_t p, size_t q, int rational)
{
    if (et_surface_new(s, p, q, counts[p], counts[q], rational) != ET_OK)
        return 0;
    data(s);
    return 1;
}

int make_shell(et_shell *s, size_t p, size_t q, int rational)
{
    const et_doublenet control = {counts[p], counts[q]};
    if (et_shell_new(s, p, q, control, rational) != ET_OK)
        return 0;
    data(&s->view[0]);
    data(&s->view[1]);
    return 1;
}

/* Frama-C's contracts of these ask for numbers that are finite, which C does not. */
double frexp(double x, int *exponent)
{
    *exponent = Frama_C_interval(-1073, 1024);
    return any();
}

double ldexp(double x, int exponent)
{
    static volatile double unknown;
    return unknown;
}

double eva_fabs(double x) { return x < 0 ? -x : x; }

double eva_sqrt(double x)
{
    static volatile double unknown;
    return unknown;
}

double fmax(double x, double y) { return x < y || x != x ? y : x; }
double fmin(double x, double y) { return y < x || x != x ? y : x; }

/* The generator, of which WP proves its own: any of the numbers it promises. */
struct et_rng { int unused; };

et_status et_rng_new(et_rng **rng, uint64_t seed)
{
    return posix_memalign((void **)rng, sizeof(int), sizeof **rng) == 0 ? ET_OK : ET_ENOMEM;
}

void et_rng_free(et_rng *rng) { free(rng); }
double et_rng_uniform(et_rng *rng) { return Frama_C_double_interval(0, 0x1.fffffffep-1); }
size_t et_rng_index(et_rng *rng, size_t n) { return Frama_C_size_t_interval(0, n - 1); }

enum { WORK = 100, INDICES = 30 };

lapack_int LAPACKE_dgelsd_work(int order, lapack_int m, lapack_int n, lapack_int nrhs, double *a, lapack_int lda, double *b, lapack_int ldb, double *s,
                               double rcond, lapack_int *rank, double *work, lapack_int lwork, lapack_int *iwork)
{
    if (lwork == -1) {
        *work = WORK;
        *iwork = INDICES;
        return 0;
    }
    for (lapack_int i = 0; i < lwork; i++)
        work[i] = any();
    for (lapack_int i = 0; i < INDICES; i++)
        iwork[i] = 0;
    return gelsd_numbers(m, n, nrhs, a, lda, b, ldb, s, rank);
}

/* The slow phase of the elementary functions, MPFR's: any number. */
double real_mpfr_exp(double x) { return any(); }
double real_mpfr_log(double x) { return any(); }
double real_mpfr_pow(double x, double y) { return any(); }
double real_mpfr_sin(double x) { return any(); }
double real_mpfr_cos(double x) { return any(); }
