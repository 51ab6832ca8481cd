/* LAPACKE's functions as the Eva harnesses see them: what they read and write (LAPACK Users' Guide, column-major), and that sizes and statuses are as
 * documented.  Of their numbers nothing is assumed: they may be NaN. */
#ifndef PROOFS_EVA_LAPACKE_H
#define PROOFS_EVA_LAPACKE_H
typedef int lapack_int;
enum { LAPACK_COL_MAJOR = 102, LAPACK_WORK_MEMORY_ERROR = -1010, LAPACK_TRANSPOSE_MEMORY_ERROR = -1011 };

/*@ requires a: \valid(a + (0 .. lda * n - 1)) && lda >= m >= 1;
    requires p: \valid(jpvt + (0 .. n - 1)) && \valid(tau + (0 .. (m < n ? m : n) - 1));
    assigns  a[0 .. lda * n - 1], jpvt[0 .. n - 1], tau[0 .. (m < n ? m : n) - 1], \result \from a[0 .. lda * n - 1];
    ensures  pivots: \forall integer i; 0 <= i < n ==> 1 <= jpvt[i] <= n;
    ensures  status: \result <= 0; */
lapack_int LAPACKE_dgeqp3(int order, lapack_int m, lapack_int n, double *a, lapack_int lda, lapack_int *jpvt, double *tau);

/*@ requires a: \valid(a + (0 .. lda * n - 1)) && lda >= n;
    assigns  a[0 .. lda * n - 1], \result \from a[0 .. lda * n - 1];
    ensures  status: \result <= n; */
lapack_int LAPACKE_dpotrf(int order, char uplo, lapack_int n, double *a, lapack_int lda);

/*@ requires a: \valid_read(a + (0 .. lda * n - 1)) && \valid(rcond);
    assigns  *rcond, \result \from a[0 .. lda * n - 1], anorm;
    ensures  status: \result <= 0; */
lapack_int LAPACKE_dpocon(int order, char uplo, lapack_int n, const double *a, lapack_int lda, double anorm, double *rcond);

/*@ requires a: \valid_read(a + (0 .. lda * n - 1)) && \valid(b + (0 .. ldb * nrhs - 1));
    assigns  b[0 .. ldb * nrhs - 1], \result \from a[0 .. lda * n - 1], b[0 .. ldb * nrhs - 1];
    ensures  status: \result <= 0; */
lapack_int LAPACKE_dpotrs(int order, char uplo, lapack_int n, lapack_int nrhs, const double *a, lapack_int lda, double *b, lapack_int ldb);

/* Its numbers; eva.c has the query for room, lwork = -1, beside them. */
/*@ requires a: \valid(a + (0 .. lda * n - 1)) && \valid(b + (0 .. ldb * nrhs - 1)) && \valid(s + (0 .. (m < n ? m : n) - 1)) && \valid(rank);
    assigns  a[0 .. lda * n - 1], b[0 .. ldb * nrhs - 1], s[0 .. (m < n ? m : n) - 1], *rank, \result \from a[0 .. lda * n - 1],
             b[0 .. ldb * nrhs - 1];
    ensures  rank:  0 <= *rank <= (m < n ? m : n); */
lapack_int gelsd_numbers(lapack_int m, lapack_int n, lapack_int nrhs, double *a, lapack_int lda, double *b, lapack_int ldb, double *s, lapack_int *rank);

lapack_int LAPACKE_dgelsd_work(int order, lapack_int m, lapack_int n, lapack_int nrhs, double *a, lapack_int lda, double *b, lapack_int ldb, double *s,
                               double rcond, lapack_int *rank, double *work, lapack_int lwork, lapack_int *iwork);

/*@ requires a: \valid(ab + (0 .. ldab * n - 1)) && ldab >= kd + 1;
    assigns  ab[0 .. ldab * n - 1], \result \from ab[0 .. ldab * n - 1];
    ensures  status: \result <= n; */
lapack_int LAPACKE_dpbtrf(int order, char uplo, lapack_int n, lapack_int kd, double *ab, lapack_int ldab);

/*@ requires a: \valid_read(ab + (0 .. ldab * n - 1)) && \valid(rcond);
    assigns  *rcond, \result \from ab[0 .. ldab * n - 1], anorm;
    ensures  status: \result <= 0; */
lapack_int LAPACKE_dpbcon(int order, char uplo, lapack_int n, lapack_int kd, const double *ab, lapack_int ldab, double anorm, double *rcond);

/*@ requires a: \valid_read(ab + (0 .. ldab * n - 1)) && \valid(rcond);
    assigns  *rcond, \result \from ab[0 .. ldab * n - 1];
    ensures  status: \result <= 0; */
lapack_int LAPACKE_dtbcon(int order, char norm, char uplo, char diag, lapack_int n, lapack_int kd, const double *ab, lapack_int ldab, double *rcond);
#endif
