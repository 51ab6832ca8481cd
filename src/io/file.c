#define _XOPEN_SOURCE 700   /* realpath */
#include "etalon/io/file.h"
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BUFFER = 1 << 16, NAME = 64, ATTEMPTS = 1000 };

/* The temporaries now open, for a signal handler: name[k] may be read while live[k] is set. */
static const char *volatile name[ET_FILE_LIVE];
static volatile sig_atomic_t live[ET_FILE_LIVE];
static pthread_mutex_t table = PTHREAD_MUTEX_INITIALIZER;
static unsigned long counter;

static et_status cannot_write(et_message *message, const char *path, int error)
{
    return et_status_fail(message, ET_EIO, "cannot write %s: %s", path, error ? strerror(error) : "write error");
}

static int enter(const char *temporary)
{
    for (int k = 0; k < ET_FILE_LIVE; k++) {
        if (!live[k]) {
            name[k] = temporary;
            live[k] = 1;
            return 1;
        }
    }
    return 0;
}

static void leave(const char *temporary)
{
    pthread_mutex_lock(&table);
    for (int k = 0; k < ET_FILE_LIVE; k++) {
        if (live[k] && name[k] == temporary)
            live[k] = 0;
    }
    pthread_mutex_unlock(&table);
}

/* Create the file named at `temporary`, whose part after `directory` bytes is written here, and enter it into the table.  Signals wait
 * meanwhile: a handler finds either no file or its name. */
static int open_temporary(char *temporary, size_t directory, mode_t mode)
{
    int fd = -1, error = EEXIST;
    sigset_t all, before;
    sigfillset(&all);
    pthread_mutex_lock(&table);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    for (int attempt = 0; attempt < ATTEMPTS && fd < 0 && error == EEXIST; attempt++) {
        (void)snprintf(temporary + directory, NAME, ".etalon-%ld-%lu.tmp", (long)getpid(), ++counter);
        fd = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOCTTY, mode);
        error = errno;
    }
    if (fd >= 0 && !enter(temporary)) {
        close(fd);
        unlink(temporary);
        fd = -1;
        error = EMFILE;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    pthread_mutex_unlock(&table);
    errno = error;
    return fd;
}

static char *join(const char *directory, size_t length, size_t room)
{
    char *s = malloc(length + room);
    if (s)
        memcpy(s, directory, length);
    return s;
}

/* The temporary beside file->target, and its stream.  before: the permissions to keep, null when the target is new. */
static et_status open_beside(et_file *file, const struct stat *before, et_message *message)
{
    const char *slash = strrchr(file->target, '/');
    size_t directory = slash ? (size_t)(slash - file->target) + 1 : 0;
    file->temporary = join(file->target, directory, NAME);
    if (!file->temporary)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    int fd = open_temporary(file->temporary, directory, before ? before->st_mode & 0777 : 0666);
    if (fd < 0) {
        et_status status = cannot_write(message, file->path, errno);
        free(file->temporary);
        file->temporary = NULL;
        return status;
    }
    if (before)
        (void)fchmod(fd, before->st_mode & 0777);     /* what the umask took; where a file system has no permissions that is no fault */
    file->stream = fdopen(fd, "wb");
    if (!file->stream) {
        close(fd);
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    }
    return ET_OK;
}

/* Appending, because /dev/stdout may lead to a file that others have written to. */
static et_status open_direct(et_file *file, et_message *message)
{
    int fd = open(file->path, O_WRONLY | O_APPEND | O_NOCTTY);
    if (fd < 0)
        return cannot_write(message, file->path, errno);
    file->stream = fdopen(fd, "ab");
    if (!file->stream) {
        close(fd);
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    }
    return ET_OK;
}

/* The names of files that the process has open already: they may lead to a regular file, but must not be replaced. */
static int is_open_file(const char *path)
{
    static const char *const first[] = { "/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/" };
    for (size_t k = 0; k < sizeof first / sizeof *first; k++) {
        if (strncmp(path, first[k], strlen(first[k])) == 0)
            return 1;
    }
    return 0;
}

static et_status open_path(et_file *file, et_message *message)
{
    struct stat before;
    int exists = stat(file->path, &before) == 0;
    if (!exists && (errno != ENOENT || !*file->path))
        return cannot_write(message, file->path, errno);
    if (exists && S_ISDIR(before.st_mode))
        return cannot_write(message, file->path, EISDIR);
    if (is_open_file(file->path) || (exists && !S_ISREG(before.st_mode)))
        return open_direct(file, message);
    if (exists && access(file->path, W_OK) != 0)
        return cannot_write(message, file->path, errno);
    file->target = exists ? realpath(file->path, NULL) : strdup(file->path);
    if (!file->target)
        return errno == ENOMEM ? et_status_fail(message, ET_ENOMEM, "out of memory") : cannot_write(message, file->path, errno);
    return open_beside(file, exists ? &before : NULL, message);
}

et_status et_file_create(et_file *file, const char *path, et_message *message)
{
    et_file made = { NULL, NULL, NULL, NULL };
    et_status status = ET_OK;
    if (!file || !path)
        return et_status_fail(message, ET_EINVAL, "no file to write");
    made.path = strdup(strcmp(path, "-") == 0 ? "standard output" : path);
    if (!made.path)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    if (strcmp(path, "-") == 0)
        made.stream = stdout;
    else
        status = open_path(&made, message);
    if (status) {
        et_file_abandon(&made);
        return status;
    }
    if (made.stream != stdout)
        (void)setvbuf(made.stream, NULL, _IOFBF, BUFFER);
    *file = made;
    return ET_OK;
}

/* Flush and close; 0, or the reason why what was written may not be there. */
static int finish(et_file *file)
{
    errno = 0;
    int failed = ferror(file->stream) != 0;
    if (fflush(file->stream) != 0)
        failed = 1;
    int error = errno;
    if (!failed && file->temporary && fsync(fileno(file->stream)) != 0) {
        failed = 1;
        error = errno;
    }
    if (file->stream != stdout && fclose(file->stream) != 0 && !failed) {
        failed = 1;
        error = errno;
    }
    file->stream = NULL;
    return failed ? (error ? error : EIO) : 0;
}

et_status et_file_commit(et_file *file, et_message *message)
{
    if (!file)
        return et_status_fail(message, ET_EINVAL, "no file to write");
    if (!file->stream) {
        et_file_abandon(file);
        return et_status_fail(message, ET_EINVAL, "no file to write");
    }
    int error = finish(file);
    if (!error && file->temporary) {
        if (rename(file->temporary, file->target) == 0) {
            leave(file->temporary);
            free(file->temporary);
            file->temporary = NULL;
        } else {
            error = errno;
        }
    }
    et_status status = error ? cannot_write(message, file->path, error) : ET_OK;
    et_file_abandon(file);
    return status;
}

void et_file_abandon(et_file *file)
{
    if (!file)
        return;
    if (file->stream && file->stream != stdout)
        (void)fclose(file->stream);
    if (file->temporary) {
        (void)unlink(file->temporary);
        leave(file->temporary);
    }
    free(file->temporary);
    free(file->target);
    free(file->path);
    memset(file, 0, sizeof *file);
}

void et_file_abandon_all(void)
{
    int error = errno;
    for (int k = 0; k < ET_FILE_LIVE; k++) {
        if (live[k])
            (void)unlink(name[k]);
    }
    errno = error;
}
