/* file: output that is complete or not there: written beside its place, then renamed over it.
 * A failed or abandoned write leaves an earlier file of that name as it was. */
#ifndef ETALON_IO_FILE_H
#define ETALON_IO_FILE_H
#include "etalon/base/status.h"
#include <stdio.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { FILE *stream; char *path, *temporary; } et_file;

/* "-" is standard output (no temporary).  ET_EIO, ET_ENOMEM. */
et_status et_file_create(et_file *file, const char *path, et_message *message);
/* Flush, close, rename; on any failure the temporary is removed, and ET_EIO.  Frees either way. */
et_status et_file_commit(et_file *file, et_message *message);
/* Close and remove the temporary. */
void et_file_abandon(et_file *file);
/* Remove the temporaries of all files now open: async-signal-safe, for a handler that is about to end the program. */
void et_file_abandon_all(void);

#ifdef __cplusplus
}
#endif
#endif
