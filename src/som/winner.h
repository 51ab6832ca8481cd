/* winner: the search for the nearest class and the next nearest, and the tally of what it finds; private to this room, shared by som and quality.
 *
 * Weights are kept as three arrays (x, y, z), padded with infinities, and seen as rows of LANES classes: class c stands in lane
 * (c - 1) mod LANES.  Loops over the lanes have a fixed length and no branch, so they become vector instructions under any cost model; and
 * whatever the vector's width the arithmetic is that of one class after the other: the squared distance is ((dx*dx + dy*dy) + dz*dz).
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

enum { WINNER_LANES = 16, WINNER_CHUNK = 2 * WINNER_LANES }; /* two rows at a time */

typedef struct {
    double *memory;             /* all arrays below but index */
    double *x, *y, *z;          /* weights of class c at c - 1 */
    double *d;                  /* squared distances to the last input */
    double least[WINNER_LANES]; /* the least d of each lane */
    size_t classes, padded;
    et_index *index; /* index vectors of the classes */
} winner_space;

typedef struct {
    size_t first, second; /* array indices: class - 1 */
    double d2;            /* squared distance of the first */
} winner_pair;

/* Squares of differences of such numbers cannot overflow, and no NaN is among them. */
static int winner_bounded(const et_vec3 *points, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!(fabs(points[i].x) <= 0x1p500 && fabs(points[i].y) <= 0x1p500 && fabs(points[i].z) <= 0x1p500))
            return 0;
    return 1;
}

static void winner_free(winner_space *w)
{
    free(w->memory);
    free(w->index);
}

static et_status winner_new(winner_space *w, et_doublenet net)
{
    const size_t classes = et_doublenet_nov(net), padded = ((classes - 1) / WINNER_CHUNK + 1) * WINNER_CHUNK;
    size_t doubles;

    w->memory = et_size_mul(&doubles, 4, padded) ? NULL : et_size_array(doubles, sizeof *w->memory);
    w->index = et_size_array(classes, sizeof *w->index);
    if (!w->memory || !w->index) {
        winner_free(w);
        return ET_ENOMEM;
    }
    w->x = w->memory;
    w->y = w->x + padded;
    w->z = w->y + padded;
    w->d = w->z + padded;
    w->classes = classes;
    w->padded = padded;
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
    for (size_t c = w->classes; c < w->padded; c++)
        w->x[c] = w->y[c] = w->z[c] = INFINITY;
}

static double winner_lesser(double a, double b)
{
    return b < a ? b : a;
}

/* Distances of two rows, and the lanes' minima.  Restricted arguments tell the compiler that nothing overlaps. */
static void winner_rows(double *restrict d, double *restrict least, const double *restrict x, const double *restrict y, const double *restrict z,
                        et_vec3 p)
{
    for (size_t l = 0; l < WINNER_LANES; l++) {
        const double ax = p.x - x[l], ay = p.y - y[l], az = p.z - z[l], a = ax * ax + ay * ay + az * az;
        const double bx = p.x - x[l + WINNER_LANES], by = p.y - y[l + WINNER_LANES], bz = p.z - z[l + WINNER_LANES];
        const double b = bx * bx + by * by + bz * bz, ab = b < a ? b : a;

        d[l] = a;
        d[l + WINNER_LANES] = b;
        least[l] = ab < least[l] ? ab : least[l];
    }
}

static void winner_distances(winner_space *w, et_vec3 p)
{
    double least[WINNER_LANES];

    for (size_t l = 0; l < WINNER_LANES; l++)
        least[l] = INFINITY;
    for (size_t c = 0; c < w->padded; c += WINNER_CHUNK)
        winner_rows(w->d + c, least, w->x + c, w->y + c, w->z + c, p);
    for (size_t l = 0; l < WINNER_LANES; l++)
        w->least[l] = least[l];
}

/* The lowest array index of the least squared distance: only lanes that hold it are looked through. */
static size_t winner_lowest(const winner_space *w)
{
    const double *m = w->least;
    double four[4], least;
    size_t lowest = SIZE_MAX;

    for (size_t l = 0; l < 4; l++)
        four[l] = winner_lesser(winner_lesser(m[l], m[l + 4]), winner_lesser(m[l + 8], m[l + 12]));
    least = winner_lesser(winner_lesser(four[0], four[1]), winner_lesser(four[2], four[3]));
    for (size_t l = 0; l < WINNER_LANES; l++)
        if (m[l] == least) {
            size_t i = l;

            while (w->d[i] != least)
                i += WINNER_LANES;
            lowest = i < lowest ? i : lowest;
        }
    return lowest;
}

/* Put the class at i out of the running. */
static void winner_exclude(winner_space *w, size_t i)
{
    const size_t lane = i % WINNER_LANES;
    double even = INFINITY, odd = INFINITY;

    w->d[i] = INFINITY;
    for (size_t c = lane; c < w->padded; c += WINNER_CHUNK) {
        even = winner_lesser(even, w->d[c]);
        odd = winner_lesser(odd, w->d[c + WINNER_LANES]);
    }
    w->least[lane] = winner_lesser(even, odd);
}

/* A net has four classes at least, so there is a second. */
static winner_pair winner_find(winner_space *w, et_vec3 p)
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
    double *error;       /* of the block now filling */
    double *block;       /* sums of the full blocks */
    size_t count, apart; /* inputs; those whose winner and second winner are not adjacent */
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
