/* vectors: the frozen requests of golden/conformance, with what is right. */
#ifndef ETALON_CONFORM_VECTORS_H
#define ETALON_CONFORM_VECTORS_H
#include "etalon/conform/campaign.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    char *id, *issue, *comment;           /* owned; issue and comment may be null */
    et_category category;
    et_request request;
    et_truth truth;
} et_vector;
typedef struct { et_vector *vector; size_t count; } et_vectors;

/* All vectors of one file; ET_EFORMAT names file and vector, ET_EIO, ET_ENOMEM.  Freed by et_vectors_free. */
et_status et_vectors_read(et_vectors *vectors, const char *path, et_message *message);
void et_vectors_free(et_vectors *vectors);

#ifdef __cplusplus
}
#endif
#endif
