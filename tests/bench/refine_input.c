#include "refine_input.h"

static int number(int n, int view, int i, int j)
{
    const int inside = i > 0 && i < n - 1 && j > 0 && j < n - 1;
    return view && inside ? n * n + (i - 1) * (n - 2) + j - 1 : i * n + j;
}

/* A lens over the unit square: the bottom below, the top above, the border at height 0; a little noise on top of it. */
static void shape(double P[3], int view, double a, double b, unsigned *state, double noise)
{
    const double h = 4.0 * a * (1.0 - a) * b * (1.0 - b);
    P[0] = a;
    P[1] = b;
    P[2] = view ? h : -h;
    for (int d = 0; d < 3; d++) {
        *state = *state * 1664525u + 1013904223u;
        P[d] += noise * ((double)(*state >> 8) * 0x1p-24 - 0.5);
    }
}

int refine_input_basis(double N[4], const refine_input *in, double x)
{
    const double *u = in->knots;
    double left[4], right[4];
    int span = 3;
    while (span < REFINE_CONTROL - 1 && x >= u[span + 1]) span++;
    N[0] = 1.0;
    for (int j = 1; j <= 3; j++) {
        double saved = 0.0;
        left[j] = x - u[span + 1 - j];
        right[j] = u[span + j] - x;
        for (int r = 0; r < j; r++) {
            const double temp = N[r] / (right[r + 1] + left[j - r]);
            N[r] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        N[j] = saved;
    }
    return span - 3;
}

void refine_input_make(refine_input *in)
{
    const int m = REFINE_CONTROL, n = REFINE_DATA;
    unsigned state = 1;
    for (int k = 0; k < m + 4; k++) in->knots[k] = k < 4 ? 0.0 : k >= m ? 1.0 : (double)(k - 3) / (double)(m - 3);
    for (int i = 0; i < n; i++) in->t[i] = (double)i / (double)(n - 1);
    for (int w = 0; w < 2; w++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                const int c = in->data_class[w][i][j] = number(n, w, i, j);
                if (w == 0 || c >= n * n) shape(in->data + 3 * c, w, in->t[i], in->t[j], &state, 1e-2);
            }
    for (int w = 0; w < 2; w++)
        for (int i = 0; i < m; i++)
            for (int j = 0; j < m; j++) {                    /* at the Greville points */
                const double a = (in->knots[i + 1] + in->knots[i + 2] + in->knots[i + 3]) / 3.0;
                const double b = (in->knots[j + 1] + in->knots[j + 2] + in->knots[j + 3]) / 3.0;
                const int c = in->control_class[w][i][j] = number(m, w, i, j);
                if (w == 0 || c >= m * m) shape(in->x0 + 3 * c, w, a, b, &state, 0.0);
            }
}
