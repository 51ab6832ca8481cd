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

/*@ predicate winner_arrays(winner_space *w) =
        4 <= w->classes <= w->padded && w->padded % WINNER_CHUNK == 0 && 4*w->padded <= SIZE_MAX
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

    predicate winner_attained(double *d, integer n, integer l, double m) = \exists integer q; 0 <= q && 16*q + l < n && \eq_double(d[16*q + l], m);
    predicate winner_below(double *d, integer n, integer l, double m) = \forall integer q; 0 <= q && 16*q + l < n ==> \le_double(m, d[16*q + l]);
    predicate winner_lane(double *d, integer n, integer l, double m) = !\is_NaN(m) && winner_below(d, n, l, m) && winner_attained(d, n, l, m);
    predicate winner_lanes(winner_space *w) = \forall integer l; 0 <= l < WINNER_LANES ==> winner_lane(w->d, w->padded, l, w->least[l]);
    predicate winner_infinite(winner_space *w) = \forall integer c; w->classes <= c < w->padded ==> \is_plus_infinity(w->d[c]);
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

/*@ requires number: !\is_NaN(a) && !\is_NaN(b);
    assigns  \nothing;
    ensures  number: !\is_NaN(\result);
    ensures  lesser: \le_double(\result, a) && \le_double(\result, b) && (\eq_double(\result, a) || \eq_double(\result, b));
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
    requires input:  winner_class(p.x, p.y, p.z);
    requires places: \forall integer i; 0 <= i < 32 ==> winner_class(x[i], y[i], z[i]) || winner_padding(x[i], y[i], z[i]);
    requires number: \forall integer l; 0 <= l < 16 ==> !\is_NaN(least[l]);
    assigns  d[0 .. 31], least[0 .. 15];
    ensures  finite: \forall integer i; 0 <= i < 32 && winner_class(x[i], y[i], z[i]) ==> \is_finite(d[i]);
    ensures  padded: \forall integer i; 0 <= i < 32 && winner_padding(x[i], y[i], z[i]) ==> \is_plus_infinity(d[i]);
    ensures  least:  \forall integer l; 0 <= l < 16 ==> !\is_NaN(least[l]) && \le_double(least[l], \old(least[l]))
                         && \le_double(least[l], d[l]) && \le_double(least[l], d[l + 16])
                         && (\eq_double(least[l], \old(least[l])) || \eq_double(least[l], d[l]) || \eq_double(least[l], d[l + 16]));
*/
static void winner_rows(double *restrict d, double *restrict least, const double *restrict x, const double *restrict y, const double *restrict z,
                        et_vec3 p)
{
    /*@ loop invariant place:  l <= WINNER_LANES;
        loop invariant finite: \forall integer i; 0 <= i < l ==> (winner_class(x[i], y[i], z[i]) ==> \is_finite(d[i]))
                                   && (winner_class(x[i + 16], y[i + 16], z[i + 16]) ==> \is_finite(d[i + 16]));
        loop invariant padded: \forall integer i; 0 <= i < l ==> (winner_padding(x[i], y[i], z[i]) ==> \is_plus_infinity(d[i]))
                                   && (winner_padding(x[i + 16], y[i + 16], z[i + 16]) ==> \is_plus_infinity(d[i + 16]));
        loop invariant least:  \forall integer i; 0 <= i < l ==> !\is_NaN(least[i]) && \le_double(least[i], \at(least[i], Pre))
                                   && \le_double(least[i], d[i]) && \le_double(least[i], d[i + 16])
                                   && (\eq_double(least[i], \at(least[i], Pre)) || \eq_double(least[i], d[i]) || \eq_double(least[i], d[i + 16]));
        loop invariant later:  \forall integer i; l <= i < 16 ==> !\is_NaN(least[i]) && \eq_double(least[i], \at(least[i], Pre));
        loop assigns l, d[0 .. 31], least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++) {
        const double ax = p.x - x[l], ay = p.y - y[l], az = p.z - z[l], a = ax * ax + ay * ay + az * az;
        const double bx = p.x - x[l + WINNER_LANES], by = p.y - y[l + WINNER_LANES], bz = p.z - z[l + WINNER_LANES];
        const double b = bx * bx + by * by + bz * bz, ab = b < a ? b : a;

        //@ assert square: winner_class(x[l], y[l], z[l]) ==> \is_finite(a);
        //@ assert square: winner_class(x[l + 16], y[l + 16], z[l + 16]) ==> \is_finite(b);
        //@ assert square: winner_padding(x[l], y[l], z[l]) ==> \is_plus_infinity(a);
        //@ assert square: winner_padding(x[l + 16], y[l + 16], z[l + 16]) ==> \is_plus_infinity(b);
        d[l] = a;
        d[l + WINNER_LANES] = b;
        least[l] = ab < least[l] ? ab : least[l];
    }
}

/*@ requires arrays:  winner_arrays(w) && winner_weights(w);
    requires input:   winner_class(p.x, p.y, p.z);
    assigns  w->d[0 .. w->padded - 1], w->least[0 .. 15];
    ensures  lanes:   winner_lanes(w);
    ensures  finite:  \forall integer c; 0 <= c < w->classes ==> \is_finite(w->d[c]);
    ensures  padded:  winner_infinite(w);
*/
static void winner_distances(winner_space *w, et_vec3 p)
{
    double least[WINNER_LANES];

    /*@ loop invariant place: l <= WINNER_LANES;
        loop invariant far:   \forall integer a; 0 <= a < l ==> \is_plus_infinity(least[a]);
        loop assigns l, least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        least[l] = INFINITY;
    /*@ loop invariant place:  c <= w->padded && c % WINNER_CHUNK == 0;
        loop invariant number: \forall integer l; 0 <= l < 16 ==> !\is_NaN(least[l]);
        loop invariant below:  \forall integer l; 0 <= l < 16 ==> winner_below(w->d, c, l, least[l]);
        loop invariant found:  \forall integer l; 0 <= l < 16 ==> winner_attained(w->d, c, l, least[l]) || \is_plus_infinity(least[l]);
        loop invariant finite: \forall integer a; 0 <= a < c && a < w->classes ==> \is_finite(w->d[a]);
        loop invariant padded: \forall integer a; w->classes <= a < c ==> \is_plus_infinity(w->d[a]);
        loop invariant kept:   winner_weights(w);
        loop assigns c, least[0 .. 15], w->d[0 .. w->padded - 1];
        loop variant w->padded - c;
    */
    for (size_t c = 0; c < w->padded; c += WINNER_CHUNK)
        winner_rows(w->d + c, least, w->x + c, w->y + c, w->z + c, p);
    //@ assert found: \forall integer l; 0 <= l < 16 ==> winner_lane(w->d, w->padded, l, least[l]);
    /*@ loop invariant place: l <= WINNER_LANES;
        loop invariant same:  \forall integer a; 0 <= a < l ==> winner_lane(w->d, w->padded, a, w->least[a]);
        loop assigns l, w->least[0 .. 15];
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        w->least[l] = least[l];
}

/* The lowest array index of the least squared distance: only lanes that hold it are looked through. */
/*@ requires arrays:  winner_arrays((winner_space *)w) && winner_lanes((winner_space *)w) && winner_infinite((winner_space *)w);
    requires some:    \is_finite(w->d[0]) || \is_finite(w->d[1]);
    assigns  \nothing;
    ensures  range:   0 <= \result < w->classes && \is_finite(w->d[\result]);
    ensures  least:   \forall integer l; 0 <= l < 16 ==> winner_below(w->d, w->padded, l, w->d[\result]);
    ensures  lowest:  \forall integer c; 0 <= c < \result ==> !\eq_double(w->d[c], w->d[\result]);
*/
static size_t winner_lowest(const winner_space *w)
{
    const double *m = w->least;
    double four[4], least;
    size_t lowest = SIZE_MAX;

    /*@ loop invariant place: l <= 4;
        loop invariant four:  \forall integer a; 0 <= a < l ==> !\is_NaN(four[a])
                                  && \le_double(four[a], m[a]) && \le_double(four[a], m[a + 4]) && \le_double(four[a], m[a + 8])
                                  && \le_double(four[a], m[a + 12]) && (\eq_double(four[a], m[a]) || \eq_double(four[a], m[a + 4])
                                      || \eq_double(four[a], m[a + 8]) || \eq_double(four[a], m[a + 12]));
        loop assigns l, four[0 .. 3];
        loop variant 4 - l;
    */
    for (size_t l = 0; l < 4; l++)
        four[l] = winner_lesser(winner_lesser(m[l], m[l + 4]), winner_lesser(m[l + 8], m[l + 12]));
    least = winner_lesser(winner_lesser(four[0], four[1]), winner_lesser(four[2], four[3]));
    //@ assert every: \forall integer l; 0 <= l < 16 ==> \le_double(least, m[l]);
    //@ assert one:   \exists integer l; 0 <= l < 16 && \eq_double(m[l], least);
    //@ assert finite: \is_finite(least);
    /*@ loop invariant place:  l <= WINNER_LANES;
        loop invariant found:  lowest == SIZE_MAX || (lowest < w->padded && \eq_double(w->d[lowest], least));
        loop invariant seen:   \forall integer a; 0 <= a < l && \eq_double(m[a], least) ==> lowest < w->padded;
        loop invariant before: \forall integer a, q; 0 <= a < l && 0 <= q && 16*q + a < w->padded && 16*q + a < lowest ==>
                                   !\eq_double(w->d[16*q + a], least);
        loop assigns l, lowest;
        loop variant WINNER_LANES - l;
    */
    for (size_t l = 0; l < WINNER_LANES; l++)
        if (m[l] == least) {
            size_t i = l;
            //@ ghost size_t q = 0;

            /*@ loop invariant place:  i == 16*q + l && i < w->padded && 0 <= q;
                loop invariant before: \forall integer a; 0 <= a < q ==> !\eq_double(w->d[16*a + l], least);
                loop assigns i, q;
                loop variant w->padded - i;
            */
            while (w->d[i] != least) {
                //@ ghost q++;
                i += WINNER_LANES;
            }
            lowest = i < lowest ? i : lowest;
        }
    return lowest;
}

/* Put the class at i out of the running. */
/*@ requires arrays:  winner_arrays(w) && winner_lanes(w);
    requires class:   i < w->padded;
    assigns  w->d[i], w->least[i % WINNER_LANES];
    ensures  out:     \is_plus_infinity(w->d[i]);
    ensures  lanes:   winner_lanes(w);
*/
static void winner_exclude(winner_space *w, size_t i)
{
    const size_t lane = i % WINNER_LANES;
    double even = INFINITY, odd = INFINITY;

    w->d[i] = INFINITY;
    //@ ghost size_t q = 0;
    /*@ loop invariant place:  c == 32*q + lane && 0 <= q && c <= w->padded + lane;
        loop invariant number: !\is_NaN(even) && !\is_NaN(odd);
        loop invariant below:  \forall integer a; 0 <= a < 2*q ==> \le_double(even, w->d[16*a + lane]) || \le_double(odd, w->d[16*a + lane]);
        loop invariant even:   \is_plus_infinity(even) || winner_attained(w->d, w->padded, lane, even);
        loop invariant odd:    \is_plus_infinity(odd) || winner_attained(w->d, w->padded, lane, odd);
        loop assigns c, q, even, odd;
        loop variant w->padded + lane - c;
    */
    for (size_t c = lane; c < w->padded; c += WINNER_CHUNK) {
        //@ assert even: \eq_double(w->d[16*(2*q) + lane], w->d[c]) && !\is_NaN(w->d[c]);
        //@ assert odd:  \eq_double(w->d[16*(2*q + 1) + lane], w->d[c + 16]) && !\is_NaN(w->d[c + 16]);
        //@ ghost q++;
        even = winner_lesser(even, w->d[c]);
        odd = winner_lesser(odd, w->d[c + WINNER_LANES]);
    }
    w->least[lane] = winner_lesser(even, odd);
}

/* A net has four classes at least, so there is a second. */
/*@ requires arrays:  winner_arrays(w) && winner_weights(w);
    requires input:   winner_class(p.x, p.y, p.z);
    assigns  w->d[0 .. w->padded - 1], w->least[0 .. 15];
    ensures  range:   \result.first < w->classes && \result.second < w->classes && \result.first != \result.second;
    ensures  finite:  \is_finite(\result.d2);
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

/*@ predicate tally_arrays(tally *t) = \valid(t->error + (0 .. TALLY_BLOCK - 1)) && \valid(t->block + (0 .. t->count / TALLY_BLOCK))
        && \separated(t, t->error + (0 .. TALLY_BLOCK - 1), t->block + (0 .. t->count / TALLY_BLOCK)) && t->apart <= t->count;
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
    ensures  made:   \result == ET_OK ==> tally_arrays(t) && t->count == 0 && \valid(t->block + (0 .. inputs / TALLY_BLOCK))
                         && \separated(t, t->error + (0 .. TALLY_BLOCK - 1), t->block + (0 .. inputs / TALLY_BLOCK));
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

/*@ requires tally:  \valid(t) && tally_arrays(t) && t->count < SIZE_MAX;
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
/*@ requires tally:  \valid(t) && tally_arrays(t) && 1 <= t->count;
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
