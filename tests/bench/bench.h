/* bench: time by the processor's clock, peers as programs of their own, one table for all. */
#ifndef TESTS_BENCH_H
#define TESTS_BENCH_H
#ifdef __cplusplus
extern "C" {
#endif

/* Seconds of processor time of this process so far. */
double bench_cpu(void);

/* What a benchmark runs; it returns a residual (or 0), the same at every call. */
typedef double (*bench_fn)(void *context);

/* Least processor time in seconds of `repeats` calls of fn, after one call that warms up; *residual (may be null) what fn returned. */
double bench_min(bench_fn fn, void *context, int repeats, double *residual);

/* A peer is a program that prints its version (one word), its seconds and its residual, as `VERSION SECONDS RESIDUAL`.  It is run as
 * `COMMAND ITEM SIZE`; 0 if it is absent or fails (exit status not 0, or other output), else 1 and what it printed. */
typedef struct { char version[64]; double seconds, residual; } bench_result;
int bench_peer(bench_result *result, const char *command, const char *item, const char *size);

/* The heading, once a program. */
void bench_head(void);

/* One line: item | size | peer and version | peer's time | ours | ratio | memory | residual | goal | met.  Times in seconds for one unit of
 * work; memory is this process's peak so far.  goal_ratio 0: no goal.  Returns 1 if the goal is met or there is none. */
int bench_row(const char *item, const char *size, const char *peer, double peer_seconds, double our_seconds, double goal_ratio, double residual);

/* The goal of this build: `native` when the peers' folder (BENCH_BIN) is the native build's, else `portable`. */
double bench_goal(double portable, double native);

/* The line of a peer that is not there. */
void bench_skip(const char *item, const char *size, const char *peer);

#ifdef __cplusplus
}
#endif
#endif
