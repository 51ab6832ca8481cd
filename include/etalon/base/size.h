/* size: products of sizes that cannot wrap, and arrays allocated through them. */
#ifndef ETALON_BASE_SIZE_H
#define ETALON_BASE_SIZE_H
#include "etalon/base/status.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* *product = a * b, or ET_ENOMEM (and *product as it was) if that exceeds SIZE_MAX. */
/*@ requires product: \valid(product);
    assigns  *product;
    ensures  exact:   \result == ET_OK ==> *product == a * b;
    ensures  wraps:   \result == ET_ENOMEM ==> a * b > SIZE_MAX && *product == \old(*product);
    ensures  range:   \result == ET_OK || \result == ET_ENOMEM;
*/
et_status et_size_mul(size_t *product, size_t a, size_t b);

/* Memory of count elements of size bytes: for WP, which counts scalars, as many numbers or pointers as fill it, which never says too much. */
/*@ predicate et_array(char *p, integer count, integer size) =
        (size % 8 == 0 ==> \valid((double *)p + (0 .. count * (size / 8) - 1))) && (size == 1 ==> \valid(p + (0 .. count - 1)));

    predicate et_numbers(double *p, integer n) = \valid(p + (0 .. n - 1)); */

/* A new array of count elements of size bytes each, all bytes zero, aligned to 64 bytes; count == 0 gives a valid pointer to free.
 * Returns null when the product overflows or memory is short.  The caller frees it with free().
 * Golden: none (an address). */
/*@ assigns \result \from count, size;
    ensures array: \result == \null || et_array((char *)\result, count, size);
    ensures fits:  \result == \null || count * size <= SIZE_MAX;
*/
void *et_size_array(size_t count, size_t size);

#ifdef __cplusplus
}
#endif
#endif
