/* json: nets and surfaces as JSON files (docs/json.md has the schema); every double round-trips. */
#ifndef ETALON_IO_JSON_H
#define ETALON_IO_JSON_H
#include "etalon/base/frame.h"
#include "etalon/fit/fit.h"
#include "etalon/som/som.h"
#ifdef __cplusplus
extern "C" {
#endif

/* A trained double net: weights (in the unit cube), the frame back to the cloud's own coordinates, how it was trained, how good it is. */
typedef struct {
    et_doublenet net;
    et_vec3 *weights;                     /* NOV */
    et_frame frame;
    et_som_options options;
    uint64_t seed;
    et_som_quality training, final;       /* during training (the source's), after training over all points */
} et_net_file;

/* A fitted double surface: a fit (shell, data sides, parameters), the frame, the fit's options, its errors; uv when the data's parameters
 * were refined (2*NOV numbers, else null). */
typedef struct {
    et_fit fit;
    et_fit_options options;
    et_frame frame;
    et_fit_error error;
    double seam_gap;
    double *uv;
} et_surface_file;

et_status et_json_write_net(const char *path, const et_net_file *net, et_message *message);
et_status et_json_read_net(et_net_file *net, const char *path, et_message *message);
void et_json_free_net(et_net_file *net);

et_status et_json_write_surface(const char *path, const et_surface_file *surface, et_message *message);
et_status et_json_read_surface(et_surface_file *surface, const char *path, et_message *message);
void et_json_free_surface(et_surface_file *surface);

#ifdef __cplusplus
}
#endif
#endif
