/* fit/param: lines for columns, in other units, and means of means. */
#include "etalon/fit/param.h"
#include "gen.h"
#include <math.h>
#include <string.h>

enum { SIDE = 5 };

/* Of the grid turned the parameters change places; of points 2^e times as far they are the same: every bit. */
verdict prop_param_grid_turned(gen *g)
{
    const size_t nx = gen_between(g, 2, SIDE), ny = gen_between(g, 2, SIDE);
    const et_param_method method = (et_param_method)gen_upto(g, 3);
    const int e = (int)gen_upto(g, 40);
    et_vec3 D[SIDE * SIDE], T[SIDE * SIDE];
    double s[SIDE], r[SIDE], a[SIDE], b[SIDE];
    size_t flat, turned, far;

    gen_points(g, &D[0].x, nx * ny);
    for (size_t k = 0; k < nx * ny; k++)
        T[k % ny * nx + k / ny] = D[k];
    bool ok = gen_check(g, et_param_grid(s, nx, r, ny, &flat, D, method) == ET_OK && et_param_grid(a, ny, b, nx, &turned, T, method) == ET_OK,
            "not made");
    ok = ok && gen_check(g, flat == turned && memcmp(s, b, nx * sizeof *s) == 0 && memcmp(r, a, ny * sizeof *r) == 0, "turned: other parameters");
    for (size_t k = 0; k < nx * ny; k++)
        D[k] = (et_vec3){ldexp(D[k].x, e), ldexp(D[k].y, e), ldexp(D[k].z, e)};
    ok = ok && gen_check(g, et_param_grid(b, nx, a, ny, &far, D, method) == ET_OK && far == flat, "not made");
    return ok && gen_check(g, memcmp(s, b, nx * sizeof *s) == 0 && memcmp(r, a, ny * sizeof *r) == 0, "2^%d times: other parameters",
            e) ? PASS : FAIL;
}

/* It does not matter which is first, and once is enough. */
verdict prop_param_standardise_again(gen *g)
{
    const size_t n = gen_between(g, 2, SIDE);
    double a[SIDE], b[SIDE], c[SIDE], d[SIDE];

    for (size_t i = 0; i < n; i++) {
        a[i] = d[i] = gen_real(g, 0, 1);
        b[i] = c[i] = gen_real(g, 0, 1);
    }
    et_param_standardise(a, b, n);
    et_param_standardise(c, d, n);
    bool ok = gen_check(g, memcmp(a, c, n * sizeof *a) == 0 && memcmp(b, d, n * sizeof *b) == 0, "exchanged: other means");
    et_param_standardise(c, d, n);
    return ok && gen_check(g, memcmp(a, c, n * sizeof *a) == 0 && memcmp(a, d, n * sizeof *a) == 0, "again: other means") ? PASS : FAIL;
}
