"""Golden rows of base/frame: extents and maps of rationals; two roundings and the reference's half ulp are at most 3 ulps."""
from fractions import Fraction as F

from rational import Choices, bound_of, head, row

BOX, UNIFORM, NONE = 0, 1, 2


def frame(kind, p):
    lo = [min(c) for c in zip(*p)]
    side = [float(F(max(c)) - F(min(c))) for c in zip(*p)]
    if kind == NONE:
        return [0.0] * 3 + [1.0] * 3
    return lo + ([max(side)] * 3 if kind == UNIFORM else [s if s > 0 else 1.0 for s in side])


def of(kind, p, why):
    row("frame_of", "exact", why, [kind] + [c for q in p for c in q], [0] + frame(kind, p))


head("frame", "frames of clouds, and coordinates there and back")
c = Choices(5)
CLOUDS = [([(0.0, 0.0, 0.0), (1.0, 2.0, 4.0)], "a box"), ([(1.0, 5.0, 2.0), (3.0, 5.0, 2.5)], "flat in y"), ([(-1.0, 0.1, 1e9), (0.3, 0.2, 1e9 + 1)], "far"),
          ([(1e-300, 0.0, 0.0), (0.0, 5e-324, 0.0)], "tiny"), ([(-8e307, 0.0, 0.0), (8e307, 1.0, 0.0)], "huge"),
          ([(2.0, 2.0, 2.0), (2.0, 2.0, 2.0), (2.0, 2.0, 2.0 + 2.0**-51)], "one ulp")]
CLOUDS += [([(-0.0, 0.0, 0.0), (0.0, -0.0, 1.0)], "of two zeros the first")]
CLOUDS += [([tuple(c.real(-9, 9) for _ in range(3)) for _ in range(7)], "any") for _ in range(4)]
for p, why in CLOUDS:
    for kind in (BOX, UNIFORM, NONE):
        of(kind, p, why)
ZERO = [0.0] * 6
inf, nan = float("inf"), float("nan")
for kind in (BOX, UNIFORM, NONE):
    row("frame_of", "exact", "no point", [kind], [2] + ZERO)
    row("frame_of", "exact", "one point", [kind, 1.0, 2.0, 3.0], [2] + ZERO)
    row("frame_of", "exact", "all equal", [kind] + [1.0, 2.0, 3.0] * 3, [2] + ZERO)
    row("frame_of", "exact", "not a number", [kind, 1.0, 2.0, 3.0, 1.0, nan, 3.0], [2] + ZERO)
    row("frame_of", "exact", "infinite", [kind, 1.0, 2.0, 3.0, 1.0, 1.0, -inf], [2] + ZERO)
    row("frame_of", "exact", "overflow", [kind, 1.0, 1e308, 3.0, 1.0, -1e308, 3.0], [2] + ZERO)
row("frame_of", "exact", "unknown kind", [3, 1.0, 2.0, 3.0, 2.0, 2.0, 3.0], [1] + ZERO)
for o, hi in [(0.0, 1.0), (0.1, 0.7), (-3.3, 9.9), (1e9, 1e9 + 0.1), (5e-324, 1.0), (-1e-5, 1e-7)]:
    s = float(F(hi) - F(o))
    row("frame_to_unit", "exact", "the minimum", [o, s, o], [0.0])
    top = (F(hi) - F(o)) / F(s)                # 1 where the extent is a double
    row("frame_to_unit", "exact" if top == 1 else "ulp 3", "the maximum", [o, s, hi], [top])
    row("frame_from_unit", "exact", "the minimum", [o, s, 0.0], [o])
    row("frame_from_unit", "exact", "the extent rounds", [o, s, 1.0], [F(o) + F(s)])
for x in (0.0, -0.0, 0.3, -1e300, 5e-324):
    row("frame_to_unit", "exact", "identity", [0.0, 1.0, x], [x])
    row("frame_from_unit", "exact", "identity", [0.0, 1.0, x], [x])
for _ in range(15):
    o, s, t = c.real(-5, 5), c.real(0.1, 9), c.real(0, 1)
    x = o + s * t
    row("frame_to_unit", "ulp 3", "any", [o, s, x], [(F(x) - F(o)) / F(s)])
    row("frame_from_unit", "exact", "no rounding in between", [float(round(o)), 4.0, t], [F(round(o)) + 4 * F(t)])


U = F(1, 2**53)
SCALES = [("random", 1.0, 0.0), ("extreme scale, offset", 1.0, 1e9), ("extreme scale", 1e150, 0.0), ("extreme scale", 1e-150, 0.0),
          ("extreme scale", 1e300, 0.0), ("coincident points", 0.0, 3.0)]
for why, s, o in SCALES:
    for n in (2, 3, 7, 24):
        p = [tuple(o + s * c.short(-1, 1) for _ in range(3)) for _ in range(n)]
        p[0] = p[0][:2] + (p[0][2] + (s or 1.0),)
        for kind in (BOX, UNIFORM, NONE):
            of(kind, p, why)
for at in range(9):
    for bad in (nan, inf, -inf):
        p = [c.short(-1, 1) for _ in range(9)]
        p[at] = bad
        row("frame_of", "exact", "not a number or infinite", [at % 3] + p, [2] + ZERO)
for _ in range(24):
    a = c.real(-9, 9)
    p = [(a, 0.0, 0.0), (a * (1 + 2.0**-52), 0.0, 0.0)]
    for kind in (BOX, UNIFORM):
        of(kind, p, "nearly coincident points")
for k in range(60):
    e = 2.0 ** (c.upto(1000) - 500)
    o, s = c.real(-5, 5) * e, c.real(0.1, 9) * e
    for why, x in [("random", o + s * c.real(0, 1)), ("end of domain", o), ("end of domain", o + s), ("outside", o - s)]:
        row("frame_to_unit", "ulp 3", why, [o, s, x], [(F(x) - F(o)) / F(s)])
    for why, t in [("random", c.real(0, 1)), ("end of domain", 0.0), ("end of domain", 1.0), ("outside", c.real(-9, 9)), ("extreme scale", 5e-324)]:
        # fl(o + fl(s t)) and the wanted value's own rounding; s t may underflow.
        v = F(o) + F(s) * F(t)
        row("frame_from_unit", "abs " + bound_of(U * (abs(F(s) * F(t)) * (1 + U) + 2 * abs(v)) + F(1, 2**1074)), why, [o, s, t], [v])
