/* request: a question of the conformance protocol (docs/conformance.md): an operation and its arguments, whether they are valid or not. */
#ifndef ETALON_CONFORM_REQUEST_H
#define ETALON_CONFORM_REQUEST_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include "etalon/spline/surface.h"
#include "etalon/spline/curve.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    ET_OP_SPAN = 0, ET_OP_MULTIPLICITY, ET_OP_GREVILLE, ET_OP_BASIS, ET_OP_BASIS_DERS, ET_OP_CURVE_POINT, ET_OP_CURVE_DERS, ET_OP_SURFACE_POINT,
    ET_OP_SURFACE_DERS, ET_OP_SURFACE_NORMAL, ET_OP_CURVE_INSERT, ET_OP_CURVE_REMOVE, ET_OP_CURVE_ELEVATE, ET_OP_SURFACE_INSERT, ET_OP_SURFACE_REMOVE,
    ET_OP_SURFACE_ELEVATE, ET_OP_PARAMETERS, ET_OP_PARAMETERS_GRID, ET_OP_KNOTS, ET_OP_FIT_CURVE, ET_OP_FIT_GRID, ET_OP_FIT_SCATTERED, ET_OP_APPROXIMATE,
    ET_OP_CURVE_NEAREST, ET_OP_SURFACE_NEAREST, ET_OP_SURFACE_ERROR, ET_OP_NET_COUNTS, ET_OP_NET_CLASS, ET_OP_NET_NODE, ET_OP_SEAM_GAP,
    ET_OPS
} et_request_op;

typedef enum { ET_ARG_COUNT = 0, ET_ARG_REAL, ET_ARG_REALS, ET_ARG_POINTS, ET_ARG_WORD } et_request_kind;

/* What an argument is: its name in the table of docs/conformance.md ("p", "u", "points", "side_u", ...), its kind and, of a word, the words there are. */
typedef struct {
    const char *name;
    et_request_kind kind;
    const char *const *words;             /* null past the last; ET_ARG_WORD */
} et_request_shape;

/* COUNT: count.  WORD: count, the number of the word.  REAL: x[0].  REALS: x[0..count-1].  POINTS: x[0..3*count-1]. */
typedef struct {
    size_t count;
    double *x;                            /* owned; null where there is nothing */
} et_request_value;

enum { ET_REQUEST_ARGS = 16 };
typedef struct {
    et_request_op op;
    et_request_value arg[ET_REQUEST_ARGS];
} et_request;

/* "span", "multiplicity", ...; null past the last. */
const char *et_request_name(et_request_op op);
/* The operation of that name; ET_OPS if there is none. */
et_request_op et_request_find(const char *name);
/* The k-th argument of the operation; null past the last. */
const et_request_shape *et_request_argument(et_request_op op, size_t k);

/* A request with all counts and words 0, reals 0 (x[0] allocated), and empty arrays.  ET_EINVAL (op), ET_ENOMEM.  Freed by et_request_free. */
et_status et_request_new(et_request *request, et_request_op op);
void et_request_free(et_request *request);
et_status et_request_copy(et_request *copy, const et_request *request);
/* Argument k gets the count (or the word's number), or a copy of reals or points (x may be null for count 0).  ET_EINVAL (kind, k), ET_ENOMEM. */
et_status et_request_set(et_request *request, size_t k, size_t count, const double *x);

/* The line `OP ARGUMENTS...` (no id, no line end).  ET_EFORMAT with a sentence that names the word at fault, ET_ENOMEM. */
et_status et_request_parse(et_request *request, const char *line, et_message *message);
/* The line as a new string, freed by free().  ET_ENOMEM. */
et_status et_request_print(char **line, const et_request *request);

/* The curve at arguments k .. k+3, the surface at k .. k+5, sharing the request's memory: not to be freed.  Sizes are taken from the knots; ET_EFORMAT if
 * counts of knots, points and weights do not fit each other (nothing else is checked: see et_curve_valid). */
et_status et_request_curve(et_curve *c, const et_request *request, size_t k);
et_status et_request_surface(et_surface *s, const et_request *request, size_t k);

#ifdef __cplusplus
}
#endif
#endif
