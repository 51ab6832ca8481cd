#include "etalon/base/size.h"
#include <stdint.h>
#include <stdlib.h>

et_status et_size_mul(size_t *product, size_t a, size_t b)
{
    if (b != 0 && a > SIZE_MAX / b) {
        return ET_ENOMEM;
    }
    *product = a * b;
    return ET_OK;
}

void *et_size_array(size_t count, size_t size)
{
    size_t bytes;
    if (et_size_mul(&bytes, count, size) != ET_OK) {
        return NULL;
    }
    return bytes == 0 ? calloc(1, 1) : calloc(bytes, 1);
}
