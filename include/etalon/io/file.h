/* file: output that is complete or not there: written beside its place, then renamed over it.
 * A failed or abandoned write leaves an earlier file of that name as it was. */
#ifndef ETALON_IO_FILE_H
#define ETALON_IO_FILE_H
#include "etalon/base/status.h"
#include <stdio.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A file being written.  stream: write here.  path: what is to be written, for messages.  target: the place to rename to (symbolic links
 * resolved) and temporary: the file written meanwhile; both null when the stream writes to its place directly.  All null: no file. */
typedef struct { FILE *stream; char *path, *target, *temporary; } et_file;

/* At most so many files with a temporary may be open at once. */
enum { ET_FILE_LIVE = 64 };

/* Begin to write `path`.
 *
 * A regular file, existing or not, is written as a new file `.etalon-PID-COUNT.tmp` in the same directory (rename(2) is atomic only
 * within one file system); a new file gets the permissions 0666 less the umask, a replaced one keeps its own.  A symbolic link to a
 * regular file stays a link: the file it leads to is replaced.  "-" is standard output.  What is not a regular file (a terminal, a FIFO,
 * /dev/null), and /dev/stdout, /dev/stderr, /dev/fd/N and everything under /proc/, is opened for appending and written directly.
 *
 * ET_EINVAL: path is null.  ET_EIO, message `cannot write PATH: reason`: no such directory, path is a directory, no permission, no
 * space, ET_FILE_LIVE files open already.  ET_ENOMEM.  On failure *file is unchanged and nothing has been created.
 * Golden: none (the effect is on the file system) */
/*@ requires file:      \valid(file);
    requires path:      path == \null || valid_read_string(path);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(file, message);
    assigns  *file, *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  open:      \result == ET_OK ==> file->stream != \null && file->path != \null;
    ensures  beside:    \result == ET_OK ==> (file->temporary == \null <==> file->target == \null);
    ensures  unchanged: \result != ET_OK ==> *file == \old(*file);
*/
et_status et_file_create(et_file *file, const char *path, et_message *message);

/* Finish: flush, force to the medium (fsync), close, rename over the target; standard output is flushed and stays open.
 *
 * ET_EINVAL: no file.  ET_EIO, message `cannot write PATH: reason`: anything written since et_file_create was refused (no space, quota,
 * broken pipe), or the rename was; the temporary is then removed and an earlier file is intact.  Frees and zeroes *file either way.
 * Golden: none (the effect is on the file system) */
/*@ requires file:      \valid(file);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(file, message);
    assigns  *file, *message, *file->stream;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO;
    ensures  none:      \old(file->stream) == \null ==> \result == ET_EINVAL;
    ensures  closed:    file->stream == \null && file->path == \null && file->target == \null && file->temporary == \null;
*/
et_status et_file_commit(et_file *file, et_message *message);

/* Give up: close, remove the temporary, free and zero *file; an earlier file is intact.  What went directly to its place stays there.
 * Does nothing where there is no file.
 * Golden: none (the effect is on the file system) */
/*@ requires file:      \valid(file);
    assigns  *file, *file->stream;
    ensures  closed:    file->stream == \null && file->path == \null && file->target == \null && file->temporary == \null;
*/
void et_file_abandon(et_file *file);

/* Remove the temporaries of all files now open: async-signal-safe, for a handler that is about to end the program.  A file whose
 * temporary is gone can still be written to and abandoned; to commit it is ET_EIO.
 * Golden: none (the effect is on the file system) */
/*@ assigns \nothing;
*/
void et_file_abandon_all(void);

#ifdef __cplusplus
}
#endif
#endif
