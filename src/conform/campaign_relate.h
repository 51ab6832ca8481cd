/* campaign_relate: one check of a relation between answers. */
#ifndef ETALON_CONFORM_CAMPAIGN_RELATE_H
#define ETALON_CONFORM_CAMPAIGN_RELATE_H
#include "conform/campaign_parts.h"

typedef struct {
    const char *name;
    et_judgement *judgement;
    et_request *told;                     /* the request of the report; set by campaign_base */
    const et_hello *hello;
    et_campaign_ask *ask;
    void *context;
    et_rng *rng;
    uint64_t seed, number;
    double worst;                         /* greatest difference / tolerance so far; negative: nothing compared */
    int exact, decided;                   /* all differences 0; a verdict stands that is no comparison's */
    et_status status;
} campaign_relation;

/* A valid request of the operation, in a category that takes its turn; 0 if there is none.  It is r->told. */
int campaign_base(campaign_relation *r, et_request_op op, const et_category *categories, size_t n);
/* 1: the reply has `count` finite numbers (SIZE_MAX: any number).  0: the verdict has been given, or r->status. */
int campaign_asked(campaign_relation *r, et_reply *reply, const et_request *q, size_t count);
/* The bounds of the numbers of the exact answer, both limits included where either is right; null: the verdict has been given, or r->status. */
double *campaign_bounds(campaign_relation *r, size_t *n, const et_request *q);
/* got and want may differ by tolerance. */
void campaign_compare(campaign_relation *r, size_t at, double got, double want, double tolerance);
void campaign_decide(campaign_relation *r, et_verdict verdict, const char *text);
double campaign_size(const et_request *q, int points);      /* greatest coordinate, at least 2^-1000 */
/* A double's coordinates cut to multiples of 2^-20, so that shifts by whole numbers are exact. */
void campaign_dyadic(et_request_value *v);
void campaign_reverse(double *x, size_t n, size_t width);
void campaign_negate(et_request_value *u);                  /* -x in reversed order */
/* Copies of r->told; 0 on r->status. */
int campaign_again(campaign_relation *r, et_request *q);
void campaign_fail(campaign_relation *r, et_status status);

void campaign_relate_order(campaign_relation *r, et_request_op op, et_request_op plain);
void campaign_relate_unity(campaign_relation *r);
void campaign_relate_constant(campaign_relation *r);
void campaign_relate_moved(campaign_relation *r, et_request_op op, int how);       /* evaluation */
void campaign_relate_transposed(campaign_relation *r);
void campaign_relate_limits(campaign_relation *r);
void campaign_relate_spans(campaign_relation *r);
void campaign_relate_greville(campaign_relation *r);
void campaign_relate_edited(campaign_relation *r, et_request_op op);
void campaign_relate_removed(campaign_relation *r);
void campaign_relate_parameters(campaign_relation *r, int how);
void campaign_relate_fitted(campaign_relation *r, et_request_op op, int how);
void campaign_relate_normal(campaign_relation *r, et_request_op op);
void campaign_relate_approximate(campaign_relation *r, int how);
void campaign_relate_seam(campaign_relation *r);
void campaign_relate_nearest(campaign_relation *r, et_request_op op);
void campaign_relate_net(campaign_relation *r);

enum { CAMPAIGN_SHIFT = 0, CAMPAIGN_SCALE, CAMPAIGN_REVERSE };

#endif
