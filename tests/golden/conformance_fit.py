"""conformance_fit: frozen vectors of parameters, knots from parameters and least squares, by rational normal equations without fractions."""
from fractions import Fraction as F
from math import lcm

from conformance_base import (DEFINED, INF, INVALID, LEAST, NAN, U, VALID, Choices, Operation, domain, knots_kind, number, points, reals, spans, sure,
                              worse)
from conformance_evaluate import GEOMDL, SCIPY
from conformance_inputs import bad_knots, control, extreme_knots, not_clamped
from knots_of import clamped
from lines import Line, grid
from rational import root, up, window

METHODS = ("uniform", "chord", "centripetal", "exponential")
RULES = ("piegl", "faithful", "uniform", "averaging")


def parameters():
    op = Operation("parameters")
    c = Choices(301)

    def ask(category, method, P, issue=None, comment=None):
        args = [METHODS[method], points(P)]
        if len(P) < 2 or not all(number(x) for q in P for x in q):
            op.add(category, args, INVALID, issue=issue, comment=comment)
            return
        K = 4 * (len(P) + 8)
        op.add(category, args, VALID, Line(P, method).parameters(), [(K, K * U + K * LEAST)] * len(P), issue=issue, comment=comment)
    for k in range(12):
        for method in range(4):
            ask("plain", method, control(c, c.between(2, 9), c.of(("short", "real"))))
            ask("extreme_scale", method, control(c, c.between(3, 6), ("far", "huge", "tiny", "subnormal", "mixed")[k % 5]))
            P = control(c, c.between(3, 7))
            j = c.upto(len(P) - 2)
            P[j + 1] = P[j]
            ask("degenerate", method, P, comment="two neighbours coincide")
            if k < 4:
                P = control(c, k + 2)
                ask("degenerate", method, [P[0]] * (k + 2), GEOMDL + ("132", "166")[k % 2], "all points coincide: the parameters are uniform")
                ask("degenerate", method, [P[0]] * (k + 1) + P[1:2], comment="all but one coincide")
                closed = control(c, 5)
                ask("seam", method, closed + closed[:1], comment="a closed line")
                ask("end_of_domain", method, [(float(x), 0.0, 0.0) for x in range(k + 2)], comment="the last parameter is 1")
                ask("degenerate", method, [(float(x * x), 0.0, 0.0) for x in range(k + 3)], comment="a line")
    for method in range(4):
        ask("size", method, [(float(x % 7), float(x % 5), float(x)) for x in range(150)], comment="150 points")
        for value in (NAN, INF, -INF):
            ask("bad_input", method, [(0.0, 0.0, 0.0), (1.0, value, 0.0), (2.0, 0.0, 0.0)], comment="a coordinate is no number")
        ask("bad_input", method, [], comment="no points")
        ask("bad_input", method, [(1.0, 2.0, 3.0)], comment="one point")
        ask("extreme_scale", method, [(0.0, 0.0, 0.0), (1.5e308, 0.0, 0.0), (-1.5e308, 1.5e308, 0.0)],
            comment="differences overflow, parameters do not")
        ask("extreme_scale", method, [(0.0, 0.0, 0.0), (2.0**-1074, 0.0, 0.0), (2.0**-1074, 2.0**-1074, 0.0), (1.0, 0.0, 0.0)],
            comment="squares underflow")
    return op


def parameter_grids():
    op = Operation("parameters_grid")
    c = Choices(302)

    def ask(category, method, nx, ny, P, issue=None, comment=None):
        args = [METHODS[method], nx, ny, points(P)]
        if nx < 2 or ny < 2 or len(P) != nx * ny or not all(number(x) for q in P for x in q):
            op.add(category, args, INVALID, issue=issue, comment=comment)
            return
        _, s, r = grid([[P[i * ny + j] for j in range(ny)] for i in range(nx)], method)
        K = 4 * (nx + ny + 8)
        op.add(category, args, VALID, s + r, [(K, K * U + K * LEAST)] * (nx + ny), issue=issue, comment=comment)
    for k in range(6):
        for method in range(4):
            nx, ny = c.between(2, 5), c.between(2, 4)
            ask("plain", method, nx, ny, control(c, nx * ny, c.of(("short", "real"))))
            ask("extreme_scale", method, nx, ny, control(c, nx * ny, ("far", "huge", "tiny", "subnormal", "mixed")[k % 5]))
            P = control(c, nx * ny)
            ask("degenerate", method, nx, ny, [P[0]] * ny + P[ny:], GEOMDL + ("132", "166")[k % 2],
                "one row is a point: it counts with uniform parameters")
            ask("seam", method, nx + 1, ny, P + P[:ny], comment="closed along i")
            if k < 2:
                ask("degenerate", method, nx, ny, [P[0]] * (nx * ny), comment="all points coincide")
    for method in (0, 1):
        P = control(c, 6)
        ask("bad_input", method, 2, 3, P[:5], comment="a point too few")
        ask("bad_input", method, 2, 2, P, comment="points too many")
        ask("bad_input", method, 1, 6, P, comment="one row")
        ask("bad_input", method, 6, 1, P, comment="one column")
        ask("bad_input", method, 0, 0, [], comment="nothing")
        for value in (NAN, INF):
            ask("bad_input", method, 2, 3, [(value, 0.0, 0.0)] + P[1:], comment="a coordinate is no number")
    return op


def inner_of(rule, p, n, t):
    """Interior knots, exactly."""
    out, spans_of = [], n - p
    for j in range(1, spans_of):
        if rule == "piegl":
            i, a = divmod(F(j * len(t), spans_of), 1)
            out.append((1 - a) * t[i - 1] + a * t[i])
        elif rule == "uniform":
            out.append(F(j, spans_of))
        else:
            out.append(sum(t[j:j + p]) / p)
    return out


def sites(c, n, how):
    """n parameters from 0 to 1, none below the one before."""
    draw = {"random": lambda: c.real(0, 1), "short": lambda: c.short(0, 1, 32), "repeated": lambda: c.short(0, 1, 4),
            "near": lambda: 0.5 + c.upto(3) * 2.0**-53, "ends": lambda: c.of((0.0, 1.0, 1 - 2.0**-53, 2.0**-53)),
            "tiny": lambda: c.of((2.0**-1074, 2.0**-1000, 1e-160, 0.5, 1e-16))}[how]
    return [0.0] + sorted(draw() for _ in range(n - 2)) + [1.0]


def knot_rules():
    op = Operation("knots")
    c = Choices(303)

    def ask(category, rule, p, n, t, issue=None, comment=None):
        args = [rule, p, n, reals(t)]
        bad = n < p + 1 or len(t) < 2 or not all(map(number, t)) or (rule == "averaging" and len(t) != n) or (rule in ("piegl",
                "faithful") and len(t) < n)
        odd = not bad and (p == 0 or any(a > b for a, b in zip(t, t[1:])) or t[0] < 0 or t[-1] > 1)
        if bad or odd:
            op.add(category, args, INVALID if bad else DEFINED, issue=issue, comment=comment)
            return
        inner, K = inner_of(rule, p, n, [F(x) for x in t]), 4 * (p + 2)
        op.add(category, args, VALID, [F(0)] * (p + 1) + inner + [F(1)] * (p + 1), [None] * (p + 1) + [(K, K * U)] * len(inner) + [None] * (p + 1),
               issue=issue, comment=comment)
    hows = (("random", "plain"), ("short", "plain"), ("repeated", "repeated_knots"), ("near", "near_knots"), ("ends", "end_of_domain"),
            ("tiny", "extreme_scale"))
    for how, category in hows:
        for k in range(9):
            m = c.between(4, 14)
            p = c.between(1, 4)
            n = c.between(min(p + 1, m), m)
            t = sites(c, m, how)
            ask(category, "piegl", p, n, t)
            ask(category, "faithful", p, n, t)
            ask(category, "uniform", p, n, t)
            if n >= 2:
                ask(category, "averaging", p, n, sites(c, n, how))
    for p in range(1, 26):
        n = p + c.between(1, 4)
        ask("degrees", c.of(RULES[:3]), p, n, sites(c, n + 1, "short"), comment="degree %d" % p)
        ask("degrees", "averaging", p, n, sites(c, n, "short"), comment="degree %d" % p)
    book = [0.0, 5 / 17, 9 / 17, 14 / 17, 1.0]
    for rule in RULES:
        ask("plain", rule, 3, 5, book, comment="Piegl and Tiller, example 9.1")
        ask("plain", rule, 1, 2, [0.0, 1.0], comment="no knots inside")
        ask("size", rule, 3, 100, [k / 128.0 for k in range(99)] + [1.0], comment="100 control points")
        ask("bad_input", rule, 3, 3, sites(c, 5, "short"), comment="fewer control points than degree and one")
        ask("bad_input", rule, 2, 4, [], comment="no parameters")
        ask("bad_input", rule, 1, 2, [0.5], comment="one parameter")
        ask("degrees", rule, 0, 3, [0.0, 0.5, 1.0], comment="degree 0: may be refused")
        for value in (NAN, INF):
            ask("bad_input", rule, 2, 4, [0.0, value, 0.5, 1.0], comment="a parameter is no number")
        ask("bad_input", rule, 2, 4, [0.0, 0.75, 0.25, 1.0], comment="parameters decrease: may be refused")
        ask("bad_input", rule, 2, 4, [-0.5, 0.25, 0.5, 1.5], comment="parameters beyond [0, 1]: may be refused")
        if rule != "uniform":
            ask("bad_input", rule, 2, 6, sites(c, 5, "short"), comment="more control points than parameters")
    ask("bad_input", "averaging", 2, 4, sites(c, 6, "short"), comment="averaging asks for as many parameters as control points")
    for p in (1, 2, 3):
        ask("fit_failure", "piegl", p, p + 3, [0.0] + [0.5] * 8 + [1.0], SCIPY + "22704", "repeated parameters give repeated knots")
    return op


def collocation(u, p, t):
    rows = []
    for x in t:
        k = spans(u, p, x, "right")
        rows.append([F(0)] * (k - p) + window(u, p, k, x) + [F(0)] * (len(u) - p - 2 - k))
    return rows


class System:
    """Least squares with a matrix of rationals: its normal matrix's inverse times a whole number; None of it if the rank is not full."""

    def __init__(self, A):
        self.A, n = A, len(A[0])
        scale = lcm(*(x.denominator for r in A for x in r))
        N = [[int(x * scale) for x in r] for r in A]
        G = [[sum(r[i] * r[j] for r in N if r[i] and r[j]) for j in range(n)] for i in range(n)]
        self.det, V = adjugate(G)
        self.full = self.det != 0
        if self.full:
            self.V = [[F(x * scale * scale, self.det) for x in r] for r in V]
            self.inverse2 = sum(self.V[i][i] for i in range(n))       # |A+|_F^2
            self.size2 = sum(x * x for r in A for x in r)
            self.K = sqrt(self.inverse2 * self.size2)

    def plus(self, D):
        """A+ D"""
        return product(self.V, product(transposed(self.A), D))


def adjugate(G):
    """Determinant and adjugate of a whole matrix that is positive semidefinite, by Bareiss' elimination; 0 and nothing if it is singular."""
    n = len(G)
    M = [list(r) + [int(i == j) for j in range(n)] for i, r in enumerate(G)]
    before = 1
    for k in range(n):
        if M[k][k] == 0:
            return 0, None
        for i in range(n):
            if i != k:
                a, b = M[k][k], M[i][k]
                M[i] = [(a * x - b * y) // before for x, y in zip(M[i], M[k])]
        before = M[k][k]
    return before, [r[n:] for r in M]


def transposed(A):
    return [list(r) for r in zip(*A)]


def product(A, B):
    C = transposed(B)
    return [[sum(x * y for x, y in zip(r, c) if x and y) for c in C] for r in A]


def sqrt(x):
    return up(root(x, 2, 100)[0], 80)


def norm(values):
    return sqrt(sum(x * x for x in values))


def bounds_of(k, K, size, X, R):
    """Per coordinate (k, B) of X[..][3] and the residuals R[..][3]."""
    out = []
    for c in range(3):
        x, r = norm([q[c] for q in X]), norm([q[c] for q in R])
        out.append((k, k * U * (K * x + K * K * r / size) + k * LEAST * (1 + K * K)))
    return out


def finite(*lists):
    return all(number(x) for t in lists for x in t)


def outside_it(u, p, t):
    lo, hi = domain(u, p)
    return any(not lo <= x <= hi for x in t)


def on_full_knot(u, p, t):
    lo, hi = domain(u, p)
    return any(lo < x < hi and sum(y == x for y in u) > p for x in t)


def exactly(P):
    return [[F(x) for x in q] for q in P]


def give(op, category, args, kind, right, X, bounds, **more):
    """X: points; bounds: one of each coordinate."""
    if not right:
        op.add(category, args, kind, **more)
        return
    want = [x for q in X for x in q]
    if all(abs(x) < F(2)**900 for x in want):
        op.add(category, args, kind, want, bounds * len(X), **more)


def fit_curve(op, category, p, u, t, P, issue=None, comment=None):
    args, more = [p, reals(u), reals(t), points(P)], {"issue": issue, "comment": comment}
    kind = knots_kind(p, u)
    if kind == INVALID or len(t) != len(P) or not finite(t, *P) or not t or outside_it(u, p, t):
        op.add(category, args, INVALID, **more)
        return
    if p == 0 or not sure(kind, u) or on_full_knot(u, p, t):
        op.add(category, args, DEFINED, **more)
        return
    A = System(collocation(u, p, t))
    if not A.full:
        op.add(category, args, INVALID, **more)
        return
    X = A.plus(exactly(P))
    R = [[a - b for a, b in zip(x, y)] for x, y in zip(product(A.A, X), exactly(P))]
    m, n = len(t), len(X)
    k = 16 * max(m, n)
    if n * k * U * A.K >= 1:
        kind = DEFINED
    give(op, category, args, kind, True, X, bounds_of(k, A.K, sqrt(A.size2), X, R), **more)


def fit_knots(c, p, n):
    """n control points, knots on [0, 1] at some sixteenths."""
    inner = sorted(c.between(1, 15) / 16.0 for _ in range(n - p - 1))
    return clamped(p, inner) if all(inner.count(x) <= p for x in inner) else clamped(p, [k / (n - p) for k in range(1, n - p)])


def good_sites(c, u, p, m, how="short"):
    """Parameters that Schoenberg and Whitney ask for: Greville points moved to sixteenths and more of them."""
    n = len(u) - p - 1
    t = [0.0, 1.0]
    t += [round(32 * sum(u[i + 1:i + p + 1]) / p) / 32.0 for i in range(1, n - 1)]
    while len(t) < m:
        t.append(c.real(0, 1) if how == "real" else c.short(0, 1, 32))
    return sorted(t)


def fit_curves():
    op = Operation("fit_curve")
    c = Choices(304)
    for k in range(16):
        for p in (1, 2, 3):
            n = p + c.between(1, 5)
            u = fit_knots(c, p, n)
            t = good_sites(c, u, p, n + c.upto(6))
            fit_curve(op, "plain", p, u, t, control(c, len(t)))
            if k < 6:
                t = good_sites(c, u, p, n + 2, "real")
                fit_curve(op, "plain", p, u, t, control(c, len(t), "real"))
                t = good_sites(c, u, p, n)
                fit_curve(op, "plain", p, u, t, control(c, len(t)), comment="interpolation")
                how = ("far", "huge", "tiny", "subnormal", "mixed")[k % 5]
                t = good_sites(c, u, p, n + 3)
                fit_curve(op, "extreme_scale", p, u, t, control(c, len(t), how), comment="data: " + how)
                fit_curve(op, "degenerate", p, u, t, [(0.1, 0.2, 0.3)] * len(t), comment="all data coincide")
                fit_curve(op, "fit_failure", p, u, [t[0]] * (len(t) - 1) + t[-1:], control(c, len(t)), SCIPY + "22704",
                          "repeated parameters: rank deficient")
                fit_curve(op, "fit_failure", p, u, t[:n - 1], control(c, n - 1), comment="fewer data than control points")
                s = [x / 4.0 for x in t]
                fit_curve(op, "fit_failure", p, clamped(p, [0.5, 0.75]), s, control(c, len(s)), "https://github.com/scipy/scipy/pull/26090",
                          "no parameter where a basis function lives: Schoenberg-Whitney violated")
                fit_curve(op, "repeated_knots", p, clamped(p, [0.5] * p), sorted(set(t + [0.25, 0.5, 0.75, 0.125])),
                          control(c, len(set(t + [0.25, 0.5, 0.75, 0.125]))))
                full = [0.0, 0.125, 0.25, 0.375, 0.4375, 0.5625, 0.625, 0.75, 0.875, 1.0]
                fit_curve(op, "repeated_knots", p, clamped(p, [0.5] * (p + 1)), full, control(c, 10), comment="two curves in one")
                fit_curve(op, "repeated_knots", p, clamped(p, [0.5] * (p + 1)), full + [1.0], control(c, 11))
                fit_curve(op, "repeated_knots", p, clamped(p, [0.5] * (p + 1)), full[:5] + [0.5] + full[5:], control(c, 11),
                          comment="a parameter where the curve jumps: may be refused")
                e = extreme_knots(c, p)
                lo, hi = domain(e, p)
                if sure(VALID, e) and len(e) < 2 * p + 4:
                    fit_curve(op, "extreme_scale", p, e, [lo + (hi - lo) * (j / 8.0) for j in range(9)], control(c, 9))
                e = not_clamped(c, p)
                lo, hi = domain(e, p)
                fit_curve(op, "end_of_domain", p, e, [lo + (hi - lo) * (j / 16.0) for j in range(17)], control(c, 17),
                          comment="knots not clamped: may be refused")
    for k in (10, 20, 26, 30, 34, 45):
        fit_curve(op, "fit_failure", 1, clamped(1, [0.5]), [0.0, 2.0**-k, 0.5, 1.0 - 2.0**-k],
                  [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0), (1.0, 0.0, -1.0)],
                  comment="two parameters 2^-%d apart" % k)
        fit_curve(op, "fit_failure", 2, clamped(2, [0.5]), [0.0, 0.5, 0.5 + 2.0**-k, 1.0],
                  [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0), (1.0, 0.0, -1.0)],
                  comment="two parameters 2^-%d apart" % k)
    fit_curve(op, "fit_failure", 1, clamped(1, []), [0.0, 0.5, 1.0], [(0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (2.0, 2.0, 2.0)], GEOMDL + "124",
              "a line through three points of a line")
    t = [0.0] * 3 + [0.5] * 3 + [1.0] * 3
    fit_curve(op, "fit_failure", 5, clamped(5, [0.25, 0.5, 0.75]), t, control(c, 9), GEOMDL + "119", "nine data at three parameters: rank deficient")
    fit_curve(op, "fit_failure", 3, clamped(3, [0.5]), [0.0, 0.25, 0.25, 0.25, 0.25, 1.0], control(c, 6), GEOMDL + "181",
              "repeated parameters: rank deficient")
    fit_curve(op, "fit_failure", 3, clamped(3, []), [0.0, 0.25, 0.25, 0.75, 0.75, 1.0], control(c, 6), GEOMDL + "181",
              "repeated parameters, but enough others")
    for p in range(1, 10):
        t = [j / 32.0 for j in range(0, 33, 2)]
        fit_curve(op, "degrees", p, clamped(p, []), t, control(c, 17), comment="degree %d" % p)
    u = clamped(3, [j / 32.0 for j in range(1, 32)])
    fit_curve(op, "size", 3, u, [j / 64.0 for j in range(65)], [(float(j), float(j % 5), float(j % 3)) for j in range(65)],
              comment="35 control points, 65 data")
    p, u, t = 2, clamped(2, [0.5]), [0.0, 0.25, 0.5, 0.75, 1.0]
    P = control(c, 5)
    for what, bad in bad_knots(u, p):
        fit_curve(op, "bad_input", p, bad, t, P, comment=what)
    for value in (NAN, INF):
        fit_curve(op, "bad_input", p, u, [0.0, value, 0.5, 0.75, 1.0], P, comment="a parameter is no number")
        fit_curve(op, "bad_input", p, u, t, [(value, 0.0, 0.0)] + P[1:], comment="a datum is no number")
    fit_curve(op, "bad_input", p, u, t, P[:4], comment="a datum too few")
    fit_curve(op, "bad_input", p, u, t[:4], P, comment="a parameter too few")
    fit_curve(op, "bad_input", p, u, [], [], comment="no data")
    fit_curve(op, "bad_input", p, u, [-0.25, 0.25, 0.5, 0.75, 1.0], P, comment="a parameter outside the domain")
    fit_curve(op, "bad_input", p, u, [0.0, 0.25, 0.5, 0.75, 1.25], P, comment="a parameter outside the domain")
    fit_curve(op, "degrees", 0, [0.0, 0.5, 1.0], t, P, comment="degree 0: may be refused")
    fit_curve(op, "plain", p, u, t[::-1], P, comment="parameters in another order")
    return op


def fit_grid(op, category, corners, p, q, u, v, s, r, P, issue=None, comment=None):
    args, more = [corners, p, q, reals(u), reals(v), reals(s), reals(r), points(P)], {"issue": issue, "comment": comment}
    kind = worse(knots_kind(p, u), knots_kind(q, v))
    if kind == INVALID or len(s) * len(r) != len(P) or not finite(s, r, *P) or not P or outside_it(u, p, s) or outside_it(v, q, r):
        op.add(category, args, INVALID, **more)
        return
    if p * q == 0 or not sure(kind, u, v) or on_full_knot(u, p, s) or on_full_knot(v, q, r):
        op.add(category, args, DEFINED, **more)
        return
    A, B = System(collocation(u, p, s)), System(collocation(v, q, r))
    if not A.full or not B.full:
        op.add(category, args, INVALID, **more)
        return
    nu, nv, mu, mv = len(u) - p - 1, len(v) - q - 1, len(s), len(r)
    if corners == "interpolated" and any(w[0] != w[d] or w[-1] != w[-d - 1] for w, d in ((u, p), (v, q))):
        op.add(category, args, DEFINED, **more)
        return
    X, R = [[None] * 3 for _ in range(nu * nv)], [[None] * 3 for _ in range(mu * mv)]
    for c in range(3):
        D = [[F(P[i * mv + j][c]) for j in range(mv)] for i in range(mu)]
        Y = transposed(B.plus(transposed(A.plus(D))))
        if corners == "interpolated":
            Y = with_corners(A, B, Y, D)
            if Y is None:
                return
        S = product(product(A.A, Y), transposed(B.A))
        for k in range(nu * nv):
            X[k][c] = Y[k // nv][k % nv]
        for k in range(mu * mv):
            R[k][c] = S[k // mv][k % mv] - D[k // mv][k % mv]
    k, K = 16 * (max(mu, nu) + max(mv, nv)), A.K * B.K
    if max(nu, nv) * k * U * K >= 1:
        kind = DEFINED
    give(op, category, args, kind, True, X, bounds_of(k, K, sqrt(A.size2) * sqrt(B.size2), X, R), **more)


def with_corners(A, B, Y, D):
    """The optimum among those that meet the corners: the free one and a combination of the corners' images under the inverse normal matrix."""
    ends = [(i, j) for i in (0, len(D) - 1) for j in (0, len(D[0]) - 1)]
    a, b = product(A.A, A.V), product(B.A, B.V)
    M = [[dot(a[i], A.A[k]) * dot(b[j], B.A[m]) for k, m in ends] for i, j in ends]
    miss = [[D[i][j] - dot(A.A[i], [dot(B.A[j], y) for y in Y])] for i, j in ends]
    scale = lcm(*(x.denominator for row in M for x in row))
    det, V = adjugate([[int(x * scale) for x in row] for row in M])
    if det == 0:
        return None
    g = [F(sum(x * y[0] for x, y in zip(row, miss)) * scale, 1) / det for row in V]
    return [[Y[x][y] + sum(w * a[i][x] * b[j][y] for w, (i, j) in zip(g, ends)) for y in range(len(Y[0]))] for x in range(len(Y))]


def dot(x, y):
    return sum(p * q for p, q in zip(x, y) if p and q)


def fit_grids():
    op = Operation("fit_grid")
    c = Choices(305)
    for k in range(7):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 2)):
            nu, nv = p + 1 + c.upto(2), q + 1 + c.upto(2)
            u, v = fit_knots(c, p, nu), fit_knots(c, q, nv)
            s, r = good_sites(c, u, p, nu + c.upto(3)), good_sites(c, v, q, nv + c.upto(2))
            for corners in ("free", "interpolated"):
                fit_grid(op, "plain", corners, p, q, u, v, s, r, control(c, len(s) * len(r)))
            if k < 3:
                how = ("far", "huge", "tiny", "subnormal", "mixed")[(k + p) % 5]
                fit_grid(op, "extreme_scale", c.of(("free", "interpolated")), p, q, u, v, s, r, control(c, len(s) * len(r), how),
                         comment="data: " + how)
                P = control(c, len(s) * len(r))
                fit_grid(op, "degenerate", "interpolated", p, q, u, v, s, r, [P[0]] * len(r) + P[len(r):], GEOMDL + "132",
                         "one row of data is a point")
                fit_grid(op, "seam", "free", p, q, u, v, s, r, P[:-len(r)] + P[:len(r)], comment="data closed along i")
                fit_grid(op, "fit_failure", "free", p, q, u, v, [0.0] * (len(s) - 1) + [1.0], r, P,
                         comment="repeated parameters: rank deficient" if nu > 2 else None)
                fit_grid(op, "fit_failure", "free", p, q, clamped(p, [0.5, 0.75]), v, [x / 4.0 for x in s], r, P,
                         comment="Schoenberg-Whitney violated")
                fit_grid(op, "fit_failure", "free", p, q, u, v, s[:nu - 1], r, P[:(nu - 1) * len(r)], comment="fewer rows than control points")
    for k in (8, 16, 24, 40):
        fit_grid(op, "fit_failure", "free", 1, 1, clamped(1, [0.5]), clamped(1, []), [0.0, 2.0**-k, 0.5, 1.0 - 2.0**-k], [0.0, 2.0**-k, 1.0],
                 control(c, 12),
                 comment="parameters 2^-%d apart" % k)
    u, v, s, r = clamped(2, [0.5]), clamped(1, []), [0.0, 0.25, 0.5, 0.75, 1.0], [0.0, 0.5, 1.0]
    P = control(c, 15)
    for corners in ("free", "interpolated"):
        fit_grid(op, "bad_input", corners, 2, 1, u, v, s, r, P[:14], comment="a datum too few")
        fit_grid(op, "bad_input", corners, 2, 1, u, v, [0.0, NAN, 0.5, 0.75, 1.0], r, P, comment="a parameter is NaN")
        fit_grid(op, "bad_input", corners, 2, 1, u, v, s, [0.0, 0.5, 1.5], P, comment="a parameter outside the domain")
        fit_grid(op, "bad_input", corners, 2, 1, u, v, s, r, [(INF, 0.0, 0.0)] + P[1:], comment="a datum is infinite")
        fit_grid(op, "degrees", corners, 0, 1, [0.0, 0.5, 1.0], v, s, r, P, comment="degree 0: may be refused")
        fit_grid(op, "bad_input", corners, 2, 1, u, v, [], [], [], comment="no data")
    for what, bad in bad_knots(u, 2):
        fit_grid(op, "bad_input", "free", 2, 1, bad, v, s, r, P, comment=what)
    wide = [j / 16.0 for j in range(17)]
    fit_grid(op, "size", "interpolated", 3, 3, clamped(3, [0.25, 0.5, 0.75]), clamped(3, [0.5]), wide, wide[::2],
             [(float(i), float(j), float(i * j % 5)) for i in range(17) for j in range(9)], comment="17 x 9 data")
    loose = [2.0, 2.25, 2.5, 2.75, 3.0]
    for corners in ("free", "interpolated"):
        fit_grid(op, "end_of_domain", corners, 2, 1, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0], v, loose, r, P, comment="knots not clamped: may be refused")
        fit_grid(op, "repeated_knots", corners, 1, 1, clamped(1, [0.5, 0.5]), v, s, r, P, comment="a row where the surface jumps: may be refused")
        for k in (30, 44, 50):
            fit_grid(op, "fit_failure", corners, 1, 1, clamped(1, [0.5]), v, [0.0, 2.0**-k, 0.75, 0.75 + 2.0**-k, 1.0], r, P,
                     comment="few parameters in the middle, two 2^-%d apart" % k)
            fit_grid(op, "fit_failure", corners, 2, 1, clamped(2, []), v, [0.0, 2.0**-k, 2.0 ** (1 - k), 2.0 ** (2 - k), 1.0], r, P,
                     comment="all but one parameter within 2^-%d" % (k - 2))
    for p in (4, 5):
        fit_grid(op, "degrees", "free", p, 1, clamped(p, []), clamped(1, []), [j / 8.0 for j in range(9)], [0.0, 1.0], control(c, 18),
                 comment="degree %d" % p)
    return op


def fit_scattered(op, category, p, q, u, v, a, b, P, issue=None, comment=None):
    args, more = [p, q, reals(u), reals(v), reals(a), reals(b), points(P)], {"issue": issue, "comment": comment}
    kind = worse(knots_kind(p, u), knots_kind(q, v))
    if kind == INVALID or len(P) < (len(u) - p - 1) * (len(v) - q - 1) or not len(a) == len(b) == len(P) or not finite(a, b, *P) or not P or outside_it(u, p, a) or outside_it(v, q, b):
        op.add(category, args, INVALID, **more)
        return
    if p * q == 0 or not sure(kind, u, v) or on_full_knot(u, p, a) or on_full_knot(v, q, b):
        op.add(category, args, DEFINED, **more)
        return
    A = System([[x * y for x in r for y in s] for r, s in zip(collocation(u, p, a), collocation(v, q, b))])
    if not A.full:
        op.add(category, args, INVALID, **more)
        return
    X = A.plus(exactly(P))
    R = [[x - y for x, y in zip(g, h)] for g, h in zip(product(A.A, X), exactly(P))]
    n, m = len(X), len(P)
    k = 16 * max(m, n)
    if n * k * U * A.K >= 1:
        kind = DEFINED
    give(op, category, args, kind, True, X, bounds_of(k, A.K, sqrt(A.size2), X, R), **more)


def strewn(c, u, p, v, q, more):
    """Places enough for full rank: a grid of good ones, and some more."""
    s, r = good_sites(c, u, p, 0), good_sites(c, v, q, 0)
    at = [(x, y) for x in s for y in r] + [(c.short(0, 1, 16), c.short(0, 1, 16)) for _ in range(more)]
    return [x for x, _ in at], [y for _, y in at]


def fit_scatters():
    op = Operation("fit_scattered")
    c = Choices(306)
    for k in range(10):
        for p, q in ((1, 1), (2, 1), (2, 2), (3, 1)):
            u, v = fit_knots(c, p, p + 1 + c.upto(1)), fit_knots(c, q, q + 1 + c.upto(1))
            a, b = strewn(c, u, p, v, q, c.upto(6))
            fit_scattered(op, "plain", p, q, u, v, a, b, control(c, len(a)))
            if k < 3:
                how = ("far", "huge", "tiny", "subnormal", "mixed")[(k + p) % 5]
                fit_scattered(op, "extreme_scale", p, q, u, v, a, b, control(c, len(a), how), comment="data: " + how)
                fit_scattered(op, "degenerate", p, q, u, v, a, b, [(0.1, 0.2, 0.3)] * len(a), comment="all data coincide")
                fit_scattered(op, "fit_failure", p, q, u, v, a, a[:], control(c, len(a)), comment="all on the diagonal")
                fit_scattered(op, "fit_failure", p, q, u, v, [0.5] * len(a), b, control(c, len(a)), comment="all on one line: rank deficient")
                n = (len(u) - p - 1) * (len(v) - q - 1)
                fit_scattered(op, "fit_failure", p, q, u, v, a[:n - 1], b[:n - 1], control(c, n - 1), comment="fewer data than control points")
                fit_scattered(op, "repeated_knots", p, q, u, v, a + a, b + b, control(c, 2 * len(a)), comment="each place twice, with other data")
    u, v = clamped(2, [0.5]), clamped(1, [])
    a, b = strewn(c, u, 2, v, 1, 2)
    P = control(c, len(a))
    edge = [min(max(x, 0.0), 1.0) for x in a]
    fit_scattered(op, "end_of_domain", 2, 1, u, v, edge, b, P, "ddemidov/mba/issues/21", "places on the border of the domain")
    fit_scattered(op, "bad_input", 2, 1, u, v, a, b, P[1:], comment="a datum too few")
    fit_scattered(op, "bad_input", 2, 1, u, v, a, b[1:], P, comment="a parameter too few")
    fit_scattered(op, "bad_input", 2, 1, u, v, [NAN] + a[1:], b, P, comment="a parameter is NaN")
    fit_scattered(op, "bad_input", 2, 1, u, v, a, [1.5] + b[1:], P, comment="a parameter outside the domain")
    fit_scattered(op, "bad_input", 2, 1, u, v, a, b, [(0.0, INF, 0.0)] + P[1:], comment="a datum is infinite")
    fit_scattered(op, "bad_input", 2, 1, u, v, [], [], [], comment="no data")
    fit_scattered(op, "degrees", 2, 0, u, [0.0, 1.0], a, b, P, comment="degree 0: may be refused")
    for what, bad in bad_knots(u, 2):
        fit_scattered(op, "bad_input", 2, 1, bad, v, a, b, P, comment=what)
    for k in (2, 8, 16, 22, 24, 26):
        fit_scattered(op, "fit_failure", 1, 1, v, v, [0.0, 1.0, 0.0, 2.0**-k], [0.0, 0.0, 1.0, 2.0**-k], control(c, 4),
                      comment="nearly three places: 2^-%d" % k)
    fit_scattered(op, "end_of_domain", 1, 1, [0.0, 1.0, 2.0, 3.0], v, [1.0, 1.5, 2.0, 1.0, 1.25, 2.0], [0.0, 0.25, 0.5, 1.0, 0.75, 1.0],
                  control(c, 6),
                  comment="knots not clamped: may be refused")
    fit_scattered(op, "repeated_knots", 1, 1, clamped(1, [0.5, 0.5]), v, [0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 0.0, 0.5],
                  [0.0, 1.0, 0.5, 0.25, 0.75, 0.0, 1.0, 1.0],
                  control(c, 8), comment="a place where the surface jumps: may be refused")
    places = [((i * 7 % 33) / 32.0, (i * 5 % 17) / 16.0) for i in range(90)]
    fit_scattered(op, "size", 2, 2, clamped(2, [0.25, 0.5, 0.75]), clamped(2, [0.5]), [x for x, _ in places], [y for _, y in places],
                  [(float(i), float(i % 7), float(i % 5)) for i in range(90)], comment="90 data")
    return op


def approximations():
    op = Operation("approximate")
    c = Choices(307)

    def ask(category, p, q, nu, nv, mx, my, P, issue=None, comment=None):
        bad = nu < p + 1 or nv < q + 1 or mx < 2 or my < 2 or len(P) != mx * my or not finite(*P)
        kind = INVALID if bad else DEFINED if mx < nu or my < nv or p * q == 0 else VALID
        op.add(category, [p, q, nu, nv, mx, my, points(P)], kind, issue=issue, comment=comment)
    for k in range(8):
        p, q = c.between(1, 3), c.between(1, 3)
        nu, nv = p + c.between(1, 2), q + c.between(1, 2)
        mx, my = nu + c.between(1, 3), nv + c.between(1, 3)
        P = [(float(i), float(j), c.short(-1, 1, 16)) for i in range(mx) for j in range(my)]
        ask("plain", p, q, nu, nv, mx, my, P)
        ask("degenerate", p, q, nu, nv, mx, my, [P[0]] * my + P[my:], GEOMDL + "132", "one row of data is a point")
        ask("extreme_scale", p, q, nu, nv, mx, my, [tuple(x * 1e150 for x in t) for t in P])
        ask("seam", p, q, nu, nv, mx, my, P[:-my] + P[:my], "lzpel/cadrum/issues/120", "data closed along i")
        ask("fit_failure", p, q, mx + 1, nv, mx, my, P, comment="fewer data than control points: may be refused")
        ask("bad_input", p, q, nu, nv, mx, my, P[:-1], comment="a datum too few")
        ask("bad_input", p, q, p, nv, mx, my, P, comment="fewer control points than degree and one")
        ask("degrees", 0, q, nu, nv, mx, my, P, comment="degree 0: may be refused")
        ask("bad_input", p, q, nu, nv, mx, my, [(NAN, 0.0, 0.0)] + P[1:], comment="a datum is NaN")
    for n in (16, 30):
        ask("size", 3, 3, n // 2, n // 2, n, n, [(float(i), float(j), float(i * j % 7)) for i in range(n) for j in range(n)],
            "bgrimstad/splinter/issues/49",
            "%d x %d data: a matter of moments" % (n, n))
    ask("degenerate", 1, 1, 2, 2, 3, 3, [(1.0, 2.0, 3.0)] * 9, GEOMDL + "166", "all data coincide")
    return op

