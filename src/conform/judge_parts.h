/* judge_parts: what the files of judge share, and answer with them. */
#ifndef CONFORM_JUDGE_PARTS_H
#define CONFORM_JUDGE_PARTS_H
#include "etalon/conform/judge.h"
#include "etalon/exact/exact.h"

/* Words, in the order of the requests' lists. */
enum { JUDGE_ANY = 0, JUDGE_RIGHT, JUDGE_LEFT };
enum { JUDGE_DEGREE = 64, JUDGE_ORDER = 12, JUDGE_SAMPLES = 100, JUDGE_NUMBERS = 1000000 };

/* known: where it is not valid, there is a right value all the same (implementation-defined only, never of what is invalid). */
typedef struct {
    et_validity validity;
    int known;
    char reason[128];
} judge_case;

/* Everything that the arguments show: all rules but the rank of scattered data. */
void judge_valid(judge_case *c, const et_request *request);
/* The knot rule by the word's number. */
et_knotrule_kind judge_rule(size_t word);
/* 1 if the surfaces' knots inside the domain, p + 1 times or more, are met by one of the n parameters. */
int judge_jumps(const double *u, size_t nu, size_t p, const double *t, size_t n);

/* The wanted numbers, growing.  failed: memory was short, and nothing is put any more.  doubt: why a valid request need not be answered after all. */
typedef struct {
    double *want, *bound;
    size_t count, room;
    double condition;
    et_status failed;
    const char *doubt;
} judge_list;

void judge_list_free(judge_list *list);
/* A number that has to be equal. */
void judge_put(judge_list *list, double want);
void judge_put_all(judge_list *list, const double *want, size_t n);
/* A number that may be off by B and half an ulp; ku: K u, of which the condition is told. */
void judge_put_bound(judge_list *list, double want, double B, double ku);
/* A number that may be anything, though there is a better one. */
void judge_put_free(judge_list *list, double want);
/* B and half an ulp of want, a hair more. */
double judge_bound(double want, double B);
/* a b, 0 if either is. */
double judge_times(double a, double b);
double judge_coordinate(const et_vec3 *P, size_t c);
/* |c|, without over- or underflow on the way. */
double judge_length(const double c[3]);

/* The magnitudes m and s of docs/judge.md: of function first + j and the k-th derivative at [k (p+1) + j], j <= p, k <= d. */
typedef struct {
    size_t first, p, d;
    double length;
    double *m, *s;
} judge_line;
et_status judge_line_make(judge_line *line, const double *u, size_t nu, size_t p, double x, int left, size_t d);
void judge_line_free(judge_line *line);

/* A curve or a surface at a parameter; a curve's second direction is a line of one function. */
typedef struct {
    judge_line u, v;
    const et_vec3 *points;
    const double *weights;
    size_t nv;
    int curve;
} judge_net;
enum { JUDGE_WEIGHT = 3 };                /* the fourth component */

et_status judge_net_curve(judge_net *net, const et_curve *c, double x, int left, size_t d);
et_status judge_net_surface(judge_net *net, const et_surface *s, double x, double y, int left_u, int left_v, size_t d);
void judge_net_free(judge_net *net);
/* M and E of the derivative (a, b) of a component: of w P and w if there are weights. */
void judge_net_sums(double *M, double *E, const judge_net *net, size_t a, size_t b, size_t component);
double judge_net_k(const judge_net *net, size_t a, size_t b);
/* B[3 at + c] of all derivatives up to d, C the derivatives themselves; of a curve at = order, of a surface as in et_surface_partials. */
et_status judge_net_bounds(double *B, const judge_net *net, const et_vec3 *C, size_t d);

/* What is right, of the operations by groups; left: at knots the limits from the left where the request says any. */
et_status judge_basis(judge_list *list, const et_request *request, int left);
et_status judge_points(judge_list *list, const et_request *request, int left_u, int left_v);
et_status judge_normal(judge_list *list, const et_request *request, int left_u, int left_v);
et_status judge_edited(judge_list *list, const et_request *request);
et_status judge_parameters(judge_list *list, const et_request *request);
et_status judge_fitted(judge_list *list, const et_request *request);
et_status judge_measured(judge_list *list, const et_request *request);
/* D of a nearest point, and what the answered distance may be off from the one at the answered parameters. */
double judge_nearest_bound(double *own, const et_request *request, double distance);
/* The distance of the point asked for from the one at the parameters x, rounded once. */
et_status judge_distance_at(double *distance, const et_request *request, const double *x);
et_status judge_counted(judge_list *list, const et_request *request);
/* left[0], left[1]: which limits the request's sides mean, any being the one from the left where any_u, any_v say so.  The result has bit i if side i
 * is any. */
int judge_sides(int left[2], const et_request *request, int any_u, int any_v);
/* 1 if a parameter is a knot inside the domain, where limits may differ. */
int judge_at_knot(const et_request *request);
/* One set of sides of an operation that has some. */
et_status judge_limits(judge_list *list, const et_request *request, int left_u, int left_v);

/* A curve or a surface, and what is to be done with it: one code for both. */
typedef struct {
    et_curve c;
    et_surface s;
    int curve;
} judge_shape;
typedef struct {
    et_request_op op;
    et_direction along;
    double x, tolerance;
    size_t r;
} judge_editing;

void judge_shape_free(judge_shape *f);
et_vec3 *judge_shape_points(const judge_shape *f);
double *judge_shape_weights(const judge_shape *f);
size_t judge_shape_size(const judge_shape *f);
/* The curve or the surface of a request that is not invalid, so that it has one, in its memory; k: the argument where it begins. */
et_curve judge_curve_of(const et_request *request);
et_surface judge_surface_of(const et_request *request, size_t k);
/* The shape and the edit of such a request; K of its bounds. */
void judge_edit_of(judge_shape *f, judge_editing *e, const et_request *request);
double judge_edit_k(const judge_shape *f, const judge_editing *e);

/* A sentence about number `at` of the answer, as wanted. */
void judge_name(char name[96], const et_request *request, const double *want, size_t at);
/* Replies that are curves and surfaces, parameters and distances, or anything: judged with a look at the request. */
et_status judge_edit(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply);
et_status judge_removal(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply);
et_status judge_nearest(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply);
et_status judge_approximate(et_judgement *judgement, const et_request *request, const et_reply *reply);
/* got[0..n-1] against want and bound. */
void judge_compare(et_judgement *judgement, const et_request *request, const double *got, const double *want, const double *bound, size_t n);
void judge_say(et_judgement *judgement, et_verdict verdict, const char *format, ...);
#endif
