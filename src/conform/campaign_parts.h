/* campaign_parts: what the parts of the module campaign share. */
#ifndef ETALON_CONFORM_CAMPAIGN_PARTS_H
#define ETALON_CONFORM_CAMPAIGN_PARTS_H
#include "etalon/base/rng.h"
#include "etalon/conform/campaign.h"

/* ---- where an operation has what: numbers of arguments, -1 for none ---- */

typedef struct { int degree, knots, at, sites, side; } campaign_axis;
typedef struct {
    size_t axes;                          /* directions: 0; 1 of a curve; 2 of a surface; 4 of two surfaces */
    campaign_axis axis[4];
    int net[2];                           /* control points; the weights are the argument behind */
    int data;                             /* points that are no control points */
    int grid;                             /* 1: data point (i, j) belongs to site i of one axis and site j of the other */
    int order, along, at, times, tolerance;     /* at: the knot of an edited surface, whose direction is told by `along` */
} campaign_layout;
const campaign_layout *campaign_layout_of(et_request_op op);
/* The argument that holds the parameter (or the knot edited) of that axis; -1: none. */
int campaign_at(const et_request *request, size_t axis);
/* How many arguments the operation has. */
size_t campaign_arguments(et_request_op op);
/* 1 if degree, order, weights, sides and distances of knots are such as hello offers. */
int campaign_offered(const et_request *request, const et_hello *hello);

/* ---- drawing ---- */

/* Memory is taken once, at the start; `room` is enough for the greatest case (campaign.c). */
typedef struct {
    et_rng *rng;
    const et_hello *hello;
    et_request *request;
    const campaign_layout *layout;
    et_request_op op;
    et_category category;
    uint64_t number;                      /* of the case: the kinds of a category take turns, so that a few cases show many */
    int rational, unit, smooth;           /* weights; knots on [0,1]; knots of multiplicity p at most inside */
    int exact;                            /* knots into which insertion is exact: multiplicity p/2 and more, distances 1 */
    int e_points, e_knots;                /* exponents of two by which coordinates and knots are scaled */
    double o_points, o_knots;             /* what is added to them */
    double *room;
    size_t used, size;
    et_status status;
} campaign_maker;

/* Degree, knots and number of control points of one direction. */
typedef struct { size_t p, nu, n; double *u; } campaign_basis;

size_t campaign_pick(campaign_maker *m, size_t n);                 /* 0 .. n-1 */
size_t campaign_kind(const campaign_maker *m, size_t n);           /* the case's number, modulo n */
double campaign_real(campaign_maker *m, double lo, double hi);     /* 53 bits */
double campaign_clamp(double lo, double x, double hi);             /* C's fmin and fmax leave the sign of a zero open */
double *campaign_array(campaign_maker *m, size_t n);
void campaign_count(campaign_maker *m, int k, size_t count);
void campaign_list(campaign_maker *m, int k, const double *x, size_t n);     /* reals or points: n of them */
void campaign_number(campaign_maker *m, int k, double x);

/* knots */
void campaign_scales(campaign_maker *m);                           /* sets e_points ... o_knots for extreme scales */
size_t campaign_degree(campaign_maker *m, size_t axis, size_t least, size_t most);
campaign_basis campaign_knots(campaign_maker *m, size_t axis, size_t p, size_t spans);
size_t campaign_spans(campaign_maker *m, size_t axis);
double campaign_place(campaign_maker *m, const campaign_basis *b, size_t axis);      /* a parameter, as the category wants it */
double campaign_inside(campaign_maker *m, const campaign_basis *b);                  /* anywhere in the domain */
void campaign_put_basis(campaign_maker *m, const campaign_axis *at, const campaign_basis *b);
size_t campaign_multiplicity(const campaign_basis *b, double x);
int campaign_side(campaign_maker *m);                              /* the number of a word that hello offers */

/* points: P has 3 n numbers, n = nx ny */
void campaign_points(campaign_maker *m, double *P, size_t nx, size_t ny);
void campaign_data(campaign_maker *m, double *P, size_t nx, size_t ny);      /* as a grid that was measured */
double *campaign_weights(campaign_maker *m, size_t n);
void campaign_close(double *P, size_t nx, size_t ny, size_t kind);           /* last line = first line */

/* The families; each fills m->request. */
void campaign_draw_basis(campaign_maker *m);
void campaign_draw_spline(campaign_maker *m);
void campaign_draw_edit(campaign_maker *m);
void campaign_draw_fit(campaign_maker *m);
void campaign_draw_nearest(campaign_maker *m);
void campaign_draw_error(campaign_maker *m);
void campaign_draw_seam(campaign_maker *m);
void campaign_draw_parameters(campaign_maker *m);
void campaign_draw_knots(campaign_maker *m);
void campaign_draw_approximate(campaign_maker *m);
void campaign_draw_net(campaign_maker *m);
/* A valid request made invalid in one place. */
void campaign_spoil(campaign_maker *m);

#endif
