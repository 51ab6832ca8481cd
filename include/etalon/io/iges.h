/* iges: IGES 5.3 files with one rational B-spline surface entity (type 128) a view. */
#ifndef ETALON_IO_IGES_H
#define ETALON_IO_IGES_H
#include "etalon/base/frame.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Two 128 entities (form 0), the bottom then the top, labelled BOTTOM and TOP, in the cloud's own coordinates (frame applied to the control
 * points; weights and knots as they are).  Fixed records of 80 columns in the sections S, G, D, P, T (IGES 5.3, sections 2.2 and 4.23):
 *
 *     128, K1, K2, M1, M2, closed in u, closed in v, polynomial, 0, 0, knots of u, knots of v, weights, x, y, z, ..., u0, u1, v0, v1;
 *
 * with K1 = nu - 1, K2 = nv - 1, M1 = p, M2 = q; weights and points run with the first index fastest; a surface is closed in u (v) if it is
 * clamped there and its first and last rows (columns) of points and weights are equal; a polynomial one has weights 1.  Every real is
 * written with the fewest digits that read back as the same double, with a decimal point and, where it has an exponent, a D.  Fields
 * are never broken over lines.  Units flag 2 (millimetres: IGES has no "unknown"); the date is fixed and no name of a file or machine is
 * written, so that equal shells give equal files.
 *
 * ET_EINVAL (null pointer, shell not valid, a control point that overflows under the frame, more than 9,999,999 records), ET_EIO, ET_ENOMEM. */
/*@ requires path:    path == \null || valid_read_string(path);
    requires shell:   shell == \null || (\valid_read(shell) && et_shell_readable((et_shell *)shell));
    requires frame:   frame == \null || \valid_read(frame);
    requires message: message == \null || \valid(message);
    assigns *message \from *shell, *frame;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures refused:  (path == \null || shell == \null || frame == \null) ==> \result == ET_EINVAL;
*/
et_status et_iges_write(const char *path, const et_shell *shell, const et_frame *frame, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
