/* Least squares of one view of a double net, bicubic, next to peers on the same input: size n x m is n x n data and m x m control points, both
 * directions one after the other.  Collocation and transposition are timed with it.  The residual is the peer's sum of control coordinates against
 * ours, relative. The goal is for QR, the default; Cholesky, what the peers do, is shown beside it. */
#include "bench.h"
#include "etalon/base/real.h"
#include "etalon/base/vec3.h"
#include "etalon/fit/linalg.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "surface_input.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { P = 3, W = P + 1, SIZES = 3, TILE = 16 };

typedef struct {
    size_t n, m, *start;
    et_vec3 *D, *X, *T, *Y, *C;
    double *t, *u, *a, *work;
    et_linalg_method method;
} job;

static void transpose(et_vec3 *T, const et_vec3 *A, size_t m, size_t n)
{
    for (size_t i0 = 0; i0 < m; i0 += TILE)
        for (size_t j0 = 0; j0 < n; j0 += TILE)
            for (size_t i = i0; i < m && i < i0 + TILE; i++)
                for (size_t j = j0; j < n && j < j0 + TILE; j++)
                    T[j * m + i] = A[i * n + j];
}

static void collocate(job *k)
{
    for (size_t i = 0; i < k->n; i++) {
        const size_t span = et_knots_span(k->u, k->m + W, P, k->t[i]);
        k->start[i] = span - P;
        et_basis_eval(k->a + i * W, k->u, k->m + W, P, span, k->t[i], k->work, et_basis_work(P, 0));
    }
}

static double fit(void *context)
{
    job *k = context;
    size_t rank;

    for (size_t direction = 0; direction < 2; direction++) {
        const et_vec3 *B = direction == 0 ? k->D : k->T;
        et_vec3 *X = direction == 0 ? k->X : k->Y;
        const size_t columns = direction == 0 ? k->n : k->m;
        collocate(k);
        if (et_linalg_band_lsq(&X->x, &rank, k->a, k->start, k->n, k->m, W, &B->x, 3 * columns, k->method) != ET_OK)
            return NAN;
        transpose(direction == 0 ? k->T : k->C, X, k->m, columns);
    }
    return et_real_sum(&k->C[0].x, 3 * k->m * k->m);
}

static int setup(job *k, size_t n, size_t m)
{
    memset(k, 0, sizeof *k);
    k->n = n;
    k->m = m;
    k->start = malloc(n * sizeof *k->start);
    k->D = malloc(n * n * sizeof *k->D);
    k->X = malloc(m * n * sizeof *k->X);
    k->T = malloc(m * n * sizeof *k->T);
    k->Y = malloc(m * m * sizeof *k->Y);
    k->C = malloc(m * m * sizeof *k->C);
    k->t = malloc(n * sizeof *k->t);
    k->u = malloc((m + W) * sizeof *k->u);
    k->a = malloc(n * W * sizeof *k->a);
    k->work = malloc(et_basis_work(P, 0) * sizeof *k->work);
    if (!k->start || !k->D || !k->X || !k->T || !k->Y || !k->C || !k->t || !k->u || !k->a || !k->work)
        return 0;
    for (size_t i = 0; i < n; i++)
        k->t[i] = (double)i / (double)(n - 1);
    for (size_t i = 0; i < m + W; i++)
        k->u[i] = i < W ? 0 : i >= m ? 1 : (double)(i - P) / (double)(m - P);
    for (size_t i = 0; i < n * n; i++)
        k->D[i] = (et_vec3){k->t[i / n], k->t[i % n], surface_input_parameter(i / 2, (int)(i % 2))};
    return 1;
}

static void release(job *k)
{
    void *all[] = {k->start, k->D, k->X, k->T, k->Y, k->C, k->t, k->u, k->a, k->work};

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
}

/* The peer's time is asked once; both our methods stand beside it. */
static int table(job *k, double goal)
{
    const char *src = getenv("BENCH_SRC");
    char size[32], command[512];
    bench_result r;
    int met = 1;

    snprintf(size, sizeof size, "%zux%zu", k->n, k->m);
    snprintf(command, sizeof command, "/usr/bin/python3 %s/peer_scipy_fit.py", src ? src : "tests/bench");
    if (!bench_peer(&r, command, "fit", size)) {
        bench_skip("grid fit", size, "peer_scipy_fit.py");
        return 1;
    }
    for (size_t method = 0; method < 2; method++) {
        char item[64];
        double sum;
        k->method = (et_linalg_method)method;
        const double ours = bench_min(fit, k, 10, &sum);
        snprintf(item, sizeof item, "grid fit, %s", et_linalg_name(k->method));
        met &= bench_row(item, size, r.version, r.seconds, ours, method == 0 ? goal : 0, fabs(r.residual - sum) / fabs(sum));
    }
    return met;
}

int main(void)
{
    static const size_t sizes[SIZES][2] = {{200, 50}, {1000, 50}, {1000, 200}};
    int met = 1;

    bench_head();
    for (size_t s = 0; s < SIZES; s++) {
        job k;
        if (setup(&k, sizes[s][0], sizes[s][1]))
            met &= table(&k, bench_goal(3, 8));
        release(&k);
    }
    printf("goals %s\n", met ? "met" : "NOT met");
    return 0;
}
