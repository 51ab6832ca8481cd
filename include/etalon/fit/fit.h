/* fit: a trained double net (NOV points) becomes two B-spline surfaces by linear least squares (spec section 5). */
#ifndef ETALON_FIT_FIT_H
#define ETALON_FIT_FIT_H
#include "etalon/fit/knotrule.h"
#include "etalon/fit/linalg.h"
#include "etalon/fit/param.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

/* CONVENTIONAL: each view by itself; gaps remain.  IMPROVED: shared parameters and knots, border control points of one class replaced by
 * their mean, corners set to the data's.  JOINT: least squares over the NOV data classes in the NOV control classes; no gap. */
typedef enum { ET_FIT_CONVENTIONAL = 0, ET_FIT_IMPROVED, ET_FIT_JOINT } et_fit_approach;
const char *et_fit_name(et_fit_approach approach);            /* "conventional", "improved", "joint" */

typedef enum { ET_CORNERS_DEFAULT = 0,   /* improved: interpolated; conventional, joint: free */
               ET_CORNERS_FREE, ET_CORNERS_INTERPOLATED } et_fit_corners;

typedef struct {
    et_fit_approach approach;             /* improved */
    et_param_method method;               /* chord */
    et_knotrule_kind knots;               /* piegl */
    et_linalg_method algebra;             /* qr */
    et_fit_corners corners;               /* default */
    size_t p, q;                          /* degrees, 3 and 3; p < control.nx, q < control.ny */
    et_doublenet control;                 /* control net, sides <= those of the data */
} et_fit_options;

/* A fit: the shell and the parameters at which it was fitted, for each view (equal for improved and joint). */
typedef struct {
    et_shell shell;
    et_doublenet data;                    /* sides of the data */
    double *s[2], *r[2];                  /* s[view][0..nx-1] in u, r[view][0..ny-1] in v */
    size_t flat;                          /* rows or columns of no length that got uniform parameters */
} et_fit;

/* Surface errors, sums of |D_c - S(s_i, r_j)| (Eq. 5.13).  nov: each class once, the bottom view's surface on the border.
 * non: every node of both views.  faithful: non for conventional, nov for the others (the source's double count). */
typedef struct { double nov, non, greatest; double corner; } et_fit_error;   /* corner: greatest distance at the four corners, both views */

et_fit_options et_fit_defaults(void);     /* control {12, 12} */

/* Fit `data` (NOV points of the double net `net`).  ET_EINVAL, ET_ENOMEM, ET_ERANK (message names view, direction and rank).
 * The result is freed with et_fit_free. */
et_status et_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, et_message *message);
void et_fit_free(et_fit *fit);

/* The parameters alone: what et_fit_make computes before it solves; allocates s and r (free with et_fit_free). */
et_status et_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method);

/* Errors of a fit's shell against its data.  ET_EINVAL, ET_ENOMEM.  residual (may be null): |D_c - S| for each class. */
et_status et_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data);

#ifdef __cplusplus
}
#endif
#endif
