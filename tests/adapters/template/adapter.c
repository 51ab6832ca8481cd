/* An adapter for Etalon's conformance kit: copy it, and put your own code in place of span() and basis().
 *
 *     cc -o adapter adapter.c && etalon conform --adapter ./adapter
 *
 * To the extent possible under law, the authors have waived all rights to this file (CC0 1.0). */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *word(void) { return strtok(NULL, " \r\n"); }
static size_t count(void) { char *w = word(); return w ? strtoul(w, NULL, 10) : 0; }
static double real(void) { char *w = word(); return w ? strtod(w, NULL) : 0; }
static double *reals(size_t *n, size_t size)      /* a count and so many times `size` numbers */
{
    *n = count();
    double *x = calloc(*n * size + 1, sizeof *x);
    for (size_t i = 0; i < *n * size; i++)
        x[i] = real();
    return x;
}

/* ---- what is tested: k with u[k] <= x < u[k+1], and the p+1 basis functions that are not zero there (The NURBS Book, A2.1 and A2.2) ---- */
static size_t span(size_t p, const double *u, size_t nu, double x)
{
    size_t k = nu - p - 2;
    while (k > p && (x < u[k] || u[k] == u[nu - p - 1]))
        k--;
    return k;
}

static void basis(double *N, size_t k, size_t p, const double *u, double x)
{
    N[0] = 1;
    for (size_t j = 1; j <= p; j++) {
        double saved = 0;
        for (size_t r = 0; r < j; r++) {
            double t = N[r] / (u[k + r + 1] - u[k + 1 - j + r]);
            N[r] = saved + (u[k + r + 1] - x) * t;
            saved = (x - u[k + 1 - j + r]) * t;
        }
        N[j] = saved;
    }
}

/* Requests that break a rule are refused; spans below DBL_MIN, by which one cannot divide, may be. */
static int valid(size_t p, const double *u, size_t nu, double x)
{
    for (size_t i = 0; i < nu; i++)
        if (!isfinite(u[i]) || (i > 0 && u[i] != u[i - 1] && u[i] - u[i - 1] < DBL_MIN))
            return 0;
    return nu >= 2 * p + 2 && u[p] < u[nu - p - 1] && u[p] <= x && x <= u[nu - p - 1];
}

static void answer(const char *id, const char *op)
{
    size_t p = count(), nu, n = 0, nw = 0;
    double *u = reals(&nu, 1), *P = NULL, *w = NULL, N[64], sum[3] = { 0, 0, 0 };
    if (strcmp(op, "curve_point") == 0)
        P = reals(&n, 3), w = reals(&nw, 1);
    double x = real();
    int wrong = !valid(p, u, nu, x) || (P && (n != nu - p - 1 || nw != 0));
    for (size_t i = 0; P && !wrong && i < 3 * n; i++)
        wrong = !isfinite(P[i]);
    size_t k = wrong ? 0 : span(p, u, nu, x);
    if (wrong || p > 63) {
        printf("%s refused\n", id);
    } else if (strcmp(op, "span") == 0) {
        printf("%s ok %zu\n", id, k);
    } else {
        basis(N, k, p, u, x);
        printf("%s ok", id);
        for (size_t i = 0; !P && i < nu - p - 1; i++)
            printf(" %a", i + p >= k && i <= k ? N[i + p - k] : 0.0);
        for (size_t d = 0; P && d < 3; d++) {
            for (size_t j = 0; j <= p; j++)
                sum[d] += N[j] * P[3 * (k - p + j) + d];
            printf(" %a", sum[d]);
        }
        printf("\n");
    }
    free(u), free(P), free(w);
}

int main(void)
{
    size_t room = 1 << 24;
    char *line = malloc(room);
    while (line && fgets(line, (int)room, stdin)) {
        char *id = strtok(line, " \r\n"), *op = word();
        if (op && strcmp(op, "hello") == 0)
            printf("%s ok protocol=1 name=template-c version=1 degree=25 ops=span,basis,curve_point\n", id);
        else if (op && (strcmp(op, "span") == 0 || strcmp(op, "basis") == 0 || strcmp(op, "curve_point") == 0))
            answer(id, op);
        else
            printf("%s unsupported\n", id ? id : "0");
        fflush(stdout);
    }
    return 0;
}
