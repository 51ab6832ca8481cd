/* seam: how far two surfaces that should meet stand apart. */
#ifndef ETALON_FIT_SEAM_H
#define ETALON_FIT_SEAM_H
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double distance, u, v; } et_seam;            /* the greatest gap and where */

/* The greatest |bottom(u,v) - top(u,v)| over the border of [0,1]^2, sampled at every knot of either view and at `samples` equidistant
 * inner parameters of every span between them.  Exactly 0, bit for bit, for a closed shell.  ET_EINVAL, ET_ENOMEM. */
et_status et_seam_gap(et_seam *gap, const et_shell *shell, size_t samples);

#ifdef __cplusplus
}
#endif
#endif
