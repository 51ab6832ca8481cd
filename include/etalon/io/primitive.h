/* primitive: the source's four clouds, regenerated point by point (You 2023, Table 3.1), and at any other size; noise and outliers.
 *
 * The source's clouds are modeller primitives rounded to 4 decimals (the cube: rounded up to 5) and normalised, each axis by its own minimum
 * and maximum, to [0,1]^3.  Here they are rounded to whole units of 1e-4 (1e-5) and normalised as quotients of whole numbers, so that every
 * coordinate is a correctly rounded rational, 0 and 1 are touched exactly on each axis, and no platform's sine shows in the bits.
 *
 * cube     a x a x a lattice, its surface: i/(a-1) rounded up.  The face y = 0 comes first, quad by quad from z = 1 downwards and from x = 0, each
 *          point where the quads (c,r) (c,r+1) (c+1,r+1) (c+1,r) name it first; then the layers y > 0, from z = 1 downwards, from x = 0.
 * sphere   radius 10; a rings at equal angles between the poles, b points a ring: x = -R sin t sin f, y = R cos t, z = -R sin t cos f; halves go
 *          up, z after 0.2 units have been taken off.
 * spindle  a solid of revolution about y: radius 30, height 60; a ring of radius 0.01 at either pole's height, c conical cap rings each end
 *          over a height of 15, s rings of side, a = 2 (1 + c) + s, c : s as 50 : 49.
 * oiltank  radius 10, height 24.9; spherical caps of height 5 (sphere of 12.5) with c rings at equal angles, s rings of side, a = 2 c + s, c : s as
 *          20 : 59.
 * Spindle and oiltank: x = r cos f, z = -r sin f.  c is the nearest whole number to its share, halves up, at least 1.  Poles: first the
 * upper (y = 1), last the lower.  Very fine sizes round neighbouring points together.
 */
#ifndef ETALON_IO_PRIMITIVE_H
#define ETALON_IO_PRIMITIVE_H
#include "etalon/base/rng.h"
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_PRIMITIVE_CUBE = 0, ET_PRIMITIVE_SPHERE, ET_PRIMITIVE_SPINDLE, ET_PRIMITIVE_OILTANK } et_primitive_kind;

/* "cube", "sphere", "spindle", "oiltank"; null past the last. */
/*@ assigns \result \from kind;
    ensures named: 0 <= kind <= 3 ==> valid_read_string(\result);
    ensures past:  (kind < 0 || kind > 3) ==> \result == \null;
*/
const char *et_primitive_name(et_primitive_kind kind);

/* The number of points: cube 6 (a-1)^2 + 2, the others a b + 2.
 * Resolution: cube a lattice of a x a x a (b unused); the others a rings between the poles of b points.  a = b = 0 (cube: a = 0): the source's,
 * 36, 59 x 120, 151 x 50, 99 x 60.  ET_EINVAL: no such kind, or too small to make sense: cube a < 2; b < 3; sphere a < 1, spindle a < 4,
 * oiltank a < 2.  ET_ENOMEM: the number exceeds size_t. */
/*@ requires valid:    \valid(count);
    assigns *count;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures kind:      (kind < 0 || kind > 3) ==> \result == ET_EINVAL;
    ensures cube:      \result == ET_OK && kind == ET_PRIMITIVE_CUBE && a > 0 ==> *count == 6*((a - 1)*(a - 1)) + 2;
    ensures rings:     \result == ET_OK && kind != ET_PRIMITIVE_CUBE && a > 0 ==> *count == a*b + 2;
    ensures unchanged: \result != ET_OK ==> *count == \old(*count);
*/
et_status et_primitive_count(size_t *count, et_primitive_kind kind, size_t a, size_t b);

/* The points, count of them as et_primitive_count says (else ET_EINVAL). */
/*@ requires valid:    \valid(points + (0 .. count - 1));
    assigns points[0 .. count - 1];
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures cube:      \result == ET_OK ==> \forall integer i; 0 <= i < count ==>
                         0 <= points[i].x <= 1 && 0 <= points[i].y <= 1 && 0 <= points[i].z <= 1;
    ensures unchanged: \result != ET_OK ==> \forall integer i; 0 <= i < count ==> points[i] == \old(points[i]);
*/
et_status et_primitive_make(et_vec3 *points, size_t count, et_primitive_kind kind, size_t a, size_t b);

/* Add N(0, sigma^2) to every coordinate, and replace floor(fraction * count + 1/2) distinct points by uniform ones in the box [-0.1, 1.1]^3.
 * Draws, in this order: if sigma > 0 one et_rng_normal a coordinate, x, y, z, point by point; then the points to be replaced, by the first steps
 * of a Fisher-Yates shuffle (step k swaps k with k + et_rng_index(rng, count - k)); then for each of them, in the shuffle's order, x, y, z
 * = -0.1 + 1.2 et_rng_uniform(rng).  sigma = 0 and fraction = 0 draw nothing and change nothing.
 * ET_EINVAL: sigma negative or not finite, fraction not in [0, 1].  ET_ENOMEM.
 * Golden: none (the generator's deviates pass through a logarithm; the property replays them). */
/*@ requires valid:    \valid(points + (0 .. count - 1));
    requires rng:      \valid(rng) && \separated(rng, points + (0 .. count - 1));
    assigns points[0 .. count - 1], *rng;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:   \result == ET_EINVAL <==> !(\is_finite(sigma) && 0 <= sigma && \is_finite(fraction) && 0 <= fraction <= 1);
    ensures unchanged: \result != ET_OK ==> \forall integer i; 0 <= i < count ==> points[i] == \old(points[i]);
*/
et_status et_primitive_disturb(et_vec3 *points, size_t count, double sigma, double fraction, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
