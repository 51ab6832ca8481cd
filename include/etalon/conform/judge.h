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
    ET_VERDICT_WRONGLY_ACCEPTED, ET_VERDICT_WRONGLY_REFUSED, ET_VERDICT_CRASH, ET_VERDICT_TIMEOUT, ET_VERDICT_NONDETERMINISTIC, ET_VERDICT_UNSUPPORTED,
    ET_VERDICTS
} et_verdict;

typedef enum { ET_VALID = 0, ET_IMPLEMENTATION_DEFINED, ET_INVALID } et_validity;

/* What is right: the reply's numbers, correctly rounded, and a bound for each (half an ulp of want included).  count 0 where there is no right value.
 * Where side is `any` and the limits differ, other and other_bound (else null) hold the limit from the left.  curve_remove, surface_remove, *_nearest and approximate:
 * want and bound as documented in the C file and in docs/judge.md; the judge looks at the request, too. */
typedef struct {
    et_validity validity;
    char reason[128];                     /* why not valid */
    size_t count;
    double *want, *bound, *other, *other_bound;     /* owned */
    double condition;                     /* greatest bound relative to k u |want|, at least 1; infinite where want is 0 */
} et_truth;

typedef struct {
    et_verdict verdict;
    size_t at;                            /* the number that decided, or SIZE_MAX */
    double got, want, bound;
    double ratio;                         /* greatest error / bound */
    char text[256];                       /* a sentence for people; empty for the first two */
} et_judgement;

/* "correctly_rounded", ...; null past the last.  "valid", "implementation_defined", "invalid". */
const char *et_judge_name(et_verdict verdict);
const char *et_judge_validity_name(et_validity validity);
/* 1 for those that make the exit code 1. */
int et_judge_bad(et_verdict verdict);
et_validity et_judge_validity(char reason[128], const et_request *request);
/* By the exact layer.  ET_ENOMEM, ET_ENOCONV (nearest: undecided). */
et_status et_judge_truth(et_truth *truth, const et_request *request);
void et_judge_free(et_truth *truth);
et_status et_judge_reply(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply);

#ifdef __cplusplus
}
#endif
#endif
