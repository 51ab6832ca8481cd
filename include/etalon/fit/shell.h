/* shell: two surfaces over [0,1]^2, bottom and top, whose control nets form a double net: what Etalon fits, refines and exports. */
#ifndef ETALON_FIT_SHELL_H
#define ETALON_FIT_SHELL_H
#include "etalon/net/doublenet.h"
#include "etalon/spline/surface.h"
#ifdef __cplusplus
extern "C" {
#endif

/* view[ET_BOTTOM], view[ET_TOP]: equal degrees and equal numbers of control points; rational both or neither.
 * Glued: equal knots and, on the border, equal control points and weights, bit for bit.
 * Closed (gap-free by construction): glued, and at each end exactly p+1 (q+1) equal knots, so that the border curves are the border's. */
typedef struct { et_surface view[2]; } et_shell;

/*@ predicate et_shell_same(et_shell *s) =
        s->view[0].p == s->view[1].p && s->view[0].q == s->view[1].q && s->view[0].nu == s->view[1].nu && s->view[0].nv == s->view[1].nv &&
        (s->view[0].weights == \null <==> s->view[1].weights == \null);
    predicate et_shell_stored(et_shell *s) =
        et_shell_same(s) && (\forall integer w; 0 <= w < 2 ==> \valid(s->view[w].points + (0 .. s->view[w].nu * s->view[w].nv - 1)) &&
                                                              \valid(s->view[w].u + (0 .. s->view[w].nu + s->view[w].p)) &&
                                                              \valid(s->view[w].v + (0 .. s->view[w].nv + s->view[w].q)) &&
                                                              (s->view[w].weights == \null ||
                                                               \valid(s->view[w].weights + (0 .. s->view[w].nu * s->view[w].nv - 1))));
    predicate et_shell_readable(et_shell *s) = et_surface_readable(&s->view[0]) && et_surface_readable(&s->view[1]);
    predicate et_shell_ok(et_shell *s) =
        et_shell_same(s) && et_net_ok(s->view[0].nu, s->view[0].nv) && et_surface_ok(&s->view[0]) && et_surface_ok(&s->view[1]);
    predicate et_shell_knots(et_shell *s) =
        (\forall integer i; 0 <= i <= s->view[0].nu + s->view[0].p ==> s->view[0].u[i] == s->view[1].u[i]) &&
        (\forall integer i; 0 <= i <= s->view[0].nv + s->view[0].q ==> s->view[0].v[i] == s->view[1].v[i]);
    predicate et_shell_node(et_shell *s, integer at) =
        s->view[0].points[at].x == s->view[1].points[at].x && s->view[0].points[at].y == s->view[1].points[at].y &&
        s->view[0].points[at].z == s->view[1].points[at].z &&
        (s->view[0].weights == \null || s->view[0].weights[at] == s->view[1].weights[at]);
    predicate et_shell_border(et_shell *s) =
        \forall integer i, j; et_net_inside(s->view[0].nu, s->view[0].nv, i, j) && et_net_border(s->view[0].nu, s->view[0].nv, i, j) ==>
            et_shell_node(s, i*s->view[0].nv + j);
*/

/* Both views valid (et_surface_valid), of one shape, and their control net a double net (sides at least 2).  1 or 0.
 * Golden: none (a predicate over storage; its property tries every way to break it). */
/*@ requires valid: \valid_read(shell) && et_shell_readable((et_shell *)shell);
    assigns \nothing;
    ensures boolean: \result == 0 || \result == 1;
    ensures same:    \result == 1 ==> et_shell_same((et_shell *)shell);
    ensures net:     \result == 1 ==> et_net_ok(shell->view[0].nu, shell->view[0].nv);
    ensures ok:      \result == 1 ==> et_shell_ok((et_shell *)shell);
*/
int et_shell_valid(const et_shell *shell);

/* Valid, and glued as defined above: equal bits (0 and -0 differ).  Coincidence that is only geometric does not count.  1 or 0.
 * Golden: none (a comparison of bits). */
/*@ requires valid: \valid_read(shell) && et_shell_readable((et_shell *)shell);
    assigns \nothing;
    ensures boolean: \result == 0 || \result == 1;
    ensures same:    \result == 1 ==> et_shell_same((et_shell *)shell);
    ensures net:     \result == 1 ==> et_net_ok(shell->view[0].nu, shell->view[0].nv);
    ensures ok:      \result == 1 ==> et_shell_ok((et_shell *)shell);
    ensures knots:   \result == 1 ==> et_shell_knots((et_shell *)shell);
    ensures border:  \result == 1 ==> et_shell_border((et_shell *)shell);
*/
int et_shell_glued(const et_shell *shell);

/* Glued, and closed as defined above: no gap anywhere on the seam, not even a rounding error's.  1 or 0.
 * Golden: none (comparisons). */
/*@ requires valid: \valid_read(shell) && et_shell_readable((et_shell *)shell);
    assigns \nothing;
    ensures boolean: \result == 0 || \result == 1;
    ensures same:    \result == 1 ==> et_shell_same((et_shell *)shell);
    ensures net:     \result == 1 ==> et_net_ok(shell->view[0].nu, shell->view[0].nv);
    ensures glued:   \result == 1 ==> et_shell_ok((et_shell *)shell) && et_shell_knots((et_shell *)shell) && et_shell_border((et_shell *)shell);
    ensures first:   \result == 1 ==> shell->view[0].u[0] == shell->view[0].u[shell->view[0].p] < shell->view[0].u[shell->view[0].p + 1] &&
                                       shell->view[0].v[0] == shell->view[0].v[shell->view[0].q] < shell->view[0].v[shell->view[0].q + 1];
    ensures last:    \result == 1 ==> shell->view[0].u[shell->view[0].nu - 1] < shell->view[0].u[shell->view[0].nu] ==
                                           shell->view[0].u[shell->view[0].nu + shell->view[0].p] &&
                                       shell->view[0].v[shell->view[0].nv - 1] < shell->view[0].v[shell->view[0].nv] ==
                                           shell->view[0].v[shell->view[0].nv + shell->view[0].q];
*/
int et_shell_closed(const et_shell *shell);

/* The control net {nu, nv} (You 2023, section 4.2: one numbering for the map and for the control nets).
 * Golden: none (two fields). */
/*@ requires valid: \valid_read(shell);
    assigns \nothing;
    ensures nx: \result.nx == shell->view[0].nu;
    ensures ny: \result.ny == shell->view[0].nv;
*/
et_doublenet et_shell_net(const et_shell *shell);

/* Storage for both views, control points and knots all zero (so not yet valid), weights 1 if rational.  Freed by et_shell_free.
 * ET_EINVAL: p < 1, q < 1, p >= control.nx, q >= control.ny, or no double net.  ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires valid: \valid(shell);
    assigns *shell;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:   p < 1 || q < 1 || p >= control.nx || q >= control.ny ==> \result == ET_EINVAL;
    ensures net:       !et_net_ok(control.nx, control.ny) ==> \result == ET_EINVAL;
    ensures stored:    \result == ET_OK ==> et_shell_stored(shell) && shell->view[0].p == p && shell->view[0].q == q
                           && shell->view[0].nu == control.nx && shell->view[0].nv == control.ny;
    ensures rational:  \result == ET_OK ==> (rational == 0 <==> shell->view[0].weights == \null);
    ensures unchanged: \result != ET_OK ==> *shell == \old(*shell);
*/
et_status et_shell_new(et_shell *shell, size_t p, size_t q, et_doublenet control, int rational);

/* A copy with storage of its own.  ET_ENOMEM.  Golden: none (storage). */
/*@ requires valid:     \valid(copy) && \valid_read(shell) && et_shell_stored((et_shell *)shell);
    requires separated: \separated(copy, shell);
    assigns *copy;
    ensures stored:     \result == ET_OK ==> et_shell_stored(copy) && copy->view[0].nu == shell->view[0].nu && copy->view[0].nv == shell->view[0].nv;
    ensures unchanged:  \result != ET_OK ==> *copy == \old(*copy);
*/
et_status et_shell_copy(et_shell *copy, const et_shell *shell);

/* Frees both views and leaves a shell of zeros, which may be freed again.  Golden: none (storage). */
/*@ requires valid: \valid(shell);
    assigns *shell;
    ensures empty: shell->view[0].points == \null && shell->view[1].points == \null;
*/
void et_shell_free(et_shell *shell);

/* The NOV control classes of a shell: points[c-1]; the bottom view is read where both views have the class.  Exact copies.
 * Golden: none (copies; the numbering has its rows with doublenet). */
/*@ requires stored:    \valid_read(shell) && et_shell_stored((et_shell *)shell);
    requires net:       et_net_ok(shell->view[0].nu, shell->view[0].nv);
    requires size:      nov == NOV(shell->view[0].nu, shell->view[0].nv);
    requires valid:     \valid(points + (0 .. nov - 1));
    requires separated: \separated(points + (0 .. nov - 1), shell, shell->view[0].points + (0 .. shell->view[0].nu * shell->view[0].nv - 1)) &&
                        \separated(points + (0 .. nov - 1), shell->view[1].points + (0 .. shell->view[1].nu * shell->view[1].nv - 1));
    assigns points[0 .. nov - 1];
    ensures bottom:     \forall integer i; 0 <= i < shell->view[0].nu * shell->view[0].nv ==> points[i] == shell->view[0].points[i];
*/
void et_shell_gather(et_vec3 *points, size_t nov, const et_shell *shell);

/* The reverse: every node of class c gets points[c-1], in both views, so that the border is shared bit for bit.  Knots and weights stay.
 * Golden: none (copies; the numbering has its rows with doublenet). */
/*@ requires stored:    \valid(shell) && et_shell_stored(shell);
    requires net:       et_net_ok(shell->view[0].nu, shell->view[0].nv);
    requires size:      nov == NOV(shell->view[0].nu, shell->view[0].nv);
    requires valid:     \valid_read(points + (0 .. nov - 1));
    requires separated: \separated(shell, points + (0 .. nov - 1), shell->view[0].points + (0 .. shell->view[0].nu * shell->view[0].nv - 1),
                                   shell->view[1].points + (0 .. shell->view[1].nu * shell->view[1].nv - 1));
    assigns shell->view[0].points[0 .. shell->view[0].nu * shell->view[0].nv - 1],
            shell->view[1].points[0 .. shell->view[1].nu * shell->view[1].nv - 1];
    ensures bottom:     \forall integer i; 0 <= i < shell->view[0].nu * shell->view[0].nv ==> shell->view[0].points[i] == points[i];
    ensures shared:     \forall integer j; 0 <= j < shell->view[0].nv ==> shell->view[1].points[j] == points[j];
*/
void et_shell_scatter(et_shell *shell, const et_vec3 *points, size_t nov);

#ifdef __cplusplus
}
#endif
#endif
