/* campaign_shrink: the state of a shrinking, shared by its passes. */
#ifndef ETALON_CONFORM_CAMPAIGN_SHRINK_H
#define ETALON_CONFORM_CAMPAIGN_SHRINK_H
#include "conform/campaign_parts.h"

typedef struct {
    et_request best;                      /* the simplest so far; it fails */
    uint64_t cost;
    et_campaign_fails *fails;
    void *context;
    size_t calls;                         /* left */
    et_status status;
} campaign_shrinker;

/* What is made smaller: numbers, then degrees and counts, then the digits of numbers. */
uint64_t campaign_cost(const et_request *request);
uint64_t campaign_cost_of(double x);
/* A copy of the best; 0 when memory or calls are used up. */
int campaign_try(campaign_shrinker *s, et_request *candidate);
/* The candidate, which is used up, becomes the best if it is cheaper and fails: 1; else 0. */
int campaign_take(campaign_shrinker *s, et_request *candidate);
/* Items from .. from + count - 1 of argument k are taken out; items of `width` numbers. */
void campaign_cut(et_request *q, int k, size_t width, size_t from, size_t count);

/* The passes: 1 if there was progress. */
int campaign_shrink_structure(campaign_shrinker *s);
int campaign_shrink_numbers(campaign_shrinker *s);

#endif
