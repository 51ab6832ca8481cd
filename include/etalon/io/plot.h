/* plot: pictures drawn with gnuplot (PNG, 1200 x 900; two views side by side 1600 x 800).
 *
 * gnuplot is looked for in PATH and gets its script on standard input; the picture comes back through its standard output, so that no name of a
 * file is ever quoted.  Coordinates are those of the arguments, drawn with equal axes.  What gnuplot says when it fails is in the message.
 */
#ifndef ETALON_IO_PLOT_H
#define ETALON_IO_PLOT_H
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Points drawn of a larger cloud. */
enum { ET_PLOT_MOST = 20000 };

/* Each writes one PNG, by way of a temporary.  title may be null (none); any text is shown as it is.
 * ET_EINVAL (null pointer, n == 0, not finite), ET_ENOMEM, ET_EIO (gnuplot is not to be had or fails, or the file cannot be written: the message
 * says which; an earlier file of that name stays). */

/* A cloud, colour by height.  Of n > ET_PLOT_MOST points about ET_PLOT_MOST are drawn, chosen by a fixed hash of their numbers: the same ones
 * every time, and no pattern from the order of the points.
 * Golden: none (a picture has no determined value) */
/*@ requires path:    path == \null || valid_read_string(path);
    requires points:  points == \null || \valid_read(points + (0 .. n - 1));
    requires title:   title == \null || valid_read_string(title);
    requires message: message == \null || \valid(message);
    assigns *message;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM || \result == ET_EIO;
    ensures refused:  (path == \null || points == \null || n == 0) ==> \result == ET_EINVAL;
*/
et_status et_plot_cloud(const char *path, const et_vec3 *points, size_t n, const char *title, et_message *message);

/* The net's two views side by side, class points joined along rows and columns, the seam thick.
 * Golden: none (a picture has no determined value) */
/*@ requires path:    path == \null || valid_read_string(path);
    requires weights: weights != \null && et_net_ok(net.nx, net.ny) ==> \valid_read(weights + (0 .. NOV(net.nx, net.ny) - 1));
    requires title:   title == \null || valid_read_string(title);
    requires message: message == \null || \valid(message);
    assigns *message;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM || \result == ET_EIO;
    ensures refused:  (path == \null || weights == \null || net.nx < 2 || net.ny < 2) ==> \result == ET_EINVAL;
*/
et_status et_plot_net(const char *path, const et_vec3 *weights, et_doublenet net, const char *title, et_message *message);

/* Both surfaces as wire frames in two colours with the seam drawn thick (the border of the bottom view).
 * Golden: none (a picture has no determined value) */
/*@ requires path:    path == \null || valid_read_string(path);
    requires shell:   shell == \null || (\valid_read(shell) && et_shell_readable((et_shell *)shell));
    requires title:   title == \null || valid_read_string(title);
    requires message: message == \null || \valid(message);
    assigns *message;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM || \result == ET_EIO;
    ensures refused:  (path == \null || shell == \null) ==> \result == ET_EINVAL;
*/
et_status et_plot_shell(const char *path, const et_shell *shell, const char *title, et_message *message);

/* Residuals |D_c - S| of the NOV data classes of `net`, a coloured cell a class, one map a view with the same colours; the border is in both.
 * Golden: none (a picture has no determined value) */
/*@ requires path:     path == \null || valid_read_string(path);
    requires residual: residual != \null && et_net_ok(net.nx, net.ny) ==> \valid_read(residual + (0 .. NOV(net.nx, net.ny) - 1));
    requires title:    title == \null || valid_read_string(title);
    requires message:  message == \null || \valid(message);
    assigns *message;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM || \result == ET_EIO;
    ensures refused:   (path == \null || residual == \null || net.nx < 2 || net.ny < 2) ==> \result == ET_EINVAL;
*/
et_status et_plot_error(const char *path, const double *residual, et_doublenet net, const char *title, et_message *message);

/* Value against step 1, 2, ..., one curve a history, and a dashed line at each different value `before` (NaN: none).  The value axis is
 * logarithmic when all values are positive and the greatest is more than five times the least. */
typedef struct { const char *label; const double *value; size_t count; double before; } et_plot_curve;

/* n >= 1 curves, each of at least one value.
 * Golden: none (a picture has no determined value) */
/*@ requires path:    path == \null || valid_read_string(path);
    requires curves:  curves == \null || \valid_read(curves + (0 .. n - 1));
    requires values:  curves != \null ==> \forall integer k; 0 <= k < n ==> (curves[k].label == \null || valid_read_string(curves[k].label)) &&
                          (curves[k].value == \null || \valid_read(curves[k].value + (0 .. curves[k].count - 1)));
    requires title:   title == \null || valid_read_string(title);
    requires message: message == \null || \valid(message);
    assigns *message;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM || \result == ET_EIO;
    ensures refused:  (path == \null || curves == \null || n == 0) ==> \result == ET_EINVAL;
*/
et_status et_plot_history(const char *path, const et_plot_curve *curves, size_t n, const char *title, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
