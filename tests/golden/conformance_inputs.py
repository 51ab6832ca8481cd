"""conformance_inputs: knots, parameters, control points and weights by category, for the generators of frozen vectors."""
from conformance_base import INF, NAN, Curve, Surface, after, before, domain
from knots_of import clamped, inner_knots, near, scaled

# Coordinates: few digits wherever digits do not matter, so that people can read the files.
COORDINATES = {"short": lambda c: (c.upto(64) - 32) / 8.0, "real": lambda c: c.real(-1, 1), "far": lambda c: 1e9 + c.upto(64) / 64.0,
               "huge": lambda c: c.real(-1, 1) * 1e307, "tiny": lambda c: c.real(-1, 1) * 1e-300,
               "subnormal": lambda c: (c.upto(2000) - 1000) * 2.0**-1074, "mixed": lambda c: c.real(-1, 1) * 10.0 ** (c.upto(30) - 15)}
WEIGHTS = {"": None, "short": lambda c: (c.upto(24) + 8) / 16.0, "equal": lambda c: 0.1, "ratio": lambda c: 10.0 ** (c.upto(16) - 8),
           "tiny": lambda c: c.real(1, 2) * 1e-150, "one huge": lambda c: 1e16 if c.upto(3) == 0 else 1.0}


def control(c, n, how="short"):
    return [tuple(COORDINATES[how](c) for _ in range(3)) for _ in range(n)]


def weigh(c, n, how):
    return [WEIGHTS[how](c) for _ in range(n)] if how else []


def curve(c, p, u, how="short", weights=""):
    n = len(u) - p - 1
    return Curve(p, u, control(c, n, how), weigh(c, n, weights))


def surface(c, p, u, q, v, how="short", weights=""):
    n = (len(u) - p - 1) * (len(v) - q - 1)
    return Surface(p, q, u, v, control(c, n, how), weigh(c, n, weights))


def plain_knots(c, p, most=5):
    how = c.upto(3)
    if how == 0:
        return clamped(p, [])
    if how == 1:
        n = c.between(1, most)
        return clamped(p, [float(k) for k in range(1, n + 1)], 0.0, n + 1.0)
    if how == 2:
        return clamped(p, sorted({c.short(0, 1, 16) for _ in range(c.between(1, most))} - {0.0, 1.0}))
    return clamped(p, inner_knots(c, c.between(1, most), 1))


def repeated_knots(c, p):
    """Some inner knots, one of them of multiplicity p or p + 1, often."""
    full = c.of((2, p, p, p + 1, p + 1)) if p else 1
    t = c.short(0.125, 0.875, 12)
    inner = [t] * min(full, p + 1) + [x for x in inner_knots(c, c.between(0, 2), 1, 16) if x != t]
    return clamped(p, sorted(inner))


def near_knots(c, p):
    """Knots one or few ulps apart; zeros of both signs; knots that a tolerance of 1e-4 .. 1e-12 would merge."""
    how = c.upto(4)
    if how <= 1:
        return near(c, p)
    if how == 2:
        return clamped(p, [-0.0] if c.upto(1) else [0.0], -1.0)
    t, gap = c.short(0.25, 0.75, 8), c.of((1e-4, 1e-6, 1e-9, 1e-12, 2.0**-40))
    return clamped(p, [t] * c.between(1, max(1, p)) + [t + gap] * c.between(1, max(1, p)))


def not_clamped(c, p):
    how = c.upto(2)
    if how == 0:
        return [float(k) for k in range(2 * p + 2 + c.upto(3))]
    if how == 1:
        u = sorted(c.short(-4, 4, 32) for _ in range(2 * p + 2 + c.upto(4)))
        return u if u[p] < u[-p - 1] else [float(k) for k in range(len(u))]
    return clamped(p, [0.5])[:-1] + [1.25]


def extreme_knots(c, p):
    how = c.upto(4)
    base = clamped(p, inner_knots(c, c.between(0, 3), 2))
    if how == 0:
        return scaled(base, 2.0**531)
    if how == 1:
        return scaled(base, 2.0**-531)
    if how == 2:
        return scaled(clamped(p, sorted({c.short(0, 1, 16) for _ in range(3)} - {0.0, 1.0})), 1.0, c.of((1e9, -1e9)))
    if how == 3:
        return clamped(p, sorted([2.0 ** -c.between(20, 200), 1.0 - 2.0 ** -c.between(10, 52)]))
    m = 2.0**-1022
    return clamped(p, [m * k for k in range(1, 4)], 0.0, 4 * m)


def inside(c, u, p):
    lo, hi = domain(u, p)
    how = c.upto(3)
    if how == 0:
        return min(max(c.real(lo, hi), lo), hi)
    x = lo + (hi - lo) * (c.between(1, 15) / 16.0)
    return min(max(x, lo), hi)


def at_end(c, u, p):
    lo, hi = domain(u, p)
    return c.of((lo, hi, hi, after(lo), before(hi)))


def at_knot(c, u, p):
    lo, hi = domain(u, p)
    inner = sorted({x for x in u if lo < x < hi}) or [hi]
    return c.of(inner)


def beside_knot(c, u, p):
    x = at_knot(c, u, p)
    return c.of((x, after(x), before(x), x + 1e-10 * (1 if x else 0) or x))


def outside(c, u, p):
    lo, hi = domain(u, p)
    return c.of((before(lo), after(hi), lo - 0.5 * (hi - lo), hi + (hi - lo), hi + 1e-9 * (hi - lo)))


def bad_knots(u, p):
    """(what, knots) that no curve has; |u| and degree kept where that can be."""
    mid = len(u) // 2
    for what, value in (("a knot is NaN", NAN), ("a knot is infinite", INF), ("a knot is minus infinity", -INF)):
        yield what, u[:mid] + [value] + u[mid + 1:]
    yield "the last knot is infinite", u[:-1] + [INF]
    if len(u) > 2 * p + 2:
        k = p + 1
        yield "knots decrease", u[:k] + [u[-1] + 1.0] + u[k + 1:]
    yield "knots decrease at the end", u[:-1] + [u[-1] - 0.25 * (u[-1] - u[0])]
    yield "knots decrease by one ulp", u[:-1] + [before(u[-1])]
    yield "an empty domain", [u[0]] * len(u)

