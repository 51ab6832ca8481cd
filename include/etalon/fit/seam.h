/* seam: how far two surfaces that should meet stand apart. */
#ifndef ETALON_FIT_SEAM_H
#define ETALON_FIT_SEAM_H
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double distance, u, v; } et_seam;            /* the greatest gap and where */

/* The greatest |bottom(u,v) - top(u,v)| over the border of [0,1]^2, sampled at every knot of either view and at `samples` equidistant
 * inner parameters of every span between them.  Exactly 0, bit for bit, for a closed shell: at a clamped end the border's control points alone
 * have weight, and they are equal.  Otherwise the true greatest gap is at least as large.  Of equal gaps the first is told, in the
 * order u = 0 and u = 1 for
 * each v, then v = 0 and v = 1 for each u; no gap is told at (0,0).
 * ET_EINVAL: the shell is not valid or a view's domain is not [0,1]^2.  ET_ENOMEM. */
/*@ requires valid:    \valid(gap) && \valid_read(shell) && et_shell_readable((et_shell *)shell);
    requires separated: \separated(gap, shell);
    assigns *gap;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures gap:       \result == ET_OK ==> \is_plus_infinity(gap->distance) || gap->distance >= 0.0;
    ensures border:    \result == ET_OK ==> gap->u == 0.0 || gap->u == 1.0 || gap->v == 0.0 || gap->v == 1.0;
    ensures domain:    \result == ET_OK ==> 0.0 <= gap->u <= 1.0 && 0.0 <= gap->v <= 1.0;
    ensures unchanged: \result != ET_OK ==> *gap == \old(*gap);
*/
et_status et_seam_gap(et_seam *gap, const et_shell *shell, size_t samples);

#ifdef __cplusplus
}
#endif
#endif
