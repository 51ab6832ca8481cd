"""conformance_other: frozen vectors of nearest points, surface errors, the double net's numbering and gaps at seams.

The nearest point of a curve is found by Sturm's chains in rationals: all places where the distance is stationary, and the ends of all spans.  That of
a surface is known because the surface is made so: planes, graphs over their parameters, quarters of cylinders.
"""
from fractions import Fraction as F
from math import comb, factorial

from conformance_base import (DEFINED, INF, INVALID, LEAST, NAN, U, VALID, Choices, Count, Curve, Local, Operation, Surface, curve_kind, domain,
                              homogeneous, jumps,
                              knots_kind, number, points, reals, surface_kind, sure, worse)
from conformance_evaluate import bad_curves, collapsed, cone, hemisphere
from conformance_inputs import control, curve, not_clamped, plain_knots, repeated_knots, surface, weigh
from knots_of import clamped
from rational import decided, nearest, root, up

# ---- polynomials: lists of rationals, the constant first ----


def times(a, b):
    out = [F(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def plus(a, b, sign=1):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else F(0)) + sign * (b[i] if i < len(b) else F(0)) for i in range(n)]


def derivative(a):
    return [i * x for i, x in enumerate(a)][1:] or [F(0)]


def value(a, x):
    y = F(0)
    for c in reversed(a):
        y = y * x + c
    return y


def trimmed(a):
    a = list(a)
    while a and a[-1] == 0:
        a.pop()
    return a


def remainder(a, b):
    a = trimmed(a)
    while len(a) >= len(b):
        f = a[-1] / b[-1]
        k = len(a) - len(b)
        a = trimmed([x - (f * b[i - k] if i >= k else 0) for i, x in enumerate(a)][:-1])
    return a


def chain(a):
    """Sturm's chain, each scaled to be short."""
    out = [trimmed(a), trimmed(derivative(a))]
    while out[-1]:
        r = [-x for x in remainder(out[-2], out[-1])]
        if not r:
            break
        top = max(map(abs, r))
        out.append([x / top for x in r])
    return [p for p in out if p]


def changes(polys, x):
    signs = [v for v in (value(p, x) for p in polys) if v]
    return sum((a < 0) != (b < 0) for a, b in zip(signs, signs[1:]))


def quotient(a, b):
    """a / b, which leaves nothing."""
    a, out = trimmed(a), []
    while len(a) >= len(b):
        f = a[-1] / b[-1]
        out.append(f)
        k = len(a) - len(b)
        a = [x - (f * b[i - k] if i >= k else 0) for i, x in enumerate(a)][:-1]
    return out[::-1]


def roots(a):
    """Intervals (low, high) in [0, 1] with one root in (low, high] each, or low = high a root that is known."""
    a = trimmed(a)
    if len(a) < 2:
        return []
    polys, out = chain(a), []
    simple = quotient(a, polys[-1])
    if value(a, F(0)) == 0:
        out.append((F(0), F(0)))

    def look(low, high, n):
        if n == 0:
            return
        if n == 1:
            out.append(narrowed(simple, low, high))
            return
        mid = (low + high) / 2
        at = changes(polys, mid)
        look(low, mid, changes(polys, low) - at)
        look(mid, high, at - changes(polys, high))
    look(F(0), F(1), changes(polys, F(0)) - changes(polys, F(1)))
    return out


def narrowed(a, low, high):
    """a changes its sign once in (low, high]; low may be another root."""
    end = value(a, high)
    for bits in (40, 300):
        while high - low > F(1, 2**bits):
            mid = (low + high) / 2
            at = value(a, mid)
            if end == 0 or at == 0:
                return (high, high) if end == 0 else (mid, mid)
            if (at < 0) == (end < 0):
                high, end = mid, at
            else:
                low = mid
        guess = ((low + high) / 2).limit_denominator(2**16)
        if value(a, guess) == 0 and low <= guess <= high:
            return guess, guess
    return low, high


def enclosed(a, low, high):
    """Ends of a polynomial's values on an interval of [0, 1]."""
    if low == high:
        v = value(a, low)
        return v, v
    mid, half = (low + high) / 2, (high - low) / 2
    v, e = value(a, mid), half * sum(i * abs(x) for i, x in enumerate(a))
    return v - e, v + e


def pieces(c):
    """Per non-empty span its ends and the polynomials of w, wx, wy, wz over [0, 1]."""
    for k in range(c.p, c.n):
        if c.u[k] < c.u[k + 1]:
            at = Local(c.u, c.p, c.u[k], c.p, "right")
            H, _ = homogeneous(c.P[k - c.p:k + 1], c.w[k - c.p:k + 1] or [1.0] * (c.p + 1))
            a, b = F(c.u[k]), F(c.u[k + 1])
            yield a, b, [[sum(n * h[j] for n, h in zip(at.N[e], H)) * (b - a) ** e / factorial(e) for e in range(c.p + 1)] for j in range(4)]


def nearest_of(c, P):
    """The parameter and the squared distance of the only nearest point, as ends of intervals; None if there are more of them."""
    found = []
    for a, b, (W, *A) in pieces(c):
        D = [plus(x, [F(q) * w for w in W], -1) for x, q in zip(A, P)]
        N = plus(plus(times(D[0], D[0]), times(D[1], D[1])), times(D[2], D[2]))
        g = plus(times(derivative(N), W), [2 * x for x in times(N, derivative(W))], -1)
        for low, high in [(F(0), F(0)), (F(1), F(1))] + roots(g):
            n0, n1 = enclosed(N, low, high)
            w0, w1 = enclosed(W, low, high)
            found.append((max(n0, F(0)) / w1 ** 2, n1 / w0 ** 2, a + low * (b - a), a + high * (b - a)))
    best = min(found, key=lambda f: f[1])
    near = [f for f in found if f[0] <= best[1]]
    if any(f[2] != near[0][2] or f[3] != near[0][3] for f in near):
        return None
    return near[0]


def root_of(low, high):
    """The double nearest to a square root whose square is enclosed; None if the enclosure is too wide."""
    a, b = (nearest(root(x, 2, 120)[0]) for x in (low, high))
    return a if a == b else None


def give(op, category, args, kind, k, P, at, distance, **more):
    """P: the control points."""
    size = max(abs(F(x)) for q in P for x in q)
    box = [max(F(q[c]) for q in P) - min(F(q[c]) for q in P) for c in range(3)]
    e = up(root(sum(x * x for x in box), 2, 100)[0], 80)
    D = k * U * (size + F(distance)) + up(root(F(1, 2**53), 2, 100)[0], 80) * e
    op.add(category, args, kind, list(at) + [distance], [(k, INF)] * len(at) + [(k, D)], **more)


def curve_nearest(op, category, c, P, issue=None, comment=None):
    args, more = [c.args(), points(P)], {"issue": issue, "comment": comment}
    kind = curve_kind(c)
    if kind == INVALID or len(P) != 1 or not all(map(number, P[0])):
        op.add(category, args, INVALID, **more)
        return
    if not sure(kind, c.u, w=c.w) or c.p == 0:
        op.add(category, args, DEFINED, **more)
        return
    found = nearest_of(c, P[0])
    if found is None:
        return
    d, x = root_of(*found[:2]), nearest(found[2])
    if d is None or x != nearest(found[3]):
        return
    give(op, category, args, kind, 64 * (c.p + 2), c.P, [x], d, **more)


def curve_inversions():
    op = Operation("curve_nearest")
    c = Choices(401)
    for k in range(14):
        for p in (1, 2, 3):
            u = plain_knots(c, p, 3)
            one = curve(c, p, u, "short", "" if k % 3 else "short" if p < 3 else "")
            curve_nearest(op, "inversion", one, control(c, 1))
            if k < 7:
                curve_nearest(op, "inversion", one, [tuple(x * 8 for x in control(c, 1)[0])], comment="far away")
                curve_nearest(op, "end_of_domain", Curve(p, u, [(float(i), y, z) for i, (_, y, z) in enumerate(one.P)]),
                              [(-100.0, one.P[0][1], one.P[0][2]) if k % 2 else (100.0, one.P[-1][1], one.P[-1][2])], comment="beyond an end")
                curve_nearest(op, "repeated_knots", curve(c, p, repeated_knots(c, p)), control(c, 1))
                curve_nearest(op, "degenerate", collapsed(c, p, u, ""), control(c, 1))
    for k in range(1, 16):
        one = Curve(3, clamped(3, []), [(0.0, 0.0, 0.0), (8.0, 16.0, 0.0), (24.0, 16.0, 8.0), (32.0, 0.0, 8.0)])
        t = F(k, 16)
        Q = [sum(comb(3, i) * t ** i * (1 - t) ** (3 - i) * F(one.P[i][j]) for i in range(4)) for j in range(3)]
        curve_nearest(op, "inversion", one, [tuple(map(float, Q))], "qnzhou/nanospline/issues/49", "a point of the curve")
    arc = Curve(2, clamped(2, []), [(1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)], [1.0, 1.0, 2.0])
    for k in (1, 2, 4, 64):
        for z in (0.0, 3.0):
            curve_nearest(op, "weights", arc, [(3.0 * k / 4, 4.0 * k / 4, z)], comment="a quarter of a circle: 3, 4 and 5")
            curve_nearest(op, "weights", arc, [(15.0 * k / 8, 8.0 * k / 8, z)], comment="a quarter of a circle: 8, 15 and 17")
    for turn in range(1, 5):
        P = [(float((i % 4 in (1, 2)) * 8), float((i % 4 in (2, 3)) * 8), i / 16.0) for i in range(24)]
        coil = Curve(1, clamped(1, [float(i) for i in range(1, 23)], 0.0, 23.0), P)
        curve_nearest(op, "inversion", coil, [(3.0, -0.5, turn / 4.0 + 0.125)], "https://github.com/bldrs-ai/conway/pull/604",
                      "turns that lie near each other")
        curve_nearest(op, "inversion", coil, [(8.25, 5.0, turn / 4.0)], "https://github.com/bldrs-ai/conway/pull/604",
                      "turns that lie near each other")
    for x in (0.25, 0.5, 7.75):
        curve_nearest(op, "inversion", Curve(2, clamped(2, [1.0, 2.0], 0.0, 3.0), [(0.0, 0.0, 0.0), (2.0, 4.0, 0.0), (4.0, -4.0, 0.0),
                                                                                   (6.0, 4.0, 0.0), (8.0, 0.0, 0.0)]),
                      [(x, 1.0, 0.5)], "Open-Cascade-SAS/OCCT/issues/345", "parameter and distance belong together")
    for p in range(4, 9):
        one = Curve(p, clamped(p, []), [(float(i), float(i * i % 5), 0.0) for i in range(p + 1)])
        curve_nearest(op, "degrees", one, [(p / 2.0, 3.0, 1.0)], comment="degree %d" % p)
    for s in (2.0**300, 2.0**-300):
        one = Curve(2, clamped(2, [0.5]), [(0.0, 0.0, 0.0), (s, 2 * s, 0.0), (3 * s, 2 * s, s), (4 * s, 0.0, 0.0)])
        curve_nearest(op, "extreme_scale", one, [(s, s, s)])
        curve_nearest(op, "extreme_scale", Curve(2, [t * s for t in one.u], [(0.0, 0.0, 0.0), (1.0, 2.0, 0.0), (3.0, 2.0, 1.0), (4.0, 0.0, 0.0)]),
                      [(1.0, 1.0, 1.0)])
    curve_nearest(op, "end_of_domain", curve(c, 2, not_clamped(c, 2)), [(0.0, 0.0, 0.0)], comment="knots not clamped: may be refused")
    curve_nearest(op, "degrees", Curve(0, [0.0, 1.0, 2.0], [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)]), [(0.0, 0.0, 0.0)], comment="degree 0: may be refused")
    long = Curve(3, clamped(3, [float(i) for i in range(1, 60)], 0.0, 60.0), [(float(i), float(i * i % 7), float(i % 3)) for i in range(63)])
    curve_nearest(op, "size", long, [(31.25, 2.0, 0.5)], comment="63 control points")
    one = curve(c, 2, clamped(2, [0.5]))
    curve_nearest(op, "bad_input", one, [], comment="no point")
    curve_nearest(op, "bad_input", one, control(c, 2), comment="two points")
    for bad in (NAN, INF):
        curve_nearest(op, "bad_input", one, [(0.0, bad, 0.0)], comment="a coordinate is no number")
    bad_curves(c, lambda category, one, x, **more: curve_nearest(op, category, one, [(0.0, 0.0, 0.0)], **more) if number(x) else None)
    return op


def surface_nearest(op, category, s, P, at=None, squared=None, issue=None, comment=None):
    """at: the parameters of the only nearest point, rationals; squared: its distance, squared."""
    args, more = [s.args(), points(P)], {"issue": issue, "comment": comment}
    kind = surface_kind(s)
    if kind == INVALID or len(P) != 1 or not all(map(number, P[0])):
        op.add(category, args, INVALID, **more)
        return
    if not sure(kind, s.u, s.v, w=s.w) or s.p * s.q == 0:
        op.add(category, args, DEFINED, **more)
        return
    give(op, category, args, kind, 64 * (s.p + s.q + 2), s.P, [nearest(x) for x in at], nearest(root(squared, 2, 120)[0]), **more)


def greville(u, p):
    return [sum(F(t) for t in u[i + 1:i + p + 1]) / p for i in range(len(u) - p - 1)]


def graph(c, p, u, q, v, z):
    """S(x, y) = (x, y, z of the net): the control points stand over the Greville points, which have to be doubles."""
    g, h = greville(u, p), greville(v, q)
    if any(F(float(x)) != x for x in g + h):
        return None
    return Surface(p, q, u, v, [(float(x), float(y), z(c)) for x in g for y in h])


def held(x, lo, hi):
    return min(max(x, F(lo)), F(hi))


def surface_inversions():
    op = Operation("surface_nearest")
    c = Choices(402)
    for k in range(24):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 3)):
            u, v = dyadic(c, p), dyadic(c, q)
            flat = graph(c, p, u, q, v, lambda c: 0.5)
            if flat:
                P = tuple(F(c.between(-32, 64), 16) for _ in range(3))
                if k % 4 == 0:
                    P = (F(c.between(1, 63), 64), F(c.between(1, 63), 64), P[2])
                at = [held(P[0], u[0], u[-1]), held(P[1], v[0], v[-1])]
                inside = at == list(P[:2])
                d2 = (P[0] - at[0]) ** 2 + (P[1] - at[1]) ** 2 + (P[2] - F(1, 2)) ** 2
                surface_nearest(op, "inversion" if inside else "end_of_domain", flat, [tuple(map(float, P))], at, d2,
                                comment="a plane" if inside else "beyond the edge of a plane")
            if k < 12:
                hill = graph(c, p, u, q, v, lambda c: c.between(-8, 8) / 8.0)
                if hill:
                    at = [F(c.between(0, 16), 16), F(c.between(0, 16), 16)]
                    Q = point_of(hill, at)
                    if all(F(float(x)) == x for x in Q):
                        surface_nearest(op, "inversion", hill, [tuple(map(float, Q))], at, F(0), "qnzhou/nanospline/issues/49",
                                        "a point of the surface")
                    i, j = c.upto(1), c.upto(1)
                    corner = point_of(hill, [F(i), F(j)])
                    P = [corner[0] + (16 if i else -16), corner[1] + (16 if j else -16), corner[2]]
                    surface_nearest(op, "end_of_domain", hill, [tuple(map(float, P))], [F(i), F(j)], F(512), comment="beyond a corner")
    wall = Surface(2, 1, clamped(2, []), clamped(1, []), [(1.0, 0.0, 0.0), (1.0, 0.0, 8.0), (1.0, 1.0, 0.0), (1.0, 1.0, 8.0), (0.0, 1.0, 0.0),
                                                          (0.0, 1.0, 8.0)],
                   [1.0, 1.0, 1.0, 1.0, 2.0, 2.0])
    for k in (1, 2, 4, 8):
        for z in (-3.0, 0.0, 2.0, 5.5, 12.0):
            y = held(F(z), 0, 8)
            surface_nearest(op, "weights", wall, [(0.75 * k, 1.0 * k, z)], [F(1, 2), y / 8], (F(5 * k, 4) - 1) ** 2 + (F(z) - y) ** 2,
                            comment="a quarter of a cylinder")
    for s in (2.0**300, 2.0**-300):
        flat = Surface(1, 1, clamped(1, []), clamped(1, []), [(0.0, 0.0, 0.0), (0.0, s, 0.0), (s, 0.0, 0.0), (s, s, 0.0)])
        surface_nearest(op, "extreme_scale", flat, [(0.25 * s, 0.75 * s, 3 * s)], [F(1, 4), F(3, 4)], (3 * F(s)) ** 2)
        surface_nearest(op, "extreme_scale", flat, [(-3 * s, 0.75 * s, 4 * s)], [F(0), F(3, 4)], (5 * F(s)) ** 2)
    for p in range(1, 8):
        flat = graph(c, p, clamped(p, []), 1, clamped(1, []), lambda c: 0.0)
        if flat:
            surface_nearest(op, "degrees", flat, [(0.375, 0.625, 2.0)], [F(3, 8), F(5, 8)], F(4), comment="degree %d" % p)
    loose = graph(c, 2, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 1, clamped(1, []), lambda c: 0.0)
    for x, nearest_x in ((2.25, F(9, 4)), (1.0, F(2)), (4.0, F(3))):
        surface_nearest(op, "end_of_domain", loose, [(x, 0.5, 2.0)], [nearest_x, F(1, 2)], (F(x) - nearest_x) ** 2 + 4,
                        comment="knots not clamped, the domain is [2, 3]: may be refused")
    surface_nearest(op, "degrees", surface(c, 0, [0.0, 1.0, 2.0], 1, clamped(1, [])), [(0.0, 0.0, 0.0)], comment="degree 0: may be refused")
    flat = graph(c, 1, clamped(1, []), 1, clamped(1, []), lambda c: 0.0)
    surface_nearest(op, "bad_input", flat, [], comment="no point")
    surface_nearest(op, "bad_input", flat, control(c, 2), comment="two points")
    for bad in (NAN, INF):
        surface_nearest(op, "bad_input", flat, [(0.0, 0.0, bad)], comment="a coordinate is no number")
        surface_nearest(op, "bad_input", Surface(1, 1, flat.u, flat.v, flat.P[:3] + [(bad, 0.0, 0.0)]), [(0.0, 0.0, 0.0)],
                        comment="a control point is no number")
    surface_nearest(op, "bad_input", Surface(1, 1, flat.u, flat.v, flat.P, [1.0, -1.0, 1.0, 1.0]), [(0.0, 0.0, 0.0)], comment="a negative weight")
    surface_nearest(op, "bad_input", Surface(1, 1, flat.u, [0.0, 0.0, 1.0, 0.5], flat.P), [(0.0, 0.0, 0.0)], comment="knots decrease")
    return op


def dyadic(c, p):
    """Knots whose Greville points are doubles."""
    inner = sorted({c.between(1, 3) / 4.0 for _ in range(c.upto(2))})
    return clamped(p, inner if p != 3 else [])


def point_of(s, at):
    (W, x, y, z), _, _, _ = s.orders(float(at[0]), float(at[1]), 0, "right", "right")[0, 0]
    return [x / W, y / W, z / W]


def surface_error(op, category, f, s, r, P, issue=None, comment=None):
    args, more = [f.args(), reals(s), reals(r), points(P)], {"issue": issue, "comment": comment}
    kind = surface_kind(f)
    if kind == INVALID or len(s) * len(r) != len(P) or not P or not all(number(x) for t in [s, r] + P for x in t):
        op.add(category, args, INVALID, **more)
        return
    odd = [x for x in s if not domain(f.u, f.p)[0] <= x <= domain(f.u, f.p)[1] or (jumps(f.u, f.p, x) and f.u.count(x) > f.p)]
    odd += [x for x in r if not domain(f.v, f.q)[0] <= x <= domain(f.v, f.q)[1] or (jumps(f.v, f.q, x) and f.v.count(x) > f.q)]
    kind = worse(kind, DEFINED if f.p * f.q == 0 else VALID)
    if odd or not sure(kind, f.u, f.v, w=f.w):
        op.add(category, args, worse(kind, DEFINED), **more)
        return
    squares, sizes = [], []
    for i, x in enumerate(s):
        for j, y in enumerate(r):
            (W, *A), _, (M0, *M), _ = f.orders(x, y, 0, "right", "right")[0, 0]
            D = P[i * len(r) + j]
            squares.append(sum((a / W - F(d)) ** 2 for a, d in zip(A, D)))
            sizes.append(sum(up(m / M0, 80) + abs(F(d)) for m, d in zip(M, D)))
    K = 16 * (f.p + f.q + 2) + len(P)
    op.add(category, args, kind, [sum_of_roots(squares), nearest(root(max(squares), 2, 120)[0])],
           [(K, K * U * sum(sizes) + K * LEAST), (K, K * U * max(sizes) + K * LEAST)], **more)


def sum_of_roots(squares):
    def ends(bits):
        low = high = F(0)
        for q in squares:
            x, whole = root(q, 2, bits)
            low += x if whole else x - x / 2**(bits - 2)
            high += x if whole else x + x / 2**(bits - 2)
        return low, high
    return decided(ends)


def surface_errors():
    op = Operation("surface_error")
    c = Choices(403)
    for k in range(7):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 2)):
            u, v = plain_knots(c, p, 2), plain_knots(c, q, 2)
            f = surface(c, p, u, q, v, "short", c.of(("", "", "short")))
            s, r = steps(u, 1 + k % 3), steps(v, 2)
            surface_error(op, "plain", f, s, r, control(c, len(s) * len(r)))
            if k < 4:
                how = ("far", "tiny", "mixed", "real")[k]
                surface_error(op, "extreme_scale" if k < 3 else "plain", surface(c, p, u, q, v, how), s, r, control(c, len(s) * len(r), how),
                              comment="coordinates: " + how)
                surface_error(op, "degenerate", Surface(p, q, u, v, [f.P[0]] * len(f.P)), s, r, [f.P[0]] * (len(s) * len(r)),
                              comment="everything is one point: both are 0")
                n = repeated_knots(c, p)
                surface_error(op, "repeated_knots", surface(c, p, n, q, v), sorted(set(n)), r, control(c, len(set(n)) * len(r)))
                surface_error(op, "end_of_domain", f, [u[0], u[-1]], [v[0], v[-1]], [f.P[0], f.P[f.nv - 1], f.P[-f.nv],
                                                                                     f.P[-1]] if not f.w else control(c, 4),
                              comment="the corners are met")
                surface_error(op, "end_of_domain", f, [u[-1] + 1.0], r, control(c, len(r)), comment="outside the domain: may be refused")
                surface_error(op, "weights", Surface(p, q, u, v, f.P, weigh(c, len(f.P), c.of(("ratio", "equal")))), s, r,
                              control(c, len(s) * len(r)))
    f = surface(c, 2, clamped(2, []), 1, clamped(1, []))
    P = control(c, 6)
    for what, args in (("a datum too few", ([0.0, 0.5, 1.0], [0.0, 1.0], P[:5])), ("no data", ([], [], [])),
                       ("a parameter is NaN", ([0.0, NAN, 1.0], [0.0, 1.0], P)),
                       ("a datum is infinite", ([0.0, 0.5, 1.0], [0.0, 1.0], [(INF, 0.0, 0.0)] + P[1:])), ("no parameters in v",
                               ([0.0, 1.0], [], []))):
        surface_error(op, "bad_input", f, *args, comment=what)
    surface_error(op, "bad_input", Surface(2, 1, f.u, f.v, f.P, [-1.0] * 6), [0.0], [0.0], P[:1], comment="negative weights")
    surface_error(op, "bad_input", Surface(2, 1, f.u[::-1], f.v, f.P), [0.0], [0.0], P[:1], comment="knots decrease")
    surface_error(op, "degrees", surface(c, 0, [0.0, 1.0, 2.0], 1, clamped(1, [])), [0.5], [0.5], P[:1], comment="degree 0: may be refused")
    surface_error(op, "size", surface(c, 2, clamped(2, [0.5]), 2, clamped(2, [0.5])), [k / 16.0 for k in range(17)], [k / 8.0 for k in range(9)],
                  control(c, 153),
                  comment="17 x 9 data")
    return op


def steps(u, n):
    return [u[0] + (u[-1] - u[0]) * (k / float(n + 1)) for k in range(n + 2)]


def nov(nx, ny):
    return 2 * nx * ny - (2 * (nx + ny) - 4)


def net_counts():
    op = Operation("net_counts")

    def ask(category, nx, ny, comment=None):
        if nx < 2 or ny < 2:
            op.add(category, [nx, ny], INVALID, comment=comment)
        elif 2 * nx * ny > 2**53:
            op.add(category, [nx, ny], DEFINED, comment=comment)
        else:
            op.add(category, [nx, ny], VALID, [Count(2 * nx * ny), Count(nov(nx, ny)), Count(2 * (nx + ny) - 4)], [None] * 3, comment=comment)
    for nx in range(2, 13):
        for ny in range(2, 13):
            ask("plain", nx, ny)
    for nx, ny in ((10, 8), (20, 12), (18, 30), (20, 20), (30, 30)):
        ask("plain", nx, ny, "You 2023, tables 4.9 and 4.13")
    for nx, ny in ((2, 1000), (1000, 1000), (2**20, 2**20), (2**26, 2**26), (2, 2**51), (2**25 - 1, 2**27 + 1), (2**51, 2)):
        ask("size", nx, ny)
    for nx, ny in ((2**27, 2**26), (2**53, 2), (2**40, 2**40)):
        ask("size", nx, ny, "counts beyond 2^53: may be refused")
    for nx, ny in ((0, 0), (1, 5), (5, 1), (0, 7), (1, 1)):
        ask("bad_input", nx, ny, "a side below 2")
    return op


def walked(nx, ny):
    """Index vectors in the order of their classes: both views walked, i outer, j inner, what was met before left out."""
    place, out = {}, []
    for view in (0, 1):
        for i in range(nx):
            for j in range(ny):
                edge = i in (0, nx - 1) or j in (0, ny - 1)
                key = (i, j, 1 if edge else 2 * view)
                if key not in place:
                    place[key] = len(out) + 1
                    out.append((0 if edge else view, i, j))
    return place, out


def net_classes():
    op = Operation("net_class")
    c = Choices(404)
    for nx, ny in ((2, 2), (2, 3), (3, 3), (4, 5)):
        place, _ = walked(nx, ny)
        for view in (0, 1):
            for i in range(nx):
                for j in range(ny):
                    edge = i in (0, nx - 1) or j in (0, ny - 1)
                    op.add("seam" if edge else "plain", [nx, ny, view, i, j], VALID, [Count(place[i, j, 1 if edge else 2 * view])], [None],
                           comment="You 2023, table 4.2" if (nx, ny) == (4, 5) else None)
    for nx, ny in ((6, 7), (9, 4), (12, 9), (20, 12), (2, 17)):
        place, _ = walked(nx, ny)
        for _ in range(16):
            view, i, j = c.upto(1), c.upto(nx - 1), c.upto(ny - 1)
            edge = i in (0, nx - 1) or j in (0, ny - 1)
            op.add("seam" if edge else "plain", [nx, ny, view, i, j], VALID, [Count(place[i, j, 1 if edge else 2 * view])], [None])
    n = 2**26
    op.add("size", [n, n, 1, n - 2, n - 2], VALID, [Count(nov(n, n))], [None], comment="the last class of all")
    op.add("size", [n, n, 1, n - 1, n - 1], VALID, [Count(n * n)], [None], comment="the last corner")
    for args, what in (([1, 4, 0, 0, 0], "a side below 2"), ([4, 0, 0, 0, 0], "a side below 2"), ([4, 5, 2, 0, 0], "no such view"),
                       ([4, 5, 0, 4, 0], "i is beyond the side"),
                       ([4, 5, 0, 0, 5], "j is beyond the side"), ([4, 5, 1, 9, 9], "both are beyond")):
        op.add("bad_input", args, INVALID, comment=what)
    op.add("size", [2**27, 2**27, 0, 1, 1], DEFINED, comment="counts beyond 2^53: may be refused")
    return op


def net_nodes():
    op = Operation("net_node")
    c = Choices(405)

    def ask(category, nx, ny, k, out, comment=None):
        op.add(category, [nx, ny, k], VALID, [Count(x) for x in out[k - 1]], [None] * 3, comment=comment)
    for nx, ny in ((2, 2), (2, 3), (3, 3), (4, 5), (5, 4)):
        _, out = walked(nx, ny)
        for k in range(1, len(out) + 1):
            i, j = out[k - 1][1:]
            ask("seam" if i in (0, nx - 1) or j in (0, ny - 1) else "plain", nx, ny, k, out, "You 2023, table 4.3" if (nx, ny) == (4, 5) else None)
    for nx, ny in ((6, 7), (9, 4), (12, 9), (20, 12), (17, 2)):
        _, out = walked(nx, ny)
        for k in [1, len(out)] + [c.between(1, len(out)) for _ in range(10)]:
            i, j = out[k - 1][1:]
            ask("seam" if i in (0, nx - 1) or j in (0, ny - 1) else "plain", nx, ny, k, out)
    n = 2**26
    op.add("size", [n, n, nov(n, n)], VALID, [Count(1), Count(n - 2), Count(n - 2)], [None] * 3, comment="the last class of all")
    op.add("size", [n, n, n * n], VALID, [Count(0), Count(n - 1), Count(n - 1)], [None] * 3, comment="the last corner")
    for args, what in (([4, 5, 0], "classes begin with 1"), ([4, 5, 27], "there are 26 classes"), ([1, 5, 1], "a side below 2"),
                       ([4, 1, 1], "a side below 2"),
                       ([2, 2, 5], "there are 4 classes")):
        op.add("bad_input", args, INVALID, comment=what)
    op.add("size", [2**27, 2**27, 1], DEFINED, comment="counts beyond 2^53: may be refused")
    return op


def samples_of(a, b, n):
    knots = sorted(set(a) | set(b))
    out = [k + (m - k) * (i / float(n + 1)) for k, m in zip(knots, knots[1:]) for i in range(n + 1)]
    return out + [knots[-1]]


def seam_gap(op, category, s, t, n, issue=None, comment=None):
    args, more = [s.args(), t.args(), n], {"issue": issue, "comment": comment}
    kind = worse(surface_kind(s), surface_kind(t))
    if kind == INVALID:
        op.add(category, args, kind, **more)
        return
    same = (s.p, s.q, s.nu, s.nv, bool(s.w)) == (t.p, t.q, t.nu, t.nv, bool(t.w))
    unit = all(domain(u, p) == (0, 1) and knots_kind(p, u) == VALID for f in (s, t) for u, p in ((f.u, f.p), (f.v, f.q)))
    full = any(u.count(x) > p for f in (s, t) for u, p in ((f.u, f.p), (f.v, f.q)) for x in u[p + 1:len(u) - p - 1])
    if not same or not unit or full or n > 100 or s.p * s.q == 0 or 0 in s.w + t.w:
        op.add(category, args, DEFINED, **more)
        return
    K, most, B = 16 * (s.p + s.q + 2) + 1, F(0), F(0)
    places = [(x, y, (0, 1)) for y in samples_of(s.v, t.v, n) for x in (0.0, 1.0)] + [(x, y, (1, 0)) for x in samples_of(s.u, t.u, n) for y in (0.0,
            1.0)]
    for x, y, along in places:
        at, V, W = [], F(0), F(0)
        for f in (s, t):
            o = f.orders(x, y, 1, "right", "right")
            (g, *A), _, (M0, *M), _ = o[0, 0]
            at.append([a / g for a in A])
            _, _, (m0, *m), _ = o[along]
            V += sum(M) / M0
            W += sum(m) / M0 + (m0 * sum(M) / M0 ** 2 if f.w else 0)
        most = max(most, sum((a - b) ** 2 for a, b in zip(*at)))
        B = max(B, K * U * V + 4 * U * W)
    op.add(category, args, VALID, [nearest(root(most, 2, 120)[0])], [(K, B + K * LEAST)], **more)


def seam_gaps():
    op = Operation("seam_gap")
    c = Choices(406)
    for k in range(8):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 3)):
            u, v = unit_knots(c, p), unit_knots(c, q)
            w = "short" if k % 3 == 2 else ""
            s = surface(c, p, u, q, v, "short", w)
            t = surface(c, p, u, q, v, "short", w)
            n = (0, 1, 3, 2)[k % 4]
            seam_gap(op, "seam", s, t, n, comment="nothing in common")
            P = [a if i // s.nv in (0, s.nu - 1) or i % s.nv in (0, s.nv - 1) else b for i, (a, b) in enumerate(zip(s.P, t.P))]
            closed = Surface(p, q, u, v, P, s.w)
            seam_gap(op, "seam", s, closed, n, comment="the border in common: no gap")
            P[c.upto(s.nv - 1)] = (0.0, 0.0, 0.0)
            seam_gap(op, "seam", s, Surface(p, q, u, v, P, s.w), n, comment="one control point of the border differs")
            if k < 3:
                other = unit_knots(c, p)
                if len(other) == len(u):
                    seam_gap(op, "near_knots", s, Surface(p, q, other, v, s.P, s.w), n, comment="other knots")
                how = ("far", "tiny", "mixed")[k]
                seam_gap(op, "extreme_scale", surface(c, p, u, q, v, how), surface(c, p, u, q, v, how), 1, comment="coordinates: " + how)
    s = surface(c, 2, clamped(2, [0.5]), 1, clamped(1, []))
    seam_gap(op, "degenerate", s, s, 3, comment="one and the same surface: no gap")
    seam_gap(op, "weights", hemisphere(), Surface(2, 2, hemisphere().u, hemisphere().v, [(x, y, -z) for x, y, z in hemisphere().P], hemisphere().w),
             4,
             comment="two eighths of a sphere")
    seam_gap(op, "weights", cone(), cone(), 1, comment="a cone with itself")
    seam_gap(op, "degrees", s, surface(c, 1, clamped(1, [0.5]), 1, clamped(1, [])), 1, comment="different degrees: may be refused")
    wide = Surface(2, 1, [2 * x for x in s.u], s.v, s.P)
    seam_gap(op, "end_of_domain", s, wide, 1, comment="another domain: may be refused")
    seam_gap(op, "end_of_domain", s, surface(c, 2, clamped(2, [0.25, 0.5]), 1, clamped(1, [])), 1,
             comment="different numbers of control points: may be refused")
    for value, what in ((NAN, "NaN"), (INF, "infinite")):
        seam_gap(op, "bad_input", s, Surface(2, 1, s.u, s.v, [(value, 0.0, 0.0)] + s.P[1:]), 1, comment="a coordinate is " + what)
        seam_gap(op, "bad_input", Surface(2, 1, s.u[:3] + [value] + s.u[4:], s.v, s.P), s, 1, comment="a knot is " + what)
    seam_gap(op, "bad_input", s, Surface(2, 1, s.u, s.v, s.P[:-1]), 1, comment="a control point too few")
    seam_gap(op, "bad_input", s, Surface(2, 1, s.u, s.v, s.P, [-1.0] * len(s.P)), 1, comment="negative weights")
    return op


def unit_knots(c, p):
    return clamped(p, sorted({c.between(1, 7) / 8.0 for _ in range(c.upto(2))}))
