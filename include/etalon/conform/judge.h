/* judge: the exact result of a request, and the verdict on a reply (docs/conformance.md, "What is valid", "How an answer is judged"). */
#ifndef ETALON_CONFORM_JUDGE_H
#define ETALON_CONFORM_JUDGE_H
#include "etalon/conform/reply.h"
#include "etalon/conform/request.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    ET_VERDICT_CORRECTLY_ROUNDED = 0, ET_VERDICT_WITHIN_BOUND, ET_VERDICT_INACCURATE, ET_VERDICT_WRONG, ET_VERDICT_NON_FINITE,
    ET_VERDICT_WRONGLY_ACCEPTED, ET_VERDICT_WRONGLY_REFUSED, ET_VERDICT_CRASH, ET_VERDICT_TIMEOUT, ET_VERDICT_NONDETERMINISTIC,
    ET_VERDICT_UNSUPPORTED,
    ET_VERDICTS
} et_verdict;

typedef enum { ET_VALID = 0, ET_IMPLEMENTATION_DEFINED, ET_INVALID } et_validity;

/* What is right: the reply's numbers, correctly rounded, and a bound for each (half an ulp of want included).  count 0 where there is no right value.
 * Where side is `any` and the limits differ, other and other_bound (else null) hold the limit from the left.  An infinite bound frees a number: any
 * answer will do.  Of curve_remove, surface_remove and *_nearest, where answers other than want are right, too, and of approximate, which has none,
 * the
 * judge looks at the request. */
typedef struct {
    et_validity validity;
    char reason[128];                     /* why not valid */
    size_t count;
    double *want, *bound, *other, *other_bound;     /* owned */
    double condition;                     /* greatest B / (k u |want|), at least 1 (docs/judge.md) */
} et_truth;

typedef struct {
    et_verdict verdict;
    size_t at;                            /* the number that decided, or SIZE_MAX */
    double got, want, bound;
    double ratio;                         /* greatest error / bound */
    char text[256];                       /* a sentence for people; empty for the first two */
} et_judgement;

/*@ predicate et_truth_stored(et_truth *truth) =
        0 <= truth->validity <= ET_INVALID &&
        (truth->count == 0 || (\valid_read(truth->want + (0 .. truth->count - 1)) && \valid_read(truth->bound + (0 .. truth->count - 1)))) &&
        (truth->other == \null || (\valid_read(truth->other + (0 .. truth->count - 1)) && \valid_read(truth->other_bound + (0 .. truth->count - 1))));
*/

/* "correctly_rounded", "within_bound", ...: the words of docs/conformance.md; null past the last. */
/*@ assigns \result \from verdict;
    ensures known: 0 <= verdict < ET_VERDICTS ==> valid_read_string(\result);
    ensures past:  !(0 <= verdict < ET_VERDICTS) ==> \result == \null;
*/
const char *et_judge_name(et_verdict verdict);

/* "valid", "implementation_defined", "invalid"; null past the last. */
/*@ assigns \result \from validity;
    ensures known: 0 <= validity <= ET_INVALID ==> valid_read_string(\result);
    ensures past:  !(0 <= validity <= ET_INVALID) ==> \result == \null;
*/
const char *et_judge_validity_name(et_validity validity);

/* 1 for those that make the exit code 1: all but correctly rounded, within bound and unsupported. */
/*@ assigns \nothing;
    ensures flag: \result == 0 || \result == 1;
    ensures good: \result == 0 <==> verdict == ET_VERDICT_CORRECTLY_ROUNDED || verdict == ET_VERDICT_WITHIN_BOUND ||
                      verdict == ET_VERDICT_UNSUPPORTED;
*/
int et_judge_bad(et_verdict verdict);

/* What a request is by its arguments (docs/judge.md, "Validity, to the letter"), and why, empty where it is valid.  The rank of a fit is decided
 * exactly.  What only the result shows (a number beyond the range of doubles, a normal that vanishes, a fit conditioned so badly that it may count as
 * rank deficient) et_judge_truth knows. */
/*@ requires reason:  \valid(reason + (0 .. 127)) && \valid_read(request) && \separated(reason + (0 .. 127), request);
    assigns  reason[0 .. 127];
    ensures  known:   0 <= \result <= ET_INVALID;
    ensures  text:    valid_read_string(reason);
    ensures  empty:   \result == ET_VALID <==> reason[0] == 0;
*/
et_validity et_judge_validity(char reason[128], const et_request *request);

/* What is right, by the exact layer, with bounds as docs/judge.md defines them.  What *truth held before is not freed.  ET_ENOMEM, ET_ENOCONV
 * (nearest points and
 * averages of parameters: undecided).
 * Golden: none (the frozen vectors of golden/conformance, made in Python, are compared with it, number by number and bound by bound). */
/*@ requires truth:   \valid(truth) && \valid_read(request) && \separated(truth, request);
    assigns  *truth;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM || \result == ET_ENOCONV;
    ensures  made:    \result == ET_OK ==> et_truth_stored(truth) && truth->condition >= 1.0;
    ensures  invalid: \result == ET_OK && truth->validity == ET_INVALID ==> truth->count == 0;
    ensures  kept:    \result != ET_OK ==> *truth == \old(*truth);
*/
et_status et_judge_truth(et_truth *truth, const et_request *request);

/* Frees what is owned and zeroes the struct; nothing to do for a zeroed one.
 * Golden: none (storage). */
/*@ requires truth: \valid(truth);
    assigns  *truth;
    ensures  zero:  truth->count == 0 && truth->want == \null && truth->bound == \null && truth->other == \null && truth->other_bound == \null;
*/
void et_judge_free(et_truth *truth);

/* The verdict on a reply (docs/conformance.md, "How an answer is judged"): one of the first seven, or unsupported.  The truth is that of the request,
 * computed or read.  ET_ENOMEM; ET_EINVAL (a truth that cannot be this request's), ET_ENOCONV.
 * Golden: none (a verdict on somebody else's answer). */
/*@ requires judgement: \valid(judgement) && \valid_read(request) && \valid_read(truth) && \valid_read(reply);
    requires truth:     et_truth_stored((et_truth *)truth);
    requires reply:     et_reply_stored((et_reply *)reply);
    requires apart:     \separated(judgement, request, truth, reply);
    assigns  *judgement;
    ensures  verdict:   \result == ET_OK ==> judgement->verdict <= ET_VERDICT_WRONGLY_REFUSED || judgement->verdict == ET_VERDICT_UNSUPPORTED;
    ensures  refused:   \result == ET_OK && reply->kind == ET_REPLY_REFUSED && truth->validity == ET_INVALID ==>
                            judgement->verdict == ET_VERDICT_CORRECTLY_ROUNDED;
    ensures  accepted:  \result == ET_OK && reply->kind == ET_REPLY_OK && truth->validity == ET_INVALID ==>
                            judgement->verdict == ET_VERDICT_WRONGLY_ACCEPTED;
    ensures  kept:      \result != ET_OK ==> *judgement == \old(*judgement);
*/
et_status et_judge_reply(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply);

#ifdef __cplusplus
}
#endif
#endif
