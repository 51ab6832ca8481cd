/* campaign: seeded requests by category, smaller ones that still fail, and relations between the answers to related requests. */
#ifndef ETALON_CONFORM_CAMPAIGN_H
#define ETALON_CONFORM_CAMPAIGN_H
#include "etalon/conform/judge.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    ET_CATEGORY_PLAIN = 0, ET_CATEGORY_END_OF_DOMAIN, ET_CATEGORY_NEAR_KNOTS, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_EDITING, ET_CATEGORY_DEGENERATE,
    ET_CATEGORY_FIT_FAILURE, ET_CATEGORY_SEAM, ET_CATEGORY_INVERSION, ET_CATEGORY_SIZE, ET_CATEGORY_EXTREME_SCALE, ET_CATEGORY_WEIGHTS,
    ET_CATEGORY_DEGREES, ET_CATEGORY_BAD_INPUT,
    ET_CATEGORIES
} et_category;

/*@ predicate et_campaign_offers(et_hello *h) = \valid_read(h) && h->knot_tolerance >= 0.0;
    predicate et_campaign_stored(et_request *r) = \forall integer k; 0 <= k < ET_REQUEST_ARGS ==> r->arg[k].x == \null || \valid(r->arg[k].x);
*/

/* "plain", "end_of_domain", ... (docs/conformance.md, "Levels"); null past the last. */
/*@ assigns \result \from category;
    ensures known:   0 <= category < ET_CATEGORIES ==> valid_read_string(\result);
    ensures unknown: category >= ET_CATEGORIES ==> \result == \null;
*/
const char *et_campaign_name(et_category category);

/* 1 if cases of this category are made for the operation; 0 too for what is no operation or category.  Every operation has plain, size and
 * bad_input. */
/*@ assigns \nothing;
    ensures flag:    \result == 0 || \result == 1;
    ensures always:  0 <= op < ET_OPS && (category == ET_CATEGORY_PLAIN || category == ET_CATEGORY_SIZE || category == ET_CATEGORY_BAD_INPUT)
                         ==> \result == 1;
    ensures outside: op >= ET_OPS || category >= ET_CATEGORIES ==> \result == 0;
*/
int et_campaign_has(et_request_op op, et_category category);

/* Case number `number` of operation and category of the campaign `seed`: always the same, on every compiler and processor, whatever was drawn before
 * (streams of et_rng_stream; additions, products and quotients only; nets of the category size where size_t has 64 bits).  The kinds of a category
 * take turns with the number, so that a few cases show many of them.  A plain case is valid, one of bad_input breaks one rule; the others may be of
 * any validity (docs/campaign.md says where).  The request keeps to what hello offers: operations, degree (that of an elevated curve, too), order,
 * weights, sides; no two different knots, nor a parameter and a knot, within the knot tolerance.  Where the tolerance leaves nothing of a category, a
 * plain case comes instead.  A line has less than 200 kB.
 * ET_EINVAL (no such cases; hello leaves nothing), ET_ENOMEM.  Freed by et_request_free. */
/*@ requires request: \valid(request);
    requires hello:   et_campaign_offers((et_hello *)hello) && \separated(request, hello);
    assigns  *request;
    ensures  status:  \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  made:    \result == ET_OK ==> request->op == op && et_campaign_stored(request);
    ensures  outside: op >= ET_OPS || category >= ET_CATEGORIES ==> \result == ET_EINVAL;
    ensures  offered: 0 <= op < ET_OPS && hello->op[op] == 0 ==> \result == ET_EINVAL;
    ensures  kept:    \result != ET_OK ==> *request == \old(*request);
*/
et_status et_campaign_draw(et_request *request, et_request_op op, et_category category, uint64_t seed, uint64_t number, const et_hello *hello);

/* 1: the request still shows the fault; 0: it does not. */
typedef int et_campaign_fails(void *context, const et_request *request);

/* The request made as small and simple as it can be while `fails` says 1: fewer numbers first (knots with their control points, data with their
 * sites, no weights), then lower degrees and counts, then numbers that are 0, 1, small and whole or have few bits.  Each step is cheaper than the one
 * before in this order, so that the result is never larger, depends on nothing but the arguments, and shrinking it again changes nothing, as long as
 * calls are left.  At most `calls` calls of `fails`; the request must fail at the start, which is not asked.  ET_ENOMEM (the request is then as it
 * was).
 * Golden: none (what is left depends on the caller's predicate). */
/*@ requires request: \valid(request) && et_campaign_stored(request) && 0 <= request->op < ET_OPS;
    requires fails:   fails != \null;
    assigns  *request;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  same:    request->op == \old(request->op);
    ensures  kept:    \result != ET_OK ==> *request == \old(*request);
*/
et_status et_campaign_shrink(et_request *request, et_campaign_fails *fails, void *context, size_t calls);

/* Answers a request: an et_status other than ET_OK ends the check. */
typedef et_status et_campaign_ask(void *context, et_reply *reply, const et_request *request);

/* How many relations there are. */
/*@ assigns \nothing;
    ensures some: \result >= 1;
*/
size_t et_campaign_relations(void);

/* A few words that say what must hold, beginning with the operation or equation; null past the last.
 * Golden: none (wording). */
/*@ assigns \result \from relation;
    ensures text: \result == \null || valid_read_string(\result);
*/
const char *et_campaign_relation_name(size_t relation);

/* Relation number `relation` (of et_campaign_relations), case `number` of the seed: asks some related requests and compares.  *judgement says how it
 * went: correctly rounded where all that is compared is equal, else within bound, inaccurate or wrong, the factors as in docs/conformance.md; wrongly
 * refused and non-finite as for single answers; ET_VERDICT_UNSUPPORTED where an answer is missing or hello offers too little.  Numbers that the exact
 * layer can bound may differ by the bounds of both (et_judge_truth), those of edited curves by what their rounded control points cause as well;
 * docs/campaign.md has each.  *request is the one that is told in a report (et_request_free).  ET_EINVAL (no such relation), ET_ENOMEM, and whatever
 * ask returns.
 * Golden: none (a verdict on somebody else's answers). */
/*@ requires judgement: \valid(judgement) && \valid(request) && \separated(judgement, request, hello);
    requires hello:     et_campaign_offers((et_hello *)hello);
    requires ask:       ask != \null;
    assigns  *judgement, *request;
    ensures  made:      \result == ET_OK ==> et_campaign_stored(request) && 0 <= judgement->verdict < ET_VERDICTS;
    ensures  kept:      \result != ET_OK ==> *request == \old(*request) && *judgement == \old(*judgement);
*/
et_status et_campaign_relate(et_judgement *judgement, et_request *request, size_t relation, uint64_t seed, uint64_t number, const et_hello *hello,
                             et_campaign_ask *ask, void *context);

/* A neighbour of the request for the search of worst cases: the same operation and counts, some numbers (parameters, knots, points, weights, sites)
 * moved by ulps, by a part or by much; of the same validity, and still what hello offers.  Where no such neighbour is found in some tries, a copy.
 * ET_ENOMEM.  Freed by et_request_free.
 * Golden: none (a neighbour, one of many). */
/*@ requires varied:  \valid(varied) && \valid_read(request) && \separated(varied, request, hello);
    requires request: et_campaign_stored((et_request *)request) && 0 <= request->op < ET_OPS;
    requires hello:   et_campaign_offers((et_hello *)hello);
    assigns  *varied;
    ensures  status:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  made:    \result == ET_OK ==> varied->op == request->op && et_campaign_stored(varied);
    ensures  shape:   \result == ET_OK ==> \forall integer k; 0 <= k < ET_REQUEST_ARGS ==> varied->arg[k].count == request->arg[k].count;
    ensures  kept:    \result != ET_OK ==> *varied == \old(*varied);
*/
et_status et_campaign_vary(et_request *varied, const et_request *request, uint64_t seed, uint64_t number, const et_hello *hello);

#ifdef __cplusplus
}
#endif
#endif
