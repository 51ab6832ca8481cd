"""conformance_evaluate: frozen vectors of spans, multiplicities, Greville points, bases, points, derivatives and normals."""
from fractions import Fraction as F

from conformance_base import (DEFINED, INF, INVALID, LEAST, NAN, SIDES, U, VALID, Choices, Count, Curve, Local, Operation, Surface, after, before,
                              curve_kind,
                              divided, domain, error, fits, jumps, knots_kind, number, place_kind, reals, sequence, spans, sure, surface_kind, worse)
from conformance_inputs import (at_end, at_knot, bad_knots, beside_knot, control, curve, extreme_knots, inside, near_knots, not_clamped, outside,
                                plain_knots, repeated_knots, surface)
from knots_of import BASES, clamped, high_degrees, inner_knots
from rational import nearest, root

GEOMDL, SCIPY, TINYSPLINE = "orbingol/NURBS-Python/issues/", "scipy/scipy/issues/", "msteinbeck/tinyspline/issues/"


# Knots of a public report.
TRIPLES = [1163.0] * 4 + [1163.376576706019] * 3 + [1163.376593437529] * 3 + [1164.0] * 4


def row(u, p, x, side, d):
    """All derivatives 0..d of all basis functions from a side, and their (K, B)."""
    at, zeros = Local(u, p, x, d, side), len(u) - p - 1
    want, bound = [], []
    for e in range(d + 1):
        K = 16 * (p + e + 2)
        w, b = [F(0)] * zeros, [(K, K * LEAST * 2)] * zeros
        for r in range(p + 1):
            w[at.first + r] = at.N[e][r]
            b[at.first + r] = (K, error(K, sum(at.M[e]), 1 + at.S[e][r]))
        want += w
        bound += b
    return want, bound


def one_sided(compute, side, both):
    """The wanted one and, where any side is right and the sides differ, the left one."""
    if side == "any" and both:
        right, left = compute("right"), compute("left")
        return right, left if right[0] and left[0] and [nearest(x) for x in left[0]] != [nearest(x) for x in right[0]] else None
    return compute(side), None


def give(op, category, args, kind, result, issue, comment):
    """result: (right, left), each (values, (K, B)s); nothing where something rational is beyond the range of doubles."""
    right, left = result
    if right[0] is None:
        return
    if not fits(right[0]):
        kind = worse(kind, DEFINED)
    extra = {"left": left[0], "left_bound": left[1]} if left else {}
    op.add(category, args, kind, right[0], right[1], issue=issue, comment=comment, **extra)


def basis(op, category, p, u, x, side="any", d=None, issue=None, comment=None):
    args = [p, reals(u), x, side] + ([] if d is None else [d])
    kind = knots_kind(p, u)
    if kind != INVALID:
        kind = worse(kind, place_kind(u, p, x), DEFINED if p == 0 and d is not None else VALID)
    if not sure(kind, u) or place_kind(u, p, x) != VALID:
        op.add(category, args, kind, issue=issue, comment=comment)
        return
    give(op, category, args, kind, one_sided(lambda s: row(u, p, x, s, d or 0), side, jumps(u, p, x)), issue, comment)


def quotient(orders, rational):
    D, B = divided(orders, rational)
    if D is None:
        return None, None
    return [x for a in sequence(D) for x in D[a]], [x for a in sequence(D) for x in B[a]]


def curve_value(op, category, c, x, side="any", d=None, issue=None, comment=None):
    args = [c.args(), x, side] + ([] if d is None else [d])
    kind = curve_kind(c)
    if kind != INVALID:
        kind = worse(kind, place_kind(c.u, c.p, x), DEFINED if c.p == 0 and d is not None else VALID)
    if not sure(kind, c.u, w=c.w) or place_kind(c.u, c.p, x) != VALID:
        op.add(category, args, kind, issue=issue, comment=comment)
        return
    result = one_sided(lambda s: quotient(c.orders(x, d or 0, s), bool(c.w)), side, jumps(c.u, c.p, x))
    give(op, category, args, kind, result, issue, comment)


def spans_of():
    op = Operation("span")
    c = Choices(101)

    def span(category, p, u, x, issue=None, comment=None):
        kind = knots_kind(p, u)
        kind = kind if kind == INVALID else worse(kind, place_kind(u, p, x))
        inside_it = sure(kind, u) and place_kind(u, p, x) == VALID
        op.add(category, [p, reals(u), x], kind, [Count(spans(u, p, x, "right"))] if inside_it else None, [None], issue=issue, comment=comment)
    each_place(c, span, with_side=False)
    span("end_of_domain", 2, [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 5.0, 5.0, 5.0], 5.0,
         comment="the book's example: the last span is the one before the end")
    for p in (1, 2, 3):
        u = clamped(p, [1.0, 2.0], 0.0, 3.0)
        span("end_of_domain", p, u, 3.0, "https://github.com/ssg-aero/gbs/pull/49", "at the right end the span is the one before, not the one beyond")
    span("near_knots", 3, TRIPLES, 1163.376593437529, TINYSPLINE + "175",
         "two triple knots 1.7e-5 apart are two knots")
    span("size", 3, clamped(3, [float(k) for k in range(1, 400)], 0.0, 400.0), 399.5)
    return op


def each_place(c, give_case, with_side=True, least_degree=0, rounds=9):
    """Knot vectors and parameters by category for the operations that have nothing else."""
    def go(category, p, u, x, side="any", **more):
        give_case(category, p, u, x, *((side,) if with_side else ()), **more)
    for r in range(rounds):
        for p in (1, 2, 3, c.between(least_degree, 5)):
            u = plain_knots(c, p)
            go("plain", p, u, inside(c, u, p))
            go("end_of_domain", p, u, at_end(c, u, p))
            u = plain_knots(c, p)
            go("end_of_domain", p, u, domain(u, p)[1], c.of(SIDES))
            if r < 4:
                go("end_of_domain", p, u, outside(c, u, p))
                u = not_clamped(c, p)
                go("end_of_domain", p, u, c.of((at_end(c, u, p), inside(c, u, p))))
            u = near_knots(c, p)
            go("near_knots", p, u, beside(c, u, p))
            u = repeated_knots(c, p)
            for side in SIDES if with_side else ("any",):
                go("repeated_knots", p, u, at_knot(c, u, p), side)
            u = extreme_knots(c, p)
            go("extreme_scale", p, u, c.of((inside(c, u, p), at_knot(c, u, p))))
    for p in range(least_degree, 26):
        u = clamped(p, inner_knots(c, c.upto(2), 1, 16))
        go("degrees", p, u, inside(c, u, p), comment="degree %d" % p)
        if p % 3 == 1:
            u = clamped(p, [0.5] * min(p, 9))
            go("degrees", p, u, 0.5, "left")
            go("degrees", p, u, inside(c, u, p))
    for p, u, why in BASES:
        if p >= least_degree:
            go("repeated_knots" if "mult" in why else "plain", p, u, inside(c, u, p), comment=why)
            go("end_of_domain", p, u, domain(u, p)[1], comment=why)
    for zero in (0.0, -0.0):
        for p, u in ((2, clamped(2, [-0.0, 0.0, -0.0], -1.0)), (1, [-0.0, 0.0, 1.0, 1.0]), (3, [-0.0, 0.0, -0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 1.0])):
            go("near_knots", p, u, zero, comment="zeros of both signs are one knot")
    for p in (2, 3):
        u = plain_knots(c, p) if p == 3 else clamped(2, [0.25, 0.5])
        for what, bad in bad_knots(u, p):
            go("bad_input", p, bad, 0.5, comment=what)
        for x, what in ((NAN, "the parameter is NaN"), (INF, "the parameter is infinite"), (-INF, "the parameter is minus infinity")):
            go("bad_input", p, u, x, comment=what)
        go("bad_input", p, u[:2 * p + 1], 0.5, comment="too few knots")
        go("bad_input", p, [], 0.5, comment="no knots")
        go("bad_input", p + len(u), u, 0.5, comment="a degree that the knots are too few for")


def beside(c, u, p):
    lo, hi = domain(u, p)
    return min(max(beside_knot(c, u, p), lo), hi)


def multiplicities():
    op = Operation("multiplicity")
    c = Choices(102)

    def count(category, p, u, x, issue=None, comment=None):
        bad = not number(x) or not u or not all(map(number, u)) or any(a > b for a, b in zip(u, u[1:]))
        kind = INVALID if bad else VALID
        op.add(category, [reals(u), x], kind, None if bad else [Count(sum(t == x for t in u))], [None], issue=issue, comment=comment)
    each_place(c, count, with_side=False, rounds=5)
    for x in (0.0, -0.0):
        count("near_knots", 1, [-2.0, -1.0, -0.0, -0.0, 0.0, 1.0, 3.0], x, "hyrodium/BasicBSpline.jl/issues/282",
              "zeros of both signs count together")
    for x in (1163.376576706019, 1163.376593437529):
        count("near_knots", 3, TRIPLES, x, TINYSPLINE + "175", "two triple knots 1.7e-5 apart, not one of multiplicity six")
    for x in (0.0, 0.5, 1.0, 0.25):
        count("repeated_knots", 2, clamped(2, [0.5, 0.5]), x, "pradeep-pyro/tinynurbs/issues/10", "the count of equal knots")
    return op


def grevilles():
    op = Operation("greville")
    c = Choices(103)

    def points_of(category, p, u, issue=None, comment=None):
        kind = knots_kind(p, u)
        if not sure(kind, u) or p == 0:
            op.add(category, [p, reals(u)], worse(kind, DEFINED), issue=issue, comment=comment)
            return
        parts = [[F(t) for t in u[i + 1:i + p + 1]] for i in range(len(u) - p - 1)]
        K = 4 * (p + 2)
        op.add(category, [p, reals(u)], kind, [sum(t) / p for t in parts], [(K, K * U * max(map(abs, t))) for t in parts], issue=issue,
               comment=comment)
    for _ in range(14):
        for p in (1, 2, 3, c.between(1, 6)):
            points_of("plain", p, plain_knots(c, p))
            points_of("near_knots", p, near_knots(c, p))
            points_of("repeated_knots", p, repeated_knots(c, p))
            points_of("extreme_scale", p, extreme_knots(c, p))
        points_of("end_of_domain", 2, not_clamped(c, 2))
    for p in range(0, 26):
        points_of("degrees", p, clamped(p, inner_knots(c, 2, 1, 16)), comment="degree %d" % p)
    for p, u, why in BASES:
        points_of("plain", p, u, comment=why)
    for what, bad in bad_knots(clamped(3, [0.25, 0.5]), 3):
        points_of("bad_input", 3, bad, comment=what)
    points_of("bad_input", 3, [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0], comment="too few knots")
    points_of("end_of_domain", 3, [0.0] * 4 + [0.01092385, 0.02200375, 0.03316167, 0.04435861, 0.05526295, 0.0663331, 0.07748615, 0.08868065,
                                               0.09989588,
              0.11080936, 0.12188408, 0.13303942, 0.14423507, 0.15545087, 0.16636463, 0.1774395, 0.1885949, 0.19979059] + [0.2] * 4,
              "SINTEF/Splipy/issues/44", "the last Greville point is the end of the domain, not a rounding beyond it")
    points_of("size", 3, clamped(3, [float(k) for k in range(1, 300)], 0.0, 300.0))
    points_of("extreme_scale", 2, clamped(2, [1e308], -1e308, 1.7e308), comment="a sum of knots overflows, their mean does not")
    return op


def bases():
    op = Operation("basis")
    each_place(Choices(104), lambda category, p, u, x, side="any", **more: basis(op, category, p, u, x, side, **more), rounds=8)
    end = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0]
    for side in SIDES:
        basis(op, "end_of_domain", 2, end, 5.0, side, issue=GEOMDL + "117", comment="at the right end the last function is 1")
        basis(op, "end_of_domain", 3, clamped(3, [1.0, 2.0, 3.0], 0.0, 4.0), 4.0, side, issue=SCIPY + "20888",
              comment="the last function is 1 at the end")
        basis(op, "end_of_domain", 1, [0.0, 0.0, 1.0, 1.0], 1.0, side, issue="HoBeZwe/NURBS.jl/issues/9", comment="the last function is 1 at the end")
        basis(op, "end_of_domain", 3, clamped(3, [25.0, 35.0, 55.0, 65.0], 0.0, 85.0), 85.0, side, issue="johntfoster/bspline/issues/1",
              comment="the last function is 1 at the end, not 0")
    basis(op, "bad_input", 2, [1.0, 2.0, 3.0, 4.0], 3.5, issue="gismo/gismo/issues/478", comment="four knots are too few for degree 2")
    for x in (1.25, 2.5):
        basis(op, "end_of_domain", 2, [float(k) for k in range(7)], x, issue=SCIPY + "16448",
              comment="knots not clamped; 1.25 is outside the domain [2, 4]")
    for x in (3 * 2.0**-53, 0.5, 1.0 - 2.0**-53):
        basis(op, "end_of_domain", 0, [0.0, 0.5, 1.0], x)
    for x in (1163.376576706019, 1163.376593437529, 1163.37658):
        basis(op, "near_knots", 3, TRIPLES, x, issue=TINYSPLINE + "175", comment="knots 1.7e-5 apart")
    return op


def basis_derivatives():
    op = Operation("basis_ders")
    c = Choices(105)
    each_place(c, lambda category, p, u, x, side="any", **more: basis(op, category, p, u, x, side, c.of((0, 1, 1, 2, 2, 3, 3, p)) if p < 9 else 3,
                                                                      **more),
               rounds=7, least_degree=1)
    end = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0]
    for side in SIDES:
        basis(op, "end_of_domain", 2, end, 5.0, side, 1, GEOMDL + "117", "value and derivative at the right end, from inside")
    for x in (1163.376576706019, 1163.376593437529, 1163.37658):
        basis(op, "near_knots", 3, TRIPLES, x, "any", 2, TINYSPLINE + "175", "knots 1.7e-5 apart")
    u = clamped(4, [0.2, 0.4, 0.6, 0.8])
    for x in (0.2, 0.4, 0.8, 1.0):
        for side in SIDES:
            basis(op, "repeated_knots", 4, u, x, side, 4, TINYSPLINE + "220", "the fourth derivative of degree 4 jumps at every knot")
    basis(op, "plain", 2, clamped(2, [0.5]), 0.25, "any", 5, comment="derivatives beyond the degree are 0")
    basis(op, "degrees", 0, [0.0, 0.5, 1.0], 0.25, "any", 1, comment="degree 0: may be refused")
    return op


ARC = 0.7071067811865476
CIRCLE = [0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0]
CIRCLE_P = [(1.0, 0.0, 2.0), (1.0, 1.0, 2.0), (0.0, 1.0, 2.0), (-1.0, 1.0, 2.0), (-1.0, 0.0, 2.0), (-1.0, -1.0, 2.0), (0.0, -1.0, 2.0),
            (1.0, -1.0, 2.0),
            (1.0, 0.0, 2.0)]
CIRCLE_W = [1.0, ARC] * 4 + [1.0]


def each_curve(c, go, rounds, least_degree):
    """(category, curve, parameter, side)"""
    for r in range(rounds):
        for p in (1, 2, 3, c.between(least_degree, 5)):
            w = c.of(("", "", "short"))
            u = plain_knots(c, p)
            one = curve(c, p, u, c.of(("short", "short", "real")), w)
            go("plain", one, inside(c, u, p))
            go("end_of_domain", one, at_end(c, u, p))
            go("end_of_domain", one, domain(u, p)[r % 2], c.of(SIDES))
            if r % 3 == 0:
                go("end_of_domain", one, outside(c, u, p))
                u = not_clamped(c, p)
                go("end_of_domain", curve(c, p, u), c.of((at_end(c, u, p), inside(c, u, p))))
            u = near_knots(c, p)
            go("near_knots", curve(c, p, u, "short", w), beside(c, u, p))
            u = repeated_knots(c, p)
            one = curve(c, p, u, "short", w)
            x = at_knot(c, u, p)
            for side in SIDES:
                go("repeated_knots", one, x, side)
            u = extreme_knots(c, p)
            go("extreme_scale", curve(c, p, u), c.of((inside(c, u, p), at_knot(c, u, p))))
            u = plain_knots(c, p)
            for how in (c.of(("far", "far", "huge")), c.of(("tiny", "subnormal", "mixed"))):
                go("extreme_scale", curve(c, p, u, how, c.of(("", "", "short"))), inside(c, u, p), comment="coordinates: " + how)
            for w in (c.of(("equal", "ratio")), c.of(("tiny", "one huge"))):
                go("weights", curve(c, p, u, "short", w), c.of((inside(c, u, p), at_knot(c, u, p))), comment="weights: " + w)
            go("degenerate", collapsed(c, p, u, c.of(("", "short"))), c.of((inside(c, u, p), at_end(c, u, p))))
    for p in range(least_degree, 26):
        u = clamped(p, inner_knots(c, c.upto(2), 1, 16))
        go("degrees", curve(c, p, u, "short", c.of(("", "short"))), inside(c, u, p), comment="degree %d" % p)
    for k in range(17):
        go("weights", Curve(2, CIRCLE, CIRCLE_P, CIRCLE_W), k / 16.0, comment="a circle of four arcs")
    bad_curves(c, go)


def collapsed(c, p, u, w):
    """Control points that coincide, all or some, or lie on a line."""
    n, how = len(u) - p - 1, c.upto(2)
    P = control(c, n)
    if how == 0:
        P = [P[0]] * n
    elif how == 1:
        k = c.upto(n - 2)
        P[k + 1] = P[k]
    else:
        P = [(float(k), 2.0 * k, -0.5 * k) for k in range(n)]
    from conformance_inputs import weigh
    return Curve(p, u, P, weigh(c, n, w))


def bad_curves(c, go):
    for p, w in ((2, ""), (3, "short")):
        u = clamped(p, [0.25, 0.5])
        good = curve(c, p, u, "short", w)
        for what, bad in bad_knots(u, p):
            go("bad_input", Curve(p, bad, good.P, good.w), 0.5, comment=what)
        for x, what in ((NAN, "the parameter is NaN"), (INF, "the parameter is infinite")):
            go("bad_input", good, x, comment=what)
        for value, what in ((NAN, "NaN"), (INF, "infinite"), (-INF, "minus infinity")):
            at = c.upto(len(good.P) - 1)
            P = list(good.P)
            P[at] = (P[at][0], value, P[at][2])
            go("bad_input", Curve(p, u, P, good.w), 0.5, comment="a coordinate is " + what)
            go("bad_input", Curve(p, u, good.P, [1.0] * at + [value] + [1.0] * (good.n - at - 1)), 0.5, comment="a weight is " + what)
        go("bad_input", Curve(p, u, good.P, [1.0] * (good.n - 1) + [-1.0]), 0.5, comment="a negative weight")
        go("bad_input", Curve(p, u, good.P[:-1], good.w[:-1]), 0.5, comment="a control point too few")
        go("bad_input", Curve(p, u, good.P + good.P[:1], (good.w + [1.0])[:good.n + 1] if good.w else []), 0.5, comment="a control point too many")
        go("bad_input", Curve(p, u, good.P, [1.0] * (good.n - 1)), 0.5, comment="a weight too few")
        go("bad_input", Curve(p, u[:2 * p + 1], good.P[:p], []), 0.5, comment="too few knots")
        go("bad_input", Curve(p, u, [], []), 0.5, comment="no control points")
        zero = Curve(p, u, good.P, [1.0] * (good.n - 2) + [0.0, 1.0])
        go("weights", zero, 0.75, comment="a weight is zero: may be refused")
        go("weights", Curve(p, u, good.P, [0.0] * good.n), 0.75, comment="all weights are zero: no right value")
        go("weights", Curve(p, clamped(p, []), good.P[:p + 1], [0.0] + [1.0] * p), 0.0, comment="the only weight that counts is zero")


def curves():
    op = Operation("curve_point")
    c = Choices(106)
    each_curve(c, lambda category, one, x, side="any", **more: curve_value(op, category, one, x, side, **more), 10, 0)
    for k in range(16):
        curve_value(op, "plain", Curve(3, clamped(3, []), [(0.0, 0.0, 0.0), (1.0, 2.0, 0.0), (3.0, 2.0, 1.0), (4.0, 0.0, 1.0)]), k / 15.0,
                    comment="a Bezier cubic")
    from_trackers(op, None)
    long = clamped(3, [float(k) for k in range(1, 256)], 0.0, 256.0)
    many = Curve(3, long, [(float(k), float(k % 7), float(k % 3)) for k in range(259)])
    for x in (0.0, 100.0, 100.5, 255.99, 256.0):
        curve_value(op, "size", many, x, comment="259 control points")
    for x in (1.0, 3.5):
        curve_value(op, "degrees", Curve(0, [0.0, 1.0, 2.0, 4.0], [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0)]), x,
                    comment="degree 0 is a step")
    return op


def curve_derivatives():
    op = Operation("curve_ders")
    c = Choices(107)
    each_curve(c, lambda category, one, x, side="any", **more: curve_value(op, category, one, x, side, c.of((0, 1, 1, 2, 2, 3, 3)), **more), 6, 1)
    from_trackers(op, 2)
    for x in (0.2, 0.4, 0.6, 0.8, 1.0):
        for side in SIDES:
            curve_value(op, "repeated_knots", Curve(4, clamped(4, [0.2, 0.4, 0.6, 0.8]), [(k / 8.0, 0.0, 0.0) for k in range(9)]), x, side, 4,
                        TINYSPLINE + "220", "the fourth derivative is a step")
    one = Curve(3, clamped(3, [1.0] * 4 + [2.0] * 4, 0.0, 3.0), control(c, 12))
    for x in (1.0, 2.0):
        for side in SIDES:
            curve_value(op, "repeated_knots", one, x, side, 2, TINYSPLINE + "99", "knots of multiplicity order: pieces of their own")
    return op


def from_trackers(op, d):
    """Cases that were told in public, in our words."""
    end = Curve(2, [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0], [(float(k), float(k * k), 0.0) for k in range(7)])
    for x in (0.0, 5.0):
        curve_value(op, "end_of_domain", end, x, "any", d, GEOMDL + "117", "x at an end is the first or last control point")
    line = [(-2.0, -4.0, 0.0), (-1.0, -4.0, 2.0), (0.0, -4.0, 0.0), (1.0, -4.0, 0.0), (2.0, -4.0, 0.0)]
    for x in (0.0, 0.5, 1.0):
        curve_value(op, "bad_input", Curve(2, [0.0] * 4 + [1.0] * 4, line, [1.0] * 5), x, "any", d, GEOMDL + "180",
                    "end knots of multiplicity p + 2: the outer functions vanish; may be refused")
    square = [(1.0, 1.0, 0.0), (1.0, -1.0, 0.0), (-1.0, -1.0, 0.0), (-1.0, 1.0, 0.0)]
    for x in (3.0, 3.25, 4.0, 2.5, 5.0):
        curve_value(op, "end_of_domain", Curve(3, [float(k) for k in range(8)], square), x, "any", d, GEOMDL + "115",
                    "uniform knots, not clamped: the domain is [3, 4]")
    for x in (1.25, 2.5, 2.0, 4.0):
        curve_value(op, "end_of_domain", Curve(2, [float(k) for k in range(7)], [(-1.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 0.0, 0.0),
                                                                                 (-1.0, 0.0, 0.0)]), x,
                    "any", d, SCIPY + "16448", "knots not clamped: the domain is [2, 4]")
    curve_value(op, "end_of_domain", Curve(3, clamped(3, [0.25, 0.5, 0.75]), [(float(k), 1.0, 0.0) for k in range(7)]), -1e-5, "any", d,
                TINYSPLINE + "222",
                "just below the domain: anything finite, or a refusal, but an answer")
    some = Curve(3, TRIPLES, [(float(k), float(k % 2), 0.0) for k in range(10)])
    for x in (1163.376576706019, 1163.376585, 1163.376593437529):
        curve_value(op, "near_knots", some, x, "any", d, TINYSPLINE + "175",
                    "triple knots 1.7e-5 apart: the curve runs through a control point at each")
    dense = Curve(3, clamped(3, [k / 8.0 for k in range(1, 8)]), [(float(k), float(k * k % 5), 0.0) for k in range(11)])
    for x in (0.25 + 1e-5, 0.25 - 1e-5, 0.5 + 1e-7, 0.625 - 1e-9):
        curve_value(op, "near_knots", dense, x, "any", d, TINYSPLINE + "252", "a parameter near a knot is not that knot")
    arc = Curve(2, [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0],
                [(821.51962938, -677.395551576, 3.5410634089), (873.5806602364927, -682.3571637856359, 88.77621736805291),
                 (879.1302220964927, -582.5406209926358, 91.19699162172292), (879.1656602459713, -581.9032177447318, 91.21245004565435),
                 (879.196849813, -581.265461848, 91.2209560929)], [1.0, ARC, 1.0, 0.9999796117372515, 1.0])
    for x in (0.25, 0.5, 0.75):
        curve_value(op, "weights", arc, x, "any", d, GEOMDL + "125", "a quarter of a circle and a sliver")


def surface_value(op, category, s, x, y, side_u="any", side_v="any", d=None, issue=None, comment=None):
    kind = surface_kind(s)
    usable = kind != INVALID
    if usable:
        at = (place_kind(s.u, s.p, x), place_kind(s.v, s.q, y))
        kind = worse(kind, *at, DEFINED if s.p * s.q == 0 and d is not None else VALID)
        jump = at == (VALID, VALID) and (("any" == side_u and jumps(s.u, s.p, x)) or ("any" == side_v and jumps(s.v, s.q, y)))
    args = [s.args(), x, y, side_u, side_v] + ([] if d is None else [d])
    if not usable or not sure(kind, s.u, s.v, w=s.w) or at != (VALID, VALID):
        op.add(category, args, kind, issue=issue, comment=comment)
        return

    def compute(side):
        return quotient(s.orders(x, y, d or 0, side if side_u == "any" else side_u, side if side_v == "any" else side_v), bool(s.w))
    give(op, category, args, kind, one_sided(compute, "any", jump), issue, comment)


def each_surface(c, go, rounds, least_degree, sided=True):
    """(category, surface, x, y, side_u, side_v)"""
    for r in range(rounds):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 3), (c.between(least_degree, 4), c.between(least_degree, 3))):
            u, v = plain_knots(c, p, 2), plain_knots(c, q, 2)
            w = c.of(("", "", "short"))
            one = surface(c, p, u, q, v, c.of(("short", "short", "real")), w)
            go("plain", one, inside(c, u, p), inside(c, v, q))
            go("end_of_domain", one, domain(u, p)[r % 2], at_end(c, v, q))
            go("end_of_domain", one, inside(c, u, p), domain(v, q)[1], c.of(SIDES), c.of(SIDES))
            if r % 3 == 0:
                go("end_of_domain", one, outside(c, u, p), inside(c, v, q))
                go("end_of_domain", one, inside(c, u, p), outside(c, v, q))
                n = not_clamped(c, p)
                go("end_of_domain", surface(c, p, n, q, v), c.of((at_end(c, n, p), inside(c, n, p))), inside(c, v, q))
            n = near_knots(c, p)
            go("near_knots", surface(c, p, n, q, v), beside(c, n, p), inside(c, v, q))
            if p <= 2:
                n, m = repeated_knots(c, p), repeated_knots(c, q)
                one = surface(c, p, n, q, m)
                x, y = at_knot(c, n, p), at_knot(c, m, q)
                for sides in (("any", "right"), ("any", "any"), ("right", "left"), ("left", "left")) if sided else (("any", "any"),):
                    go("repeated_knots", one, x, y, *sides)
            n = extreme_knots(c, p)
            go("extreme_scale", surface(c, p, n, q, v), inside(c, n, p), inside(c, v, q))
            how = c.of(("far", "huge", "tiny", "subnormal", "mixed"))
            go("extreme_scale", surface(c, p, u, q, v, how), inside(c, u, p), inside(c, v, q), comment="coordinates: " + how)
            w = c.of(("equal", "ratio", "tiny", "one huge"))
            go("weights", surface(c, p, u, q, v, "short", w), inside(c, u, p), inside(c, v, q), comment="weights: " + w)
            one = surface(c, p, u, q, v)
            pole = Surface(p, q, u, v, [one.P[0] if k < one.nv else P for k, P in enumerate(one.P)])
            go("degenerate", pole, domain(u, p)[c.upto(1)], inside(c, v, q), comment="one edge is a point")
            go("degenerate", pole, inside(c, u, p), inside(c, v, q), comment="one edge is a point")
            if r % 2:
                go("degenerate", Surface(p, q, u, v, [one.P[0]] * len(one.P)), inside(c, u, p), inside(c, v, q),
                   comment="all control points coincide")
            else:
                go("degenerate", Surface(p, q, u, v, [one.P[k % one.nv] for k in range(len(one.P))]), inside(c, u, p), inside(c, v, q),
                   comment="a surface that is a curve")
            closed = one.P[:len(one.P) - one.nv] + one.P[:one.nv]
            for x in domain(u, p):
                go("seam", Surface(p, q, u, v, closed), x, inside(c, v, q), comment="closed in u: both ends are one curve")
    for p in range(least_degree, 26, 1 if least_degree == 0 else 3):
        q = (p + 1) % 3 + (1 if least_degree else 0)
        u, v = clamped(p, []), clamped(q, [])
        go("degrees", surface(c, p, u, q, v), inside(c, u, p), inside(c, v, q), comment="degrees %d and %d" % (p, q))
        if p % 5 == 4:
            go("degrees", surface(c, q, v, p, u), inside(c, v, q), inside(c, u, p), comment="degrees %d and %d" % (q, p))
    bad_surfaces(c, go)


def bad_surfaces(c, go):
    p, q = 2, 1
    u, v = clamped(2, [0.5]), clamped(1, [0.25])
    for w in ("", "short"):
        good = surface(c, p, u, q, v, "short", w)
        for what, bad in bad_knots(u, p):
            go("bad_input", Surface(p, q, bad, v, good.P, good.w), 0.5, 0.5, comment=what + ", in u")
        for what, bad in bad_knots(v, q):
            go("bad_input", Surface(p, q, u, bad, good.P, good.w), 0.5, 0.5, comment=what + ", in v")
        for bad in (NAN, INF):
            go("bad_input", good, bad, 0.5, comment="a parameter is no number")
            go("bad_input", good, 0.5, bad, comment="a parameter is no number")
            at = c.upto(len(good.P) - 1)
            P = list(good.P)
            P[at] = (P[at][0], P[at][1], bad)
            go("bad_input", Surface(p, q, u, v, P, good.w), 0.5, 0.5, comment="a coordinate is no number")
            go("bad_input", Surface(p, q, u, v, good.P, [1.0] * at + [bad] + [1.0] * (len(P) - at - 1)), 0.5, 0.5, comment="a weight is no number")
        go("bad_input", Surface(p, q, u, v, good.P, [1.0] * (len(good.P) - 1) + [-0.5]), 0.5, 0.5, comment="a negative weight")
        go("bad_input", Surface(p, q, u, v, good.P[:-1], good.w[:-1]), 0.5, 0.5, comment="a control point too few")
        go("bad_input", Surface(p, q, u, v, good.P[:-3], good.w[:-3]), 0.5, 0.5, comment="a row too few")
        go("bad_input", Surface(p, q, u, v, good.P, [1.0] * 3), 0.5, 0.5, comment="weights too few")
        go("bad_input", Surface(p, q, u[:5], v, good.P[:2], []), 0.5, 0.5, comment="too few knots in u")
        go("bad_input", Surface(p, q, u, v[:3], good.P[:4], []), 0.5, 0.5, comment="too few knots in v")
        go("weights", Surface(p, q, u, v, good.P, [0.0] + [1.0] * (len(good.P) - 1)), 0.25, 0.5, comment="a weight is zero: may be refused")


def hemisphere():
    """A quarter turn of a quarter circle: degree 2 in both, one edge is the pole."""
    rows = []
    for (r, z), a in (((1.0, 0.0), 1.0), ((1.0, 1.0), ARC), ((0.0, 1.0), 1.0)):
        for (x, y), b in (((1.0, 0.0), 1.0), ((1.0, 1.0), ARC), ((0.0, 1.0), 1.0)):
            rows.append(((r * x, r * y, z), a * b))
    return Surface(2, 2, clamped(2, []), clamped(2, []), [P for P, _ in rows], [w for _, w in rows])


def cone():
    """A line turned about the axis that it meets: its tip is an edge of no length."""
    return Surface(1, 2, clamped(1, []), clamped(2, []), [(0.0, 0.0, 1.0)] * 3 + [(1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)],
                   [1.0, ARC, 1.0] * 2)


def surfaces():
    op = Operation("surface_point")
    c = Choices(108)
    each_surface(c, lambda category, s, x, y, a="any", b="any", **more: surface_value(op, category, s, x, y, a, b, **more), 5, 0)
    for k in range(9):
        surface_value(op, "weights", hemisphere(), k / 8.0, (k * 3 % 8) / 8.0, comment="an eighth of a sphere")
        surface_value(op, "degenerate", hemisphere(), 1.0, k / 8.0, comment="the pole of a sphere")
    flat = [(-17.5, 0.0, 0.0)] * 3
    rows = [(52.5, 60.0, 0.0), (52.5, 60.0, 60.0), (52.5, 0.0, 60.0), (17.5, 60.0, 0.0), (17.5, 60.0, 60.0), (17.5, 0.0, 60.0), (17.5, 0.0, 0.0),
            (17.5, 0.0, 0.0), (17.5, 0.0, 0.0)] + flat + [(-52.5, 0.0, 0.0)] * 3
    some = Surface(2, 2, clamped(2, [0.25, 0.5]), clamped(2, []), rows)
    for x in (0.0, 0.25, 0.5, 0.75, 1.0):
        for y in (0.0, 0.5, 1.0):
            surface_value(op, "degenerate", some, x, y, issue=GEOMDL + "168", comment="rows of control points that coincide")
    u, v = clamped(3, [0.5]), clamped(3, [1.570796326795] * 3 + [2.356194490192], 1.408501368196, 2.856730419592)
    shell = Surface(3, 3, u, v, [(float(i - 2), float(j * i % 5), 1.94) for i in range(5) for j in range(8)])
    for y in (1.408501368196, 1.570796326795, 2.0, 2.856730419592):
        surface_value(op, "repeated_knots", shell, 0.0, y, issue=GEOMDL + "175", comment="parameters are the knots' own, not scaled to [0, 1]")
    lofted = Surface(3, 3, clamped(3, []), clamped(3, [0.85]), [(float(i), float(i * j % 3), j * 1.75) for i in range(4) for j in range(5)])
    for y in (0.85, 0.85 + 1e-10, 0.85 - 1e-10):
        surface_value(op, "near_knots", lofted, 0.0, y, issue="SINTEF/Splipy/issues/168", comment="a parameter 1e-10 beside a knot is not that knot")
    grid = Surface(3, 2, clamped(3, [float(k) for k in range(1, 24)], 0.0, 24.0), clamped(2, [float(k) for k in range(1, 8)], 0.0, 8.0),
                   [(float(i), float(j), float(i * j % 5)) for i in range(27) for j in range(10)])
    for x, y in ((0.0, 0.0), (11.5, 3.25), (24.0, 8.0), (12.0, 4.0)):
        surface_value(op, "size", grid, x, y, comment="27 x 10 control points")
    return op


def surface_derivatives():
    op = Operation("surface_ders")
    c = Choices(109)
    each_surface(c, lambda category, s, x, y, a="any", b="any", **more: surface_value(op, category, s, x, y, a, b, c.of((0, 1, 1, 1, 2, 2, 3)),
                                                                                      **more), 3, 1)
    for k in range(5):
        surface_value(op, "weights", hemisphere(), k / 4.0, 0.5, d=2, comment="an eighth of a sphere")
        surface_value(op, "degenerate", cone(), 0.0, k / 4.0, d=2, issue="solvespace/solvespace/pull/736", comment="the tip of a cone: S_v = 0")
    return op


def normal_of(s, x, y, side):
    """The correctly rounded normal and its (K, B); whether it can be told from none.  () where the cross product is 0, None where something
    is out of range."""
    D, E = divided(s.orders(x, y, 1, side, side), bool(s.w))
    if D is None:
        return None
    exact = cross(D[1, 0], D[0, 1])
    if not any(exact):
        return ()
    l2 = sum(t * t for t in exact)
    n = []
    for t in exact:
        r = nearest(root(t * t / l2, 2, 120)[0])
        n.append(-r if t < 0 else r)
    if not fits(D[1, 0] + D[0, 1]) or any(B == INF for _, B in E[1, 0] + E[0, 1]):
        return None
    a, b = [F(nearest(t)) for t in D[1, 0]], [F(nearest(t)) for t in D[0, 1]]
    alpha, beta = [B for _, B in E[1, 0]], [B for _, B in E[0, 1]]
    K = 16 * (s.p + s.q + 4)
    e, lost = [], LEAST * max(1, max(map(abs, a)) * max(map(abs, b)))
    for i, j in ((1, 2), (2, 0), (0, 1)):
        e.append(abs(a[i]) * beta[j] + alpha[i] * abs(b[j]) + abs(a[j]) * beta[i] + alpha[j] * abs(b[i])
                 + K * U * (abs(a[i] * b[j]) + abs(a[j] * b[i])) + K * lost)
    length = root(sum(t * t for t in cross(a, b)), 2, 120)[0]
    if any(p and not F(2)**-400 < p < F(2)**480 for p in map(abs, a + b)) or length == 0:
        return None                              # products of doubles near the ends of their range
    m = [abs(F(t)) for t in n]
    along = sum(p * q for p, q in zip(m, e))
    return n, [(K, (p + q * along) / length + K * U * q + K * LEAST) for p, q in zip(e, m)], length > 2**10 * sum(e)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normal(op, category, s, x, y, issue=None, comment=None):
    args = [s.args(), x, y]
    kind = surface_kind(s)
    at = (VALID, VALID)
    if kind != INVALID:
        at = (place_kind(s.u, s.p, x), place_kind(s.v, s.q, y))
        kind = worse(kind, *at, DEFINED if s.p * s.q == 0 else VALID)
    if not sure(kind, s.u, s.v, w=s.w) or at != (VALID, VALID) or s.p * s.q == 0:
        op.add(category, args, kind, issue=issue, comment=comment)
        return
    result = normal_of(s, x, y, "right")
    other = normal_of(s, x, y, "left") if jumps(s.u, s.p, x) or jumps(s.v, s.q, y) else result
    if result is None or other is None or (not result) != (not other):
        return
    if not result:
        op.add(category, args, worse(kind, DEFINED), issue=issue, comment=comment)
        return
    n, bound, told = result
    m, left_bound, left_told = other
    more = {"left": m, "left_bound": left_bound} if m != n else {}
    op.add(category, args, kind if told and (left_told or not more) else worse(kind, DEFINED), n, bound, issue=issue, comment=comment, **more)


def normals():
    op = Operation("surface_normal")
    c = Choices(110)
    each_surface(c, lambda category, s, x, y, *_, **more: normal(op, category, s, x, y, **more), 4, 1, sided=False)
    for k in range(9):
        normal(op, "weights", hemisphere(), k / 9.0, 0.5, comment="an eighth of a sphere: the normal is the point")
        normal(op, "degenerate", hemisphere(), 1.0, k / 8.0, "PixarAnimationStudios/OpenSubdiv/issues/947",
               "the pole of a sphere: the cross product vanishes")
        normal(op, "degenerate", cone(), 0.0, k / 8.0, "solvespace/solvespace/pull/736", "the tip of a cone: the cross product vanishes")
        normal(op, "degenerate", cone(), 2.0 ** -(8 * k), 0.5, "solvespace/solvespace/pull/736", "near the tip of a cone there is a normal")
    par = Surface(1, 1, clamped(1, []), clamped(1, []), [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0), (3.0, 0.0, 0.0)])
    normal(op, "degenerate", par, 0.5, 0.5, "PixarAnimationStudios/OpenSubdiv/issues/947", "S_u and S_v are parallel")
    for k in (4, 20, 40, 52, 60, 200):
        skew = Surface(1, 1, clamped(1, []), clamped(1, []), [(0.0, 0.0, 0.0), (1.0, 2.0**-k, 0.0), (1.0, 0.0, 0.0), (2.0, 2.0**-k, 0.0)])
        normal(op, "degenerate", skew, 0.5, 0.5, comment="S_u and S_v nearly parallel: 2^-%d" % k)
    return op
