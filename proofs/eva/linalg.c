#include "eva.h"
#include "etalon/fit/linalg.h"

static void solve(et_linalg_method method)
{
    double A[15], B[10], X[6], R[9], C[6];
    size_t rank;

    any_memory();
    fill(A, 15);
    fill(B, 10);
    et_linalg_name(method);
    et_linalg_lsq(X, &rank, A, 5, 3, B, 2, method);
    et_linalg_qr(R, C, A, 5, 3, B, 2);
}

static void band(et_linalg_method method)
{
    static const size_t start[5] = {0, 0, 1, 2, 2};
    double a[10], B[10], X[8];
    size_t rank;

    any_memory();
    fill(a, 10);
    fill(B, 10);
    et_linalg_band_lsq(X, &rank, a, start, 5, 4, 2, B, 2, method);
}

void eva_linalg_qr(void) { solve(ET_LINALG_QR); }
void eva_linalg_cholesky(void) { solve(ET_LINALG_CHOLESKY); }
void eva_linalg_svd(void) { solve(ET_LINALG_SVD); }
void eva_linalg_band_qr(void) { band(ET_LINALG_QR); }
void eva_linalg_band_cholesky(void) { band(ET_LINALG_CHOLESKY); }
