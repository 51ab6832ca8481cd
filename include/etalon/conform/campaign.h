/* campaign: seeded requests by category, smaller ones that still fail, and relations between the answers to related requests. */
#ifndef ETALON_CONFORM_CAMPAIGN_H
#define ETALON_CONFORM_CAMPAIGN_H
#include "etalon/conform/judge.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    ET_CATEGORY_PLAIN = 0, ET_CATEGORY_END_OF_DOMAIN, ET_CATEGORY_NEAR_KNOTS, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_EDITING, ET_CATEGORY_DEGENERATE,
    ET_CATEGORY_FIT_FAILURE, ET_CATEGORY_SEAM, ET_CATEGORY_INVERSION, ET_CATEGORY_SIZE, ET_CATEGORY_EXTREME_SCALE, ET_CATEGORY_WEIGHTS, ET_CATEGORY_DEGREES,
    ET_CATEGORY_BAD_INPUT,
    ET_CATEGORIES
} et_category;

/* "plain", "end_of_domain", ...; null past the last. */
const char *et_campaign_name(et_category category);
/* 1 if cases of this category are made for the operation. */
int et_campaign_has(et_request_op op, et_category category);
/* Case number `number` of operation and category of the campaign `seed`: always the same.  The request keeps to what hello offers (degree, order,
 * rational, sides, knot tolerance).  ET_EINVAL (no such cases; hello leaves nothing), ET_ENOMEM. */
et_status et_campaign_draw(et_request *request, et_request_op op, et_category category, uint64_t seed, uint64_t number, const et_hello *hello);

/* 1: the request still shows the fault; 0: it does not. */
typedef int et_campaign_fails(void *context, const et_request *request);
/* The request made as small and simple as it can be while `fails` says 1: lower degrees, fewer control points and knots, no weights, short numbers.  At
 * most `calls` calls.  The request must fail at the start.  ET_ENOMEM (the request is then as it was). */
et_status et_campaign_shrink(et_request *request, et_campaign_fails *fails, void *context, size_t calls);

/* Answers a request: an et_status other than ET_OK ends the check. */
typedef et_status et_campaign_ask(void *context, et_reply *reply, const et_request *request);
/* Relation number `number` (of et_campaign_relations) drawn from the seed: asks some related requests and compares.  *judgement says how it went
 * (ET_VERDICT_UNSUPPORTED where an answer is missing); *request is the one that is told in a report. */
size_t et_campaign_relations(void);
const char *et_campaign_relation_name(size_t relation);
et_status et_campaign_relate(et_judgement *judgement, et_request *request, size_t relation, uint64_t seed, uint64_t number, const et_hello *hello,
                             et_campaign_ask *ask, void *context);
/* A neighbour of the request for the search of worst cases: same shape, numbers moved. */
et_status et_campaign_vary(et_request *varied, const et_request *request, uint64_t seed, uint64_t number, const et_hello *hello);

#ifdef __cplusplus
}
#endif
#endif
