/* optimum_cases: what the tests of the optimum's parts share: small fits in every state, and basis functions by their definition. */
#ifndef TESTS_REFINE_OPTIMUM_CASES_H
#define TESTS_REFINE_OPTIMUM_CASES_H
#include "etalon/fit/fit.h"
#include "gen.h"
#include <arb.h>

enum { OPTIMUM_MOST = 8, OPTIMUM_CLASSES = 2 * OPTIMUM_MOST * OPTIMUM_MOST, OPTIMUM_BITS = 320 };

typedef struct {
    et_fit fit;
    et_doublenet control;
    size_t nov, n;                        /* classes of data and of control points */
    et_vec3 data[OPTIMUM_CLASSES], start[OPTIMUM_CLASSES];
} optimum_case;

/* tame: even knots, more data than control points; steep: the same, the parameters of one direction or both pushed together; bare: few data and any
 * parameters, so that control points stay undetermined; loose: the parameters do not reach the ends. */
typedef enum { TAME, STEEP, BARE, LOOSE } optimum_state;

/* Everything 0 but the sizes; false where there is no room. */
bool optimum_case_new(optimum_case *c, size_t p, size_t q, et_doublenet control, et_doublenet data);
bool optimum_case_draw(gen *g, optimum_case *c, optimum_state state);
void optimum_case_end(optimum_case *c);
/* The top view's knots and parameters from the bottom's, control points from start. */
void optimum_case_close(optimum_case *c);

/* n + p + 1 knots, clamped on [0, 1], spans alike. */
void optimum_case_even(double *u, size_t n, size_t p);
/* n + p + 1 knots, clamped or not, tiny spans and full multiplicity often. */
void optimum_case_knots(gen *g, double *u, size_t n, size_t p);
/* nt parameters in order: from end to end and even (0), pushed together (1), anywhere, knots and repeated ones often (2). */
void optimum_case_parameters(gen *g, double *t, size_t nt, const double *u, size_t n, size_t p, size_t kind);

/* N_i,p(t) by the recursion of Cox and de Boor, 0/0 = 0, the last span that is not empty closed; t outside of the domain is moved to its end. */
void optimum_case_basis(arb_t N, const double *u, size_t n, size_t p, size_t i, double t);
double optimum_case_nearest(const arb_t x);

bool optimum_case_same(const double *a, const double *b, size_t n);
#endif
