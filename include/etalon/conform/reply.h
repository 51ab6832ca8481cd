/* reply: an answer of the conformance protocol (docs/conformance.md). */
#ifndef ETALON_CONFORM_REPLY_H
#define ETALON_CONFORM_REPLY_H
#include "etalon/base/status.h"
#include "etalon/spline/curve.h"
#include "etalon/spline/surface.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_REPLY_OK = 0, ET_REPLY_REFUSED, ET_REPLY_UNSUPPORTED } et_reply_kind;

/* Values are doubles, counts too (they are at most 2^53). */
typedef struct {
    et_reply_kind kind;
    size_t count;
    double *x;                            /* owned */
    char reason[128];                     /* of refused and unsupported, cut if longer */
} et_reply;

/*@ predicate et_reply_stored(et_reply *reply) =
        0 <= reply->kind <= ET_REPLY_UNSUPPORTED && (reply->count == 0 || \valid_read(reply->x + (0 .. reply->count - 1)));
*/

/* What an adapter offers (`hello`). */
typedef struct {
    char name[64], version[64];
    size_t degree, order;                 /* SIZE_MAX: no limit */
    int rational;
    int any, left, right;                 /* sides */
    double knot_tolerance;
    int op[64];                           /* op[et_request_op] */
    size_t unknown;                       /* words of ops that are no operation */
} et_hello;

/* The line `ID KIND VALUES...`; *id its number, a count.  Values are reals, read as by et_request_parse; a reason is cut to 127 bytes, and what is no
 * printable character in it becomes a blank.  ET_EFORMAT with a sentence, ET_ENOMEM. */
/*@ requires reply:   \valid(reply) && \valid(id);
    requires line:    valid_read_string(line);
    requires message: message == \null || \valid(message);
    requires apart:   \separated(reply, id, message);
    assigns  *reply, *id, *message;
    ensures  status:  \result == ET_OK || \result == ET_EFORMAT || \result == ET_ENOMEM;
    ensures  made:    \result == ET_OK ==> et_reply_stored(reply) && *id <= 9007199254740992;
    ensures  kept:    \result != ET_OK ==> *reply == \old(*reply) && *id == \old(*id);
*/
et_status et_reply_parse(et_reply *reply, uint64_t *id, const char *line, et_message *message);
/* `ID KIND VALUES...` as a new string, freed by free(): reals as C's %a writes them, whatever the locale.  ET_ENOMEM. */
/*@ requires line:   \valid(line);
    requires reply:  \valid_read(reply) && et_reply_stored((et_reply *)reply);
    assigns  *line;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  text:   \result == ET_OK ==> valid_read_string(*line);
    ensures  kept:   \result != ET_OK ==> *line == \old(*line);
*/
et_status et_reply_print(char **line, uint64_t id, const et_reply *reply);

/* Frees the values and zeroes the struct; nothing to do for a zeroed one.
 * Golden: none (storage). */
/*@ requires reply: \valid(reply);
    assigns  *reply;
    ensures  zero:  reply->x == \null && reply->count == 0 && reply->kind == ET_REPLY_OK;
*/
void et_reply_free(et_reply *reply);

/* x[0..n-1] appended.  ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires reply:  \valid(reply) && et_reply_stored(reply);
    requires x:      n == 0 || \valid_read(x + (0 .. n - 1));
    assigns  *reply;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  longer: \result == ET_OK ==> reply->count == \old(reply->count) + n && et_reply_stored(reply);
    ensures  kept:   \result != ET_OK ==> *reply == \old(*reply);
*/
et_status et_reply_put(et_reply *reply, const double *x, size_t n);

/* Appended: `p u[] P{} w[]`.  ET_ENOMEM: none of it is.
 * Golden: none (what is put is what et_reply_get_curve gets). */
/*@ requires reply:  \valid(reply) && et_reply_stored(reply);
    requires c:      \valid_read(c) && et_curve_stored((et_curve *)c);
    assigns  *reply;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  longer: \result == ET_OK ==> reply->count == \old(reply->count) + 5 + c->p + 4 * c->n + (c->weights == \null ? 0 : c->n);
    ensures  kept:   \result != ET_OK ==> reply->count == \old(reply->count);
*/
et_status et_reply_put_curve(et_reply *reply, const et_curve *c);

/* Appended: `p q u[] v[] P{} w[]`.  ET_ENOMEM: none of it is.
 * Golden: none (what is put is what et_reply_get_surface gets). */
/*@ requires reply:  \valid(reply) && et_reply_stored(reply);
    requires s:      \valid_read(s) && et_surface_stored((et_surface *)s);
    assigns  *reply;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  longer: \result == ET_OK ==> reply->count == \old(reply->count) + 8 + s->nu + s->p + s->nv + s->q + 3 * s->nu * s->nv +
                         (s->weights == \null ? 0 : s->nu * s->nv);
    ensures  kept:   \result != ET_OK ==> reply->count == \old(reply->count);
*/
et_status et_reply_put_surface(et_reply *reply, const et_surface *s);

/* The curve that stands at x[*at], with storage of its own; *at moves behind it.  ET_EFORMAT: the numbers do not make one: a count that is none or
 * says more than there is, n + p + 1 knots for other than n > p points, weights for some points only.  ET_ENOMEM.
 * Golden: none (what is put is what is got). */
/*@ requires c:      \valid(c) && \valid(at);
    requires reply:  \valid_read(reply) && et_reply_stored((et_reply *)reply);
    requires apart:  \separated(c, at, reply);
    assigns  *c, *at;
    ensures  status: \result == ET_OK || \result == ET_EFORMAT || \result == ET_ENOMEM;
    ensures  made:   \result == ET_OK ==> et_curve_stored(c) && c->n > c->p && \old(*at) < *at <= reply->count;
    ensures  kept:   \result != ET_OK ==> *c == \old(*c) && *at == \old(*at);
*/
et_status et_reply_get_curve(et_curve *c, size_t *at, const et_reply *reply);

/* The surface that stands at x[*at], as et_reply_get_curve.
 * Golden: none (what is put is what is got). */
/*@ requires s:      \valid(s) && \valid(at);
    requires reply:  \valid_read(reply) && et_reply_stored((et_reply *)reply);
    requires apart:  \separated(s, at, reply);
    assigns  *s, *at;
    ensures  status: \result == ET_OK || \result == ET_EFORMAT || \result == ET_ENOMEM;
    ensures  made:   \result == ET_OK ==> et_surface_stored(s) && s->nu > s->p && s->nv > s->q && \old(*at) < *at <= reply->count;
    ensures  kept:   \result != ET_OK ==> *s == \old(*s) && *at == \old(*at);
*/
et_status et_reply_get_surface(et_surface *s, size_t *at, const et_reply *reply);

/* 1 if kind and values are the same bit for bit (NaN equal to NaN; 0 and -0 differ), else 0; reasons do not count. */
/*@ requires a:       \valid_read(a) && et_reply_stored((et_reply *)a);
    requires b:       \valid_read(b) && et_reply_stored((et_reply *)b);
    assigns  \nothing;
    ensures  flag:    \result == 0 || \result == 1;
    ensures  differs: a->kind != b->kind || a->count != b->count ==> \result == 0;
*/
int et_reply_same(const et_reply *a, const et_reply *b);

/* The words `key=value` of a reply to hello (the line behind `0 ok `); keys that are not known are passed over.  Absent: degree SIZE_MAX, order 3,
 * rational 0, side any, knot_tolerance 0.  Names are cut to 63 bytes.  ET_EFORMAT with a sentence: protocol (1), name, version or ops missing, a
 * key twice, a value that its key cannot have, a word that is not key=value.  ET_ENOMEM. */
/*@ requires hello:   \valid(hello);
    requires words:   valid_read_string(words);
    requires message: message == \null || \valid(message);
    requires apart:   \separated(hello, message);
    assigns  *hello, *message;
    ensures  status:  \result == ET_OK || \result == ET_EFORMAT || \result == ET_ENOMEM;
    ensures  names:   \result == ET_OK ==> hello->name[0] != 0 && hello->version[0] != 0;
    ensures  sides:   \result == ET_OK ==> hello->any == 1 || hello->left == 1 || hello->right == 1;
    ensures  kept:    \result != ET_OK ==> *hello == \old(*hello);
*/
et_status et_reply_hello(et_hello *hello, const char *words, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
