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
        /*@ assert distinct: \separated(w.x + (0 .. w.padded - 1), w.y + (0 .. w.padded - 1), w.z + (0 .. w.padded - 1),
                                        w.d + (0 .. w.padded - 1), w.index + (0 .. w.classes - 1), score.error + (0 .. TALLY_BLOCK - 1),
                                        score.block + (0 .. n / TALLY_BLOCK), &w, &score); */
        /*@ assert fresh: \separated(weights + (0 .. nov - 1), w.x + (0 .. w.padded - 1), w.y + (0 .. w.padded - 1), w.z + (0 .. w.padded - 1))
                       && \separated(cloud + (0 .. n - 1), w.x + (0 .. w.padded - 1), w.y + (0 .. w.padded - 1), w.z + (0 .. w.padded - 1),
                                     w.d + (0 .. w.padded - 1), score.error + (0 .. TALLY_BLOCK - 1), score.block + (0 .. n / TALLY_BLOCK)); */
        winner_load(&w, weights);
        /*@ loop invariant place:   i <= n;
            loop invariant score:   tally_arrays(&score, n) && score.count == i;
            loop invariant weights: winner_weights(&w);
            loop assigns i, w.least[0 .. 15], w.d[0 .. w.padded - 1], score.least, score.greatest, score.apart, score.count,
                         score.error[0 .. TALLY_BLOCK - 1], score.block[0 .. n / TALLY_BLOCK];
            loop variant n - i;
        */
        for (size_t i = 0; i < n; i++)
            tally_add(&score, &w, winner_find(&w, cloud[i]));
        *quality = tally_quality(&score);
        tally_free(&score);
    }
    winner_free(&w);
    return status;
}
