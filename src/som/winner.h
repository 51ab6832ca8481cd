/* winner: the search for the nearest class and the next nearest, and the tally of what it finds; private to this room, shared by som and quality.
 *
 * Weights are kept as three arrays (x, y, z), padded with infinities to whole chunks.  A chunk is ROWS rows of LANES classes: loops of such
 * fixed lengths become vector instructions even under the most timid cost model, and whatever the vector's width the arithmetic is
 * that of one class after the other: the squared distance is ((dx*dx + dy*dy) + dz*dz), in this order.
 *
 * Nearest means least squared distance as computed; equal ones go to the lowest class.
 */
#ifndef SOM_WINNER_H
#define SOM_WINNER_H
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/som/som.h"
#include <math.h>
#include <stdlib.h>

enum { WINNER_LANES = 8, WINNER_ROWS = 4, WINNER_CHUNK = WINNER_LANES * WINNER_ROWS };

typedef struct {
    double *memory;                       /* all arrays below but index */
    double *x, *y, *z;                    /* weights of class c at c - 1 */
    double *d;                            /* squared distances to the last input */
    double *least;                        /* the least d of each lane of each chunk */
    size_t classes, chunks;
    et_index *index;                      /* index vectors of the classes */
} winner_space;

typedef struct {
    size_t first, second;                 /* array indices: class - 1 */
    double d2;                            /* squared distance of the first */
} winner_pair;

static void winner_free(winner_space *w)
{
    free(w->memory);
    free(w->index);
}

static et_status winner_new(winner_space *w, et_doublenet net)
{
    const size_t classes = et_doublenet_nov(net), chunks = (classes - 1) / WINNER_CHUNK + 1, padded = chunks * WINNER_CHUNK;
    size_t doubles;

    w->memory = et_size_mul(&doubles, 5, padded) ? NULL : et_size_array(doubles, sizeof *w->memory);
    w->index = et_size_array(classes, sizeof *w->index);
    if (!w->memory || !w->index) {
        winner_free(w);
        return ET_ENOMEM;
    }
    w->x = w->memory;
    w->y = w->x + padded;
    w->z = w->y + padded;
    w->d = w->z + padded;
    w->least = w->d + padded;
    w->classes = classes;
    w->chunks = chunks;
    for (size_t c = 0; c < classes; c++)
        w->index[c] = et_doublenet_index(net, c + 1);
    return ET_OK;
}

static void winner_load(winner_space *w, const et_vec3 *weights)
{
    for (size_t c = 0; c < w->classes; c++) {
        w->x[c] = weights[c].x;
        w->y[c] = weights[c].y;
        w->z[c] = weights[c].z;
    }
    for (size_t c = w->classes; c < w->chunks * WINNER_CHUNK; c++)
        w->x[c] = w->y[c] = w->z[c] = INFINITY;
}

static void winner_distances(const winner_space *w, et_vec3 p)
{
    for (size_t c = 0; c < w->chunks; c++) {
        const double *restrict x = w->x + c * WINNER_CHUNK, *restrict y = w->y + c * WINNER_CHUNK, *restrict z = w->z + c * WINNER_CHUNK;
        double *restrict d = w->d + c * WINNER_CHUNK, *restrict least = w->least + c * WINNER_LANES;

        for (size_t i = 0; i < WINNER_CHUNK; i++) {
            const double dx = p.x - x[i], dy = p.y - y[i], dz = p.z - z[i];

            d[i] = dx * dx + dy * dy + dz * dz;
        }
        for (size_t l = 0; l < WINNER_LANES; l++) {
            const double a = d[l], b = d[l + WINNER_LANES], e = d[l + 2 * WINNER_LANES], f = d[l + 3 * WINNER_LANES];
            const double ab = b < a ? b : a, ef = f < e ? f : e;

            least[l] = ef < ab ? ef : ab;
        }
    }
}

/* The lowest array index of the least squared distance; only the first chunk that holds the minimum is looked through. */
static size_t winner_lowest(const winner_space *w)
{
    double m[WINNER_LANES];
    double least;
    size_t c = 0, i;

    for (size_t l = 0; l < WINNER_LANES; l++)
        m[l] = w->least[l];
    for (size_t k = 1; k < w->chunks; k++) {
        const double *restrict row = w->least + k * WINNER_LANES;

        for (size_t l = 0; l < WINNER_LANES; l++)
            m[l] = row[l] < m[l] ? row[l] : m[l];
    }
    least = m[0];
    for (size_t l = 1; l < WINNER_LANES; l++)
        least = m[l] < least ? m[l] : least;
    while (w->least[c] != least)
        c++;
    i = c / WINNER_LANES * WINNER_CHUNK;
    while (w->d[i] != least)
        i++;
    return i;
}

/* Put class i out of the running. */
static void winner_exclude(const winner_space *w, size_t i)
{
    const size_t chunk = i / WINNER_CHUNK, lane = i % WINNER_LANES;
    const double *d = w->d + chunk * WINNER_CHUNK + lane;
    double least = INFINITY;

    w->d[i] = INFINITY;
    for (size_t r = 0; r < WINNER_ROWS; r++)
        least = d[r * WINNER_LANES] < least ? d[r * WINNER_LANES] : least;
    w->least[chunk * WINNER_LANES + lane] = least;
}

/* A net has four classes at least, so there is a second. */
static winner_pair winner_find(const winner_space *w, et_vec3 p)
{
    winner_pair pair;

    winner_distances(w, p);
    pair.first = winner_lowest(w);
    pair.d2 = w->d[pair.first];
    winner_exclude(w, pair.first);
    pair.second = winner_lowest(w);
    return pair;
}

/* The tally: distances are summed in blocks of TALLY_BLOCK, and the blocks' sums in turn, each by et_real_sum. */
enum { TALLY_BLOCK = 4096 };

typedef struct {
    double *error;                        /* of the block now filling */
    double *block;                        /* sums of the full blocks */
    size_t count, apart;                  /* inputs; those whose winner and second winner are not adjacent */
    double least, greatest;
} tally;

static void tally_free(tally *t)
{
    free(t->error);
    free(t->block);
}

static et_status tally_new(tally *t, size_t inputs)
{
    t->error = et_size_array(TALLY_BLOCK, sizeof *t->error);
    t->block = et_size_array(inputs / TALLY_BLOCK + 1, sizeof *t->block);
    t->count = t->apart = 0;
    t->least = INFINITY;
    t->greatest = 0;
    if (t->error && t->block)
        return ET_OK;
    tally_free(t);
    return ET_ENOMEM;
}

static void tally_add(tally *t, const winner_space *w, winner_pair pair)
{
    const double error = sqrt(pair.d2);

    t->error[t->count % TALLY_BLOCK] = error;
    t->least = error < t->least ? error : t->least;
    t->greatest = error > t->greatest ? error : t->greatest;
    t->apart += !et_doublenet_adjacent(w->index[pair.first], w->index[pair.second]);
    t->count++;
    if (t->count % TALLY_BLOCK == 0)
        t->block[t->count / TALLY_BLOCK - 1] = et_real_sum(t->error, TALLY_BLOCK);
}

/* At least one input has been added. */
static et_som_quality tally_quality(tally *t)
{
    const size_t full = t->count / TALLY_BLOCK, rest = t->count % TALLY_BLOCK;
    et_som_quality q;

    t->block[full] = et_real_sum(t->error, rest);
    q.qe = et_real_sum(t->block, full + 1) / (double)t->count;
    q.te = (double)t->apart / (double)t->count;
    q.min_error = t->least;
    q.max_error = t->greatest;
    q.steps = t->count;
    return q;
}
#endif
