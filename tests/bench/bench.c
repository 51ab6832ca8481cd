/* C99 has no peak memory and no pipe: this file alone uses POSIX. */
#include "bench.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>

double bench_cpu(void)
{
    struct rusage r;
    if (getrusage(RUSAGE_SELF, &r) != 0) {
        return 0.0;
    }
    return (double)r.ru_utime.tv_sec + (double)r.ru_stime.tv_sec + 1e-6 * ((double)r.ru_utime.tv_usec + (double)r.ru_stime.tv_usec);
}

double bench_min(bench_fn fn, void *context, int repeats, double *residual)
{
    double value = fn(context);
    double least = 0.0;
    for (int k = 0; k < repeats; k++) {
        double start = bench_cpu();
        value = fn(context);
        double spent = bench_cpu() - start;
        if (k == 0 || spent < least) {
            least = spent;
        }
    }
    if (residual) {
        *residual = value;
    }
    return least;
}

int bench_peer(bench_result *result, const char *command, const char *item, const char *size)
{
    char line[1024];
    bench_result r;
    int n = snprintf(line, sizeof line, "%s %s %s 2>/dev/null", command, item, size);
    if (n < 0 || (size_t)n >= sizeof line) {
        return 0;
    }
    fflush(stdout);
    FILE *pipe = popen(line, "r");
    if (!pipe) {
        return 0;
    }
    int got = fscanf(pipe, "%63s %lf %lf", r.version, &r.seconds, &r.residual);
    while (fgetc(pipe) != EOF) {
        /* to its end: a peer still writing must not be cut off */
    }
    if (pclose(pipe) != 0 || got != 3 || !(r.seconds > 0.0)) {
        return 0;
    }
    *result = r;
    return 1;
}

/* Three figures and a unit a reader takes in at once. */
static const char *duration(char *text, size_t size, double seconds)
{
    static const char *unit[] = {"s", "ms", "us", "ns"};
    int k = 0;
    while (k < 3 && seconds < 1.0) {
        seconds *= 1000.0;
        k++;
    }
    snprintf(text, size, "%.3g %s", seconds, unit[k]);
    return text;
}

void bench_head(void)
{
    printf("%-28s | %-14s | %-26s | %9s | %9s | %6s | %8s | %9s | %5s | met\n", "item", "size", "peer version", "peer time", "ours", "ratio", "memory",
           "residual", "goal");
    fflush(stdout);
}

int bench_row(const char *item, const char *size, const char *peer, double peer_seconds, double our_seconds, double goal_ratio, double residual)
{
    char theirs[32], ours[32], goal[32];
    struct rusage r;
    long kilobytes = getrusage(RUSAGE_SELF, &r) == 0 ? r.ru_maxrss : 0;
    double ratio = our_seconds > 0.0 ? peer_seconds / our_seconds : 0.0;
    int met = ratio >= goal_ratio;
    snprintf(goal, sizeof goal, goal_ratio > 0.0 ? "%.3gx" : "-", goal_ratio);
    printf("%-28s | %-14s | %-26s | %9s | %9s | %5.2fx | %5ld MB | %9.2e | %5s | %s\n", item, size, peer, duration(theirs, sizeof theirs, peer_seconds),
           duration(ours, sizeof ours, our_seconds), ratio, kilobytes / 1024, residual, goal, goal_ratio > 0.0 ? (met ? "yes" : "NO") : "-");
    fflush(stdout);
    return met;
}

void bench_skip(const char *item, const char *size, const char *peer)
{
    printf("%-28s | %-14s | %-26s | not installed, skipped\n", item, size, peer);
    fflush(stdout);
}

double bench_goal(double portable, double native)
{
    const char *folder = getenv("BENCH_BIN");
    return folder && strstr(folder, "native") ? native : portable;
}
