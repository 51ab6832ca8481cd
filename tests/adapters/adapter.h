/* adapter: what the adapters in C and C++ share: a request's words are taken one after the other, a reply's numbers put one after the other. */
#ifndef TESTS_ADAPTERS_ADAPTER_H
#define TESTS_ADAPTERS_ADAPTER_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of a request; points are 3n of them.  They live until the reply is written. */
typedef struct { size_t n; double *x; } list;
typedef struct { size_t p; list u, points, weights; size_t n; } curve;                 /* n: control points the knots ask for */
typedef struct { size_t p, q; list u, v, points, weights; size_t nu, nv; } surface;

size_t take_count(void);
double take_real(void);
list take_reals(void);
list take_points(void);
/* The number of the next word among the words of the null-ended list. */
size_t take_word(const char *const *words);
curve take_curve(void);
surface take_surface(void);
/* Memory until the reply is written; never null. */
double *room(size_t n);

/* Once an answer was refused or not supported, what is put no longer counts. */
void refuse(const char *reason);
void unsupport(const char *reason);
int refused(void);
void put(double value);
void put_all(const double *values, size_t n);
void put_list(const double *values, size_t n);                                         /* with its count */
void put_points(const double *values, size_t n);                                       /* n triples, with their count */

/* What every adapter looks at before it calls its library; each refuses for itself and then says 0. */
int knots_good(const list *u, size_t p);
int reals_good(const list *x);
int curve_good(const curve *c);
int surface_good(const surface *s);
/* The domain's last knot, or the like. */
int inside(const list *u, size_t p, double x);

typedef struct { const char *op; void (*answer)(void); } operation;
/* Answers until the input ends.  hello: `name=... version=... degree=...`; protocol and ops are added. */
int adapter_run(const char *hello, const operation *operations);

#ifdef __cplusplus
}
#endif
#endif
