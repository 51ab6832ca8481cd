/* cli: what the subcommands share.  Nothing here is part of the library. */
#ifndef ETALON_CLI_H
#define ETALON_CLI_H
#include "etalon/base/task.h"
#include "etalon/io/json.h"
#include "etalon/fit/enclosure.h"
#include "etalon/refine/ceres.h"
#include "etalon/refine/optimum.h"
#include "etalon/refine/search.h"
#include <jansson.h>
#include <stdio.h>

/* ---- options: one table a subcommand ------------------------------------------------------------------------------- */

typedef enum {
    CLI_FLAG,      /* int: set to 1 */
    CLI_TEXT,      /* const char * */
    CLI_SIZE,      /* size_t */
    CLI_PAIR,      /* size_t[2]: 20x30, or 20 for 20x20 */
    CLI_REAL,      /* double, finite */
    CLI_SEED,      /* uint64_t */
    CLI_NAME       /* int: index of the word in `names` */
} cli_kind;

typedef struct {
    const char *name;                     /* long name, without the dashes */
    char letter;                          /* short name, or 0 */
    cli_kind kind;
    void *target;
    const char *value;                    /* what the help calls its value, or null */
    const char *help;
    const char *(*names)(size_t k);       /* CLI_NAME: the words, null past the last */
} cli_option;

typedef struct {
    const char *name, *usage, *what;      /* "train", "etalon train CLOUD [options]", one sentence */
    const char *examples;
    size_t least, most;                   /* positional arguments */
} cli_help;

/* Options every subcommand has, and the state of this run. */
typedef struct {
    int json, quiet, progress, help;
    int exact;                            /* --exact, of the subcommands that have it */
    size_t threads;
    uint64_t seed;
    const char *input;                    /* the cloud's name, for messages */
    const char *stage;                    /* what the progress line says is being done */
    double began, shown;                  /* wall clock, progress line only */
    int drawn;
} cli_run;

enum { CLI_COMMON = 6, CLI_POSITIONAL = 8 };
cli_run cli_run_defaults(void);
void cli_common(cli_option options[CLI_COMMON], cli_run *run);

/* Parse argv[1..]; prints the help and sets run->help when asked for it.  ET_EINVAL with a sentence otherwise. */
et_status cli_parse(const char **positional, size_t *npositional, int argc, char **argv, const cli_option *options, size_t noptions,
                    const cli_help *help, et_message *message);
/* A comma-separated list of words into indices; ET_EINVAL names the word that is not known. */
et_status cli_list(size_t *chosen, size_t *count, size_t most, const char *text, const char *(*names)(size_t), const char *option, et_message *message);
et_status cli_pairs(size_t (*pairs)[2], size_t *count, size_t most, const char *text, const char *option, et_message *message);

/* ---- one run: progress, interruption, clocks ------------------------------------------------------------------------- */

void cli_signals(void);                   /* SIGINT, SIGTERM ask to stop; a second one ends at once; SIGPIPE is an error code */
void cli_memory(void);                    /* without memory for JSON the program ends, with exit code 70 and nothing half-written */
int cli_stopped(void);
void cli_end_at_once(void);               /* from here on the first signal ends the program: there is no best so far to save */
void cli_on_end(void (*function)(void));  /* called (async-signal-safe) when a signal ends the program; null: nothing */
et_status cli_check(et_message *message); /* ET_ESTOPPED once a stop was asked for */
et_task cli_task(cli_run *run, const char *stage);      /* progress line and stop, for a computation */
void cli_task_end(cli_run *run);          /* wipe the progress line */
double cli_cpu(void);                     /* processor seconds of this thread */
void cli_say(const cli_run *run, const char *format, ...);     /* to standard error unless --quiet or --json */
et_status cli_print(const json_t *object, et_message *message);/* one JSON line on standard output */
/* A member, an element more; where memory is short *o is freed and becomes null, which the packing or printing that follows tells. */
void cli_json_add(json_t **o, const char *name, json_t *value);
void cli_json_append(json_t **array, json_t *value);
json_t *cli_json_text(const char *text);   /* null: null; what is no text, as a file's name may be, has question marks for its odd bytes */
et_status cli_json_load(json_t **document, const char *path, et_message *message);     /* a file, whatever it holds */
/* ET_EINVAL if two of the n paths are one; null and "-" do not count. */
et_status cli_distinct(const char *const *paths, size_t n, et_message *message);

/* ---- the pipeline ------------------------------------------------------------------------------------------------------ */

typedef struct { size_t grid[2]; size_t iterations; double alpha, radius; et_frame_kind frame; } cli_train_options;
typedef enum { CLI_GA = 0, CLI_DE, CLI_PSO, CLI_CERES, CLI_CERES_FULL, CLI_OPTIMUM, CLI_ALGORITHMS } cli_algorithm;
typedef struct {
    et_search_options search;
    et_ceres_options ceres;
    et_optimum_options optimum;
    int exact;                            /* the result is measured exactly */
    size_t generations;
    int faithful;                         /* the source's: the result is the population's best even where the start was better */
    const char *checkpoint, *resume;      /* files, or null: where a search's state is left at the end, and taken up from */
} cli_refine_options;

typedef struct {
    cli_algorithm algorithm;
    double before, after, seconds;
    uint64_t evaluations;
    size_t steps;                         /* generations or iterations made */
    int stopped;
    double *history;                      /* steps entries: best value after each */
    et_optimum_result optimum;            /* CLI_OPTIMUM: the certified interval, and the dual that proves it */
    et_vec3 *dual;
    et_surface_file surface;
} cli_refined;

/* Option tables that several subcommands share, and what was chosen by them. */
typedef struct { int approach, method, knots, algebra, corners; size_t degree[2], control[2]; } cli_fit_choice;
enum { CLI_TRAIN_OPTIONS = 5, CLI_FIT_OPTIONS = 6, CLI_REFINE_OPTIONS = 22 };
cli_fit_choice cli_fit_choice_defaults(void);
void cli_train_table(cli_option table[CLI_TRAIN_OPTIONS], cli_train_options *o, int *frame);
void cli_fit_table(cli_option table[CLI_FIT_OPTIONS], cli_fit_choice *choice);
et_fit_options cli_fit_chosen(const cli_fit_choice *choice);
void cli_refine_table(cli_option table[CLI_REFINE_OPTIONS], cli_refine_options *o);
/* Settings made consistent, after parsing: --faithful brings the source's box.  ET_EINVAL names what is out of range. */
et_status cli_refine_settle(cli_refine_options *o, et_message *message);

const char *cli_algorithm_name(size_t k); /* "ga", "de", "pso", "ceres", "ceres-full", "optimum" */
const char *cli_approach_name(size_t k);
const char *cli_method_name(size_t k);
const char *cli_knots_name(size_t k);
const char *cli_algebra_name(size_t k);
const char *cli_corners_name(size_t k);
const char *cli_frame_name(size_t k);

cli_train_options cli_train_defaults(void);
cli_refine_options cli_refine_defaults(void);

/* Train on a cloud (copied, then mapped to the unit cube). */
et_status cli_train(et_net_file *net, double *seconds, const et_vec3 *cloud, size_t n, const cli_train_options *options, cli_run *run, et_message *message);
/* Fit, measure, and gap; with run->exact every stage correctly rounded. */
et_status cli_fit(et_surface_file *surface, const et_net_file *net, const et_fit_options *options, cli_run *run, et_message *message);
/* Refine a copy of surface; round r of an experiment draws from its own stream.  task may be null.  On ET_ESTOPPED the result holds the best so far. */
et_status cli_refine(cli_refined *result, const et_surface_file *surface, const et_vec3 *data, cli_algorithm algorithm,
                     const cli_refine_options *options, uint64_t seed, uint64_t round, const et_task *task, et_message *message);
void cli_refined_free(cli_refined *result);
et_status cli_surface_copy(et_surface_file *copy, const et_surface_file *surface);
/* Errors and seam gap; exact: correctly rounded, for surfaces measured at their fit's parameters. */
et_status cli_surface_measure(et_surface_file *surface, const et_vec3 *data, int exact);
/* Residuals, NOV of them, and errors; at the data's refined parameters where the surface has them. */
et_status cli_residual(double *residual, et_fit_error *error, const et_surface_file *surface, const et_vec3 *data);
/* How far control points leave the box of the net, as a share of its longest side: a surface that swings out between its data. */
double cli_overshoot(const et_surface_file *surface, const et_vec3 *data);
void cli_warn_overshoot(const cli_run *run, double overshoot);

/* ---- JSON fragments ------------------------------------------------------------------------------------------------------ */

json_t *cli_json_som(const et_net_file *net, double seconds);
json_t *cli_json_fit(const et_surface_file *surface, double overshoot);
json_t *cli_json_refined(const cli_refined *result);
et_status cli_write_json(const char *path, const json_t *object, et_message *message);
/* The dual point of an optimum, with the interval it proves. */
et_status cli_write_certificate(const char *path, const cli_refined *result, et_message *message);
et_status cli_write_history(const char *path, const cli_refined *results, size_t n, et_message *message);

/* ---- checkpoints of a search (src/cli/checkpoint.c) ------------------------------------------------------------------------ */

et_status cli_checkpoint_write(const char *path, const et_search *search, const et_rng *rng, cli_algorithm algorithm, uint64_t seed, const double *history,
                               et_message *message);
/* Take up a search just started: everything in it but its options and callback is replaced; *history is grown to hold what was made and `more`. */
et_status cli_checkpoint_read(et_search *search, et_rng *rng, double **history, cli_algorithm algorithm, uint64_t seed, size_t more, const char *path,
                              et_message *message);

/* ---- what reconstruct hands to its report (src/cli/report.c) ---------------------------------------------------------------- */

typedef struct {
    const char *cloud;                    /* the input's name */
    size_t points;
    uint64_t seed;
    et_net_file net;
    double train_seconds, fit_seconds, overshoot;
    et_surface_file fit[3];               /* conventional, improved, joint */
    size_t approach;                      /* which of them goes on */
    cli_refined *refined;
    size_t nrefined, best;                /* best: index of the least `after`, nrefined when there is none */
    size_t vertices, triangles;
    double volume, stl_rounding;          /* the latter as a share of the mesh's size */
    int pictures;
} cli_reconstruction;

json_t *cli_json_summary(const cli_reconstruction *r);
et_status cli_write_report(const char *path, const cli_reconstruction *r, et_message *message);
const et_surface_file *cli_final(const cli_reconstruction *r);

/* ---- subcommands: each returns a status and, when that is not ET_OK, a message ------------------------------------------- */

et_status cli_generate(int argc, char **argv, et_message *message);
et_status cli_train_command(int argc, char **argv, et_message *message);
et_status cli_evaluate(int argc, char **argv, et_message *message);
et_status cli_fit_command(int argc, char **argv, et_message *message);
et_status cli_refine_command(int argc, char **argv, et_message *message);
et_status cli_compare(int argc, char **argv, et_message *message);
et_status cli_reconstruct(int argc, char **argv, et_message *message);
et_status cli_conform(int argc, char **argv, et_message *message);
et_status cli_serve(int argc, char **argv, et_message *message);
#endif
