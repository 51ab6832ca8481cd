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

/* The line `ID KIND VALUES...`; *id its number.  ET_EFORMAT with a sentence, ET_ENOMEM. */
et_status et_reply_parse(et_reply *reply, uint64_t *id, const char *line, et_message *message);
/* `ID KIND VALUES...` as a new string, freed by free(). */
et_status et_reply_print(char **line, uint64_t id, const et_reply *reply);
void et_reply_free(et_reply *reply);
/* x[0..n-1] appended.  ET_ENOMEM. */
et_status et_reply_put(et_reply *reply, const double *x, size_t n);
/* Appended: `p u[] P{} w[]`, or that of a surface. */
et_status et_reply_put_curve(et_reply *reply, const et_curve *c);
et_status et_reply_put_surface(et_reply *reply, const et_surface *s);
/* The curve (surface) that stands at x[*at], with storage of its own; *at moves behind it.  ET_EFORMAT: the numbers do not make one (counts), ET_ENOMEM. */
et_status et_reply_get_curve(et_curve *c, size_t *at, const et_reply *reply);
et_status et_reply_get_surface(et_surface *s, size_t *at, const et_reply *reply);
/* 1 if kind and values are the same bit for bit (NaN equal to NaN), else 0. */
int et_reply_same(const et_reply *a, const et_reply *b);
/* The words `key=value` of a reply to hello (the line behind `0 ok `). */
et_status et_reply_hello(et_hello *hello, const char *words, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
