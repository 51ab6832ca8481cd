/* status: how a call ended, and what to tell the person who made it.
 *
 * Every function that can fail returns an et_status and leaves its outputs as they were when it is not ET_OK.  There is no
 * global error state.  Where a sentence for a human is worth having (which file, which line, which argument) the function
 * takes an et_message, which may be null.
 */
#ifndef ETALON_BASE_STATUS_H
#define ETALON_BASE_STATUS_H
#include <string.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    ET_OK = 0,        /* done */
    ET_EINVAL,        /* an argument breaks the contract */
    ET_EFORMAT,       /* input data are malformed or cannot be used: bad line, NaN, all points equal */
    ET_EIO,           /* a file cannot be read or written */
    ET_ENOMEM,        /* memory, or a size that does not fit size_t */
    ET_ERANK,         /* a linear system is rank deficient */
    ET_ENOCONV,       /* an iteration did not converge */
    ET_ESTOPPED,      /* the caller's callback asked to stop; the best so far has been delivered */
    ET_EINTERNAL,     /* a fault of Etalon itself */
    ET_EDIFFER        /* a comparison with figures given from outside failed */
} et_status;

enum { ET_MESSAGE_SIZE = 1024 };
typedef struct { char text[ET_MESSAGE_SIZE]; } et_message;

/* A short English phrase for a status; never null, "unknown status" for values outside the enumeration.
 * Golden: none (wording, not a computed value). */
/*@ assigns \result \from status;
    ensures text: valid_read_string(\result) && \result[0] != 0;
*/
const char *et_status_text(et_status status);

/* The exit code of the command line for a status: 0, 1 (EDIFFER), 2 (EINVAL), 3 (EFORMAT), 4 (EIO), 5 (ERANK, ENOCONV),
 * 70 (EINTERNAL, ENOMEM), 130 (ESTOPPED); 70 for values outside the enumeration. */
/*@ assigns \nothing;
    ensures code:    0 <= \result <= 255;
    ensures success: \result == 0 <==> status == ET_OK;
*/
int et_status_exit(et_status status);

/* Write a formatted sentence (printf's rules, cut at ET_MESSAGE_SIZE - 1 bytes) into message unless it is null; return status.
 * Golden: none (the text is the C library's printf). */
/*@ requires message: message == \null || \valid(message);
    requires format:  valid_read_string(format);
    assigns  message->text[0 .. ET_MESSAGE_SIZE - 1];
    ensures  status:  \result == status;
*/
et_status et_status_fail(et_message *message, et_status status, const char *format, ...);

#ifdef __cplusplus
}
#endif
#endif
