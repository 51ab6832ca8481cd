"""conformance_edit: frozen vectors of knot insertion, removal and degree elevation, by Boehm's formula and polar forms in rationals."""
from fractions import Fraction as F
from itertools import combinations
from math import isinf

from conformance_base import (DEFINED, INF, INVALID, LEAST, NAN, U, VALID, Choices, Count, Curve, Operation, Surface, after, curve_kind, domain,
                              fits, number,
                              surface_kind, sure, worse)
from conformance_evaluate import ARC, CIRCLE, CIRCLE_P, CIRCLE_W, GEOMDL, collapsed, cone, hemisphere
from conformance_inputs import (at_knot, bad_knots, beside_knot, curve, extreme_knots, inside, near_knots, not_clamped, outside, plain_knots,
                                repeated_knots,
                                surface)
from knots_of import clamped
from rational import nearest


def coefficients(P, w):
    """w, wx, wy, wz exactly, and what the bounds are made of: fl(w |x|), ..., w; widen() goes with it"""
    out = []
    for k, q in enumerate(P):
        g = w[k] if w else 1.0
        out.append([F(g)] + [F(g) * F(x) for x in q] + [F(g * abs(x)) for x in q] + [F(g)])
    return out


def widen(line, p):
    """What the bounds are made of becomes the greatest at most p places away: 1 - a may cancel, where a is a coefficient."""
    near = [line[max(0, i - p):i + p + 1] for i in range(len(line))]
    return [c[:4] + [max(q[k] for q in at) for k in range(4, 8)] for c, at in zip(line, near)]


def blend(a, x, y):
    """(1 - a) x + a y"""
    return [p + a * (q - p) for p, q in zip(x, y)]


def insert_once(u, p, C, x):
    """Boehm: knots and coefficients with x once more."""
    x = F(x)
    k = max(i for i in range(len(u)) if u[i] <= x)
    s = sum(t == x for t in u)
    out = []
    for i in range(len(C) + 1):
        if i <= k - p:
            out.append(C[i])
        elif i <= k - s:
            a = (x - F(u[i])) / (F(u[i + p]) - F(u[i]))
            out.append(blend(a, C[i - 1], C[i]))
        else:
            out.append(C[i - 1])
    return u[:k + 1] + [float(x)] + u[k + 1:], out


def insert(u, p, C, x, r):
    for _ in range(r):
        u, C = insert_once(u, p, C, x)
    return u, C


def remove_once(u, p, C, x):
    """What gives back the coefficients when x is inserted; None if nothing does.  The first four of each coefficient count."""
    k = max(i for i in range(len(u)) if u[i] == x)
    v = u[:k] + u[k + 1:]
    s, x, k = sum(t == x for t in v), F(x), k - 1
    out = [c[:4] for c in C[:k - p + 1]]
    for i in range(k - p + 1, k - s + 1):
        a = (x - F(v[i])) / (F(v[i + p]) - F(v[i]))
        out.append([(q - (1 - a) * b) / a for b, q in zip(out[i - 1], C[i])])
    rest = [c[:4] for c in C[k - s + 1:]]
    if out[-1] != rest[0]:
        return None
    return v, out + rest[1:]


def polar(u, p, k, C, at):
    """The polar form of the polynomial of span k at p arguments."""
    d = C[k - p:k + 1]
    for j in range(p):
        x = at[j]
        d = [blend((x - F(u[i])) / (F(u[i + p - j]) - F(u[i])), d[r], d[r + 1]) for r, i in enumerate(range(k - p + j + 1, k + 1))]
    return d[0]


def elevate(u, p, C, r):
    v, kept = [], []
    for t in u:
        if not kept or kept[-1] != t:
            kept.append(t)
            v += [t] * r
        v.append(t)
    v.sort()
    P = p + r
    out = []
    for i in range(len(v) - P - 1):
        j = next(j for j in range(i, i + P + 1) if v[j] < v[j + 1])
        k = max(m for m in range(len(u)) if u[m] == v[j])
        args = [F(t) for t in v[i + 1:i + P + 1]]
        many = {}
        for chosen in combinations(args, p):
            many[chosen] = many.get(chosen, 0) + 1
        total, count = None, 0
        for at, n in many.items():
            f = [n * x for x in polar(u, p, k, C, at)]
            total = f if total is None else [x + y for x, y in zip(total, f)]
            count += n
        out.append([x / count for x in total])
    return v, out


def listed(C, rational, K):
    """Control points and weights of a reply, with bounds; None if a number is beyond the range of doubles."""
    want, bound = [Count(len(C))], [None]
    weights = []
    for W, *rest in C:
        for h, a in zip(rest[:3], rest[3:6]):
            if not rational:
                want.append(h)
                bound.append((K, K * U * a + K * LEAST))
            else:
                v = h / W
                want.append(v)
                bound.append((K, (K * U * a + K * LEAST + abs(v) * (K * U * rest[6] + K * LEAST)) / W + K * LEAST))
        weights.append((W, rest[6]))
    want.append(Count(len(weights) if rational else 0))
    bound.append(None)
    if rational:
        want += [W for W, _ in weights]
        bound += [(K, 2 * K * U * most + 2 * K * LEAST) for _, most in weights]
    return want, bound


def knots_part(u):
    return [Count(len(u))] + list(u), [None] * (len(u) + 1)


def reply_of(degrees, knots, C, rational, K):
    want, bound = [Count(d) for d in degrees], [None] * len(degrees)
    for u in knots:
        a, b = knots_part(u)
        want += a
        bound += b
    a, b = listed(C, rational, K)
    return want + a, bound + b


def place_to_insert(u, p, x, r):
    if not number(x):
        return INVALID
    lo, hi = domain(u, p)
    if not lo <= x <= hi or sum(t == x for t in u) + r > p + 1:
        return INVALID
    return DEFINED if too_near(u, x, r) else VALID


def too_near(u, x, r):
    """The new knot would be closer than 2^-1022 to another one: there is no right value then."""
    return r > 0 and number(x) and all(map(number, u)) and any(0 < abs(F(t) - F(x)) < F(2)**-1022 for t in u)


def place_to_remove(u, p, x, tol):
    if not number(x) or not number(tol) or tol < 0:
        return INVALID
    lo, hi = domain(u, p)
    return VALID if lo < x < hi and x in u else INVALID


def give(op, category, args, kind, right, result, issue, comment):
    if not right or kind == INVALID:
        op.add(category, args, kind, issue=issue, comment=comment)
        return
    want, bound = result()
    if not fits([F(w) if not isinstance(w, Count) else F(int(w)) for w in want]):
        return
    op.add(category, args, kind, want, bound, issue=issue, comment=comment)


def is_clamped(u, p):
    """And no knot stands more than p + 1 times."""
    lo, hi = domain(u, p)
    return u[0] == lo and u[-1] == hi and not any(a == b for a, b in zip(u, u[p + 1:]))


def curve_insert(op, category, c, x, r, issue=None, comment=None):
    kind = curve_kind(c)
    if kind != INVALID:
        kind = worse(kind, place_to_insert(c.u, c.p, x, r), DEFINED if c.p == 0 else VALID)

    def result():
        u, C = insert(c.u, c.p, widen(coefficients(c.P, c.w), c.p), x, r)
        return reply_of([c.p], [u], C, bool(c.w), 16 * (c.p + r + 1))
    give(op, category, [c.args(), x, r], kind, sure(kind, c.u, w=c.w) and c.p and not too_near(c.u, x, r), result, issue, comment)


def curve_elevate(op, category, c, r, issue=None, comment=None):
    kind = curve_kind(c)
    if kind != INVALID:
        kind = worse(kind, VALID if is_clamped(c.u, c.p) and c.p and r <= 64 else DEFINED)

    def result():
        u, C = elevate(c.u, c.p, widen(coefficients(c.P, c.w), c.p), r)
        return reply_of([c.p + r], [u], C, bool(c.w), 16 * (c.p + r + 1))
    give(op, category, [c.args(), r], kind, sure(kind, c.u, w=c.w) and c.p and is_clamped(c.u, c.p) and r <= 64, result, issue, comment)


def removed(u, p, lines, x, r):
    """t and the knots and the lines of coefficients without x, t times."""
    t = 0
    while t < r and x in u:
        tried = [remove_once(u, p, C, x) for C in lines]
        if any(y is None for y in tried):
            break
        u, lines, t = tried[0][0], [y[1] for y in tried], t + 1
    return t, u, lines


def removal_reply(t, degrees, knots, C, P, w, K, tol):
    size = max(abs(F(x)) for q in P for x in q)
    want, bound = [Count(t)] + [Count(d) for d in degrees], [None] * (1 + len(degrees))
    for u in knots:
        a, b = knots_part(u)
        want += a
        bound += b
    want.append(Count(len(C)))
    bound.append(None)
    for W, *h in C:
        want += [x / W for x in h[:3]]
        bound += [(K, F(tol) + K * U * size)] * 3
    want.append(Count(len(C) if w else 0))
    bound.append(None)
    if w:
        want += [W for W, *_ in C]
        bound += [(K, 2 * K * U * max(map(F, w)) + 2 * K * LEAST)] * len(C)
    return want, bound


def curve_remove(op, category, c, x, r, tol=0.0, issue=None, comment=None):
    kind = curve_kind(c)
    if kind != INVALID:
        kind = worse(kind, place_to_remove(c.u, c.p, x, tol), DEFINED if c.p == 0 else VALID)

    def result():
        t, u, (C,) = removed(c.u, c.p, [coefficients(c.P, c.w)], x, r)
        return removal_reply(t, [c.p], [u], C, c.P, c.w, 16 * (c.p + r + 1), tol)
    give(op, category, [c.args(), x, r, tol], kind, sure(kind, c.u, w=c.w) and c.p, result, issue, comment)


def lines_of(s, C, along):
    """Coefficients in lines along a direction, and back."""
    if along == "u":
        return [[C[i * s.nv + j] for i in range(s.nu)] for j in range(s.nv)]
    return [C[i * s.nv:(i + 1) * s.nv] for i in range(s.nu)]


def together(lines, along):
    return [q for row in (zip(*lines) if along == "u" else lines) for q in row]


def edited(op, category, s, along, args, place, work, right=True, issue=None, comment=None):
    """work(u, p, lines) -> degree, knots, lines"""
    kind = surface_kind(s)
    u, p = (s.u, s.p) if along == "u" else (s.v, s.q)
    if kind != INVALID:
        kind = worse(kind, place(u, p), DEFINED if s.p * s.q == 0 else VALID)

    def result():
        degree, new, lines, finish = work(u, p, [widen(line, p) for line in lines_of(s, coefficients(s.P, s.w), along)])
        degrees = [degree, s.q] if along == "u" else [s.p, degree]
        knots = [new, s.v] if along == "u" else [s.u, new]
        return finish(degrees, knots, together(lines, along))
    give(op, category, [s.args(), along, args], kind, sure(kind, s.u, s.v, w=s.w) and s.p * s.q and right, result, issue, comment)


def surface_insert(op, category, s, along, x, r, **more):
    def work(u, p, lines):
        done = [insert(u, p, C, x, r) for C in lines]
        return p, done[0][0], [C for _, C in done], lambda d, k, C: reply_of(d, k, C, bool(s.w), 16 * (p + r + 1))
    edited(op, category, s, along, [x, r], lambda u, p: place_to_insert(u, p, x, r), work,
           right=not too_near(s.u if along == "u" else s.v, x, r), **more)


def surface_elevate(op, category, s, along, r, **more):
    def work(u, p, lines):
        done = [elevate(u, p, C, r) for C in lines]
        return p + r, done[0][0], [C for _, C in done], lambda d, k, C: reply_of(d, k, C, bool(s.w), 16 * (p + r + 1))
    u, p = (s.u, s.p) if along == "u" else (s.v, s.q)
    usable = surface_kind(s) != INVALID and is_clamped(u, p) and r <= 64
    edited(op, category, s, along, [r], lambda u, p: VALID if usable else DEFINED, work, right=usable, **more)


def surface_remove(op, category, s, along, x, r, tol=0.0, **more):
    def work(u, p, lines):
        t, new, lines = removed(u, p, lines, x, r)
        return p, new, lines, lambda d, k, C: removal_reply(t, d, k, C, s.P, s.w, 16 * (p + r + 1), tol)
    edited(op, category, s, along, [x, r, tol], lambda u, p: place_to_remove(u, p, x, tol), work, **more)


def times_left(c, u, p, x):
    return c.between(1, max(1, p + 1 - sum(t == x for t in u)))


def each_insertion(c, go, rounds):
    """(category, degree, knots, x, r)"""
    for k in range(rounds):
        for p in (1, 2, 3, c.between(1, 6)):
            u = plain_knots(c, p, 3)
            x = inside(c, u, p)
            if domain(u, p)[0] < x < domain(u, p)[1]:
                go("editing", p, u, x, times_left(c, u, p, x))
                go("editing", p, u, x, p + 1 - sum(t == x for t in u), comment="to full multiplicity: two curves in one")
            if len(u) > 2 * p + 2:
                x = at_knot(c, u, p)
                go("editing", p, u, x, 1, comment="at a knot")
            u = near_knots(c, p)
            x = beside_knot(c, u, p)
            if domain(u, p)[0] < x < domain(u, p)[1]:
                go("near_knots", p, u, x, 1)
            u = repeated_knots(c, p)
            x = at_knot(c, u, p)
            go("repeated_knots", p, u, x, p + 1 - sum(t == x for t in u))
            x = inside(c, u, p)
            go("repeated_knots", p, u, x, 1)
            u = extreme_knots(c, p)
            x = inside(c, u, p)
            if domain(u, p)[0] < x < domain(u, p)[1]:
                go("extreme_scale", p, u, x, 1)
        u = not_clamped(c, 2)
        go("end_of_domain", 2, u, c.of(domain(u, 2)), 1)
        go("end_of_domain", 2, u, inside(c, u, 2), 1)
        u = plain_knots(c, 3)
        go("end_of_domain", 3, u, domain(u, 3)[k % 2], 0, comment="nothing to be inserted: the same")
        go("end_of_domain", 3, u, domain(u, 3)[k % 2], 1, comment="beyond multiplicity p + 1")
        go("bad_input", 3, u, outside(c, u, 3), 1, comment="outside the domain")
    for p in range(1, 26, 2):
        u = clamped(p, [0.5])
        go("degrees", p, u, c.of((0.25, 0.5, 0.625)), 1 + p // 8, comment="degree %d" % p)
    u = clamped(2, [0.25, 0.5, 0.5])
    for x, r, what in ((NAN, 1, "x is NaN"), (INF, 1, "x is infinite"), (0.5, 2, "beyond multiplicity p + 1"), (0.75, 4, "beyond multiplicity p + 1"),
                       (-0.5, 1, "outside the domain"), (1.0, 1, "beyond multiplicity p + 1")):
        go("bad_input", 2, u, x, r, comment=what)
    for what, bad in bad_knots(u, 2):
        go("bad_input", 2, bad, 0.375, 1, comment=what)


def curve_insertions():
    op = Operation("curve_insert")
    c = Choices(201)

    def go(category, p, u, x, r, issue=None, comment=None):
        curve_insert(op, category, curve(c, p, u, c.of(("short", "short", "real")), c.of(("", "", "short"))), x, r, issue, comment)
    each_insertion(c, go, 6)
    for w in ("equal", "ratio", "tiny", "one huge"):
        for p in (1, 2, 3):
            u = plain_knots(c, p, 2)
            curve_insert(op, "weights", curve(c, p, u, "short", w), inside_open(c, u, p), 1, comment="weights: " + w)
    for how in ("far", "huge", "tiny", "subnormal", "mixed"):
        for p in (1, 2, 3):
            u = plain_knots(c, p, 2)
            curve_insert(op, "extreme_scale", curve(c, p, u, how), inside_open(c, u, p), 1, comment="coordinates: " + how)
    for p in (1, 2, 3, 4):
        u = plain_knots(c, p, 2)
        curve_insert(op, "degenerate", collapsed(c, p, u, c.of(("", "short"))), inside_open(c, u, p), 1)
    for k in range(1, 16):
        curve_insert(op, "weights", Curve(2, CIRCLE, CIRCLE_P, CIRCLE_W), k / 16.0, 1, comment="a circle of four arcs")
    curve_insert(op, "end_of_domain", Curve(2, [float(k) for k in range(7)], [(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (2.0, 1.0, 0.0), (3.0, 0.0, 0.0)]),
                 4.0, 1,
                 GEOMDL + "158", "knots not clamped, at the end of the domain")
    line = [(float(k), float(k), 0.0) for k in range(7)]
    for r in (1, 2):
        curve_insert(op, "editing", Curve(2, [0.0, 0.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0], line), 0.5, r, GEOMDL + "153",
                     "before it is removed again")
    for r in (1, 2):
        curve_insert(op, "editing", Curve(2, clamped(2, []), [(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (2.0, 0.0, 0.0)]), 0.5, r, GEOMDL + "135",
                     "a parabola cut in the middle")
    from_bad_nets(c, lambda one, **more: curve_insert(op, "bad_input", one, 0.375, 1, **more))
    u = clamped(3, [float(k) for k in range(1, 64)], 0.0, 64.0)
    curve_insert(op, "size", Curve(3, u, [(float(k), float(k % 7), 0.0) for k in range(67)]), 31.5, 2, comment="67 control points")
    return op


def inside_open(c, u, p):
    lo, hi = domain(u, p)
    return lo + (hi - lo) * (c.between(1, 15) / 16.0)


def from_bad_nets(c, go):
    p, u = 2, clamped(2, [0.5])
    good = curve(c, p, u)
    for value, what in ((NAN, "NaN"), (INF, "infinite")):
        go(Curve(p, u, [(value, 0.0, 0.0)] + good.P[1:]), comment="a coordinate is " + what)
        go(Curve(p, u, good.P, [1.0, value, 1.0, 1.0]), comment="a weight is " + what)
    go(Curve(p, u, good.P, [1.0, -1.0, 1.0, 1.0]), comment="a negative weight")
    go(Curve(p, u, good.P[:-1]), comment="a control point too few")
    go(Curve(p, u, good.P, [1.0] * 5), comment="a weight too many")
    go(Curve(p, u, good.P, [1.0, 0.0, 1.0, 1.0]), comment="a weight is zero: may be refused")


def curve_elevations():
    op = Operation("curve_elevate")
    c = Choices(202)

    def draw(p, u, how="short", w=""):
        return curve(c, p, u, how, w)
    for k in range(6):
        for p in (1, 2, 3):
            for r in (1, 1 + k % 3):
                u = plain_knots(c, p, 3)
                curve_elevate(op, "editing", draw(p, u, c.of(("short", "real")), c.of(("", "", "short"))), r)
            u = repeated_knots(c, p)
            curve_elevate(op, "repeated_knots", draw(p, u, "short", c.of(("", "short"))), 1)
            u = near_knots(c, p)
            curve_elevate(op, "near_knots", draw(p, u), 1)
            u = extreme_knots(c, p)
            curve_elevate(op, "extreme_scale", draw(p, u), 1)
        u = not_clamped(c, 2)
        curve_elevate(op, "end_of_domain", draw(2, u), 1, comment="not clamped: may be refused")
        for w in ("equal", "ratio", "tiny"):
            p = c.between(1, 3)
            curve_elevate(op, "weights", draw(p, plain_knots(c, p, 2), "short", w), 1, comment="weights: " + w)
        for how in (("far", "huge", "tiny", "subnormal", "mixed")[k % 5],):
            curve_elevate(op, "extreme_scale", draw(2, plain_knots(c, 2, 2), how), 1, comment="coordinates: " + how)
        curve_elevate(op, "degenerate", collapsed(c, 2, plain_knots(c, 2, 2), ""), 1)
    for p in range(1, 16):
        curve_elevate(op, "degrees", draw(p, clamped(p, [])), 1, comment="a Bezier curve of degree %d" % p)
    for r in range(0, 9):
        curve_elevate(op, "degrees", draw(2, clamped(2, [0.5])), r, comment="by %d" % r)
        curve_elevate(op, "degrees", draw(1, clamped(1, [])), r, comment="a line, by %d" % r)
    curve_elevate(op, "weights", Curve(2, CIRCLE, CIRCLE_P, CIRCLE_W), 1, comment="a circle of four arcs")
    arc = Curve(2, [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0],
                [(821.51962938, -677.395551576, 3.5410634089), (873.5806602364927, -682.3571637856359, 88.77621736805291),
                 (879.1302220964927, -582.5406209926358, 91.19699162172292), (879.1656602459713, -581.9032177447318, 91.21245004565435),
                 (879.196849813, -581.265461848, 91.2209560929)], [1.0, ARC, 1.0, 0.9999796117372515, 1.0])
    curve_elevate(op, "weights", arc, 1, GEOMDL + "125", "a quarter of a circle and a sliver keep their shape")
    for k, value in enumerate((1.0, -3.0)):
        curve_elevate(op, "editing", Curve(2, clamped(2, [0.25, 0.25 + k / 4.0]), [(float(i), value * i * i, 0.0) for i in range(5)]), 1,
                      "mfem/mfem/pull/5510", "signs are kept")
    from_bad_nets(c, lambda one, **more: curve_elevate(op, "bad_input", one, 1, **more))
    for what, bad in bad_knots(clamped(2, [0.5]), 2):
        curve_elevate(op, "bad_input", Curve(2, bad, [(1.0, 2.0, 3.0)] * 4), 1, comment=what)
    curve_elevate(op, "degrees", Curve(0, [0.0, 1.0, 2.0], [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)]), 1, comment="degree 0: may be refused")
    return op


def doubles(C):
    """All coefficients are doubles, and their products with weights are exact."""
    return all(F(nearest(x)) == x for c in C for x in c[:4])


def inserted_exactly(c, p, u, x, r, w):
    """A curve without x and the same with x, r times, in doubles: whole numbers over powers of two; None if that does not come out."""
    for _ in range(6):
        one = curve(c, p, u, "short", "short" if w else "")
        if w:
            one.w = [2.0 ** (c.upto(4) - 2) for _ in one.w]
        v, C = insert(one.u, p, coefficients(one.P, one.w), x, r)
        P = [[h / q[0] for h in q[1:4]] for q in C]
        if all(F(nearest(x)) == x for q in P for x in q) and all(F(nearest(q[0])) == q[0] for q in C):
            return Curve(p, v, [[nearest(x) for x in q] for q in P], [nearest(q[0]) for q in C] if w else [])
    return None


def dyadic_knots(c, p, n):
    inner = sorted({c.short(0, 1, 8) for _ in range(n)} - {0.0, 1.0})
    return clamped(p, inner)


def curve_removals():
    op = Operation("curve_remove")
    c = Choices(203)
    for k in range(10):
        for p in (1, 2, 3, 4):
            u = clamped(p, [0.5] * (k % 2)) if p > 1 else dyadic_knots(c, p, k % 3)
            x = c.of((0.25, 0.5, 0.75))
            most = p + 1 - sum(t == x for t in u)
            r = c.between(1, max(1, min(most, 3)))
            one = inserted_exactly(c, p, u, x, min(r, most), k % 4 == 3) if most else None
            if one:
                curve_remove(op, "editing", one, x, r, 0.0, comment="a knot that was inserted %d times comes out again" % r)
                curve_remove(op, "editing", one, x, 1, 2.0**-40, comment="once")
                curve_remove(op, "editing", one, x, r + 1, 0.0, comment="asked for more than can be")
            u = plain_knots(c, p, 3)
            if len(u) > 2 * p + 2:
                x = at_knot(c, u, p)
                curve_remove(op, "editing", curve(c, p, u, "short", c.of(("", "short"))), x, 1, 0.0, comment="a knot that is needed stays")
                curve_remove(op, "editing", curve(c, p, u), x, 1, 2.0**-30, comment="a knot that is needed stays")
        u = repeated_knots(c, 2)
        curve_remove(op, "repeated_knots", curve(c, 2, u), at_knot(c, u, 2), 2, 0.0)
        P = [(1.0, 2.0, 3.0)] * 7
        u = clamped(3, [0.25, 0.5, 0.75])
        curve_remove(op, "degenerate", Curve(3, u, P), c.of((0.25, 0.5, 0.75)), 1, 0.0, comment="all control points coincide")
        u = near_knots(c, 2)
        if not any(isinf(t) for t in u):
            curve_remove(op, "near_knots", curve(c, 2, u), at_knot(c, u, 2), 1, 0.0)
        curve_remove(op, "degenerate", Curve(1, clamped(1, [0.5]), [(0.0, 0.0, k + 0.0), (0.5, 1.0, k + 0.5), (1.0, 2.0, k + 1.0)]), 0.5, 1, 0.0,
                     comment="three points of a line")
    for scale in (2.0**900, 2.0**-900, 2.0**40):
        for p in (1, 2, 3):
            one = inserted_exactly(c, p, clamped(p, []), 0.5, 1, False)
            if one:
                curve_remove(op, "extreme_scale", Curve(p, one.u, [[x * scale for x in q] for q in one.P]), 0.5, 1, 0.0)
                curve_remove(op, "extreme_scale", Curve(p, [t * scale for t in one.u], one.P), 0.5 * scale, 1, 0.0)
    for p in range(1, 12):
        one = inserted_exactly(c, p, clamped(p, []), 0.5, 1, False)
        if one:
            curve_remove(op, "degrees", one, 0.5, 1, 0.0, comment="degree %d" % p)
    for w in ("equal", "ratio"):
        u = clamped(2, [0.25, 0.5])
        curve_remove(op, "weights", curve(c, 2, u, "short", w), 0.5, 1, 0.0, comment="weights: " + w)
    v, C = insert(clamped(2, []), 2, coefficients([(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (2.0, 0.0, 0.0)], []), 0.5, 1)
    parabola = Curve(2, v, [[nearest(x) for x in q[1:4]] for q in C])
    for r in (1, 2):
        curve_remove(op, "editing", parabola, 0.5, r, 1e-4, GEOMDL + "135", "what was inserted comes out, and the parabola is as before")
    v, C = insert(clamped(2, []), 2, coefficients([(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (2.0, 0.0, 0.0)], []), 0.5, 3)
    apart = Curve(2, v, [[nearest(x) for x in q[1:4]] for q in C])
    for r in (1, 2, 3):
        curve_remove(op, "editing", apart, 0.5, r, 0.0, GEOMDL + "176", "cut in two by insertion, and joined again by removal, %d times" % r)
    line = [(float(k), float(k), 0.0) for k in range(7)]
    v, C = insert([0.0, 0.0, 0.0, 0.25, 0.375, 0.625, 0.75, 1.0, 1.0, 1.0], 2, coefficients(line, []), 0.5, 1)
    again = Curve(2, v, [[nearest(x) for x in q[1:4]] for q in C])
    curve_remove(op, "editing", again, 0.5, 1, 0.0, GEOMDL + "153", "insert, then remove: the control points are those of before")
    v, C = insert(clamped(3, [0.5]), 3, coefficients([(0.0, 0.0, 0.0), (8.0, 16.0, 0.0), (24.0, 8.0, 8.0), (32.0, -8.0, 0.0), (40.0, 0.0, 16.0)],
                                                     []), 0.25, 2)
    cubic = Curve(3, v, [[nearest(x) for x in q[1:4]] for q in C])
    for r in (1, 2, 3):
        curve_remove(op, "editing", cubic, 0.25, r, 0.0, "BIMCoderLiang/LNLib/pull/3",
                     "a knot that was inserted twice comes out twice, not three times")
        curve_remove(op, "editing", cubic, 0.25, r, 2.0**-20, "mfem/mfem/pull/5510", "insertion and removal: the same as before")
    loose = [float(k) for k in range(7)]
    curve_remove(op, "end_of_domain", curve(c, 2, loose), 3.0, 1, 0.0, comment="knots not clamped, a knot that is needed: may be refused")
    curve_remove(op, "end_of_domain", Curve(2, loose, [(1.0, 2.0, 3.0)] * 4), 3.0, 1, 0.0,
                 comment="knots not clamped, a knot that is not: may be refused")
    u = [0.0] * 4 + [1.0, 2.0, 2.0, 3.0, 4.0] + [5.0] * 4
    P = [(0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 1.0, 0.0), (1.0, 1.0, 1.0), (1.0, 1.0, 2.0), (3.0, 1.0, 1.0), (2.0, 1.0, 2.0),
         (0.0, 4.0, 1.0)]
    v, C = insert(u, 3, coefficients(P, []), 1.5, 2)
    assert doubles(C)
    twice = Curve(3, v, [[nearest(x) for x in q[1:4]] for q in C])
    for r in (1, 2, 3):
        curve_remove(op, "editing", twice, 1.5, r, 1e-7, "ssg-aero/gbs/issues/59", "a knot that was inserted twice comes out twice")
    for x, r, tol, what in ((0.3, 1, 0.0, "no knot"), (0.0, 1, 0.0, "the left end"), (1.0, 1, 0.0, "the right end"), (NAN, 1, 0.0, "x is NaN"),
                            (0.5, 1, NAN, "the tolerance is NaN"), (0.5, 1, -1.0, "a negative tolerance"), (2.0, 1, 0.0, "outside the domain"),
                            (after(0.5), 1, 0.0, "one ulp beside a knot"), (0.5, 1, INF, "an infinite tolerance")):
        curve_remove(op, "bad_input", parabola, x, r, tol, comment=what)
    for what, bad in bad_knots(clamped(2, [0.5]), 2):
        curve_remove(op, "bad_input", Curve(2, bad, [(1.0, 2.0, 3.0)] * 4), 0.5, 1, 0.0, comment=what)
    from_bad_nets(c, lambda one, **more: curve_remove(op, "bad_input", one, 0.5, 1, 0.0, **more))
    curve_remove(op, "editing", parabola, 0.5, 0, 0.0, comment="nothing to be removed: the same")
    return op


def surface_insertions():
    op = Operation("surface_insert")
    c = Choices(204)

    def go(category, p, u, x, r, issue=None, comment=None):
        q, along = c.between(1, 2), c.of(("u", "v"))
        v = plain_knots(c, q, 1)
        w = c.of(("", "", "short"))
        s = surface(c, p, u, q, v, "short", w) if along == "u" else surface(c, q, v, p, u, "short", w)
        if len(s.P) < 60:
            surface_insert(op, category, s, along, x, r, issue=issue, comment=comment)
    each_insertion(c, go, 4)
    for along in ("u", "v"):
        for x in (0.25, 0.5, 0.8125):
            surface_insert(op, "weights", hemisphere(), along, x, 1, comment="an eighth of a sphere")
            surface_insert(op, "degenerate", hemisphere(), along, x, 2, comment="an eighth of a sphere")
            surface_insert(op, "degenerate", cone(), along, x, 1, comment="a cone: one edge is a point")
    return op


def surface_elevations():
    op = Operation("surface_elevate")
    c = Choices(205)
    for k in range(7):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 2)):
            along = "uv"[k % 2]
            u, v = plain_knots(c, p, 2), plain_knots(c, q, 2)
            surface_elevate(op, "editing", surface(c, p, u, q, v, "short", c.of(("", "", "short"))), along, 1 + (k + p) % 2)
        u, v = repeated_knots(c, 2), plain_knots(c, 1, 1)
        surface_elevate(op, "repeated_knots", surface(c, 2, u, 1, v), c.of(("u", "v")), 1)
        surface_elevate(op, "extreme_scale", surface(c, 2, extreme_knots(c, 2), 1, v, "short"), c.of(("u", "v")), 1)
        surface_elevate(op, "weights", surface(c, 2, plain_knots(c, 2, 1), 1, v, "short", c.of(("ratio", "equal"))), c.of(("u", "v")), 1)
        surface_elevate(op, "end_of_domain", surface(c, 2, not_clamped(c, 2), 1, v), "u", 1, comment="not clamped: may be refused")
    for along in ("u", "v"):
        surface_elevate(op, "weights", hemisphere(), along, 1, comment="an eighth of a sphere")
        surface_elevate(op, "degenerate", cone(), along, 1, comment="a cone: one edge is a point")
        surface_elevate(op, "degenerate", cone(), along, 0, comment="by nothing: the same")
        for what, bad in bad_knots(clamped(2, [0.5]), 2):
            surface_elevate(op, "bad_input", Surface(2, 1, bad, clamped(1, []), [(1.0, 2.0, 3.0)] * 8), along, 1, comment=what)
    return op


def surface_removals():
    op = Operation("surface_remove")
    c = Choices(206)
    for k in range(12):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 1)):
            along = "uv"[(k + p) % 2]
            base = surface(c, p, clamped(p, []), q, clamped(q, [0.5] * (k % 2)), "short")
            u, d = (base.u, p) if along == "u" else (base.v, q)
            x = c.of((0.25, 0.5, 0.75))
            if sum(t == x for t in u) > d:
                continue
            done = [insert(u, d, C, x, 1) for C in lines_of(base, coefficients(base.P, []), along)]
            C = together([C for _, C in done], along)
            if not doubles(C):
                continue
            new = done[0][0]
            P = [[nearest(t) for t in h[1:4]] for h in C]
            s = Surface(p, q, new, base.v, P) if along == "u" else Surface(p, q, base.u, new, P)
            surface_remove(op, "editing", s, along, x, 1 + k % 2, 0.0, comment="a knot that was inserted comes out again")
            s.P[c.upto(len(P) - 1)] = (9.0, -9.0, 5.0)
            surface_remove(op, "editing", s, along, x, 1, 0.0, comment="one line of control points needs it")
    flat = Surface(2, 2, clamped(2, [0.25, 0.5]), clamped(2, [0.5]), [(1.0, 2.0, 3.0)] * 20)
    for along, x in (("u", 0.25), ("u", 0.5), ("v", 0.5)):
        surface_remove(op, "degenerate", flat, along, x, 1, 0.0, comment="all control points coincide")
    loose = Surface(2, 1, [float(k) for k in range(7)], clamped(1, []), [(1.0, 2.0, 3.0)] * 8)
    surface_remove(op, "end_of_domain", loose, "u", 3.0, 1, 0.0, comment="knots not clamped: may be refused")
    for along, x, r, tol, what in (("v", 0.25, 1, 0.0, "no knot in v"), ("u", 0.3, 1, 0.0, "no knot"), ("u", 0.0, 1, 0.0, "the left end"),
                                   ("u", NAN, 1, 0.0, "x is NaN"),
                                   ("u", 0.5, 1, -1.0, "a negative tolerance"), ("v", 0.5, 1, NAN, "the tolerance is NaN")):
        surface_remove(op, "bad_input", flat, along, x, r, tol, comment=what)
    for what, bad in bad_knots(clamped(2, [0.5]), 2):
        surface_remove(op, "bad_input", Surface(2, 1, bad, clamped(1, []), [(1.0, 2.0, 3.0)] * 8), "u", 0.5, 1, 0.0, comment=what)
    return op

