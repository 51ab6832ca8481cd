/* run: which mutants the tests notice.
 *
 * run --list                       the units of test: a property, its corpus, a table against the functions, a table against the exact layer
 * run --watch FOLDER [UNIT...]     each unit once, unmutated; FOLDER/UNIT.seen gets, for every mutant that would make a difference in it, in which cases
 * run --kill FOLDER SECONDS        the mutants named on the standard input, a line each; a line of answer each
 *
 * A mutant is a number of its point's table (see mutants.h); each is tried in a child of its own, which stops at the first test that notices.
 * Tables and corpora are the files named in the environment's ET_TABLES and ET_CORPUS, blanks between them; ET_MOST is how many cases that differ are
 * tried of each unit, for a quick look.
 */
#define _DEFAULT_SOURCE
#include "mutants.h"
#include "rows.h"
#include "source.h"
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { CASES = 1000, UNITS = 4096, NAME = 128, MODULE = 32, STAGES = 4 };
static size_t limits[STAGES] = { 2, 20, 200, SIZE_MAX };

extern const et_points *const et_files[];       /* generated; ends with null */
extern const unsigned et_mutants;               /* how many, numbered through all files */

/* Of memory.c, or of what is linked in its place. */
size_t et_memory_cases(const char *folder);
int et_memory_fails(size_t k);
/* Of the sanitizer, where there is one. */
extern int __lsan_do_recoverable_leak_check(void) __attribute__((weak));

typedef enum { PROPERTY, CORPUS, GOLDEN, TRUTH, MEMORY } kind;
typedef struct {
    kind is;
    char name[NAME], module[MODULE];
    const property *p;
    char **list;                                /* paths of the corpus, or lines of the table */
    size_t cases;
    /* What was seen when it was watched: */
    double mean, longest;
    size_t skips;
    const unsigned char *base, *seen;           /* a verdict a case; mutants, each with a bit a case */
    size_t nseen;
} unit;

typedef struct {
    unsigned done, unit, at, stage;
    double spent;
} board;

static unit units[UNITS];
static size_t nunits, runs;                     /* runs: only so many cases of each property, ET_RUNS */
static gen *source;
static board *shared;

/* The points. */

static enum { RUN, WATCH, MUTATE } mode;
static unsigned wanted;                         /* the mutant */
static unsigned char *hit;
static unsigned *hits, nhits;
static struct { unsigned char *on; } *off;      /* points at rest until the next case */
static unsigned noff;

static void note(unsigned m)
{
    if (!hit[m]) {
        hit[m] = 1;
        hits[nhits++] = m;
    }
}

static void rest(const et_points *f, unsigned p)
{
    for (unsigned m = f->first[p]; m < f->first[p + 1]; m++)
        if (!hit[m])
            return;
    f->on[p] = 0;
    off[noff++].on = &f->on[p];
}

unsigned et_choose(const et_points *f, unsigned p, const void *variants, size_t size, unsigned n)
{
    const unsigned char *v = variants;

    if (mode == MUTATE)
        return wanted - f->first[p] + 1;
    if (mode == WATCH) {
        for (unsigned i = 1; i < n; i++)
            if (memcmp(v, v + i * size, size) != 0)
                note(f->first[p] + i - 1);
        rest(f, p);
    }
    return 0;
}

int et_flip(const et_points *f, unsigned p)
{
    if (mode == WATCH) {
        note(f->first[p]);
        rest(f, p);
    }
    return mode == MUTATE;
}

void et_trap(const et_points *f, unsigned p, unsigned variant)
{
    if (mode == WATCH)
        note(f->first[p] + variant - 1);
    if (mode == MUTATE && wanted == f->first[p] + variant - 1)
        raise(SIGFPE);
}

int et_same(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static void begin_case(void)
{
    while (nhits > 0)
        hit[hits[--nhits]] = 0;
    while (noff > 0)
        *off[--noff].on = 1;
}

static void switch_all(unsigned char value)
{
    for (size_t f = 0; et_files[f]; f++)
        memset(et_files[f]->on, value, et_files[f]->points);
}

static void switch_on(unsigned m)
{
    switch_all(0);
    wanted = m;
    mode = MUTATE;
    for (size_t f = 0; et_files[f]; f++)
        for (unsigned p = 0; p < et_files[f]->points; p++)
            if (et_files[f]->first[p] <= m && m < et_files[f]->first[p + 1])
                et_files[f]->on[p] = 1;
}

/* The units. */

static void *need(void *p)
{
    if (!p) {
        fputs("run: no memory\n", stderr);
        exit(2);
    }
    return p;
}

static uint64_t case_seed(const char *name, uint64_t seed, size_t i)
{
    uint64_t h = gen_mix(seed);

    while (*name)
        h = gen_mix(h ^ (unsigned char)*name++);
    return gen_mix(h + i);
}

static verdict run_corpus(const unit *u, size_t i)
{
    static uint8_t bytes[GEN_BYTES];
    FILE *f = fopen(u->list[i], "rb");
    const size_t n = f ? fread(bytes, 1, sizeof bytes, f) : 0;

    if (f)
        fclose(f);
    gen_from_bytes(source, bytes, n);
    return f ? u->p->run(source) : FAIL;
}

static verdict run_row(const unit *u, size_t i)
{
    char what[ROW_WHAT];
    char *line = need(malloc(strlen(u->list[i]) + 1));
    strcpy(line, u->list[i]);
    const verdict v = row_run(u->name, i + 1, line, u->is == GOLDEN ? ROW_GOLDEN : ROW_TRUTH, what);

    free(line);
    return v;
}

static verdict run_case(const unit *u, size_t i)
{
    if (u->is == PROPERTY) {
        gen_from_seed(source, case_seed(u->p->name, 1, i));
        return u->p->run(source);
    }
    if (u->is == MEMORY)
        return et_memory_fails(i) ? FAIL : PASS;
    return u->is == CORPUS ? run_corpus(u, i) : run_row(u, i);
}

static unit *add_unit(kind is, const char *prefix, const char *name, size_t length)
{
    unit *u = &units[nunits];

    if (nunits + 1 >= UNITS)
        exit(2);
    nunits++;
    u->is = is;
    snprintf(u->name, NAME, "%s%.*s", prefix, (int)length, name);
    snprintf(u->module, MODULE, "%.*s", (int)strcspn(name, "_."), name);
    return u;
}

static void add_line(unit *u, const char *text)
{
    if (u->cases % 64 == 0)
        u->list = need(realloc(u->list, (u->cases + 64) * sizeof *u->list));
    u->list[u->cases] = need(malloc(strlen(text) + 1));
    strcpy(u->list[u->cases++], text);
}

static const char *last_part(const char *path)
{
    return strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
}

static void add_table(const char *path)
{
    enum { LINE = 1 << 20 };
    static char line[LINE];
    const char *name = last_part(path);
    unit *g = add_unit(GOLDEN, "golden.", name, strcspn(name, ".")), *t = add_unit(TRUTH, "truth.", name, strcspn(name, "."));
    FILE *f = fopen(path, "r");

    while (f && fgets(line, LINE, f))
        if (line[0] != '#' && line[strspn(line, " \t\r\n")] != '\0') {
            add_line(g, line);
            add_line(t, line);
        }
    if (f)
        fclose(f);
}

static void add_case(const char *path)
{
    const char *name = last_part(path);
    const size_t n = strcspn(name, ".");

    for (size_t i = 0; i < nunits; i++)
        if (units[i].is == CORPUS && strlen(units[i].p->name) == n && memcmp(units[i].p->name, name, n) == 0) {
            add_line(&units[i], path);
            return;
        }
    for (const property *p = properties; p->name; p++)
        if (strlen(p->name) == n && memcmp(p->name, name, n) == 0) {
            unit *u = add_unit(CORPUS, "corpus.", name, n);
            u->p = p;
            add_line(u, path);
        }
}

static void each_word(const char *words, void (*what)(const char *word))
{
    char *copy = need(malloc(words ? strlen(words) + 1 : 1));

    strcpy(copy, words ? words : "");
    for (char *w = strtok(copy, " \n"); w; w = strtok(NULL, " \n"))
        what(w);
    free(copy);
}

static void add_units(void)
{
    for (const property *p = properties; p->name; p++) {
        unit *u = add_unit(PROPERTY, "", p->name, strlen(p->name));
        u->p = p;
        u->cases = (CASES + p->in - 1) / p->in;
    }
    const size_t calls = et_memory_cases(getenv("ET_MEMORY"));
    if (calls > 0)
        add_unit(MEMORY, "", "memory", 6)->cases = calls;
    each_word(getenv("ET_CORPUS"), add_case);
    each_word(getenv("ET_TABLES"), add_table);
}

static double now(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void silence(void)
{
    const int null = open("/dev/null", O_RDWR);

    dup2(null, 0);
    dup2(null, 1);
    dup2(null, 2);
}

/* Watching. */

static void write_seen(const unit *u, const char *path, unsigned char *bits, const unsigned char *base, double spent, double longest)
{
    const size_t width = (u->cases + 7) / 8;
    const double head[4] = { (double)u->cases, spent, longest, 0 };
    FILE *f = fopen(path, "wb");

    if (!f)
        _exit(3);
    fwrite(head, sizeof head, 1, f);
    fwrite(base, 1, u->cases, f);
    for (unsigned m = 0; m < et_mutants; m++) {
        bool any = false;
        for (size_t i = 0; i < width && !any; i++)
            any = bits[m * width + i] != 0;
        if (any) {
            fwrite(&m, sizeof m, 1, f);
            fwrite(bits + m * width, 1, width, f);
        }
    }
    if (fclose(f) != 0)
        _exit(3);
}

static void watch_unit(const unit *u, const char *path)
{
    const size_t width = (u->cases + 7) / 8;
    unsigned char *bits = need(calloc(et_mutants + 1, width)), *base = need(calloc(u->cases + 1, 1));
    double spent = 0, longest = 0;

    switch_all(1);
    mode = WATCH;
    for (size_t i = 0; i < u->cases; i++) {
        const double t = now(CLOCK_PROCESS_CPUTIME_ID);
        begin_case();
        base[i] = (unsigned char)run_case(u, i);
        for (unsigned h = 0; h < nhits; h++)
            bits[hits[h] * width + i / 8] |= (unsigned char)(1u << i % 8);
        const double took = now(CLOCK_PROCESS_CPUTIME_ID) - t;
        spent += took;
        longest = took > longest ? took : longest;
        if (base[i] == FAIL)
            _exit(4);
    }
    write_seen(u, path, bits, base, spent, longest);
    _exit(0);
}

static int watch(const char *folder, char **names)
{
    char path[4096];
    int failed = 0;

    for (size_t k = 0; k < nunits; k++) {
        bool mine = !*names;
        for (char **n = names; *n; n++)
            mine |= strcmp(*n, units[k].name) == 0;
        if (!mine)
            continue;
        int status = 0;
        fflush(stdout);
        snprintf(path, sizeof path, "%s/%s.seen", folder, units[k].name);
        const pid_t child = fork();
        if (child == 0) {
            silence();
            watch_unit(&units[k], path);
        }
        waitpid(child, &status, 0);
        if (status != 0) {
            failed = 1;
            printf("FAIL %s: the instrumented copy does not pass it (%d)\n", units[k].name, status);
        } else
            printf("ok %s\n", units[k].name);
        fflush(stdout);
    }
    return failed;
}

/* Killing. */

static void read_seen(unit *u, const char *folder)
{
    char path[4096];
    struct stat s;
    const unsigned char *m;
    double head[4];

    snprintf(path, sizeof path, "%s/%s.seen", folder, u->name);
    const int f = open(path, O_RDONLY);
    if (f < 0 || fstat(f, &s) != 0 || (size_t)s.st_size < sizeof head) {
        fprintf(stderr, "run: %s is missing: nobody asks this unit\n", path);
        u->cases = 0;
        return;
    }
    m = mmap(NULL, (size_t)s.st_size, PROT_READ, MAP_SHARED, f, 0);
    close(f);
    memcpy(head, m, sizeof head);
    u->mean = head[1] / (double)u->cases;
    u->longest = head[2];
    u->base = m + sizeof head;
    for (size_t i = 0; i < u->cases; i++)
        u->skips += u->base[i] == SKIP;
    u->seen = u->base + u->cases;
    u->nseen = ((size_t)s.st_size - sizeof head - u->cases) / (4 + (u->cases + 7) / 8);
}

/* The bits of mutant m in unit u, or null: the entries are in ascending order. */
static const unsigned char *bits_of(const unit *u, unsigned m)
{
    const size_t width = 4 + (u->cases + 7) / 8;
    size_t lo = 0, hi = u->nseen;

    while (lo < hi) {
        const size_t mid = (lo + hi) / 2;
        unsigned at;
        memcpy(&at, u->seen + mid * width, sizeof at);
        if (at == m)
            return u->seen + mid * width + 4;
        if (at < m)
            lo = mid + 1;
        else
            hi = mid;
    }
    return NULL;
}

typedef struct { unit *u; const unsigned char *bits; size_t next, tried, skips; bool own; } trial;

static bool is_own(const unit *u, const char *path)
{
    const char *name = last_part(path);
    const size_t n = strcspn(name, "_.");

    if (u->is == MEMORY || (strstr(path, "src/exact/") && u->is == TRUTH))
        return true;
    if (strcmp(name, "winner.h") == 0)
        return strcmp(u->module, "som") == 0 || strcmp(u->module, "quality") == 0;
    return strlen(u->module) == n && memcmp(u->module, name, n) == 0;
}

static int cheaper(const void *a, const void *b)
{
    const trial *s = a, *t = b;

    if (s->own != t->own)
        return t->own - s->own;
    return (s->u->mean > t->u->mean) - (s->u->mean < t->u->mean);
}

static void limit_case(double seconds)
{
    struct itimerval t = { { 0, 0 }, { (time_t)seconds, (suseconds_t)((seconds - (double)(time_t)seconds) * 1e6) } };

    setitimer(ITIMER_PROF, &t, NULL);
}

/* Try cases that differ until so many have been; does one fail? */
static bool try_cases(trial *t, size_t limit, double until)
{
    const unit *u = t->u;

    limit_case(0.3 + 5 * u->longest);
    for (; t->next < u->cases && t->tried < limit; t->next++) {
        if (u->is == PROPERTY && runs > 0 && t->next * u->p->in >= runs)
            continue;
        if (!(t->bits[t->next / 8] >> t->next % 8 & 1))
            continue;
        shared->at = (unsigned)t->next;
        limit_case(0.3 + 5 * u->longest);
        const verdict v = run_case(u, t->next);
        t->tried++;
        t->skips += (v == SKIP) - (size_t)(u->base[t->next] == SKIP);
        if (v == FAIL)
            return true;
        if (now(CLOCK_PROCESS_CPUTIME_ID) > until)
            return false;
    }
    if (t->next == u->cases && __lsan_do_recoverable_leak_check && __lsan_do_recoverable_leak_check() != 0)
        return true;
    return t->next == u->cases && u->is == PROPERTY && (u->skips + t->skips) * 10 > u->cases * 9;
}

static void try_mutant(unsigned m, const char *path, double budget)
{
    static trial trials[UNITS];
    size_t n = 0;

    for (size_t i = 0; i < nunits; i++) {
        const unsigned char *bits = bits_of(&units[i], m);
        if (bits)
            trials[n++] = (trial){ .u = &units[i], .bits = bits, .own = is_own(&units[i], path) };
    }
    qsort(trials, n, sizeof *trials, cheaper);
    shared->done = n == 0 ? 3 : 0;
    /* Own ones first in each round, and others within the budget: own 2, own 20, own 200, others 2, own all, others 20, ... */
    for (size_t stage = 0; stage < 2 * STAGES && !shared->done; stage++) {
        for (size_t i = 0; i < n && !shared->done; i++) {
            const bool other = !trials[i].own;
            const size_t round = other ? (stage >= 2 ? stage - 2 : SIZE_MAX) : stage;
            if (round >= STAGES)
                continue;
            if (other && now(CLOCK_PROCESS_CPUTIME_ID) > budget) {
                shared->done = 2;
                break;
            }
            shared->unit = (unsigned)(trials[i].u - units);
            shared->stage = (unsigned)stage;
            if (try_cases(&trials[i], limits[round], other ? budget : 1e9))
                shared->done = 1;
        }
        /* When the budget is used up by the others the own ones are still run to their end. */
        if (shared->done == 2)
            for (size_t i = 0; i < n && shared->done == 2; i++)
                if (trials[i].own) {
                    shared->unit = (unsigned)(trials[i].u - units);
                    if (try_cases(&trials[i], limits[STAGES - 1], 1e9))
                        shared->done = 1;
                }
    }
    if (!shared->done)
        shared->done = 4;
    shared->spent = now(CLOCK_PROCESS_CPUTIME_ID);
    _exit(0);
}

static void die_with_parent(void)
{
    struct rlimit memory = { (rlim_t)3 << 30, (rlim_t)3 << 30 }, core = { 0, 0 };

    if (!getenv("ET_SANITIZED"))
        setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &core);
    silence();
}

static void kill_mutant(unsigned m, const char *path, double budget)
{
    int status = 0;
    const char *how = "killed";
    struct rusage before, after;

    memset(shared, 0, sizeof *shared);
    getrusage(RUSAGE_CHILDREN, &before);
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        die_with_parent();
        alarm(600);
        switch_on(m);
        try_mutant(m, path, budget);
    }
    waitpid(child, &status, 0);
    getrusage(RUSAGE_CHILDREN, &after);
    const double spent = (double)(after.ru_utime.tv_sec - before.ru_utime.tv_sec) + 1e-6 * (double)(after.ru_utime.tv_usec - before.ru_utime.tv_usec);
    if (WIFSIGNALED(status))
        how = WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM ? "endless" : "crash";
    else if (WEXITSTATUS(status) != 0 || !shared->done)
        how = "crash";
    else if (shared->done != 1)
        how = shared->done == 2 ? "budget" : shared->done == 3 ? "unreached" : "survived";
    if (strcmp(how, "killed") == 0 || strcmp(how, "crash") == 0 || strcmp(how, "endless") == 0)
        printf("%u %s %s %u %.3f\n", m, how, units[shared->unit].name, shared->at, spent);
    else
        printf("%u %s - 0 %.3f\n", m, how, spent);
    fflush(stdout);
}

static const char *file_of(unsigned m)
{
    for (size_t f = 0; et_files[f]; f++)
        if (et_files[f]->points > 0 && m < et_files[f]->first[et_files[f]->points])
            return et_files[f]->path;
    return "";
}

static int kill_all(const char *folder, double budget)
{
    unsigned m;

    for (size_t i = 0; i < nunits; i++)
        read_seen(&units[i], folder);
    while (scanf("%u", &m) == 1)
        if (m < et_mutants)
            kill_mutant(m, file_of(m), budget);
    return 0;
}

int main(int argc, char **argv)
{
    source = need(calloc(1, sizeof *source));
    hit = need(calloc(et_mutants + 1, 1));
    hits = need(calloc(et_mutants + 1, sizeof *hits));
    off = need(calloc(et_mutants + 1, sizeof *off));
    shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    add_units();
    if (getenv("ET_RUNS"))
        runs = (size_t)strtoull(getenv("ET_RUNS"), NULL, 0);
    if (getenv("ET_MOST"))
        for (size_t i = 0; i < STAGES; i++) {
            const size_t most = (size_t)strtoull(getenv("ET_MOST"), NULL, 0);
            limits[i] = i + 1 == STAGES || limits[i] > most ? most : limits[i];
        }
    if (argc > 1 && strcmp(argv[1], "--list") == 0) {
        for (size_t i = 0; i < nunits; i++)
            printf("%s\t%s\t%zu\n", units[i].name, units[i].module, units[i].cases);
        return 0;
    }
    if (argc > 2 && strcmp(argv[1], "--watch") == 0)
        return watch(argv[2], argv + 3);
    if (argc > 3 && strcmp(argv[1], "--kill") == 0 && nunits > 0)
        return kill_all(argv[2], strtod(argv[3], NULL));
    fputs("run --list | --watch FOLDER [UNIT...] | --kill FOLDER SECONDS\n", stderr);
    return 2;
}
