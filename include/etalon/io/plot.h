/* plot: pictures drawn with gnuplot (PNG). */
#ifndef ETALON_IO_PLOT_H
#define ETALON_IO_PLOT_H
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Each writes one PNG.  ET_EIO if gnuplot is not to be had or fails: the message says so. */
et_status et_plot_cloud(const char *path, const et_vec3 *points, size_t n, const char *title, et_message *message);
/* The net's two views side by side, class points joined along rows and columns. */
et_status et_plot_net(const char *path, const et_vec3 *weights, et_doublenet net, const char *title, et_message *message);
/* Both surfaces as wire frames in two colours with the seam drawn thick. */
et_status et_plot_shell(const char *path, const et_shell *shell, const char *title, et_message *message);
/* Residual |D_c - S| over (u, v), one map a view. */
et_status et_plot_error(const char *path, const double *residual, et_doublenet net, const char *title, et_message *message);
/* Value against step, one curve a history. */
typedef struct { const char *label; const double *value; size_t count; double before; } et_plot_curve;
et_status et_plot_history(const char *path, const et_plot_curve *curves, size_t n, const char *title, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
