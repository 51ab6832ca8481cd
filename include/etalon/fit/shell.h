/* shell: two surfaces over [0,1]^2, bottom and top, whose control nets form a double net: what Etalon fits, refines and exports. */
#ifndef ETALON_FIT_SHELL_H
#define ETALON_FIT_SHELL_H
#include "etalon/net/doublenet.h"
#include "etalon/spline/surface.h"
#ifdef __cplusplus
extern "C" {
#endif

/* view[ET_BOTTOM], view[ET_TOP]: equal degrees and equal numbers of control points; rational both or neither.
 * Closed (gap-free by construction): equal knots and, on the border, equal control points and weights, bit for bit. */
typedef struct { et_surface view[2]; } et_shell;

int et_shell_valid(const et_shell *shell);        /* both views valid and of one shape */
int et_shell_closed(const et_shell *shell);       /* valid, and closed as defined above */
et_doublenet et_shell_net(const et_shell *shell); /* the control net {nu, nv} */

et_status et_shell_new(et_shell *shell, size_t p, size_t q, et_doublenet control, int rational);
et_status et_shell_copy(et_shell *copy, const et_shell *shell);
void et_shell_free(et_shell *shell);

/* Between a closed shell and its NOV control classes: points[c-1]; gather reads the bottom view where both have a class;
 * scatter writes every node of a class, so that the shell's border is shared bit for bit. */
void et_shell_gather(et_vec3 *points, size_t nov, const et_shell *shell);
void et_shell_scatter(et_shell *shell, const et_vec3 *points, size_t nov);

#ifdef __cplusplus
}
#endif
#endif
