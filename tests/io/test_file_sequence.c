/* io/file: any sequence of files begun, written, finished and given up: a file holds what was last finished, and nothing else lies about. */
#include "etalon/io/file.h"
#include "io/some_shell.h"
#include <dirent.h>
#include <sys/stat.h>

enum { NAMES = 3, OPEN = 4, CALLS = 16, PATH = 300, TEXT = 4000 };

typedef struct { et_file file; size_t name, n; char text[TEXT]; bool open; } writing;
typedef struct { char directory[256], text[NAMES][TEXT]; size_t n[NAMES]; bool there[NAMES]; writing open[OPEN]; } model;

static const char *path_of(char path[PATH], const model *m, size_t name)
{
    snprintf(path, PATH, "%s/%c", m->directory, (char)('a' + name));
    return path;
}

/* Each file holds what was last finished; beside them there are as many temporaries as open files. */
static bool as_modelled(gen *g, const model *m)
{
    char path[PATH];
    size_t files = 0, open = 0, there = 0;
    bool ok = true;

    for (size_t k = 0; ok && k < NAMES; k++) {
        size_t n = 0;
        char *const text = whole_file(path_of(path, m, k), &n);
        ok = gen_check(g, (text != NULL) == m->there[k] && (!text || (n == m->n[k] && memcmp(text, m->text[k], n) == 0)), "file %zu", k);
        free(text);
        there += m->there[k];
    }
    for (size_t k = 0; k < OPEN; k++)
        open += m->open[k].open;
    DIR *const d = opendir(m->directory);
    for (const struct dirent *e = d ? readdir(d) : NULL; e; e = readdir(d))
        files += e->d_name[0] != '.' || strncmp(e->d_name, ".etalon-", 8) == 0;
    if (d)
        closedir(d);
    return ok && gen_check(g, files == there + open, "%zu entries for %zu files and %zu open ones", files, there, open);
}

static bool call(gen *g, model *m)
{
    writing *const w = &m->open[gen_upto(g, OPEN - 1)];
    char path[PATH];
    et_message message = { "" };

    if (!w->open) {
        w->name = (size_t)gen_upto(g, NAMES - 1);
        w->n = 0;
        gen_label(g, m->there[w->name] ? "begun over another" : "begun");
        w->open = gen_check(g, et_file_create(&w->file, path_of(path, m, w->name), &message) == ET_OK, "%s", message.text);
        return w->open;
    }
    const uint64_t kind = gen_upto(g, 3);
    if (kind < 2) {
        const size_t n = (size_t)gen_upto(g, 2) * 700;
        memset(w->text + w->n, (int)('0' + gen_upto(g, 9)), w->n + n <= TEXT ? n : 0);
        w->n += w->n + n <= TEXT && fwrite(w->text + w->n, 1, n, w->file.stream) == n ? n : 0;
        return true;
    }
    w->open = false;
    if (kind == 3) {
        gen_label(g, "given up");
        et_file_abandon(&w->file);
        return gen_check(g, !w->file.stream && !w->file.path && !w->file.temporary, "not zeroed");
    }
    gen_label(g, "finished");
    memcpy(m->text[w->name], w->text, w->n);
    m->n[w->name] = w->n;
    m->there[w->name] = true;
    return gen_check(g, et_file_commit(&w->file, &message) == ET_OK && !w->file.stream && !w->file.path, "%s", message.text);
}

/* One case in 2. */
verdict prop_file_commit_sequence(gen *g)
{
    static model m;
    char path[PATH];

    memset(&m, 0, sizeof m);
    if (!gen_check(g, mkdir(some_path(m.directory, ".d"), 0700) == 0, "no directory"))
        return FAIL;
    bool ok = true;
    for (uint64_t calls = 1 + gen_upto(g, CALLS - 1); ok && calls > 0; calls--)
        ok = call(g, &m) && as_modelled(g, &m);
    for (size_t k = 0; k < OPEN; k++)
        if (m.open[k].open)
            et_file_abandon(&m.open[k].file);
    for (size_t k = 0; k < NAMES; k++)
        unlink(path_of(path, &m, k));
    ok = gen_check(g, rmdir(m.directory) == 0, "something is left") && ok;
    return ok ? PASS : FAIL;
}
