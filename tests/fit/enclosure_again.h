/* enclosure_again: everything an enclosure says, computed a second time: the formulas of docs/enclosure.md ("In numbers") in the order told there,
 * with the basis functions by the recursion of Cox and de Boor, matrices whole, sums without skipping anything.  The same operations in the same
 * order give the same bits on every processor, so that radii, norms, backward errors, statuses and messages must be equal and not only near. */
#ifndef TESTS_FIT_ENCLOSURE_AGAIN_H
#define TESTS_FIT_ENCLOSURE_AGAIN_H
#include "fit/enclosure_parts.h"
#include "gen.h"
#include <math.h>

enum { SIDE = 5, NODES = SIDE * SIDE, KNOTS = 2 * SIDE, LEFT_OUT = 999 };

#define TINY 0x1p-1000
#define U2 0x1p-106

static inline bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static inline bool same_dd(et_dd a, et_dd b)
{
    return same(a.hi, b.hi) && same(a.lo, b.lo);
}

static inline et_dd whole(double x)
{
    return (et_dd){ x, 0 };
}

/* ---- systems ---- */

typedef struct {
    size_t rows, columns, width, tall;
    size_t at[NODES * NODES]; /* of the row's entries; 0 for those that are left out */
    et_dd a[NODES * NODES];
    double weight[NODES], share[NODES], relative;
    double T[NODES][NODES], C[NODES][NODES], defect, norm, inverse;
    et_dd r[NODES], g[NODES];
} again_system;

void again_direction(again_system *s, const double *t, size_t m, const double *u, size_t n, size_t p, bool inner);
void again_product(again_system *s, const again_system *U, const again_system *V, const size_t *number, size_t columns);
et_status again_verify(again_system *s);
/* The solution of a verified system for one right-hand side, each datum off by error at most, and its radii. */
void again_column(et_dd *x, double *radius, again_system *s, const et_dd *d, const double *error);

/* Where x is a knot p times or more, the function that is 1 there: of those that could be the last, at the end of the domain the first; else n. */
size_t again_alone(const double *u, size_t n, size_t p, double x);
/* The most functions that parameters of their own make positive; inner: of all functions but the first and the last. */
size_t again_rank(const double *t, size_t m, const double *u, size_t n, size_t p, bool inner);

/* ---- solutions ---- */

typedef struct {
    et_dd x[2][3 * NODES];
    double radius[2][3 * NODES], norm, inverse;
    char text[sizeof ((et_message *)0)->text];
} again_answer;

bool again_on_border(et_doublenet n, size_t i, size_t j);
bool again_at_corner(et_doublenet n, size_t i, size_t j);
et_status again_solve(again_answer *x, const enclosure_job *k);
double again_backward(const enclosure_job *k, const again_answer *x);

/* ---- cases ---- */

typedef struct {
    et_fit fit;
    et_fit_options options;
    enclosure_job job;
    et_message message;
    double t[2][2][SIDE], u[2][2][KNOTS], D[2][3 * NODES];
    et_vec3 P[2][NODES];
} again_case;

/* Sizes, degrees, approach, corners, parameters and knots. */
void again_draw_frame(gen *g, again_case *c);
/* Data of a job: between -1 and 1, next to nothing, or past what sums can hold; what scaling lost may be much, to be seen. */
void again_draw_job(gen *g, again_case *c);
/* Control points, near those of x where there is one. */
void again_draw_points(gen *g, again_case *c, const enclosure_solution *x);
/* Data of any unit for the functions themselves, and their job. */
void again_draw_data(gen *g, again_case *c, et_vec3 *data);
/* The job of data: coordinates over powers of two, the greatest in [1/2, 1). */
void again_take_job(again_case *c, const et_vec3 *data);
void again_tell(gen *g, const again_case *c);
#endif
