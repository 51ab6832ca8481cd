#include "etalon/io/file.h"
#include "gen.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PATH = 600, MOST = 200000 };

/* ---- a directory of the case's own ---- */

static bool make_directory(char directory[PATH])
{
    const char *const where = getenv("TMPDIR");

    snprintf(directory, PATH, "%s/etalon-file-%ld", where && *where ? where : access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp", (long)getpid());
    return mkdir(directory, 0700) == 0;
}

static const char *within(char path[PATH], const char *directory, const char *name)
{
    const size_t n = strlen(directory);

    memcpy(path, directory, n);
    snprintf(path + n, PATH - n, "/%s", name);
    return path;
}

/* Its entries, and how many of them are temporaries. */
static size_t entries(const char *directory, size_t *temporaries)
{
    DIR *const d = opendir(directory);
    size_t n = 0;

    *temporaries = 0;
    for (const struct dirent *e = d ? readdir(d) : NULL; e; e = readdir(d)) {
        n += strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0;
        *temporaries += strncmp(e->d_name, ".etalon-", 8) == 0;
    }
    if (d)
        closedir(d);
    return n;
}

static void remove_directory(const char *directory)
{
    char path[PATH];
    DIR *const d = opendir(directory);

    for (const struct dirent *e = d ? readdir(d) : NULL; e; e = readdir(d))
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0 && unlink(within(path, directory, e->d_name)) != 0)
            rmdir(path);
    if (d)
        closedir(d);
    rmdir(directory);
}

static void spill(const char *path, const char *text)
{
    FILE *const f = fopen(path, "wb");

    if (f) {
        fputs(text, f);
        fclose(f);
    }
}

static bool holds(const char *path, const char *bytes, size_t n)
{
    FILE *const f = fopen(path, "rb");
    char *const got = malloc(n + 1);
    const bool same = f && got && fread(got, 1, n + 1, f) == n && memcmp(got, bytes, n) == 0;

    if (f)
        fclose(f);
    free(got);
    return same;
}

static bool holds_text(const char *path, const char *text)
{
    return holds(path, text, strlen(text));
}

static bool zeroed(const et_file *f)
{
    return !f->stream && !f->path && !f->target && !f->temporary;
}

static bool message_is(const et_message *m, const char *path, const char *reason)
{
    char wanted[ET_MESSAGE_SIZE];

    snprintf(wanted, sizeof wanted, "cannot write %s: %s", path, reason);
    return strcmp(m->text, wanted) == 0;
}

/* Runs a check in a child: its true is our true. */
static bool apart(bool (*check)(const char *directory), const char *directory)
{
    int status = -1;
    const pid_t child = (fflush(stdout), fork());

    if (child == 0)
        _exit(check(directory) ? 0 : 1);
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* ---- et_file_create ---- */

static mode_t mode_of(const char *path)
{
    struct stat s;

    return lstat(path, &s) == 0 ? s.st_mode : 0;
}

/* A new file, or one that replaces another: nothing to be seen before the commit, permissions as promised. */
static bool creates(gen *g, const char *directory)
{
    const mode_t old = (mode_t)(0600 + gen_upto(g, 3) * 020 + gen_upto(g, 3) * 2), mask = gen_chance(g, 2) ? 077 : 022;
    const bool before = gen_chance(g, 2), link = before && gen_chance(g, 2);
    const mode_t umask_was = umask(mask);
    char path[PATH], place[PATH], wanted[PATH];
    et_file f;
    et_message m;
    size_t temporaries = 0;

    within(path, directory, "out");
    within(place, directory, link ? "real" : "out");
    if (before) {
        spill(place, "earlier");
        chmod(place, old);
    }
    if (link && symlink("real", path) != 0)
        return false;
    if (!gen_check(g, et_file_create(&f, path, &m) == ET_OK, "not created"))
        return false;
    snprintf(wanted, sizeof wanted, "%.500s/.etalon-%ld-", directory, (long)getpid());
    bool ok = gen_check(g, f.stream && strcmp(f.path, path) == 0, "path %s", f.path);
    ok = ok && gen_check(g, f.temporary && strncmp(f.temporary, wanted, strlen(wanted)) == 0, "temporary %s", f.temporary);
    entries(directory, &temporaries);
    ok = ok && gen_check(g, temporaries == 1 && access(f.temporary, F_OK) == 0, "%zu temporaries", temporaries);
    ok = ok && gen_check(g, before ? holds_text(place, "earlier") : access(path, F_OK) != 0, "seen before the commit");
    fputs("later", f.stream);
    ok = gen_check(g, et_file_commit(&f, &m) == ET_OK && zeroed(&f), "not committed") && ok;
    ok = ok && gen_check(g, holds_text(place, "later") && holds_text(path, "later"), "content");
    ok = ok && gen_check(g, entries(directory, &temporaries) == (link ? 2 : 1) && temporaries == 0, "left something");
    ok = ok && gen_check(g, (mode_of(place) & 0777) == (before ? old : (0666 & ~mask)), "permissions %o", (unsigned)mode_of(place));
    ok = ok && gen_check(g, S_ISLNK(mode_of(path)) == link, "the link is gone");
    umask(umask_was);
    return ok;
}

static bool refuses_as(gen *g, const char *path, et_status status, const char *reason)
{
    static char somewhere[4];
    const et_file unused = { stdin, somewhere, somewhere + 1, somewhere + 2 };
    et_file f = unused;
    et_message m = { "" };
    bool ok = gen_check(g, et_file_create(&f, path, &m) == status, "status");

    ok = ok && gen_check(g, memcmp(&f, &unused, sizeof f) == 0, "*file changed");
    ok = ok && gen_check(g, !reason || message_is(&m, path, reason), "message %s", m.text);
    return ok && gen_check(g, et_file_create(&f, path, NULL) == status, "status without a message");
}

static bool refuses(gen *g, const char *directory)
{
    char path[PATH], long_name[300];
    size_t temporaries = 0;
    bool ok = refuses_as(g, directory, ET_EIO, strerror(EISDIR)) && refuses_as(g, NULL, ET_EINVAL, NULL);

    ok = ok && gen_check(g, et_file_create(NULL, "x", NULL) == ET_EINVAL, "null file");
    ok = ok && refuses_as(g, within(path, directory, "none/out"), ET_EIO, strerror(ENOENT));
    ok = ok && refuses_as(g, within(path, directory, "none/"), ET_EIO, strerror(ENOENT));
    ok = ok && refuses_as(g, "", ET_EIO, strerror(ENOENT));
    memset(long_name, 'n', sizeof long_name - 1);
    long_name[sizeof long_name - 1] = 0;
    ok = ok && refuses_as(g, within(path, directory, long_name), ET_EIO, strerror(ENAMETOOLONG));
    spill(within(path, directory, "file"), "x");
    ok = ok && refuses_as(g, within(path, directory, "file/out"), ET_EIO, strerror(ENOTDIR));
    if (geteuid() != 0) {                 /* the superuser may do anything */
        chmod(within(path, directory, "file"), 0444);
        ok = ok && refuses_as(g, path, ET_EIO, strerror(EACCES));
        chmod(directory, 0500);
        ok = ok && refuses_as(g, within(path, directory, "out"), ET_EIO, strerror(EACCES));
        chmod(directory, 0700);
    }
    return ok && gen_check(g, entries(directory, &temporaries) == 1 && temporaries == 0, "left something");
}

/* What is no regular file is written directly. */
static bool writes_directly(gen *g, const char *directory)
{
    char path[PATH], got[16] = "";
    et_file f;
    et_message m;
    bool ok = gen_check(g, et_file_create(&f, "/dev/null", &m) == ET_OK && !f.temporary && !f.target, "/dev/null");

    ok = ok && fputs("x", f.stream) >= 0 && gen_check(g, et_file_commit(&f, &m) == ET_OK && zeroed(&f), "/dev/null");
    if (!ok || mkfifo(within(path, directory, "fifo"), 0600) != 0)
        return false;
    const int reader = open(path, O_RDONLY | O_NONBLOCK);
    ok = gen_check(g, et_file_create(&f, path, &m) == ET_OK && !f.temporary, "FIFO") && fputs("through", f.stream) >= 0;
    ok = ok && gen_check(g, et_file_commit(&f, &m) == ET_OK, "FIFO");
    ok = ok && gen_check(g, read(reader, got, sizeof got) == 7 && memcmp(got, "through", 7) == 0 && S_ISFIFO(mode_of(path)), "FIFO got %s", got);
    close(reader);
    ok = ok && gen_check(g, et_file_create(&f, "-", &m) == ET_OK && f.stream == stdout && !f.temporary, "standard output");
    ok = ok && gen_check(g, et_file_commit(&f, &m) == ET_OK && zeroed(&f) && fcntl(1, F_GETFD) >= 0, "standard output");
    return ok;
}

/* Two thousandths of a second: not in every case.  The table is full with ET_FILE_LIVE files, and free again after. */
static bool counts(gen *g, const char *directory)
{
    et_file f[ET_FILE_LIVE + 1];
    char path[PATH], name[32];
    size_t n = 0, temporaries = 0;
    et_message m = { "" };

    for (; n <= ET_FILE_LIVE; n++) {
        snprintf(name, sizeof name, "out%zu", n);
        if (et_file_create(&f[n], within(path, directory, name), &m) != ET_OK)
            break;
    }
    bool ok = gen_check(g, n == ET_FILE_LIVE, "%zu files open", n) && gen_check(g, message_is(&m, path, strerror(EMFILE)), "message %s", m.text);
    entries(directory, &temporaries);
    ok = ok && gen_check(g, temporaries == n, "%zu temporaries of %zu files", temporaries, n);
    for (size_t k = 0; k < n; k++)
        et_file_abandon(&f[k]);
    return ok && gen_check(g, entries(directory, &temporaries) == 0, "left something") && creates(g, directory);
}

/* A stale file of the next temporary's name is not touched. */
static bool steps_aside(gen *g, const char *directory)
{
    char path[PATH], stale[PATH];
    et_file f;
    unsigned long count;

    if (et_file_create(&f, within(path, directory, "out"), NULL) != ET_OK)
        return gen_check(g, false, "not created");
    const char *const number = strrchr(f.temporary, '-');
    count = strtoul(number + 1, NULL, 10);
    snprintf(stale, sizeof stale, "%.*s-%lu.tmp", (int)(number - f.temporary), f.temporary, count + 1);
    et_file_abandon(&f);
    spill(stale, "stale");
    bool ok = gen_check(g, et_file_create(&f, path, NULL) == ET_OK && strcmp(f.temporary, stale) != 0, "took %s", stale);
    if (ok)
        et_file_abandon(&f);
    return ok && gen_check(g, holds_text(stale, "stale"), "%s was written", stale);
}

/* A name without a directory stands in the current one; descriptor 0 serves as another; "/dev/stdout" is not replaced. */
static bool here(const char *directory)
{
    et_file f;
    struct stat before, after;
    bool ok = chdir(directory) == 0 && close(0) == 0 && et_file_create(&f, "out", NULL) == ET_OK && strncmp(f.temporary, ".etalon-", 8) == 0;

    ok = ok && fileno(f.stream) == 0 && et_file_commit(&f, NULL) == ET_OK && access("out", F_OK) == 0;
    ok = ok && et_file_create(&f, "/dev/null", NULL) == ET_OK && fileno(f.stream) == 0 && et_file_commit(&f, NULL) == ET_OK;
    spill("log", "first ");
    const int fd = open("log", O_WRONLY | O_APPEND);
    ok = ok && fd >= 0 && dup2(fd, 1) == 1 && stat("log", &before) == 0 && et_file_create(&f, "/dev/stdout", NULL) == ET_OK && !f.temporary;
    ok = ok && fputs("second", f.stream) >= 0 && et_file_commit(&f, NULL) == ET_OK;
    return ok && holds_text("log", "first second") && stat("log", &after) == 0 && before.st_ino == after.st_ino;
}

verdict prop_file_create(gen *g)
{
    char directory[PATH];
    bool ok;

    if (!make_directory(directory))
        return SKIP;
    switch (gen_upto(g, 19)) {
    case 0: ok = writes_directly(g, directory); break;
    case 1: ok = counts(g, directory); break;
    case 2: ok = steps_aside(g, directory); break;
    case 3: ok = gen_check(g, apart(here, directory), "the current directory, /dev/stdout"); break;
    case 4: case 5: ok = refuses(g, directory); break;
    default: ok = creates(g, directory); break;
    }
    chmod(directory, 0700);
    remove_directory(directory);
    return ok ? PASS : FAIL;
}

/* ---- et_file_commit ---- */

static bool commits(gen *g, const char *directory)
{
    const size_t n = (size_t)gen_upto(g, gen_chance(g, 8) ? MOST : 100), step = 1 + (size_t)gen_upto(g, 9999);
    const unsigned stride = (unsigned)gen_upto(g, 250);
    static char bytes[MOST];
    char path[PATH];
    et_file f;
    et_message m = { "untouched" };

    for (size_t k = 0; k < n; k++)
        bytes[k] = (char)(k * (stride + 1) + k / 251);
    if (gen_chance(g, 2))
        spill(within(path, directory, "out"), "earlier, and longer than some of what replaces it");
    if (!gen_check(g, et_file_create(&f, within(path, directory, "out"), &m) == ET_OK, "not created"))
        return false;
    for (size_t k = 0; k < n; k += step)
        fwrite(bytes + k, 1, n - k < step ? n - k : step, f.stream);
    return gen_check(g, et_file_commit(&f, &m) == ET_OK && zeroed(&f) && strcmp(m.text, "untouched") == 0, "not committed") &&
           gen_check(g, holds(path, bytes, n), "content of %zu bytes", n);
}

/* The rename cannot be made: a directory has appeared, or the temporary is gone. */
static bool rename_fails(gen *g, const char *directory)
{
    char path[PATH];
    et_file f;
    et_message m = { "" };
    size_t temporaries = 0;
    const bool gone = gen_chance(g, 2);

    if (!gen_check(g, et_file_create(&f, within(path, directory, "out"), &m) == ET_OK, "not created"))
        return false;
    fputs("x", f.stream);
    if (gone ? unlink(f.temporary) != 0 : mkdir(path, 0700) != 0)
        return false;
    return gen_check(g, et_file_commit(&f, &m) == ET_EIO && zeroed(&f), "status") &&
           gen_check(g, message_is(&m, path, strerror(gone ? ENOENT : EISDIR)), "message %s", m.text) &&
           gen_check(g, entries(directory, &temporaries) == (gone ? 0 : 1) && temporaries == 0, "left something");
}

/* No room: a file that may not grow past 4096 bytes, and /dev/full. */
static bool no_room(const char *directory)
{
    const struct rlimit limit = { 4096, 4096 };
    char path[PATH], block[1000] = "";
    et_file f;
    et_message m = { "" };
    size_t temporaries = 0;
    bool ok = true;

    for (size_t size = 5000; ok && size <= 500000; size *= 100) {
        spill(within(path, directory, "out"), "earlier");
        signal(SIGXFSZ, SIG_IGN);
        ok = setrlimit(RLIMIT_FSIZE, &limit) == 0 && et_file_create(&f, path, &m) == ET_OK;
        for (size_t k = 0; ok && k < size; k += sizeof block)
            fwrite(block, 1, sizeof block, f.stream);
        ok = ok && et_file_commit(&f, &m) == ET_EIO && zeroed(&f) && strncmp(m.text, "cannot write ", 13) == 0 && strstr(m.text, path);
        ok = ok && holds_text(path, "earlier") && entries(directory, &temporaries) == 1;
    }
    return ok;
}

static bool full(gen *g, size_t n)
{
    et_file f;
    et_message m = { "" };

    if (!gen_check(g, et_file_create(&f, "/dev/full", &m) == ET_OK, "not opened"))
        return false;
    for (size_t k = 0; k < n; k++)
        putc('x', f.stream);
    return gen_check(g, et_file_commit(&f, &m) == ET_EIO && zeroed(&f) && message_is(&m, "/dev/full", strerror(ENOSPC)), "message %s", m.text);
}

/* A broken pipe, and a full standard output. */
static bool broken(const char *directory)
{
    char path[PATH];
    et_file f;
    et_message m = { "" };
    int ends[2];
    bool ok = mkfifo(within(path, directory, "fifo"), 0600) == 0;
    const int reader = open(path, O_RDONLY | O_NONBLOCK);

    signal(SIGPIPE, SIG_IGN);
    ok = ok && reader >= 0 && et_file_create(&f, path, &m) == ET_OK && close(reader) == 0 && fputs("x", f.stream) >= 0;
    ok = ok && et_file_commit(&f, &m) == ET_EIO && message_is(&m, path, strerror(EPIPE));
    ok = ok && pipe(ends) == 0 && dup2(ends[1], 1) == 1 && close(ends[0]) == 0 && et_file_create(&f, "-", &m) == ET_OK;
    ok = ok && fputs("x", f.stream) >= 0 && et_file_commit(&f, &m) == ET_EIO;
    return ok && message_is(&m, "standard output", strerror(EPIPE)) && fcntl(1, F_GETFD) >= 0;
}

verdict prop_file_commit(gen *g)
{
    char directory[PATH];
    et_file none = { NULL, NULL, NULL, NULL };
    bool ok = gen_check(g, et_file_commit(&none, NULL) == ET_EINVAL && et_file_commit(NULL, NULL) == ET_EINVAL, "no file");

    if (!make_directory(directory))
        return SKIP;
    switch (gen_upto(g, 19)) {
    case 0: ok = ok && full(g, 1 + (size_t)gen_upto(g, MOST)); break;
    case 1: ok = ok && gen_check(g, apart(no_room, directory), "no room"); break;
    case 2: ok = ok && gen_check(g, apart(broken, directory), "broken pipe"); break;
    case 3: case 4: ok = ok && rename_fails(g, directory); break;
    default: ok = ok && commits(g, directory); break;
    }
    remove_directory(directory);
    return ok ? PASS : FAIL;
}

/* ---- et_file_abandon ---- */

verdict prop_file_abandon(gen *g)
{
    char directory[PATH], path[PATH];
    const bool before = gen_chance(g, 2);
    const size_t n = (size_t)gen_upto(g, 3) * 50000;
    et_file f = { NULL, NULL, NULL, NULL };
    size_t temporaries = 0;
    bool ok;

    et_file_abandon(NULL);
    et_file_abandon(&f);
    if (!make_directory(directory))
        return SKIP;
    within(path, directory, "out");
    if (before)
        spill(path, "earlier");
    ok = gen_check(g, et_file_create(&f, path, NULL) == ET_OK, "not created");
    for (size_t k = 0; ok && k < n; k++)
        putc('x', f.stream);
    et_file_abandon(&f);
    ok = ok && gen_check(g, zeroed(&f), "not zeroed");
    ok = ok && gen_check(g, entries(directory, &temporaries) == (before ? 1 : 0) && temporaries == 0, "left something");
    ok = ok && gen_check(g, !before || holds_text(path, "earlier"), "the earlier file");
    ok = ok && gen_check(g, et_file_create(&f, "-", NULL) == ET_OK && (et_file_abandon(&f), fcntl(1, F_GETFD) >= 0), "standard output closed");
    remove_directory(directory);
    return ok ? PASS : FAIL;
}

/* ---- et_file_abandon_all ---- */

static void on_signal(int number)
{
    et_file_abandon_all();
    _exit(number == SIGTERM ? 0 : 1);
}

/* A handler removes what is open. */
static bool ended_by_signal(const char *directory)
{
    char path[PATH];
    et_file a, b;

    signal(SIGTERM, on_signal);
    if (et_file_create(&a, within(path, directory, "a"), NULL) != ET_OK || et_file_create(&b, within(path, directory, "b"), NULL) != ET_OK)
        return false;
    fputs("x", a.stream);
    fflush(a.stream);
    raise(SIGTERM);
    return false;
}

verdict prop_file_abandon_all(gen *g)
{
    enum { FILES = 5 };
    char directory[PATH], path[PATH], name[8];
    et_file f[FILES];
    bool open[FILES] = { false };
    size_t temporaries = 0;
    bool ok = true;

    if (!make_directory(directory))
        return SKIP;
    for (size_t k = 0; k < FILES; k++) {
        snprintf(name, sizeof name, "%zu", k);
        spill(within(path, directory, name), "earlier");
        open[k] = et_file_create(&f[k], path, NULL) == ET_OK;
        ok = ok && gen_check(g, open[k], "not created");
    }
    const size_t done = (size_t)gen_upto(g, FILES - 1);
    fputs("later", f[done].stream);
    if (gen_chance(g, 2))
        ok = gen_check(g, et_file_commit(&f[done], NULL) == ET_OK, "not committed") && ok;
    else
        et_file_abandon(&f[done]);
    open[done] = false;
    errno = EDOM;
    et_file_abandon_all();
    ok = ok && gen_check(g, errno == EDOM, "errno changed");
    ok = ok && gen_check(g, entries(directory, &temporaries) == FILES && temporaries == 0, "%zu temporaries left", temporaries);
    for (size_t k = 0; k < FILES; k++) {
        if (open[k] && k % 2)
            ok = gen_check(g, et_file_commit(&f[k], NULL) == ET_EIO, "committed what is gone") && ok;
        else if (open[k])
            et_file_abandon(&f[k]);
        snprintf(name, sizeof name, "%zu", k);
        ok = ok && gen_check(g, k == done || holds_text(within(path, directory, name), "earlier"), "the earlier file");
    }
    if (gen_chance(g, 20))
        ok = ok && gen_check(g, apart(ended_by_signal, directory) && entries(directory, &temporaries) == FILES, "the handler left a temporary");
    remove_directory(directory);
    return ok ? PASS : FAIL;
}
