/* answer: Etalon answers a request, by its fast functions or by its exact layer; refused what docs/conformance.md calls invalid. */
#ifndef ETALON_CONFORM_ANSWER_H
#define ETALON_CONFORM_ANSWER_H
#include "etalon/conform/reply.h"
#include "etalon/conform/request.h"
#ifdef __cplusplus
extern "C" {
#endif

/* What Etalon offers: exact != 0 all operations, else those that the fast functions have (the nearest points are missing).  Degrees to 64,
 * derivatives
 * to the eighth, weights, limits from either side, knots told apart to the bit.
 * Golden: none (a list of what there is). */
/*@ assigns \nothing;
    ensures sides:    \result.any == 1 && \result.left == 1 && \result.right == 1 && \result.rational == 1 && \result.knot_tolerance == 0.0;
    ensures limits:   \result.degree == 64 && \result.order == 8;
    ensures all:      exact != 0 ==> \forall integer op; 0 <= op < ET_OPS ==> \result.op[op] == 1;
*/
et_hello et_answer_hello(int exact);

/* *reply is refused where the request is invalid, or implementation-defined without a right value (with the reason), or where the fast functions
 * find it
 * numerically singular; unsupported where hello does not offer it; else computed in doubles by the public functions of the other rooms.  With side
 * `any` limits are those from the right.  What *reply held before is not freed.  ET_ENOMEM only.
 * Golden: none (the frozen vectors of golden/conformance are asked and judged). */
/*@ requires reply:   \valid(reply) && \valid_read(request) && \separated(reply, request);
    assigns  *reply;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  made:    \result == ET_OK ==> et_reply_stored(reply);
    ensures  kept:    \result != ET_OK ==> *reply == \old(*reply);
*/
et_status et_answer_fast(et_reply *reply, const et_request *request);

/* The same of the exact layer: every number correctly rounded (et_judge_truth), nothing unsupported.  Where there are many right answers: a removal
 * with a
 * tolerance is the exact one unless the fast one takes more knots; nearest is one parameter of a least distance; an approximation is the exact least
 * squares surface at chord length parameters (uniform ones where the data coincide) with piegl knots.  ET_ENOMEM only.
 * Golden: none (the frozen vectors of golden/conformance are asked and judged). */
/*@ requires reply:   \valid(reply) && \valid_read(request) && \separated(reply, request);
    assigns  *reply;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  offered: \result == ET_OK ==> reply->kind != ET_REPLY_UNSUPPORTED;
    ensures  made:    \result == ET_OK ==> et_reply_stored(reply);
    ensures  kept:    \result != ET_OK ==> *reply == \old(*reply);
*/
et_status et_answer_exact(et_reply *reply, const et_request *request);

#ifdef __cplusplus
}
#endif
#endif
