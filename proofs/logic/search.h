/* What the population searches call, as in libm.h: isfinite, isnan, memcpy of doubles (Frama-C's own contract copies characters, which the memory
 * model does not see as doubles).  A generator is here a struct that holds no double and no pointer. */
#ifndef SEARCH_H
#define SEARCH_H
#include "libm.h"
#include "logic.h"
#include <stdint.h>
#include <string.h>
struct et_rng { uint64_t draws; };
#include "etalon/refine/search.h"
#undef isnan
#define isnan(x) search_isnan(x)
#define memcpy(to, from, bytes) search_memcpy(to, from, bytes)
/*@ assigns \nothing;
    ensures  truth:    \result == 0 || \result == 1;
    ensures  none:     \result == 1 <==> \is_NaN(x);
*/
int search_isnan(double x);
/*@ requires bytes:    bytes % sizeof(double) == 0;
    requires valid:    \valid(to + (0 .. bytes / sizeof(double) - 1)) && \valid_read(from + (0 .. bytes / sizeof(double) - 1));
    requires apart:    \separated(to + (0 .. bytes / sizeof(double) - 1), from + (0 .. bytes / sizeof(double) - 1));
    assigns  to[0 .. bytes / sizeof(double) - 1];
    ensures  finite:   \forall integer k; 0 <= k < bytes / sizeof(double) && \is_finite(from[k]) ==> \is_finite(to[k]);
    ensures  order:    \forall integer k; 0 <= k < bytes / sizeof(double) && !\is_NaN(from[k]) ==> \eq_double(to[k], from[k]) && !\is_NaN(to[k]);
*/
void search_memcpy(double *to, const double *from, size_t bytes);
/* Any objective, and any algorithm's step: all that is known of them is this. */
/*@ requires value:    \valid(value) && \valid_read(x + (0 .. n - 1)) && \separated(value, x + (0 .. n - 1));
    assigns  *value;
*/
et_status search_any_fn(double *value, const double *x, size_t n, void *context);
/*@ requires search:   et_search_started(search) && et_search_rng(search, rng);
    requires room:     search->evaluations + search->options.population <= UINT64_MAX && search->generation < SIZE_MAX;
    assigns  search->x[0 .. search->options.population * search->n - 1], search->value[0 .. search->options.population - 1],
             search->velocity[0 .. search->options.population * search->n - 1], search->memory[0 .. search->options.population * search->n - 1],
             search->remembered[0 .. search->options.population - 1],
             search->trial[0 .. (search->options.population + 1) * (search->n + 1) - 1],
             search->best[0 .. search->n - 1], search->best_value, search->generation, search->evaluations, *rng;
    ensures  count:    \result == ET_OK ==> search->evaluations <= \old(search->evaluations) + search->options.population
                                         && search->generation == \old(search->generation) + 1;
    ensures  falling:  \le_double(search->best_value, \old(search->best_value));
    ensures  started:  et_search_started(search);
*/
et_status search_any_step(et_search *search, et_rng *rng);
/* What a step keeps: the values do not rise, and what was no NaN is none.  Memory of m numbers at p is aside when writing to it changes none of that. */
/*@ predicate search_aside(double *p, integer m, et_search *s) =
        \separated(p + (0 .. m - 1), s) &&
        (\forall integer k; 0 <= k < s->options.population ==> \separated(p + (0 .. m - 1), s->value + k)) &&
        (\forall integer k; 0 <= k < s->n ==> \separated(p + (0 .. m - 1), s->x0 + k)) &&
        (s->velocity != \null ==> \forall integer k; 0 <= k < s->options.population ==> \separated(p + (0 .. m - 1), s->remembered + k));
    predicate search_values{P, Q}(et_search *s) =
        \forall integer k; 0 <= k < \at(s->options.population, P) ==>
            !\is_NaN(\at(s->value[k], Q)) && \le_double(\at(s->value[k], Q), \at(s->value[k], P));
    predicate search_centre{Q}(et_search *s) = \forall integer k; 0 <= k < \at(s->n, Q) ==> \is_finite(\at(s->x0[k], Q));
    predicate search_own{Q}(et_search *s) =
        \at(s->velocity, Q) != \null ==> \forall integer k; 0 <= k < \at(s->options.population, Q) ==> !\is_NaN(\at(s->remembered[k], Q));
*/
/*@ ghost
  /@ assigns  \nothing;
     ensures  same:     \forall double x; !\is_NaN(x) ==> \le_double(x, x);
     ensures  chain:    \forall double x, y, z; \le_double(x, y) && \le_double(y, z) ==> \le_double(x, z);
     ensures  numbers:  \forall double x, y; \le_double(x, y) ==> !\is_NaN(x) && !\is_NaN(y); @/
  static void fact_order(void) {}
  /@ requires group:    1 <= n && 1 <= group && n % group == 0;
     assigns  \nothing;
     ensures  genes:    (n / group) * group == n;
     ensures  range:    1 <= n / group <= n; @/
  static void fact_genes(size_t n, size_t group) {}
  /@ requires row:      i < count;
     assigns  \nothing;
     ensures  row:      0 <= i * n && i * n + n <= count * n && (i + 1) * n <= count * n;
     ensures  next:     0 <= (size_t)(i + 1) * n <= count * n; @/
  static void fact_slot(size_t i, size_t count, size_t n)
  {
      fact_product(0, i, n);
      fact_product(i + 1, count, n);
  }
  /@ requires genes:    1 <= n && 1 <= group && n % group == 0 && gene < n / group;
     assigns  \nothing;
     ensures  gene:     0 <= gene * group && gene * group + group <= n && (gene + 1) * group <= n;
     ensures  next:     0 <= (size_t)(gene + 1) * group <= n; @/
  static void fact_gene(size_t gene, size_t n, size_t group)
  {
      fact_genes(n, group);
      fact_slot(gene, n / group, group);
  }
  /@ requires search:   et_search_arrays(s);
     assigns  \nothing;
     ensures  row:      1 <= s->n && s->n * sizeof(double) <= SIZE_MAX;
     ensures  size:     0 <= s->options.population * s->n && s->options.population * s->n * sizeof(double) <= SIZE_MAX;
     ensures  trial:    4 * s->n <= s->options.population * s->n &&
                        s->options.population * s->n + s->options.population + s->n < (s->options.population + 1) * (s->n + 1); @/
  static void fact_search(const et_search *s)
  {
      fact_product(0, s->options.population, s->n);
      fact_product(4, s->options.population, s->n);
  }
*/
#endif
