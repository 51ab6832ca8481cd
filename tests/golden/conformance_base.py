"""conformance_base: what the generators of frozen vectors share: how a vector is written, bounds, curves and surfaces by their definition.

The bounds are those of docs/judge.md, in rationals, rounded up to 40 binary digits when they are written.
"""
import json
from fractions import Fraction as F
from math import comb, isinf, isnan

from rational import Choices, nearest, show, times, up, whole, window

U = F(1, 2**53)
LEAST = F(1, 2**1074)
INF = float("inf")
NAN = float("nan")
SIDES = ("any", "right", "left")
VALID, DEFINED, INVALID = "valid", "implementation_defined", "invalid"
CATEGORIES = ("plain", "end_of_domain", "near_knots", "repeated_knots", "editing", "degenerate", "fit_failure", "seam", "inversion", "size",
              "extreme_scale", "weights", "degrees", "bad_input")


def word(x):
    """A number of a request: counts are int, reals float; words stay."""
    return show(x) if isinstance(x, float) else str(x)


def reals(xs):
    return [len(xs)] + [float(x) for x in xs]


def points(ps):
    return [len(ps)] + [float(x) for p in ps for x in p]


def flat(args):
    out = []
    for a in args:
        if isinstance(a, (list, tuple)):
            out += flat(a)
        else:
            out.append(a)
    return out


class Count(int):
    """A count among the wanted numbers: exact, its bound is 0."""


class Operation:
    """The vectors of one operation, collected and written."""

    def __init__(self, name):
        self.name, self.vectors, self.numbers, self.known = name, [], {}, set()

    def add(self, category, args, validity=VALID, want=None, bound=None, left=None, left_bound=None, condition=None, issue=None, comment=None):
        assert category in CATEGORIES, category
        request = " ".join(word(x) for x in flat(args))
        if request in self.known:
            return
        self.known.add(request)
        self.numbers[category] = self.numbers.get(category, 0) + 1
        v = {"id": "%s/%s/%d" % (self.name, category, self.numbers[category]), "category": category, "validity": validity, "request": request}
        if want is not None:
            if any(b and b[1] == INF and not isinf(nearest(F(w))) for w, b in zip(want, bound)) and not self.name.endswith("nearest"):
                self.numbers[category] -= 1          # a right value, but no bound: of no use to anybody
                return
            want, bound, condition = written(want, bound)
            v["want"], v["bound"] = want, bound
            if left is not None:
                v["want_left"], v["bound_left"], again = written(left, left_bound)
                condition = max(condition, again)
            v["condition"] = show(condition)
        if issue:
            v["issue"] = issue if issue.startswith("https:") else "https://github.com/" + issue
        if comment:
            v["comment"] = comment
        self.vectors.append(v)

    def text(self):
        lines = ",\n".join("  " + json.dumps(v) for v in self.vectors)
        return '{ "format": "etalon-conformance", "version": 1, "operation": "%s", "vectors": [\n%s\n] }\n' % (self.name, lines)


def half_ulp(x):
    """h of docs/judge.md: half the distance of the doubles about x, at least 2^-1074."""
    if x == 0:
        return LEAST
    f = abs(F(x))
    e = f.numerator.bit_length() - f.denominator.bit_length()
    if F(2) ** e > f:
        e -= 1
    return max(F(2) ** (max(e, -1022) - 53), LEAST)


def upward(x):
    """A double not below the rational, of at most 40 binary digits unless it is subnormal; infinite beyond the greatest."""
    if x == INF:
        return INF
    y = nearest(up(x, 40))
    while y < x:
        y = y + max(abs(y) * 2.0**-50, 5e-324)
    return y


def written(want, bound):
    """Texts of the wanted numbers and of their bounds, and the condition.  A bound is None where B is said to be 0, else (K, B);
    B may be infinite."""
    texts, bounds, condition = [], [], 1.0
    for w, b in zip(want, bound, strict=True):
        if isinstance(w, Count):
            texts.append(str(w))
            bounds.append("0x0p+0")
            continue
        x = nearest(w) if isinstance(w, F) else w + 0.0
        assert not isnan(x)
        texts.append(show(x))
        if b is None:
            bounds.append("0x0p+0")
            continue
        K, B = b
        full = INF if isinf(x) else upward(B if B == INF else B + half_ulp(x))
        bounds.append(show(full))
        if not isinf(full):
            condition = max(condition, nearest(F(full) / (K * U * abs(F(x)))) if x else INF if full > 2.0**-1000 else 1.0)
    return texts, bounds, condition


def fits(values):
    """All are within the range of doubles."""
    return all(not isinf(nearest(F(v))) for v in values)


def after(x):
    from math import nextafter
    return nextafter(x, INF)


def before(x):
    from math import nextafter
    return nextafter(x, -INF)


def domain(u, p):
    return u[p], u[len(u) - p - 1]


def spans(u, p, x, side):
    """The span whose polynomial is meant at x of the domain: of the limit from the right or left; at the ends of the domain the one inside."""
    lo, hi = domain(u, p)
    inside = range(p, len(u) - p - 1)
    if (side == "left" and x > lo) or x >= hi:
        return max(k for k in inside if u[k] < x and u[k] < u[k + 1])
    return max(k for k in inside if u[k] <= x and u[k] < u[k + 1])


def jumps(u, p, x):
    """x is a knot inside the domain: left and right may differ."""
    lo, hi = domain(u, p)
    return lo < x < hi and x in u


def ones(u, p, k, d):
    """s^(d) of the functions k-p .. k on span k: the recursion of the derivatives' magnitudes begun with 1."""
    if d > p:
        return [F(0)] * (p + 1)
    w, _, scale = whole(u[k - p:k + p + 2], 0)
    n = [F(1)] * (p - d + 1)
    for e in range(p - d + 1, p + 1):
        n = [F(0)] + n + [F(0)]
        n = [times(n[r], e, w[i + e] - w[i]) + times(n[r + 1], e, w[i + e + 1] - w[i + 1]) for r, i in enumerate(range(p - e, p + 1))]
    return [x * scale ** d for x in n]


class Local:
    """One direction at one parameter: values, magnitudes m and s of docs/judge.md, of the functions on the span, for the orders 0 .. d."""

    def __init__(self, u, p, x, d, side):
        self.first = spans(u, p, x, side) - p
        k = self.first + p
        self.N = [window(u, p, k, x, e) for e in range(d + 1)]
        self.M = [n if e == 0 else [up(m, 80) for m in window(u, p, k, x, e, 1)] for e, n in enumerate(self.N)]
        self.L = max(F(1), F(u[-1]) - F(u[0]))
        self.S = [[1 + self.L * up(s, 80) for s in ones(u, p, k, e)] for e in range(d + 1)]


def homogeneous(P, w):
    """(w, wx, wy, wz) exactly, and the magnitudes of docs/judge.md: fl(w |x|)."""
    H = [(F(g), F(g) * F(a), F(g) * F(b), F(g) * F(c)) for g, (a, b, c) in zip(w, P)]
    A = [(F(g), F(g * abs(a)), F(g * abs(b)), F(g * abs(c))) for g, (a, b, c) in zip(w, P)]
    return H, A


class Curve:
    def __init__(self, p, u, P, w=()):
        self.p, self.u, self.P, self.w = p, list(u), [tuple(float(c) for c in q) for q in P], list(w)
        self.n = len(u) - p - 1

    def args(self):
        return [self.p, reals(self.u), points(self.P), reals(self.w)]

    def orders(self, x, d, side):
        """Per order (values, E, M, K) of w, wx, wy, wz."""
        at = Local(self.u, self.p, x, d, side)
        here = slice(at.first, at.first + self.p + 1)
        H, A = homogeneous(self.P[here], self.w[here] or [1.0] * (self.p + 1))
        out = {}
        for e in range(d + 1):
            K = 16 * (self.p + e + 2)
            M = [sum(m * a[c] for m, a in zip(at.M[e], A)) for c in range(4)]
            G = [1 + sum(s * a[c] for s, a in zip(at.S[e], A)) for c in range(4)]
            most = [sum(at.M[e]) * max(a[c] for a in A) for c in range(4)]
            out[(e,)] = ([sum(n * h[c] for n, h in zip(at.N[e], H)) for c in range(4)], [error(K, m, g) for m, g in zip(most, G)], M, K)
        return out


class Surface:
    def __init__(self, p, q, u, v, P, w=()):
        self.p, self.q, self.u, self.v, self.P, self.w = p, q, list(u), list(v), [tuple(float(c) for c in x) for x in P], list(w)
        self.nu, self.nv = len(u) - p - 1, len(v) - q - 1

    def args(self):
        return [self.p, self.q, reals(self.u), reals(self.v), points(self.P), reals(self.w)]

    def orders(self, x, y, d, side_u, side_v):
        a, b = Local(self.u, self.p, x, d, side_u), Local(self.v, self.q, y, d, side_v)
        H, A = [], []
        for i in range(a.first, a.first + self.p + 1):
            here = slice(i * self.nv + b.first, i * self.nv + b.first + self.q + 1)
            h, m = homogeneous(self.P[here], self.w[here] or [1.0] * (self.q + 1))
            H.append(h)
            A.append(m)
        out = {}
        for f in range(d + 1):
            value, size, small = inner(b.N[f], H), inner(b.M[f], A), inner(b.S[f], A)
            for e in range(d + 1 - f):
                K = 16 * (self.p + self.q + e + f + 2)
                M, G = outer(a.M[e], size), outer(a.S[e], small)
                most = [sum(a.M[e]) * sum(b.M[f]) * max(m[c] for r in A for m in r) for c in range(4)]
                out[e, f] = (outer(a.N[e], value), [error(K, m, 1 + g) for m, g in zip(most, G)], M, K)
        return out


def error(K, m, g):
    """K u m + K eta g; infinite where a sum on the way is beyond the range of doubles."""
    return INF if max(m, g) >= F(2)**1023 else up(K * U * m + K * LEAST * g, 80)


def inner(N, H):
    return [[sum(n * h[c] for n, h in zip(N, row) if n) for c in range(4)] for row in H]


def outer(N, rows):
    return [sum(n * r[c] for n, r in zip(N, rows) if n) for c in range(4)]


def below(a):
    """All multi-indices not above a, but 0."""
    if len(a) == 1:
        return [(i,) for i in range(1, a[0] + 1)]
    return [(i, j) for i in range(a[0] + 1) for j in range(a[1] + 1) if i + j]


def sequence(orders):
    return sorted(orders, key=lambda a: (sum(a), a[-1]))


def divided(orders, rational):
    """Derivatives of the quotient and their (K, B), per multi-index; None if the weight vanishes or something is beyond the range of doubles."""
    D, C, B = {}, {}, {}
    for a in sequence(orders):
        value, E, M, K = orders[a]
        if not rational:
            D[a], B[a] = value[1:], E[1:]
            continue
        if INF in E:
            return None, None
        zero = tuple(0 for _ in a)
        (W0, *_), (E0, *_), (M0, *_), _ = orders[zero]
        D[a], B[a] = [], []
        for c in range(3):
            v, error = value[c + 1], E[c + 1]
            for b in below(a):
                t = tuple(x - y for x, y in zip(a, b))
                m = 1
                for x, y in zip(a, b):
                    m *= comb(x, y)
                v -= m * orders[b][0][0] * D[t][c]
                error += m * (orders[b][1][0] * C[t][c] + orders[b][2][0] * B[t][c])
            v /= W0
            if isinf(nearest(v)):
                return None, None
            D[a].append(v)
            B[a].append(up((error + E0 * abs(F(nearest(v)))) / M0 + K * LEAST, 80))
        C[a] = [abs(F(nearest(v))) for v in D[a]]
    return D, {a: [(orders[a][3], x) for x in B[a]] for a in B}


def number(x):
    return not isnan(x) and not isinf(x)


def sure(kind, *knots, w=()):
    """There is a right value as far as knots and weights go."""
    return kind != INVALID and all(map(measurable, knots)) and 0 not in w


def worse(*kinds):
    return max(kinds, key=(VALID, DEFINED, INVALID).index)


def knots_kind(p, u):
    """Validity of a knot vector of degree p by itself."""
    if not all(map(number, u)) or any(a > b for a, b in zip(u, u[1:])) or len(u) < 2 * p + 2:
        return INVALID
    lo, hi = domain(u, p)
    if lo >= hi:
        return INVALID
    if u[0] != lo or u[-1] != hi or any(a == b for a, b in zip(u, u[p + 1:])):
        return DEFINED
    return VALID if measurable(u) else DEFINED


def measurable(u):
    """No two different neighbours too close, and no difference beyond the range of doubles: else there is no right value."""
    return not any(0 < F(b) - F(a) < F(2)**-1022 for a, b in zip(u, u[1:])) and not isinf(nearest(F(u[-1]) - F(u[0])))


def net_kind(n, P, w):
    """Validity of control points and weights where the knots ask for n."""
    if len(P) != n or (w and len(w) != n) or not all(number(c) for q in P for c in q) or not all(map(number, w)) or any(x < 0 for x in w):
        return INVALID
    return DEFINED if any(x == 0 for x in w) else VALID


def curve_kind(c):
    kind = knots_kind(c.p, c.u)
    return kind if kind == INVALID else worse(kind, net_kind(c.n, c.P, c.w))


def surface_kind(s):
    kind = worse(knots_kind(s.p, s.u), knots_kind(s.q, s.v))
    return kind if kind == INVALID else worse(kind, net_kind(s.nu * s.nv, s.P, s.w))


def place_kind(u, p, x):
    """Validity of a parameter where the knots are usable: a number, inside the domain."""
    if not number(x):
        return INVALID
    lo, hi = domain(u, p)
    return VALID if lo <= x <= hi else DEFINED
