/* The GNU Scientific Library: B-spline basis functions, and least squares with them. */
#include "../adapter.h"
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_version.h>
#include <stdio.h>

/* The library takes break points and clamps the ends itself; its knots are written over with the request's. */
static gsl_bspline_workspace *workspace(const list *u, size_t p)
{
    gsl_bspline_workspace *w;

    if (!knots_good(u, p))
        return NULL;
    for (size_t k = 0; k < p; k++)
        if (u->x[k] != u->x[p] || u->x[u->n - 1 - k] != u->x[u->n - 1 - p]) {
            unsupport("knots that are not clamped");
            return NULL;
        }
    w = gsl_bspline_alloc(p + 1, u->n - 2 * p);
    for (size_t k = 0; w && k < u->n; k++)
        gsl_vector_set(w->knots, k, u->x[k]);
    return w;
}

static void span(void)
{
    const size_t p = take_count();
    const list u = take_reals();
    const double x = take_real();
    gsl_bspline_workspace *w = refused() ? NULL : workspace(&u, p);

    if (!w)
        return;
    gsl_vector *N = gsl_vector_alloc(p + 1);
    size_t first, last;
    if (gsl_bspline_eval_nonzero(x, N, &first, &last, w) != GSL_SUCCESS)
        refuse("outside the domain");
    put((double)last);
    gsl_vector_free(N);
    gsl_bspline_free(w);
}

static void greville(void)
{
    const size_t p = take_count();
    const list u = take_reals();
    gsl_bspline_workspace *w = refused() ? NULL : workspace(&u, p);

    if (!w)
        return;
    for (size_t i = 0; i < gsl_bspline_ncoeffs(w); i++)
        put(gsl_bspline_greville_abscissa(i, w));
    gsl_bspline_free(w);
}

static void basis_of(size_t p, const list *u, double x, size_t d)
{
    gsl_bspline_workspace *w = refused() ? NULL : workspace(u, p);

    if (!w)
        return;
    const size_t n = gsl_bspline_ncoeffs(w);
    gsl_matrix *D = gsl_matrix_alloc(n, d + 1);
    gsl_vector *N = gsl_vector_alloc(n);
    const int status = d == 0 ? gsl_bspline_eval(x, N, w) : gsl_bspline_deriv_eval(x, d, D, w);
    if (status != GSL_SUCCESS)
        refuse(gsl_strerror(status));
    for (size_t k = 0; k <= d; k++)
        for (size_t i = 0; i < n; i++)
            put(d == 0 ? gsl_vector_get(N, i) : gsl_matrix_get(D, i, k));
    gsl_vector_free(N);
    gsl_matrix_free(D);
    gsl_bspline_free(w);
}

static const char *const sides[] = { "any", "right", "left", NULL };

static void basis(void)
{
    const size_t p = take_count();
    const list u = take_reals();
    const double x = take_real();

    take_word(sides);
    basis_of(p, &u, x, 0);
}

static void basis_ders(void)
{
    const size_t p = take_count();
    const list u = take_reals();
    const double x = take_real();

    take_word(sides);
    basis_of(p, &u, x, take_count());
}

/* A normal use of gsl_multifit_linear: one column of the design matrix a basis function. */
static void fit_curve(void)
{
    const size_t p = take_count();
    const list u = take_reals(), t = take_reals(), P = take_points();
    const list all = { 3 * P.n, P.x };

    if (refused() || !reals_good(&t) || !reals_good(&all))
        return;
    if (t.n != P.n || t.n == 0) {
        refuse("parameters and points differ in number");
        return;
    }
    gsl_bspline_workspace *w = workspace(&u, p);
    if (!w)
        return;
    const size_t n = gsl_bspline_ncoeffs(w);
    double *c = room(3 * n);
    if (t.n < n) {
        refuse("fewer points than control points");
        gsl_bspline_free(w);
        return;
    }
    gsl_matrix *A = gsl_matrix_alloc(t.n, n), *C = gsl_matrix_alloc(n, n);
    gsl_vector *N = gsl_vector_alloc(n), *y = gsl_vector_alloc(t.n);
    gsl_multifit_linear_workspace *m = gsl_multifit_linear_alloc(t.n, n);
    for (size_t k = 0; k < t.n; k++) {
        if (gsl_bspline_eval(t.x[k], N, w) != GSL_SUCCESS)
            refuse("a parameter outside the domain");
        gsl_matrix_set_row(A, k, N);
    }
    for (size_t a = 0; a < 3; a++) {
        double chi;
        size_t rank;
        for (size_t k = 0; k < t.n; k++)
            gsl_vector_set(y, k, P.x[3 * k + a]);
        if (gsl_multifit_linear_tsvd(A, y, GSL_DBL_EPSILON, N, C, &chi, &rank, m) != GSL_SUCCESS || rank < n)
            refuse("the matrix is rank deficient");
        for (size_t i = 0; i < n; i++)
            c[3 * i + a] = gsl_vector_get(N, i);
    }
    put_all(c, 3 * n);
    gsl_multifit_linear_free(m);
    gsl_vector_free(y);
    gsl_vector_free(N);
    gsl_matrix_free(C);
    gsl_matrix_free(A);
    gsl_bspline_free(w);
}

int main(void)
{
    static const operation operations[] = { { "span", span }, { "greville", greville }, { "basis", basis }, { "basis_ders", basis_ders },
                                            { "fit_curve", fit_curve }, { NULL, NULL } };
    char hello[128];

    gsl_set_error_handler_off();
    snprintf(hello, sizeof hello, "name=GSL version=%s rational=0 sides=any knot_tolerance=0", gsl_version);
    return adapter_run(hello, operations);
}
