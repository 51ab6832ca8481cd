#!/usr/bin/env python3
"""Golden rows of som: the training loop once more, in plain loops over all classes, with its own Mersenne twister in integers.

Python's floats are IEEE doubles and its arithmetic is not contracted, exp and log are correctly rounded (elementary.py): the rows hold bit for bit,
and on any platform.

Usage: som.py > golden/som.tsv
"""
import math
from functools import lru_cache

import elementary
from rational import Choices, show

exp = lru_cache(None)(elementary.exp)

import elementary

MASK = 0xFFFFFFFF


class Twister:
    """Matsumoto and Nishimura's mt19937 with the initialisation of 2002; seed 0 stands for 4357, as in GSL."""

    def __init__(self, seed):
        self.s = [seed & MASK or 4357]
        for i in range(1, 624):
            self.s.append((1812433253 * (self.s[-1] ^ self.s[-1] >> 30) + i) & MASK)
        self.at = 624

    def draw(self):
        if self.at == 624:
            for k in range(624):
                y = self.s[k] & 0x80000000 | self.s[(k + 1) % 624] & 0x7FFFFFFF
                self.s[k] = self.s[(k + 397) % 624] ^ y >> 1 ^ (0x9908B0DF if y & 1 else 0)
            self.at = 0
        y = self.s[self.at]
        self.at += 1
        y ^= y >> 11
        y ^= y << 7 & 0x9D2C5680
        y ^= y << 15 & 0xEFC60000
        return y ^ y >> 18

    def uniform(self):
        return self.draw() / 2**32

    def index(self, n):
        """The high word of a 32 x 32 bit product, unbiased by rejection of the 2^32 mod n lowest low words."""
        while True:
            m = self.draw() * n
            if m & MASK >= 2**32 % n:
                return m >> 32


def classes(nx, ny):
    """Index vectors in the order of the class numbers."""
    border = lambda i, j: i in (0, nx - 1) or j in (0, ny - 1)
    bottom = [(i, j, 1 if border(i, j) else 0) for i in range(nx) for j in range(ny)]
    return bottom + [(i, j, 2) for i in range(nx) for j in range(ny) if not border(i, j)]


def square(p, w):
    x, y, z = p[0] - w[0], p[1] - w[1], p[2] - w[2]
    return x * x + y * y + z * z


def start(rng, n):
    return [[rng.uniform() for _ in range(3)] for _ in range(n)]


def train(nx, ny, steps, alpha0, sigma0, seed, cloud):
    rng = Twister(seed)
    net = classes(nx, ny)
    w = start(rng, len(net))
    radius = max(1.0, sigma0 if sigma0 > 0 else min(nx, ny) / 2)
    apart, errors = 0, []
    for t in range(1, steps + 1):
        p = cloud[rng.index(len(cloud))]
        order = sorted(range(len(net)), key=lambda c: (square(p, w[c]), c))
        first, second = net[order[0]], net[order[1]]
        errors.append(math.sqrt(square(p, w[order[0]])))
        apart += abs(first[0] - second[0]) + abs(first[1] - second[1]) > 1 or abs(first[2] - second[2]) > 1
        shrink = elementary.exp(-(t / (steps / elementary.log(radius)))) if radius > 1 else 1.0
        alpha, sigma = alpha0 * shrink, radius * shrink
        for c, v in enumerate(net):
            dist2 = sum((a - b) ** 2 for a, b in zip(v, first))
            if dist2 < sigma * sigma and abs(v[2] - first[2]) != 2:
                f = alpha * elementary.exp(-(dist2 / (2 * (sigma * sigma))))
                w[c] = [a + f * (b - a) for a, b in zip(w[c], p)]
    return apart / steps, min(errors), max(errors), w


def row(function, kind, reason, args, want):
    print("som_" + function, kind, reason, " ".join(map(show, args)), " ".join(map(show, want)), sep="\t")


def flat(points):
    return [float(x) for p in points for x in p]


OCTAHEDRON = [(0, .5, .5), (1, .5, .5), (.5, 0, .5), (.5, 1, .5), (.5, .5, 0), (.5, .5, 1)]
CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
HELIX = [(k / 16, (k * k % 17) / 16, (k * k * k % 17) / 16) for k in range(17)]

CASES = (("one step", 2, 2, 1, .9, 0, 1, OCTAHEDRON),
         ("side of 2: constant rate", 2, 2, 40, .9, 0, 2, CUBE),
         ("no interior", 2, 5, 30, .9, 0, 3, CUBE),
         ("one inner node a view", 3, 3, 25, .9, 0, 4, OCTAHEDRON),
         ("the source's figure", 4, 5, 60, .9, 0, 5, HELIX),
         ("transposed", 5, 4, 60, .9, 0, 5, HELIX),
         ("one point", 3, 4, 20, .9, 0, 6, [(.25, .5, .75)]),
         ("coincident points", 3, 4, 20, .9, 0, 7, [(.25, .5, .75)] * 3 + [(1, 0, 1)]),
         ("rate of 1: winner meets input", 3, 3, 30, 1.0, 1.5, 8, CUBE),
         ("radius below 1", 4, 4, 30, .5, .25, 9, CUBE),
         ("radius of 1", 4, 4, 30, .5, 1.0, 9, CUBE),
         ("radius above the net", 4, 4, 30, .5, 50.0, 10, HELIX),
         ("radius of an ulp over 1", 3, 3, 30, .5, 1 + 2.0**-52, 11, HELIX),
         ("small rate", 5, 5, 50, 2.0**-20, 0, 12, HELIX),
         ("odd side", 5, 7, 100, .9, 0, 13, HELIX),
         ("seed 0", 3, 3, 10, .9, 0, 0, CUBE),
         ("even side", 6, 6, 200, .9, 0, 14, CUBE),
         ("long and thin", 2, 20, 60, .9, 3.0, 15, HELIX),
         ("thin and long", 20, 2, 60, .9, 3.0, 15, HELIX))

print("# function\tclass\treason\targuments as in tests/som/test_som.c\twanted")
print("# made by tests/golden/som.py: an independent loop and generator")
row("defaults", "exact", "the source's options", (), (30000, 0.9, 0.0))
for seed, n in ((0, 4), (1, 4), (4357, 4), (2**32 - 1, 6), (123456789, 8)):
    row("start", "bits", "seed %d" % seed, (seed, n), flat(start(Twister(seed), n)))
row("start", "bits", "beyond the generator's first state", (5, 220), flat(start(Twister(5), 220)))
for reason, nx, ny, steps, alpha0, sigma0, seed, cloud in CASES:
    te, least, greatest, w = train(nx, ny, steps, alpha0, sigma0, seed, cloud)
    row("train", "bits", reason, [nx, ny, steps, float(alpha0), float(sigma0), seed] + flat(cloud), [te, least, greatest] + flat(w))
c = Choices(43)
for k in range(60):
    nx, ny = c.between(2, 4), c.between(2, 4)
    points = [tuple(c.short(0, 1, 32) for _ in range(3)) for _ in range(c.between(1, 6))]
    why, scale = c.of((("random", 1.0), ("random", 1.0), ("extreme scale, offset", 0.0), ("extreme scale", 2.0**300), ("extreme scale", 2.0**-300)))
    points = [tuple(x * scale if scale else 1e9 + x for x in p) for p in points]
    args = [nx, ny, c.between(1, 25), c.of((.9, .5, 1.0, 2.0**-10)), c.of((0.0, 0.0, 1.0, 1.5, 3.0)), c.bits(32)]
    te, least, greatest, w = train(*args, points)
    row("train", "bits", why, args + flat(points), [te, least, greatest] + flat(w))
for k in range(30):
    seed, n = c.bits(32), c.between(1, 8)
    row("start", "bits", "random", (seed, n), flat(start(Twister(seed), n)))
