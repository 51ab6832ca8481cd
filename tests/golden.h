/* golden: one row of golden/MODULE.tsv.
 *
 * Columns, separated by tabs:  function  class  reason  arguments  wanted
 * arguments and wanted are lists separated by blanks; reals are hex floats.  Classes: `exact` (bit for bit), `ulp K` (within K ulps of the wanted,
 * correctly rounded value), `abs T` (within T, a proved bound written in hex), `gap T` (an optimum, within the gap of its certificate), `bits` (a seeded
 * replay: bit for bit), `residual K` (the check itself is a backward error in eps).
 */
#ifndef TESTS_GOLDEN_H
#define TESTS_GOLDEN_H
#include "gen.h"

typedef struct {
    const char *file; size_t line;
    char *function, *class, *reason;
    double tolerance;                     /* K or T of the class, else 0 */
    char **arg; size_t nargs;
    char **want; size_t nwant;
} row;
typedef struct { const char *name; verdict (*run)(const row *r); } golden;
extern const golden goldens[];           /* gold_NAME: the function itself; generated; ends with a null name */
extern const golden truths[];            /* true_NAME: the exact layer, for which every class means `exact`; generated */

double row_real(const row *r, size_t i);                 /* argument i as a real (strtod: hex floats, inf, nan) */
size_t row_size(const row *r, size_t i);                 /* argument i as a count */
bool row_is(const row *r, size_t i, double got);         /* wanted value i, compared as the row's class says; tells when it differs */
bool row_is_size(const row *r, size_t i, size_t got);
#endif
