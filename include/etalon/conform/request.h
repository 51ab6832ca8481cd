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
    ET_OP_SURFACE_ELEVATE, ET_OP_PARAMETERS, ET_OP_PARAMETERS_GRID, ET_OP_KNOTS, ET_OP_FIT_CURVE, ET_OP_FIT_GRID, ET_OP_FIT_SCATTERED,
    ET_OP_APPROXIMATE, ET_OP_CURVE_NEAREST, ET_OP_SURFACE_NEAREST, ET_OP_SURFACE_ERROR, ET_OP_NET_COUNTS, ET_OP_NET_CLASS, ET_OP_NET_NODE, ET_OP_SEAM_GAP,
    ET_OPS
} et_request_op;

typedef enum { ET_ARG_COUNT = 0, ET_ARG_REAL, ET_ARG_REALS, ET_ARG_POINTS, ET_ARG_WORD } et_request_kind;

/* What an argument is: its name in the table of docs/conformance.md ("p", "u", "points", "side_u", ...), its kind and, of a word, the words there
 * are. */
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

/*@ predicate et_request_stored(et_request *request) =
        0 <= request->op < ET_OPS && \forall integer k; 0 <= k < ET_REQUEST_ARGS ==> request->arg[k].x == \null || \valid_read(request->arg[k].x);
*/

/* "span", "multiplicity", ...; null past the last. */
/*@ assigns \result \from op;
    ensures past: op < 0 || op >= ET_OPS <==> \result == \null;
    ensures text: \result == \null || valid_read_string(\result);
*/
const char *et_request_name(et_request_op op);
/* The operation of that name; ET_OPS if there is none. */
/*@ requires name:  valid_read_string(name);
    assigns  \result \from name[0 .. strlen(name)];
    ensures  range: 0 <= \result <= ET_OPS;
*/
et_request_op et_request_find(const char *name);
/* The k-th argument of the operation; null past the last, and for what is no operation. */
/*@ assigns \result \from op, k;
    ensures past:  k >= ET_REQUEST_ARGS - 2 || op < 0 || op >= ET_OPS ==> \result == \null;
    ensures shape: \result == \null || (\valid_read(\result) && valid_read_string(\result->name) &&
                       (\result->kind == ET_ARG_WORD <==> \result->words != \null));
*/
const et_request_shape *et_request_argument(et_request_op op, size_t k);

/* A request with all counts and words 0, reals 0 (x[0] allocated), and empty arrays.  ET_EINVAL (op), ET_ENOMEM.  Freed by et_request_free.
 * Golden: none (storage). */
/*@ requires request: \valid(request);
    assigns  *request;
    ensures  made:    \result == ET_OK ==> et_request_stored(request) && request->op == op;
    ensures  none:    op < 0 || op >= ET_OPS ==> \result == ET_EINVAL;
    ensures  kept:    \result != ET_OK ==> *request == \old(*request);
*/
et_status et_request_new(et_request *request, et_request_op op);

/* Frees the arrays and zeroes the struct; nothing to do for a zeroed one.
 * Golden: none (storage). */
/*@ requires request: \valid(request) && et_request_stored(request);
    assigns  *request;
    ensures  zero:    \forall integer k; 0 <= k < ET_REQUEST_ARGS ==> request->arg[k].x == \null && request->arg[k].count == 0;
*/
void et_request_free(et_request *request);

/* A copy with storage of its own.  ET_EINVAL (no operation), ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires copy:    \valid(copy);
    requires request: \valid_read(request) && et_request_stored((et_request *)request);
    requires apart:   \separated(copy, request);
    assigns  *copy;
    ensures  counts:  \result == ET_OK ==> copy->op == request->op &&
                          \forall integer k; 0 <= k < ET_REQUEST_ARGS ==> copy->arg[k].count == request->arg[k].count;
    ensures  kept:    \result != ET_OK ==> *copy == \old(*copy);
*/
et_status et_request_copy(et_request *copy, const et_request *request);

/* Argument k gets the count (or the word's number), the real x[0] (count is then of no meaning), or a copy of `count` reals or points (x may be
 * null for count 0; x may be the argument's own array).  ET_EINVAL (no such argument, no such word, a count above 2^53, x missing), ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires request: \valid(request) && et_request_stored(request);
    requires x:       x == \null || \valid_read(x);
    assigns  request->arg[k];
    ensures  none:    k >= ET_REQUEST_ARGS ==> \result == ET_EINVAL;
    ensures  kept:    \result != ET_OK ==> *request == \old(*request);
*/
et_status et_request_set(et_request *request, size_t k, size_t count, const double *x);

/* The line `OP ARGUMENTS...` (no id).  Counts are decimal digits, at most 2^53; reals what strtod reads in the "C" locale whatever the program's:
 * hex and decimal, to the nearest double (beyond the range infinity), and names of infinity and NaN in any capitals.  Words may be apart by more
 * than one blank or tab, and the line may end by CR or LF.  What is allocated is at most proportional to the line's length, whatever counts say.
 * ET_EFORMAT with a sentence that names the argument and the word at fault, ET_ENOMEM. */
/*@ requires request: \valid(request);
    requires line:    valid_read_string(line);
    requires message: message == \null || \valid(message);
    requires apart:   \separated(request, message);
    assigns  *request, *message;
    ensures  status:  \result == ET_OK || \result == ET_EFORMAT || \result == ET_ENOMEM;
    ensures  made:    \result == ET_OK ==> et_request_stored(request);
    ensures  kept:    \result != ET_OK ==> *request == \old(*request);
*/
et_status et_request_parse(et_request *request, const char *line, et_message *message);
/* The line as a new string, freed by free(): words apart by one blank, reals as C's %a writes them.  ET_ENOMEM. */
/*@ requires line:    \valid(line);
    requires request: \valid_read(request) && et_request_stored((et_request *)request);
    assigns  *line;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  text:    \result == ET_OK ==> valid_read_string(*line);
    ensures  kept:    \result != ET_OK ==> *line == \old(*line);
*/
et_status et_request_print(char **line, const et_request *request);

/* The curve at arguments k .. k+3, sharing the request's memory: not to be freed.  Its size is taken from the knots; ET_EFORMAT if counts of knots,
 * points and weights do not fit each other, or there are fewer than p + 2 knots (nothing else is checked: see et_curve_valid).  ET_EINVAL: there
 * stands no curve.
 * Golden: none (storage). */
/*@ requires c:       \valid(c);
    requires request: \valid_read(request) && et_request_stored((et_request *)request);
    requires apart:   \separated(c, request);
    assigns  *c;
    ensures  status:  \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT;
    ensures  sizes:   \result == ET_OK ==> c->n >= 1 && c->p == request->arg[k].count && c->n + c->p + 1 == request->arg[k + 1].count;
    ensures  kept:    \result != ET_OK ==> *c == \old(*c);
*/
et_status et_request_curve(et_curve *c, const et_request *request, size_t k);

/* The surface at arguments k .. k+5, as et_request_curve.
 * Golden: none (storage). */
/*@ requires s:       \valid(s);
    requires request: \valid_read(request) && et_request_stored((et_request *)request);
    requires apart:   \separated(s, request);
    assigns  *s;
    ensures  status:  \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT;
    ensures  sizes:   \result == ET_OK ==> s->nu >= 1 && s->nv >= 1 && s->nu * s->nv == request->arg[k + 4].count;
    ensures  kept:    \result != ET_OK ==> *s == \old(*s);
*/
et_status et_request_surface(et_surface *s, const et_request *request, size_t k);

#ifdef __cplusplus
}
#endif
#endif
