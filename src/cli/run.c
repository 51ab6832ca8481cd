/* run: progress, interruption, clocks, and the words a run says. */
#include "cli/conform.h"
#include "etalon/io/file.h"
#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t stop_asked, at_once;
static void (*volatile clean_up)(void);

/* One press may come twice: timeout(1) tells the process and then its group. */
static struct timespec asked;
static int long_since_asked(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - asked.tv_sec) + 1e-9 * (double)(now.tv_nsec - asked.tv_nsec) > 0.3;
}

/* The first signal asks; the second, or the first where nothing is worth waiting for, ends at once and leaves no temporary behind. */
static void on_signal(int number)
{
    static const char said[] = "etalon: interrupted; nothing was written\n";

    (void)number;
    if (at_once || (stop_asked && long_since_asked())) {
        et_file_abandon_all();
        if (clean_up)
            clean_up();
        if (write(STDERR_FILENO, said, sizeof said - 1) < 0)
            _exit(130);
        _exit(130);
    }
    if (!stop_asked)
        clock_gettime(CLOCK_MONOTONIC, &asked);
    stop_asked = 1;
}

void cli_end_at_once(void)
{
    at_once = 1;
}

void cli_on_end(void (*function)(void))
{
    clean_up = function;
}

void cli_signals(void)
{
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, NULL);   /* closed pipe, file too large: errors of the write, not ends of the program */
    sigaction(SIGXFSZ, &action, NULL);
}

int cli_stopped(void)
{
    return stop_asked != 0;
}

et_status cli_check(et_message *message)
{
    return stop_asked ? et_status_fail(message, ET_ESTOPPED, "interrupted; nothing was written") : ET_OK;
}

cli_run cli_run_defaults(void)
{
    cli_run run;
    memset(&run, 0, sizeof run);
    run.seed = 1;
    run.threads = 1;
    return run;
}

static double seconds(clockid_t which)
{
    struct timespec t;
    return clock_gettime(which, &t) == 0 ? (double)t.tv_sec + 1e-9 * (double)t.tv_nsec : 0.0;
}

double cli_cpu(void)
{
    return seconds(CLOCK_THREAD_CPUTIME_ID);
}

static void draw(cli_run *run, size_t done, size_t total, double now)
{
    const double elapsed = now - run->began, rate = elapsed > 0 ? (double)done / elapsed : 0;
    const double left = rate > 0 ? (double)(total - done) / rate : 0;

    fprintf(stderr, "\r\033[K%s  %3.0f %%  %zu/%zu  %.3g/s  %.0f s left", run->stage, total ? 100.0 * (double)done / (double)total : 0.0, done, total,
            rate, left);
    fflush(stderr);
    run->drawn = 1;
    run->shown = now;
}

static et_status step(void *context, size_t done, size_t total)
{
    cli_run *run = context;

    if (stop_asked)
        return ET_ESTOPPED;
    if (!run->quiet && (run->progress || isatty(STDERR_FILENO))) {
        const double now = seconds(CLOCK_MONOTONIC);
        if (now - run->shown > 0.1)
            draw(run, done, total, now);
    }
    return ET_OK;
}

et_task cli_task(cli_run *run, const char *stage)
{
    const et_task task = { step, run };
    run->stage = stage;
    run->began = seconds(CLOCK_MONOTONIC);
    run->shown = run->progress ? 0 : run->began;
    return task;
}

void cli_task_end(cli_run *run)
{
    if (run->drawn)
        fputs("\r\033[K", stderr);
    run->drawn = 0;
}

void cli_say(const cli_run *run, const char *format, ...)
{
    va_list list;

    if (run->quiet || run->json)
        return;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
}

et_status cli_print(const json_t *object, et_message *message)
{
    char *text = object ? json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(17)) : NULL;

    if (!text)
        return et_status_fail(message, ET_ENOMEM, "not enough memory to print the result");
    const int bad = puts(text) < 0 || fflush(stdout) != 0;
    free(text);
    return bad ? et_status_fail(message, ET_EIO, "cannot write to standard output") : ET_OK;
}

void cli_json_add(json_t **o, const char *name, json_t *value)
{
    if (json_object_set_new(*o, name, value) != 0) {
        json_decref(*o);
        *o = NULL;
    }
}

void cli_json_append(json_t **array, json_t *value)
{
    if (json_array_append_new(*array, value) != 0) {
        json_decref(*array);
        *array = NULL;
    }
}

json_t *cli_json_text(const char *text)
{
    json_t *s = text ? json_string(text) : json_null();
    char clean[CONFORM_TEXT];

    return s ? s : json_string(conform_clean(clean, text));
}

et_status cli_json_load(json_t **document, const char *path, et_message *message)
{
    json_error_t error;
    FILE *stream = fopen(path, "rb");

    if (!stream)
        return et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", path, strerror(errno));
    errno = 0;
    *document = json_loadf(stream, JSON_REJECT_DUPLICATES, &error);
    const int reason = errno, failed = ferror(stream);
    fclose(stream);
    if (failed) {                        /* Jansson takes it for the end */
        json_decref(*document);
        return et_status_fail(message, ET_EIO, "cannot read %s: %s", path, reason ? strerror(reason) : "read error");
    }
    return *document ? ET_OK : et_status_fail(message, ET_EFORMAT, "%s:%d: %s", path, error.line, error.text);
}

/* Jansson 2.14 reads on when it gets no memory, past the end of what it has: the program ends before that. */
static void *memory_for_json(size_t n)
{
    static const char said[] = "etalon: not enough memory; nothing more was written\n";
    void *p = malloc(n);

    if (!p && n > 0) {
        et_file_abandon_all();
        if (clean_up)
            clean_up();
        if (write(STDERR_FILENO, said, sizeof said - 1) < 0)
            _exit(et_status_exit(ET_ENOMEM));
        _exit(et_status_exit(ET_ENOMEM));
    }
    return p;
}

void cli_memory(void)
{
    json_set_alloc_funcs(memory_for_json, free);
}

et_status cli_distinct(const char *const *paths, size_t n, et_message *message)
{
    for (size_t a = 0; a < n; a++)
        for (size_t b = a + 1; b < n; b++)
            if (paths[a] && paths[b] && strcmp(paths[a], paths[b]) == 0 && strcmp(paths[a], "-") != 0)
                return et_status_fail(message, ET_EINVAL, "%s is named for two different files", paths[a]);
    return ET_OK;
}
