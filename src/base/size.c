#include "etalon/base/size.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

et_status et_size_mul(size_t *product, size_t a, size_t b)
{
    if (b != 0 && a > SIZE_MAX / b) {
        return ET_ENOMEM;
    }
    *product = a * b;
    return ET_OK;
}

/* A cache line, and the widest vector there is.  A BLAS may sum in another order where its operands stand otherwise in memory (ATLAS does): with
 * one alignment for all arrays the bits do not depend on what was allocated before. */
enum { ALIGNMENT = 64 };

void *et_size_array(size_t count, size_t size)
{
    size_t bytes;
    void *array = NULL;
    if (et_size_mul(&bytes, count, size) != ET_OK) {
        return NULL;
    }
    bytes = bytes == 0 ? 1 : bytes;
    if (posix_memalign(&array, ALIGNMENT, bytes) != 0) {
        return NULL;
    }
    return memset(array, 0, bytes);
}
