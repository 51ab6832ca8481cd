#include "etalon/som/quality.h"
#include "som/winner.h"

et_status et_quality_of(et_som_quality *quality, const et_vec3 *weights, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n)
{
    winner_space w;
    tally score;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || n == 0)
        return ET_EINVAL;
    if (!winner_bounded(weights, nov) || !winner_bounded(cloud, n))
        return ET_EINVAL;
    status = winner_new(&w, net);
    if (status)
        return status;
    status = tally_new(&score, n);
    if (status == ET_OK) {
        winner_load(&w, weights);
        for (size_t i = 0; i < n; i++)
            tally_add(&score, &w, winner_find(&w, cloud[i]));
        *quality = tally_quality(&score);
        tally_free(&score);
    }
    winner_free(&w);
    return status;
}
