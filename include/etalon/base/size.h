/* size: products and sums of sizes that cannot wrap, and arrays allocated through them. */
#ifndef ETALON_BASE_SIZE_H
#define ETALON_BASE_SIZE_H
#include "etalon/base/status.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* *product = a * b, or ET_ENOMEM if that exceeds SIZE_MAX. */
et_status et_size_mul(size_t *product, size_t a, size_t b);

/* A new array of count elements of size bytes each, all bytes zero; count == 0 gives a valid pointer to free.
 * Returns null when the product overflows or memory is short.  The caller frees it with free(). */
void *et_size_array(size_t count, size_t size);

#ifdef __cplusplus
}
#endif
#endif
