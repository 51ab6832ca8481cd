/* conform: a peer is judged: cases asked, verdicts counted, faults shrunk. */
#ifndef ETALON_CONFORM_CONFORM_H
#define ETALON_CONFORM_CONFORM_H
#include "etalon/base/task.h"
#include "etalon/conform/campaign.h"
#include "etalon/conform/peer.h"
#include "etalon/conform/vectors.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    unsigned level;                       /* 0 .. 3 */
    int op[ET_OPS];                       /* which to ask */
    uint64_t seed;
    size_t cases;                         /* level 2: cases in all */
    const char *vectors;                  /* folder of the frozen ones; null: none are asked */
    size_t findings;                      /* how many faults are shrunk and told, of each operation and verdict */
} et_conform_options;

typedef struct {
    et_request_op op;
    et_category category;
    et_judgement judgement;
    char *vector, *issue, *relation;      /* or null */
    char *request, *reply;                /* as asked first; reply may be null */
    char *shrunk, *shrunk_reply;          /* or null */
    et_judgement shrunk_judgement;
} et_conform_finding;

typedef struct {
    size_t count[ET_OPS][ET_CATEGORIES][ET_VERDICTS];
    size_t asked, refused_rightly;
    size_t skipped;                       /* the operation timed out or crashed too often in a row; or the exact layer could not decide */
    double worst[ET_OPS];                 /* greatest error / bound */
    et_conform_finding *finding;
    size_t findings;
} et_conform_report;

/* Level 0, all operations, seed 1, 10000 cases, no vectors, 3 findings.
 * Golden: none (settings). */
/*@ assigns \nothing;
    ensures level: \result.level == 0;
    ensures all:   \forall integer k; 0 <= k < ET_OPS ==> \result.op[k] == 1;
*/
et_conform_options et_conform_defaults(void);

/* The peer is asked, judged and counted, as docs/conformance.md says.  Requests are asked in blocks of 32, once in order and then all again in the
 * reverse order; after 3 timeouts or 8 crashes in a row within an operation the rest of it is skipped.  The same seed gives the same requests.
 * *report is delivered whatever the status, and freed by et_conform_free.  ET_OK whatever the verdicts; ET_EIO (vectors cannot be read; the peer
 * does not start any more, which counts as a crash), ET_EFORMAT (vectors), ET_ENOMEM, ET_ESTOPPED (and whatever else the task says): what was known
 * then.
 * Golden: none (another program's replies). */
/*@ requires report:  \valid(report);
    requires peer:    peer != \null;
    requires options: \valid_read(options) && (options->vectors == \null || valid_read_string(options->vectors));
    requires task:    task == \null || \valid_read(task);
    requires message: message == \null || \valid(message);
    requires apart:   \separated(report, message);
    ensures  told:    report->findings == 0 || \valid_read(report->finding + (0 .. report->findings - 1));
*/
et_status et_conform_run(et_conform_report *report, et_peer *peer, const et_conform_options *options, const et_task *task, et_message *message);

/* Frees the findings and zeroes the report; nothing to do for a zeroed one.
 * Golden: none (storage). */
/*@ requires report: \valid(report);
    assigns  *report;
    ensures  zero:   report->finding == \null && report->findings == 0 && report->asked == 0;
*/
void et_conform_free(et_conform_report *report);

#ifdef __cplusplus
}
#endif
#endif
