/* The source's way to its objective: surfaces as the triple matrix product N P N', every basis value a matrix element.  Prints the seconds of one
 * evaluation and its value. */
#include "bench.h"
#include "refine_input.h"
#include <math.h>
#include <stdio.h>

enum { REPEATS = 20000 };

static refine_input in;
static double N[REFINE_DATA][REFINE_CONTROL];

static double evaluate(const double *x)
{
    double P[REFINE_CONTROL][REFINE_CONTROL], T[REFINE_DATA][REFINE_CONTROL], S[2][3][REFINE_DATA][REFINE_DATA], sum = 0.0;
    for (int w = 0; w < 2; w++)
        for (int d = 0; d < 3; d++) {
            for (int i = 0; i < REFINE_CONTROL; i++)
                for (int j = 0; j < REFINE_CONTROL; j++) P[i][j] = x[3 * in.control_class[w][i][j] + d];
            for (int a = 0; a < REFINE_DATA; a++)
                for (int j = 0; j < REFINE_CONTROL; j++) {
                    double t = 0.0;
                    for (int i = 0; i < REFINE_CONTROL; i++) t += N[a][i] * P[i][j];
                    T[a][j] = t;
                }
            for (int a = 0; a < REFINE_DATA; a++)
                for (int b = 0; b < REFINE_DATA; b++) {
                    double t = 0.0;
                    for (int j = 0; j < REFINE_CONTROL; j++) t += T[a][j] * N[b][j];
                    S[w][d][a][b] = t;
                }
        }
    for (int w = 0; w < 2; w++)
        for (int a = 0; a < REFINE_DATA; a++)
            for (int b = 0; b < REFINE_DATA; b++) {
                const double *D = in.data + 3 * in.data_class[w][a][b];
                if (w == 1 && in.data_class[w][a][b] < REFINE_DATA * REFINE_DATA) continue;
                const double dx = D[0] - S[w][0][a][b], dy = D[1] - S[w][1][a][b], dz = D[2] - S[w][2][a][b];
                sum += sqrt(dx * dx + dy * dy + dz * dz);
            }
    return sum;
}

static double repeat(void *context)
{
    double value = 0.0, *x = context;
    for (int k = 0; k < REPEATS; k++) {
        x[k % REFINE_N] += k % 2 ? 1e-9 : -1e-9;
        value = evaluate(x);
    }
    return value;
}

int main(void)
{
    refine_input_make(&in);
    for (int a = 0; a < REFINE_DATA; a++) {
        double B[4];
        const int first = refine_input_basis(B, &in, in.t[a]);
        for (int k = 0; k < 4; k++) N[a][first + k] = B[k];
    }
    static double x[REFINE_N];
    for (int k = 0; k < REFINE_N; k++) x[k] = in.x0[k];
    const double value = evaluate(x), seconds = bench_min(repeat, x, 3, NULL) / REPEATS;
    printf("dense_triple_product %.9g %.17g\n", seconds, value);
    return 0;
}
