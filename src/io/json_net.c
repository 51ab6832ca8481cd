/* The net file, read. */
#include "etalon/base/size.h"
#include "io/json_parts.h"

static et_status read_training(const json_file_source *d, et_net_file *n, const json_file_place *top)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, top, "training");
    if (!status)
        status = json_file_get_count(d, &n->options.iterations, &at, "iterations", 1);
    if (!status)
        status = json_file_get_real(d, &n->options.alpha0, &at, "alpha0", 0x1p-1074, 1);
    if (!status)
        status = json_file_get_real(d, &n->options.sigma0, &at, "sigma0", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = json_file_get_digits(d, &n->seed, &at, "seed");
    return status;
}

static et_status read_quality(const json_file_source *d, et_som_quality *q, const json_file_place *all, const char *name)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, all, name);
    if (!status)
        status = json_file_get_real(d, &q->qe, &at, "qe", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = json_file_get_real(d, &q->te, &at, "te", 0, 1);
    if (!status)
        status = json_file_get_real(d, &q->min_error, &at, "min_error", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = json_file_get_real(d, &q->max_error, &at, "max_error", q->min_error, 0x1.fffffffffffffp1023);
    if (!status)
        status = json_file_get_count(d, &q->steps, &at, "steps", 0);
    return status;
}

static et_status read_weights(const json_file_source *d, et_net_file *n, const json_file_place *top)
{
    json_file_place at;
    size_t nov = et_doublenet_nov(n->net);
    et_status status = json_file_get_array(d, &at, top, "weights", nov);
    if (status)
        return status;
    n->weights = et_size_array(nov, sizeof *n->weights);
    return n->weights ? json_file_fill_points(d, n->weights, &at) : json_file_no_memory(d);
}

et_status json_file_read_net(const json_file_source *d, et_net_file *n, const json_file_place *top)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, top, "net");
    if (!status)
        status = json_file_get_sides(d, &n->net, &at);
    if (!status)
        status = json_file_check_count(d, &at, "non", et_doublenet_non(n->net));
    if (!status)
        status = json_file_check_count(d, &at, "nov", et_doublenet_nov(n->net));
    if (!status)
        status = json_file_check_count(d, &at, "nor", et_doublenet_nor(n->net));
    if (!status)
        status = read_training(d, n, top);
    if (!status)
        status = json_file_member(d, &at, top, "quality");
    if (!status)
        status = read_quality(d, &n->training, &at, "training");
    if (!status)
        status = read_quality(d, &n->final, &at, "final");
    if (!status)
        status = json_file_get_frame(d, &n->frame, top);
    if (!status)
        status = read_weights(d, n, top);
    return status;
}
