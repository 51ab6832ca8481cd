/* raw: what a reader of files keeps, whatever the bytes.  The case is the file itself: fuzz/corpus holds files as they are. */
#ifndef TESTS_IO_RAW_H
#define TESTS_IO_RAW_H
#include "etalon/base/status.h"
#include "gen.h"
#include "io/some_shell.h"
#include <stdlib.h>

enum { RAW_MOST = 1 << 14, RAW_PATH = 256 };

typedef struct { uint8_t bytes[RAW_MOST]; size_t n; char path[RAW_PATH]; } raw_file;

static inline bool raw_spill(const char *path, const uint8_t *bytes, size_t n)
{
    FILE *const f = fopen(path, "wb");
    const bool ok = f && fwrite(bytes, 1, n, f) == n;

    return f && fclose(f) == 0 && ok;
}

static inline bool raw_draw(gen *g, raw_file *f, const char *ending, const sample *samples)
{
    f->n = gen_rest(g, f->bytes, RAW_MOST, samples);
    gen_note(g, "%zu bytes: %.*s", f->n, (int)(f->n < 2000 ? f->n : 2000), (const char *)f->bytes);
    return gen_check(g, raw_spill(some_path(f->path, ending), f->bytes, f->n), "%s cannot be written", f->path);
}

/* Lines at most, each with its end or, the last, without: LF, CR LF, CR; after a line that ended in CR alone, CR LF may be two ends. */
static inline size_t raw_lines(const raw_file *f)
{
    size_t lines = 0;

    for (size_t i = 0; i < f->n; i++)
        lines += f->bytes[i] == '\n' || f->bytes[i] == '\r' || i + 1 == f->n;
    return lines;
}

/* `FILE: what` or `FILE:LINE: what`, the line one that is there, or the one that should follow the last. */
static inline bool raw_told(gen *g, const raw_file *f, const et_message *m)
{
    const size_t n = strlen(f->path);
    const char *at = m->text + n;

    if (!gen_check(g, memchr(m->text, 0, sizeof m->text) && strncmp(m->text, f->path, n) == 0 && *at == ':', "message %s", m->text))
        return false;
    if (at[1] != ' ') {
        char *end;
        const unsigned long long line = strtoull(at + 1, &end, 10);
        if (!gen_check(g, at[1] >= '1' && at[1] <= '9' && *end == ':' && line <= raw_lines(f) + 1, "line in %s", m->text))
            return false;
        at = end;
    }
    return gen_check(g, at[1] == ' ' && strlen(at) > 2, "nothing told: %s", m->text);
}
#endif
