/* A2.1, A2.2 and A3.5 of The NURBS Book as they are printed. */
#include "surface_peer.h"

static size_t find_span(size_t n, size_t p, double u, const double *U)
{
    if (u >= U[n + 1]) {
        return n;
    }
    size_t low = p, high = n + 1, mid = (low + high) / 2;
    while (u < U[mid] || u >= U[mid + 1]) {
        if (u < U[mid]) {
            high = mid;
        } else {
            low = mid;
        }
        mid = (low + high) / 2;
    }
    return mid;
}

static void basis_funs(size_t i, double u, size_t p, const double *U, double *N)
{
    double left[8], right[8];
    N[0] = 1.0;
    for (size_t j = 1; j <= p; j++) {
        left[j] = u - U[i + 1 - j];
        right[j] = U[i + j] - u;
        double saved = 0.0;
        for (size_t r = 0; r < j; r++) {
            double temp = N[r] / (right[r + 1] + left[j - r]);
            N[r] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        N[j] = saved;
    }
}

static void point(double *S, void *context, double u, double v)
{
    const surface_input *in = context;
    double N[8], M[8];
    size_t p = 3, i = find_span(INPUT_SIDE - 1, p, u, in->knots), j = find_span(INPUT_SIDE - 1, p, v, in->knots);
    basis_funs(i, u, p, in->knots, N);
    basis_funs(j, v, p, in->knots, M);
    S[0] = S[1] = S[2] = 0.0;
    for (size_t l = 0; l <= p; l++) {
        double T[3] = {0.0, 0.0, 0.0};
        for (size_t k = 0; k <= p; k++) {
            for (size_t c = 0; c < 3; c++) {
                T[c] += N[k] * in->xyz[3 * ((i - p + k) * INPUT_SIDE + j - p + l) + c];
            }
        }
        for (size_t c = 0; c < 3; c++) {
            S[c] += M[l] * T[c];
        }
    }
}

int main(int argc, char **argv)
{
    surface_input in;
    surface_input_net(&in);
    return argc > 1 ? surface_peer_run("textbook_C", argv[1], point, &in) : 1;
}
