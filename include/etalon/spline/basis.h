/* basis: the p+1 B-spline basis functions that are not zero at a parameter (The NURBS Book, A2.2 and A2.3; Cox-de Boor, 0/0 = 0). */
#ifndef ETALON_SPLINE_BASIS_H
#define ETALON_SPLINE_BASIS_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Doubles of workspace for degree p and derivatives up to order d (d = 0 for et_basis_eval). */
size_t et_basis_work(size_t p, size_t d);

/* N[0..p] = N_{span-p,p}(x) .. N_{span,p}(x), where span = et_knots_span(u, nu, p, x). */
void et_basis_eval(double *N, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork);

/* D[k*(p+1) + j] = k-th derivative of N_{span-p+j,p} at x, k = 0..d (zero for k > p). */
void et_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork);

#ifdef __cplusplus
}
#endif
#endif
