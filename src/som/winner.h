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

/*@ predicate winner_arrays(winner_space *w) = \valid(w)
        && 4 <= w->classes <= w->padded && w->padded % WINNER_CHUNK == 0 && 4*w->padded <= SIZE_MAX
        && \valid(w->x + (0 .. w->padded - 1)) && \valid(w->y + (0 .. w->padded - 1)) && \valid(w->z + (0 .. w->padded - 1))
        && \valid(w->d + (0 .. w->padded - 1)) && \valid(w->index + (0 .. w->classes - 1))
        && \separated(w, w->x + (0 .. w->padded - 1), w->y + (0 .. w->padded - 1), w->z + (0 .. w->padded - 1),
                         w->d + (0 .. w->padded - 1), w->index + (0 .. w->classes - 1));

    predicate winner_inside(double x) = \is_finite(x) && \abs(x) <= 0x1p500;
    predicate winner_class(double x, double y, double z) = winner_inside(x) && winner_inside(y) && winner_inside(z);
    predicate winner_padding(double x, double y, double z) = \is_plus_infinity(x) && \is_plus_infinity(y) && \is_plus_infinity(z);
    predicate winner_weights(winner_space *w) =
        (\forall integer c; 0 <= c < w->classes ==> winner_class(w->x[c], w->y[c], w->z[c]))
        && (\forall integer c; w->classes <= c < w->padded ==> winner_padding(w->x[c], w->y[c], w->z[c]));
    predicate winner_indexed(winner_space *w, integer nx, integer ny) =
        \forall integer c; 0 <= c < w->classes ==> et_index_ok(nx, ny, w->index[c].i, w->index[c].j, w->index[c].k);

    predicate winner_numbers(double a, double b) = !\is_NaN(a) && !\is_NaN(b);
    predicate winner_least(double m, double a, double b) = !\is_NaN(m) && \le_double(m, a) && \le_double(m, b);
*/

/* Squares of differences of such numbers cannot overflow, and no NaN is among them. */
/*@ requires points:  \valid_read(points + (0 .. n - 1));
    assigns  \nothing;
    ensures  truth:   \result == 0 || \result == 1;
    ensures  bounded: \result == 1 <==> et_som_bounded((et_vec3 *)points, n);
*/
static int winner_bounded(const et_vec3 *points, size_t n)
{
    /*@ loop invariant place:   i <= n;
        loop invariant bounded: et_som_bounded((et_vec3 *)points, i);
        loop assigns i;
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++)
        if (!(fabs(points[i].x) <= 0x1p500 && fabs(points[i].y) <= 0x1p500 && fabs(points[i].z) <= 0x1p500))
            return 0;
    return 1;
}

/*@ requires space: \valid_read(w);
    assigns  \nothing;
*/
static void winner_free(winner_space *w)
{
    free(w->memory);
    free(w->index);
}

/*@ requires net:    et_net_ok(net.nx, net.ny);
    requires space:  \valid(w);
    assigns  *w;
    ensures  range:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  memory: \result == ET_OK ==> et_array((char *)w->memory, 4*w->padded, sizeof(double))
                                       && et_array((char *)w->index, w->classes, sizeof(et_index));
    ensures  parts:  \result == ET_OK ==> w->x == w->memory && w->y == w->memory + w->padded && w->z == w->memory + 2*w->padded
                                       && w->d == w->memory + 3*w->padded;
    ensures  made:   \result == ET_OK ==> winner_arrays(w) && w->classes == NOV(net.nx, net.ny) && winner_indexed(w, net.nx, net.ny);
*/
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
    //@ assert distinct: \separated(w->memory + (0 .. 4*padded - 1), w->index + (0 .. classes - 1));
    //@ assert fresh: \separated(w, w->memory + (0 .. 4*padded - 1)) && \separated(w, w->index + (0 .. classes - 1));
    /*@ loop invariant place:   c <= classes;
        loop invariant indexed: \forall integer a; 0 <= a < c ==> et_index_ok(net.nx, net.ny, w->index[a].i, w->index[a].j, w->index[a].k);
        loop assigns c, w->index[0 .. classes - 1];
        loop variant classes - c;
    */
    for (size_t c = 0; c < classes; c++)
        w->index[c] = et_doublenet_index(net, c + 1);
    return ET_OK;
}

/*@ requires arrays:  winner_arrays(w);
    requires weights: \valid_read(weights + (0 .. w->classes - 1)) && et_som_bounded((et_vec3 *)weights, w->classes);
    requires apart:   \separated(weights + (0 .. w->classes - 1), w->x + (0 .. w->padded - 1), w->y + (0 .. w->padded - 1),
                                  w->z + (0 .. w->padded - 1));
    assigns  w->x[0 .. w->padded - 1], w->y[0 .. w->padded - 1], w->z[0 .. w->padded - 1];
    ensures  loaded:  winner_weights(w);
*/
static void winner_load(winner_space *w, const et_vec3 *weights)
{
    /*@ loop invariant place:  c <= w->classes;
        loop invariant loaded: \forall integer a; 0 <= a < c ==> winner_class(w->x[a], w->y[a], w->z[a]);
        loop assigns c, w->x[0 .. w->padded - 1], w->y[0 .. w->padded - 1], w->z[0 .. w->padded - 1];
        loop variant w->classes - c;
    */
    for (size_t c = 0; c < w->classes; c++) {
        w->x[c] = weights[c].x;
        w->y[c] = weights[c].y;
        w->z[c] = weights[c].z;
    }
    /*@ loop invariant place:  w->classes <= c <= w->padded;
        loop invariant loaded: \forall integer a; 0 <= a < w->classes ==> winner_class(w->x[a], w->y[a], w->z[a]);
        loop invariant padded: \forall integer a; w->classes <= a < c ==> winner_padding(w->x[a], w->y[a], w->z[a]);
        loop assigns c, w->x[0 .. w->padded - 1], w->y[0 .. w->padded - 1], w->z[0 .. w->padded - 1];
        loop variant w->padded - c;
    */
    for (size_t c = w->classes; c < w->padded; c++)
        w->x[c] = w->y[c] = w->z[c] = INFINITY;
}

/*@ assigns  \nothing;
    ensures  lesser: winner_numbers(a, b) ==> winner_least(\result, a, b);
    ensures  one:    \result == a || \result == b;
*/
static double winner_lesser(double a, double b)
{
    return b < a ? b : a;
}

/* Distances of two rows, and the lanes' minima.  Restricted arguments tell the compiler that nothing overlaps. */
/*@ requires valid:  \valid(d + (0 .. 31)) && \valid(least + (0 .. 15))
                     && \valid_read(x + (0 .. 31)) && \valid_read(y + (0 .. 31)) && \valid_read(z + (0 .. 31));
    requires apart:  \separated(d + (0 .. 31), least + (0 .. 15), x + (0 .. 31)) && \separated(d + (0 .. 31), y + (0 .. 31), z + (0 .. 31))
                     && \separated(least + (0 .. 15), y + (0 .. 31), z + (0 .. 31));
    assigns  d[0 .. 31], least[0 .. 15];
*/
static void winner_rows(double *restrict d, double *restrict least, const double *restrict x, const double *restrict y, const double *restrict z,
                        et_vec3 p)
{
    /*@ loop invariant place: l <= WINNER_LANES;
        loop assigns l, d[0 .. 31], least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++) {
        const double ax = p.x - x[l], ay = p.y - y[l], az = p.z - z[l], a = ax * ax + ay * ay + az * az;
        const double bx = p.x - x[l + WINNER_LANES], by = p.y - y[l + WINNER_LANES], bz = p.z - z[l + WINNER_LANES];
        const double b = bx * bx + by * by + bz * bz, ab = b < a ? b : a;

        d[l] = a;
        d[l + WINNER_LANES] = b;
        least[l] = ab < least[l] ? ab : least[l];
    }
}

/*@ requires arrays:  winner_arrays(w);
    assigns  w->d[0 .. w->padded - 1], w->least[0 .. 15];
*/
static void winner_distances(winner_space *w, et_vec3 p)
{
    double least[WINNER_LANES];

    /*@ loop invariant place: l <= WINNER_LANES;
        loop assigns l, least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        least[l] = INFINITY;
    /*@ loop invariant place:  c <= w->padded && c % WINNER_CHUNK == 0;
        loop assigns c, least[0 .. 15], w->d[0 .. w->padded - 1];
        loop variant w->padded - c;
    */
    for (size_t c = 0; c < w->padded; c += WINNER_CHUNK) {
        //@ assert room: c + 32 <= w->padded;
        winner_rows(w->d + c, least, w->x + c, w->y + c, w->z + c, p);
    }
    /*@ loop invariant place: l <= WINNER_LANES;
        loop assigns l, w->least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        w->least[l] = least[l];
}

/* The lowest array index of the least squared distance: only lanes that hold it are looked through, and only below what was found before
 * (the last class stands for a least distance that no class has, which a NaN alone could bring about). */
/*@ requires arrays:  winner_arrays((winner_space *)w);
    assigns  \nothing;
    ensures  range:   0 <= \result < w->classes;
*/
static size_t winner_lowest(const winner_space *w)
{
    const double *m = w->least;
    double four[4], least;
    size_t lowest = w->classes - 1;

    /*@ loop invariant place: l <= 4;
        loop assigns l, four[0 .. 3];
        loop variant 4 - l;
    */
    for (size_t l = 0; l < 4; l++)
        four[l] = winner_lesser(winner_lesser(m[l], m[l + 4]), winner_lesser(m[l + 8], m[l + 12]));
    least = winner_lesser(winner_lesser(four[0], four[1]), winner_lesser(four[2], four[3]));
    /*@ loop invariant place:  l <= WINNER_LANES && lowest < w->classes;
        loop assigns l, lowest;
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        if (m[l] == least) {
            size_t i = l;

            /*@ loop invariant place:  i < lowest + WINNER_LANES;
                loop assigns i;
                loop variant lowest + WINNER_LANES - i;
            */
            while (i < lowest && w->d[i] != least)
                i += WINNER_LANES;
            lowest = i < lowest ? i : lowest;
        }
    return lowest;
}

/* Put the class at i out of the running. */
/*@ requires arrays:  winner_arrays(w);
    requires class:   i < w->padded;
    assigns  w->d[i], w->least[i % WINNER_LANES];
*/
static void winner_exclude(winner_space *w, size_t i)
{
    const size_t lane = i % WINNER_LANES;
    double even = INFINITY, odd = INFINITY;

    w->d[i] = INFINITY;
    /*@ loop invariant place:  c <= w->padded + lane && c % WINNER_CHUNK == lane;
        loop assigns c, even, odd;
        loop variant w->padded + lane - c;
    */
    for (size_t c = lane; c < w->padded; c += WINNER_CHUNK) {
        even = winner_lesser(even, w->d[c]);
        odd = winner_lesser(odd, w->d[c + WINNER_LANES]);
    }
    w->least[lane] = winner_lesser(even, odd);
}

/* A net has four classes at least, so there is a second. */
/*@ requires arrays:  winner_arrays(w);
    assigns  w->d[0 .. w->padded - 1], w->least[0 .. 15];
    ensures  range:   \result.first < w->classes && \result.second < w->classes;
*/
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

/*@ predicate tally_arrays(tally *t, integer inputs) = \valid(t) && t->apart <= t->count <= inputs
        && \valid(t->error + (0 .. TALLY_BLOCK - 1)) && \valid(t->block + (0 .. inputs / TALLY_BLOCK))
        && \separated(t, t->error + (0 .. TALLY_BLOCK - 1), t->block + (0 .. inputs / TALLY_BLOCK));
*/

/*@ requires tally: \valid_read(t);
    assigns  \nothing;
*/
static void tally_free(tally *t)
{
    free(t->error);
    free(t->block);
}

/*@ requires tally:  \valid(t);
    assigns  *t;
    ensures  range:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  memory: \result == ET_OK ==> et_array((char *)t->error, TALLY_BLOCK, sizeof(double))
                                       && et_array((char *)t->block, inputs / TALLY_BLOCK + 1, sizeof(double));
    ensures  made:   \result == ET_OK ==> tally_arrays(t, inputs) && t->count == 0;
*/
static et_status tally_new(tally *t, size_t inputs)
{
    t->error = et_size_array(TALLY_BLOCK, sizeof *t->error);
    t->block = et_size_array(inputs / TALLY_BLOCK + 1, sizeof *t->block);
    t->count = t->apart = 0;
    t->least = INFINITY;
    t->greatest = 0;
    //@ assert distinct: \separated(t->error + (0 .. TALLY_BLOCK - 1), t->block + (0 .. inputs / TALLY_BLOCK));
    //@ assert fresh: \separated(t, t->error + (0 .. TALLY_BLOCK - 1)) && \separated(t, t->block + (0 .. inputs / TALLY_BLOCK));
    if (t->error && t->block)
        return ET_OK;
    tally_free(t);
    return ET_ENOMEM;
}

/*@ requires tally:  \valid(t) && tally_arrays(t, t->count) && t->count < SIZE_MAX;
    requires space:  \valid_read(w) && pair.first < w->classes && pair.second < w->classes && \valid_read(w->index + (0 .. w->classes - 1));
    requires apart:  \separated(t, w, w->index + (0 .. w->classes - 1));
    assigns  t->error[0 .. TALLY_BLOCK - 1], t->block[0 .. t->count / TALLY_BLOCK], t->least, t->greatest, t->apart, t->count;
    ensures  counted: t->count == \old(t->count) + 1 && t->apart <= t->count;
*/
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
/*@ requires tally:  \valid(t) && tally_arrays(t, t->count) && 1 <= t->count;
    assigns  t->block[0 .. t->count / TALLY_BLOCK];
    ensures  steps:  \result.steps == t->count;
*/
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
