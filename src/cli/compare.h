/* compare: what the comparison, its journal and its tables share. */
#ifndef ETALON_CLI_COMPARE_H
#define ETALON_CLI_COMPARE_H
#include "cli/cli.h"

enum { COMPARE_CONTROLS = 64, COMPARE_METHODS = 4 };
enum { COMPARE_TEXT = 0, COMPARE_CSV, COMPARE_JSON };
const char *compare_format_name(size_t k);

typedef struct {
    const char *output, *journal, *baseline;
    int format;
    size_t controls[COMPARE_CONTROLS][2], ncontrols;
    size_t methods[COMPARE_METHODS], nmethods;
    size_t algorithms[CLI_ALGORITHMS], nalgorithms;
    size_t runs, start;
    double box;                           /* of the default readings; the faithful ones have the source's */
    cli_train_options train;
    cli_fit_choice fit;
    cli_refine_options refiner;
} compare_options;

typedef struct {
    int faithful;
    size_t control[2], method;
    et_surface_file fit[3];
    double seconds[3];
} compare_case;

typedef struct {
    size_t which, algorithm, run;         /* case, algorithm, run */
    int done, kept;                       /* computed; already in the journal */
    double before, after, gap, seconds;
    double lower;                         /* the optimum's certified lower bound; else 0 */
    uint64_t evaluations;
    size_t steps;
} compare_job;

typedef struct {
    const compare_options *options;
    const char *cloud;
    size_t points;
    json_t *som, *baseline;
    compare_case *cases; size_t ncases;
    compare_job *jobs; size_t njobs;
    FILE *journal;
} comparison;

/* The journal: its first line holds the settings, and another run's settings are refused. */
et_status compare_journal_open(comparison *t, const et_net_file *net, et_message *message);
et_status compare_journal_add(comparison *t, size_t job, et_message *message);
void compare_journal_close(comparison *t);

/* An earlier table, read before anything is computed or written. */
et_status compare_baseline_read(comparison *t, et_message *message);
/* The table, to where it was asked for, and its comparison with the baseline. */
et_status compare_deliver(const comparison *t, const cli_run *run, et_message *message);
#endif
