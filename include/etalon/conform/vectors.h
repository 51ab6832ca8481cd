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
    et_truth truth;                       /* reason is empty; want, bound, other, other_bound and condition as the file says */
} et_vector;
typedef struct { et_vector *vector; size_t count; } et_vectors;

/* All vectors of one file (docs/conformance.md, "Frozen vectors"; golden/conformance/schema.json).  ET_EFORMAT names file and vector: not JSON,
 * another format or version, an operation that there is not, a member missing, unknown or of another type, a request that is not one of the
 * operation, numbers that are none, lists of different lengths.  ET_EIO, ET_ENOMEM.  Freed by et_vectors_free; on failure *vectors is unchanged.
 * Golden: none (the files of golden/conformance are its golden files, and the tests read them all). */
/*@ requires path:    path == \null || valid_read_string(path);
    requires message: message == \null || \valid(message);
    assigns  *vectors, message->text[0 .. ET_MESSAGE_SIZE - 1];
    ensures  status:  \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  failed:  \result != ET_OK ==> *vectors == \old(*vectors);
    ensures  read:    \result == ET_OK ==> vectors->count == 0 || \valid(vectors->vector + (0 .. vectors->count - 1));
*/
et_status et_vectors_read(et_vectors *vectors, const char *path, et_message *message);

/* All memory of it; empty afterwards.  A null pointer and one that is empty are left alone.
 * Golden: none (nothing is computed). */
/*@ requires vectors: vectors == \null || \valid(vectors);
    assigns  *vectors;
    ensures  empty:   vectors != \null ==> vectors->vector == \null && vectors->count == 0;
*/
void et_vectors_free(et_vectors *vectors);

#ifdef __cplusplus
}
#endif
#endif
