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
    size_t asked, refused_rightly, skipped;      /* skipped: not asked, because the operation timed out or crashed too often in a row */
    double worst[ET_OPS];                 /* greatest error / bound */
    et_conform_finding *finding;
    size_t findings;
} et_conform_report;

et_conform_options et_conform_defaults(void);
/* ET_OK whatever the verdicts; ET_EIO, ET_EFORMAT (vectors), ET_ENOMEM, ET_ESTOPPED: the report so far is delivered. */
et_status et_conform_run(et_conform_report *report, et_peer *peer, const et_conform_options *options, const et_task *task, et_message *message);
void et_conform_free(et_conform_report *report);

#ifdef __cplusplus
}
#endif
#endif
