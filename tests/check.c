/* check: runs the properties and the golden rows, each group in a process of its own.
 *
 * check [-v] [-n RUNS] [-s SEED] [NAME | MODULE ...]   random cases (ET_RUNS, ET_SEED: the same by environment)
 * check --replay FILE...                               one case per file; the property is the file's name up to the first '.'
 * check --shrink FILE...                               the same, and a failing one is shrunk to NAME.fail
 * check --golden FILE...                               rows of golden/MODULE.tsv
 * check --truth FILE...                                the same rows against the exact layer, bit for bit
 * check --bite FILE...                                 golden rows altered by an ulp: is it noticed, by the function or the exact layer?
 * check --labels [NAME | MODULE ...]                   how often the typed generators made each hard case, a line a property
 * check --list                                         the names of the properties
 */
#include "rows.h"
#include "shrink.h"
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { RUNS = 1000, SECONDS = 240, SHRINK_CALLS = 100000, AT_ONCE = 6, WINDOW = 48, PATH = 1024 };

/* Shared by parent and child: what a crash leaves behind. */
typedef struct {
    gen g;
    shrinker s;
    verdict result;
    bool done;
    size_t runs, skipped, passed, failed, values, missed;
    double spent;
} board;

typedef struct {
    const property *p;
    board *b;
    pid_t child;
    int status;                          /* the child's, once it has ended */
    uint64_t seed;
    size_t runs;
    const uint8_t *bytes;
    size_t nbytes;
    const char *path;
} job;

static board *shared;                    /* WINDOW of them */
static bool verbose, tabular;
static unsigned seconds;                 /* a property may take, ET_SECONDS */
static size_t passed, failed;
static char program_dir[PATH];

static board *share(size_t size)
{
    FILE *f = tmpfile();
    void *m;

    if (!f || ftruncate(fileno(f), (off_t)size) != 0)
        return NULL;
    m = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(f), 0);
    fclose(f);
    return m == MAP_FAILED ? NULL : m;
}

/* Do the work in a child.  A child that ends well has set done. */
static void start(void (*work)(job *j), job *j, unsigned limit)
{
    j->b->done = false;
    fflush(stdout);
    j->child = fork();
    if (j->child == 0) {
        alarm(limit);
        work(j);
        j->b->done = true;
        exit(0);
    }
}

/* The child's wait status. */
static int await(const job *j)
{
    int status = -1;

    return j->child > 0 && waitpid(j->child, &status, 0) == j->child ? status : -1;
}

static int apart(void (*work)(job *j), job *j, unsigned limit)
{
    start(work, j, limit);
    return await(j);
}

static const char *ending(const board *b, int status)
{
    if (status != -1 && WIFSIGNALED(status))
        return WTERMSIG(status) == SIGALRM ? "timed out" : strsignal(WTERMSIG(status));
    if (!b->done)
        return "the process ended in the middle of a case";
    return status == 0 ? NULL : "errors found when the process ended (leaks?)";
}

static uint64_t case_seed(const char *name, uint64_t seed, size_t i)
{
    uint64_t h = gen_mix(seed);

    while (*name)
        h = gen_mix(h ^ (unsigned char)*name++);
    return gen_mix(h + i);
}

static void work_random(job *j)
{
    board *b = j->b;
    const clock_t began = clock();

    for (size_t i = 0; i < j->runs && b->result != FAIL; i++) {
        gen_from_seed(&b->g, case_seed(j->p->name, j->seed, i));
        b->result = j->p->run(&b->g);
        b->runs++;
        b->skipped += b->result == SKIP;
    }
    b->spent = (double)(clock() - began) / CLOCKS_PER_SEC;
}

static void work_bytes(job *j)
{
    gen_from_bytes(&j->b->g, j->bytes, j->nbytes);
    j->b->result = j->p->run(&j->b->g);
}

/* The counterexample, told. */
static void work_show(job *j)
{
    static uint64_t v[GEN_DRAWS];

    for (size_t i = 0; i < j->b->s.nbest; i++)
        v[i] = j->b->s.best[i].value;
    gen_from_values(&j->b->g, v, j->b->s.nbest);
    j->b->g.show = true;
    j->b->g.show_draws = verbose;
    j->p->run(&j->b->g);
    j->b->g.show = false;
    fflush(stdout);
}

static bool fails_here(void *context, gen *g)
{
    const job *j = context;

    return j->p->run(g) == FAIL;
}

static void work_shrink(job *j)
{
    shrink(&j->b->s);
}

static void quiet(job *j)
{
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr))
        return;
    j->b->result = j->p->run(&j->b->g);
}

static bool fails_apart(void *context, gen *g)
{
    job *j = context;
    const int status = apart(quiet, j, 5);

    return g == &j->b->g && (status != 0 || j->b->result == FAIL);
}

static void write_case(const board *b, const char *path)
{
    static uint8_t bytes[GEN_BYTES];
    const size_t n = gen_encode(bytes, b->s.best, b->s.nbest);
    FILE *f = fopen(path, "wb");

    if (!f || fwrite(bytes, 1, n, f) != n)
        printf("  cannot write %s\n", path);
    if (f)
        fclose(f);
}

static void shrink_case(job *j, bool crashed)
{
    board *b = j->b;

    b->s.fails = fails_here;
    b->s.context = j;
    b->s.trial = &b->g;
    b->s.calls = SHRINK_CALLS;
    b->s.seconds = 20;
    if (!crashed && apart(work_shrink, j, 60) == 0)
        return;
    b->s.fails = fails_apart;            /* a case that kills its process: each trial in one of its own */
    b->s.calls = 3000;
    shrink(&b->s);
}

/* The failing draws stand in the board; shrink, write, show. */
static void report(job *j, const char *how, bool shrinking)
{
    board *b = j->b;
    char path[2 * PATH];
    const bool leak = b->done && b->result != FAIL, slow = how && strcmp(how, "timed out") == 0;

    memcpy(b->s.best, b->g.draws, b->g.ndraws * sizeof b->g.draws[0]);
    memcpy(b->s.spans, b->g.spans, b->g.nspans * sizeof b->g.spans[0]);
    b->s.nbest = b->g.ndraws;
    b->s.nspans = b->g.nspans;
    if (shrinking && !leak && !slow)
        shrink_case(j, how != NULL);
    snprintf(path, sizeof path, "%s/%s.fail", program_dir, j->p->name);
    if (shrinking)
        write_case(b, path);
    if (shrinking)
        printf("  %zu draws in %s; again: check --replay %s\n", b->s.nbest, path, path);
    if (!slow)
        apart(work_show, j, 60);
}

static void clear_board(board *b)
{
    gen_clear(&b->g);
    b->result = PASS;
    b->runs = b->skipped = b->passed = b->failed = b->values = b->missed = 0;
}

static int by_text(const void *a, const void *b)
{
    return strcmp(((const label *)a)->text, ((const label *)b)->text);
}

static void tell_labels(board *b)
{
    qsort(b->g.labels, b->g.nlabels, sizeof b->g.labels[0], by_text);
    for (size_t i = 0; i < b->g.nlabels; i++)
        printf("  %5.1f %% %s\n", 100.0 * (double)b->g.labels[i].cases / (double)b->runs, b->g.labels[i].text);
}

/* A letter a label of the typed generators, then a line a property: percents, and how many labels of its own it has. */
static void labels_head(void)
{
    char letter = 'a';

    for (size_t i = 0; gen_standard[i]; i++)
        printf("# %c %s\n", letter++, gen_standard[i]);
    printf("%-36s %7s %4s", "# percent of cases", "cases", "skip");
    for (char c = 'a'; c < letter; c++)
        printf("%4c", c);
    puts("  own");
}

static void labels_row(const char *name, const board *b)
{
    const double all = b->runs > 0 ? (double)b->runs : 1;
    size_t own = b->g.nlabels;

    printf("%-36s %7zu %4.0f", name, b->runs, 100.0 * (double)b->skipped / all);
    for (size_t i = 0; gen_standard[i]; i++) {
        size_t k = 0;
        while (k < b->g.nlabels && strcmp(b->g.labels[k].text, gen_standard[i]) != 0)
            k++;
        own -= k < b->g.nlabels;
        if (k < b->g.nlabels)
            printf("%4.0f", 100.0 * (double)b->g.labels[k].cases / all);
        else
            printf("   .");
    }
    printf("%5zu\n", own);
}

static void tell_passed(const char *name, board *b)
{
    printf("ok %s %zu cases, %zu skipped", name, b->runs, b->skipped);
    if (verbose)
        printf(", %.3f s", b->spent);
    putchar('\n');
    if (verbose)
        tell_labels(b);
}

static void start_property(job *j)
{
    clear_board(j->b);
    start(work_random, j, seconds);
}

static void finish_property(job *j)
{
    board *b = j->b;
    const char *how = ending(b, j->status);

    if (how || b->result == FAIL) {
        failed++;
        printf("FAIL %s seed %llu case %zu%s%s\n", j->p->name, (unsigned long long)j->seed, b->runs, how ? ": " : "", how ? how : "");
        report(j, how, true);
    } else if (b->skipped * 10 > b->runs * 9) {
        failed++;
        printf("FAIL %s skips %zu of %zu cases\n", j->p->name, b->skipped, b->runs);
    } else {
        passed++;
        if (tabular)
            labels_row(j->p->name, b);
        else
            tell_passed(j->p->name, b);
    }
}

static const property *find(const char *name, size_t length)
{
    for (const property *p = properties; p->name; p++)
        if (strlen(p->name) == length && memcmp(p->name, name, length) == 0)
            return p;
    return NULL;
}

static void replay(const char *path, bool shrinking)
{
    static uint8_t bytes[GEN_BYTES];
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path, *how;
    FILE *f = fopen(path, "rb");
    job j = { .p = find(name, strcspn(name, ".")), .b = shared, .bytes = bytes };

    if (f) {
        j.nbytes = fread(bytes, 1, sizeof bytes, f);
        fclose(f);
    }
    if (!f || !j.p) {
        failed++;
        printf("FAIL %s: %s\n", path, f ? "no property of this name" : "cannot be read");
        return;
    }
    clear_board(shared);
    how = ending(shared, apart(work_bytes, &j, seconds));
    if (how || shared->result == FAIL) {
        failed++;
        printf("FAIL %s%s%s\n", path, how ? ": " : "", how ? how : "");
        report(&j, how, shrinking);
    } else {
        passed++;
        printf("ok %s%s\n", path, shared->result == SKIP ? " (skipped)" : "");
    }
}

static void each_row(job *j, void (*what)(job *j, char *line))
{
    enum { LINE = 1 << 20 };
    char *line = malloc(LINE);
    FILE *f = fopen(j->path, "r");

    if (!f || !line) {
        j->b->failed++;
        printf("FAIL %s: cannot be read\n", j->path);
    }
    for (size_t n = 1; f && line && fgets(line, LINE, f); n++) {
        j->b->runs = n;
        if (line[0] != '#' && line[strspn(line, " \t\r\n")] != '\0')
            what(j, line);
    }
    free(line);
    if (f)
        fclose(f);
}

static void judge_row(job *j, char *line, row_judge judge)
{
    char what[ROW_WHAT];
    const verdict v = row_run(j->path, j->b->runs, line, judge, what);

    j->b->passed += v == PASS;
    j->b->failed += v == FAIL;
    j->b->skipped += v == SKIP;
    if (v == FAIL || (verbose && v == PASS))
        printf("%s %s:%zu %s\n", v == FAIL ? "FAIL" : "ok", j->path, j->b->runs, what);
}

static void golden_row(job *j, char *line)
{
    judge_row(j, line, ROW_GOLDEN);
}

static void truth_row(job *j, char *line)
{
    judge_row(j, line, ROW_TRUTH);
}

/* The line is cut in place: each judge gets his own. */
static void bite_row(job *j, char *line)
{
    const size_t n = strlen(line) + 1;
    char *copy = malloc(n);

    if (!copy) {
        j->b->missed++;
        return;
    }
    memcpy(copy, line, n);
    j->b->values += row_bite(j->path, j->b->runs, line, ROW_GOLDEN, &j->b->missed);
    j->b->values += row_bite(j->path, j->b->runs, copy, ROW_TRUTH, &j->b->missed);
    free(copy);
}

static void work_golden(job *j)
{
    each_row(j, golden_row);
    if (j->b->failed == 0)
        printf("ok %s %zu rows\n", j->path, j->b->passed);
}

static void work_truth(job *j)
{
    each_row(j, truth_row);
    if (j->b->failed == 0)
        printf("ok %s %zu rows computed again exactly, %zu that the exact layer does not know\n", j->path, j->b->passed, j->b->skipped);
}

static void work_bite(job *j)
{
    board *b = j->b;

    each_row(j, bite_row);
    b->failed += b->missed > 0;
    b->passed += b->missed == 0;
    printf("%s %s: %zu of %zu altered values noticed\n", b->missed ? "FAIL" : "ok", j->path, b->values - b->missed, b->values);
}

static void table(const char *path, void (*work)(job *j))
{
    job j = { .b = shared, .path = path };
    const char *how;

    clear_board(shared);
    how = ending(shared, apart(work, &j, seconds));
    passed += shared->passed;
    failed += shared->failed + (how != NULL);
    if (how)
        printf("FAIL %s after line %zu: %s\n", path, shared->runs, how);
    else if (shared->passed + shared->failed + shared->skipped == 0) {
        failed++;
        printf("FAIL %s has no rows\n", path);
    }
}

static bool belongs(const char *name, const char *wanted)
{
    const size_t n = strlen(wanted);

    return strncmp(name, wanted, n) == 0 && (name[n] == '\0' || name[n] == '_');
}

/* One of the jobs first .. behind - 1 that still run has ended. */
static void await_any(job *jobs, size_t first, size_t behind)
{
    int status;
    const pid_t child = waitpid(-1, &status, 0);

    for (size_t i = first; i < behind; i++) {
        job *j = &jobs[i % WINDOW];
        if (j->child > 0 && (child == j->child || child < 0)) {
            j->status = child < 0 ? -1 : status;
            j->child = 0;
        }
    }
}

static size_t running(const job *jobs, size_t first, size_t behind)
{
    size_t n = 0;

    for (size_t i = first; i < behind; i++)
        n += jobs[i % WINDOW].child > 0;
    return n;
}

/* A few at once, the next as soon as one has ended; told in their order, so that at most WINDOW wait to be told. */
static void random_run(const property **wanted, size_t n, uint64_t seed, size_t runs)
{
    static job jobs[WINDOW];
    size_t begun = 0, told = 0;

    while (told < n) {
        while (begun < n && begun - told < WINDOW && running(jobs, told, begun) < AT_ONCE) {
            job *j = &jobs[begun % WINDOW];
            *j = (job){ .p = wanted[begun], .b = shared + begun % WINDOW, .status = -1, .seed = seed };
            j->runs = (runs + j->p->in - 1) / j->p->in;
            start_property(j);
            begun++;
        }
        if (jobs[told % WINDOW].child > 0)
            await_any(jobs, told, begun);
        else
            finish_property(&jobs[told++ % WINDOW]);
    }
}

static void random_all(char **names, size_t n, uint64_t seed, size_t runs)
{
    const property **wanted;
    size_t count = 0;

    for (size_t i = 0; i < n; i++) {
        bool known = false;
        for (const property *p = properties; p->name; p++)
            known |= belongs(p->name, names[i]);
        failed += !known;
        if (!known)
            printf("FAIL %s: no property of this name\n", names[i]);
    }
    for (const property *p = properties; p->name; p++)
        count++;
    wanted = malloc((count + 1) * sizeof *wanted);
    if (!wanted) {
        perror("check");
        exit(2);
    }
    count = 0;
    for (const property *p = properties; p->name; p++) {
        bool is = n == 0;
        for (size_t i = 0; i < n; i++)
            is |= belongs(p->name, names[i]);
        if (is)
            wanted[count++] = p;
    }
    random_run(wanted, count, seed, runs);
    free(wanted);
}

static unsigned long long setting(const char *name, unsigned long long usual)
{
    const char *text = getenv(name);

    return text && *text ? strtoull(text, NULL, 0) : usual;
}

static void list(void)
{
    for (const property *p = properties; p->name; p++)
        puts(p->name);
}

static void golden_table(const char *path)
{
    table(path, work_golden);
}

static void truth_table(const char *path)
{
    table(path, work_truth);
}

static void bite_table(const char *path)
{
    table(path, work_bite);
}

static void files(char **argv, void (*each)(const char *path))
{
    while (*argv)
        each(*argv++);
}

static void replay_only(const char *path)
{
    replay(path, false);
}

static void replay_shrink(const char *path)
{
    replay(path, true);
}

static int usage(void)
{
    fputs("check [-v] [-n RUNS] [-s SEED] [NAME | MODULE ...]\n"
          "check [-v] --replay | --shrink | --golden | --truth | --bite FILE...\n"
          "check --labels [NAME | MODULE ...]\ncheck --list\n", stderr);
    return 2;
}

int main(int argc, char **argv)
{
    unsigned long long runs = setting("ET_RUNS", RUNS), seed = setting("ET_SEED", 1);
    int i = 1;

    seconds = (unsigned)setting("ET_SECONDS", SECONDS);
    snprintf(program_dir, sizeof program_dir, "%.*s", (int)(strrchr(argv[0], '/') ? strrchr(argv[0], '/') - argv[0] : 1),
             strrchr(argv[0], '/') ? argv[0] : ".");
    shared = share(WINDOW * sizeof *shared);
    if (!shared)
        return perror("check: shared memory"), 2;
    for (; i < argc && argv[i][0] == '-' && argv[i][1] != '-'; i++)
        if (strcmp(argv[i], "-v") == 0)
            verbose = true;
        else if (strcmp(argv[i], "-n") == 0 && i + 1 < argc)
            runs = strtoull(argv[++i], NULL, 0);
        else if (strcmp(argv[i], "-s") == 0 && i + 1 < argc)
            seed = strtoull(argv[++i], NULL, 0);
        else
            return usage();
    if (i < argc && strcmp(argv[i], "--list") == 0)
        return list(), 0;
    if (i < argc && strcmp(argv[i], "--replay") == 0)
        files(argv + i + 1, replay_only);
    else if (i < argc && strcmp(argv[i], "--shrink") == 0)
        files(argv + i + 1, replay_shrink);
    else if (i < argc && strcmp(argv[i], "--golden") == 0)
        files(argv + i + 1, golden_table);
    else if (i < argc && strcmp(argv[i], "--truth") == 0)
        files(argv + i + 1, truth_table);
    else if (i < argc && strcmp(argv[i], "--bite") == 0)
        files(argv + i + 1, bite_table);
    else if (i < argc && strcmp(argv[i], "--labels") == 0) {
        tabular = true;
        labels_head();
        random_all(argv + i + 1, (size_t)(argc - i - 1), seed, (size_t)runs);
    } else if (i < argc && argv[i][0] == '-')
        return usage();
    else
        random_all(argv + i, (size_t)(argc - i), seed, (size_t)runs);
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0;
}
