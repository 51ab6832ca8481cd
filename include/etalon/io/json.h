/* json: nets and surfaces as JSON files (docs/json.md has the schema); every double round-trips bit for bit. */
#ifndef ETALON_IO_JSON_H
#define ETALON_IO_JSON_H
#include "etalon/base/frame.h"
#include "etalon/fit/fit.h"
#include "etalon/som/som.h"
#ifdef __cplusplus
extern "C" {
#endif

/* A trained double net: weights (in the unit cube), the frame back to the cloud's own coordinates, how it was trained, how good it is.
 *
 * What a file may hold: a valid net, finite weights and offset, positive finite scale; iterations >= 1, 0 < alpha0 <= 1, sigma0 >= 0; of each
 * quality qe, min_error <= max_error >= 0 and finite, 0 <= te <= 1; counts at most SIZE_MAX / 2. */
typedef struct {
    et_doublenet net;
    et_vec3 *weights;                     /* NOV */
    et_frame frame;
    et_som_options options;
    uint64_t seed;
    et_som_quality training, final;       /* during training (the source's), after training over all points */
} et_net_file;

/* A fitted double surface: a fit (shell, data sides, parameters), the frame, the fit's options, its errors; uv when the data's parameters
 * were refined (2*NOV numbers, else null): u of class c at uv[2*(c-1)], v after it.
 *
 * What a file may hold: et_shell_valid with degrees >= 1; valid data sides; s, r non-decreasing in [0,1]; uv in [0,1]; options as et_fit_make
 * takes them; errors and gap finite and >= 0; a frame as above. */
typedef struct {
    et_fit fit;
    et_fit_options options;
    et_frame frame;
    et_fit_error error;
    double seam_gap;
    double *uv;
} et_surface_file;

/* Write a net file, by the line, through et_file_create ("-" is standard output).
 *
 * ET_EINVAL: a null argument, or a value that no net file holds.  ET_EIO, ET_ENOMEM: an earlier file is intact.
 * Golden: none (what is written is what et_json_read_net reads back, bit for bit) */
/*@ requires path:      path == \null || valid_read_string(path);
    requires net:       net == \null || \valid_read(net);
    requires weights:   net != \null && et_net_ok(net->net.nx, net->net.ny) ==>
                        net->weights == \null || \valid_read(net->weights + (0 .. NOV(net->net.nx, net->net.ny) - 1));
    requires message:   message == \null || \valid(message);
    assigns  *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  refused:   path == \null || net == \null ==> \result == ET_EINVAL;
*/
et_status et_json_write_net(const char *path, const et_net_file *net, et_message *message);

/* Read a net file ("-": standard input).  The result is freed with et_json_free_net.
 *
 * ET_EINVAL: a null argument.  ET_EFORMAT with `FILE:LINE: ...` for what is no JSON (trailing text and duplicate names included), else
 * `FILE: path.to.member: what is wrong` for the first member that is missing, of the wrong type or size, or out of range; nothing is
 * allocated by a declared size before the array of that size is seen.  ET_EIO, ET_ENOMEM.
 * Golden: none (reads back what et_json_write_net wrote, bit for bit) */
/*@ requires net:       \valid(net);
    requires path:      path == \null || valid_read_string(path);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(net, message);
    assigns  *net, *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  sides:     \result == ET_OK ==> et_net_ok(net->net.nx, net->net.ny);
    ensures  weights:   \result == ET_OK ==> \valid(net->weights + (0 .. NOV(net->net.nx, net->net.ny) - 1));
    ensures  trained:   \result == ET_OK ==> et_som_options_ok(net->options);
    ensures  unchanged: \result != ET_OK ==> *net == \old(*net);
*/
et_status et_json_read_net(et_net_file *net, const char *path, et_message *message);

/* Free the weights and zero *net; does nothing for null.
 * Golden: none (frees memory) */
/*@ requires net:       net == \null || \valid(net);
    assigns  *net;
    ensures  zeroed:    net != \null ==> net->weights == \null;
*/
void et_json_free_net(et_net_file *net);

/* Write a surface file, by the line, through et_file_create ("-" is standard output).
 *
 * ET_EINVAL: a null argument, or a value that no surface file holds.  ET_EIO, ET_ENOMEM: an earlier file is intact.
 * Golden: none (what is written is what et_json_read_surface reads back, bit for bit) */
/*@ requires path:      path == \null || valid_read_string(path);
    requires surface:   surface == \null || (\valid_read(surface) && et_fit_readable((et_fit *)&surface->fit));
    requires uv:        surface != \null && et_net_ok(surface->fit.data.nx, surface->fit.data.ny) ==>
                        surface->uv == \null || \valid_read(surface->uv + (0 .. 2 * NOV(surface->fit.data.nx, surface->fit.data.ny) - 1));
    requires message:   message == \null || \valid(message);
    assigns  *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  refused:   path == \null || surface == \null ==> \result == ET_EINVAL;
*/
et_status et_json_write_surface(const char *path, const et_surface_file *surface, et_message *message);

/* Read a surface file ("-": standard input).  The result is freed with et_json_free_surface; it is closed if the shell written was.
 * Errors as et_json_read_net, and knots that are no knot vector, views of different shapes, a `closed` that the views belie.
 * Golden: none (reads back what et_json_write_surface wrote, bit for bit) */
/*@ requires surface:   \valid(surface);
    requires path:      path == \null || valid_read_string(path);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(surface, message);
    assigns  *surface, *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  sides:     \result == ET_OK ==> et_net_ok(surface->fit.data.nx, surface->fit.data.ny);
    ensures  shape:     \result == ET_OK ==> surface->fit.shell.view[0].nu == surface->fit.shell.view[1].nu &&
                        surface->fit.shell.view[0].nv == surface->fit.shell.view[1].nv;
    ensures  unchanged: \result != ET_OK ==> *surface == \old(*surface);
*/
et_status et_json_read_surface(et_surface_file *surface, const char *path, et_message *message);

/* Free what the surface holds and zero it; does nothing for null.
 * Golden: none (frees memory) */
/*@ requires surface:   surface == \null || \valid(surface);
    assigns  *surface;
    ensures  zeroed:    surface != \null ==> surface->uv == \null;
*/
void et_json_free_surface(et_surface_file *surface);

#ifdef __cplusplus
}
#endif
#endif
