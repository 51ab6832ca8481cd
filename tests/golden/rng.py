"""Golden rows of base/rng: mt19937 and splitmix64 in integers, from their definitions.

The 10000th output of seed 5489 is the C++ standard's check value of this generator, 4123659995; the first five outputs of splitmix64 from 1234567 are published.
"""
from math import sqrt

from elementary import log
from rational import Choices, head, row

MASK = 2**64 - 1


def mix(z):
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & MASK
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB & MASK
    return z ^ (z >> 31)


def stream(seed, k):
    return mix((seed + (k + 1) * 0x9E3779B97F4A7C15) & MASK)


class Twister:
    def __init__(self, seed):
        seed = seed if seed < 2**32 else mix(seed) & 0xFFFFFFFF
        x = [seed if seed else 4357]
        for i in range(1, 624):
            x.append((1812433253 * (x[-1] ^ (x[-1] >> 30)) + i) & 0xFFFFFFFF)
        self.x, self.k, self.draws = x, 0, 0

    def next(self):
        x, k = self.x, self.k
        y = (x[k] & 0x80000000) | (x[(k + 1) % 624] & 0x7FFFFFFF)
        x[k] = x[(k + 397) % 624] ^ (y >> 1) ^ (0x9908B0DF if y & 1 else 0)
        y, self.k, self.draws = x[k], (k + 1) % 624, self.draws + 1
        y ^= y >> 11
        y ^= y << 7 & 0x9D2C5680
        y ^= y << 15 & 0xEFC60000
        return y ^ y >> 18

    def uniform(self):
        return self.next() / 2.0**32

    def index(self, n):
        while True:
            k = self.next()
            if n < 2**32:
                if k * n % 2**32 >= 2**32 % n:
                    return k * n >> 32
            else:
                k = k << 32 | self.next()
                if k < 2**64 - 2**64 % n:
                    return k % n

    def normal(self):
        """In doubles, each operation and the logarithm correctly rounded."""
        while True:
            a, b = 2 * self.uniform() - 1, 2 * self.uniform() - 1
            s = a * a + b * b
            if 0 < s < 1:
                return a * sqrt(-2.0 * log(s) / s)


head("rng", "the generator's numbers")
PUBLISHED = [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431, 16408922859458223821]
for k, z in enumerate(PUBLISHED):
    assert stream(1234567, k) == z
    row("rng_stream", "exact", "published", [1234567, k], [z])
for seed, k in [(0, 0), (0, 1), (MASK, 0), (1, 10), (42, MASK), (2**63, 2**63), (MASK, MASK)]:
    row("rng_stream", "exact", "edge", [seed, k], [stream(seed, k)])

t = Twister(5489)
for _ in range(9999):
    t.next()
x = t.next()
assert x == 4123659995
row("rng_uniform", "bits", "published: output 10000", [5489, 9999], [x / 2.0**32])
row("rng_seek", "bits", "published: output 10000", [5489, 9999], [x / 2.0**32])
SEEDS = [(0, "zero means 4357"), (4357, "GSL's own"), (1, "small"), (5489, "the authors'"), (2**32 - 1, "greatest unmixed"), (2**32, "least mixed"),
         (123456789012345, "mixed"), (MASK, "greatest")]
for seed, why in SEEDS:
    t = Twister(seed)
    row("rng_uniform", "bits", why, [seed, 0], [t.uniform() for _ in range(5)])
    for skip in (623, 1247):
        t = Twister(seed)
        for _ in range(skip):
            t.next()
        values = [t.uniform() for _ in range(4)]
        row("rng_uniform", "bits", why + ", across the state's end", [seed, skip], values)
        row("rng_fill", "bits", why, [seed, skip], values)
        row("rng_seek", "bits", why, [seed, skip], values[:1])
    t = Twister(seed)
    row("rng_normal", "bits", why, [seed, 0], [t.normal() for _ in range(6)])
for n in (1, 2, 3, 10, 7352, 2**31, 2**31 + 1, 3 * 2**30, 2**32 - 1, 2**32, 2**32 + 1, 10**12, 2**63, 2**63 + 1, MASK):
    for seed in (1, 2**40 + 7):
        t = Twister(seed)
        values = [t.index(n) for _ in range(8)]
        row("rng_index", "bits", "rejects" if t.draws > (8 if n < 2**32 else 16) else "does not reject", [seed, n], values + [t.draws])


c = Choices(29)
for k in range(300):
    seed, n = c.bits(c.between(1, 64)), c.bits(c.between(1, 64))
    row("rng_stream", "exact", "random", [seed, n], [stream(seed, n)])
for k in range(60):
    seed = c.bits(c.between(1, 64)) if k % 3 else k
    skip = c.between(0, 700)
    t = Twister(seed)
    for _ in range(skip):
        t.next()
    values = [t.uniform() for _ in range(8)]
    why = "seed of %d bits" % seed.bit_length()
    row("rng_uniform", "bits", why, [seed, skip], values[:3])
    row("rng_fill", "bits", why, [seed, skip], values)
    row("rng_seek", "bits", why, [seed, skip + 3], values[3:4])
    t = Twister(seed)
    row("rng_normal", "bits", why, [seed, 0], [t.normal() for _ in range(3)])
    for n in (c.bits(c.between(1, 31)) + 1, c.bits(c.between(1, 64)) + 1):
        if n <= MASK:
            t = Twister(seed)
            values = [t.index(n) for _ in range(4)]
            row("rng_index", "bits", "rejects" if t.draws > (4 if n < 2**32 else 8) else "does not reject", [seed, n], values + [t.draws])
