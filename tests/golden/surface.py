"""Golden rows of spline/surface: sums over the control points in rationals.

Polynomial: abs gamma(7(p+q)) sum N M |x|.  Rational: numerator gamma(7(p+q)+1), denominator gamma(7(p+q)), one division; in all at most
gamma(14(p+q)+2) sum N M w |x| / sum N M w.  Derivatives: 7(p+q)+8 roundings of each term, and by Leibniz' rule those of the lower ones.
Where weights are tiny, each of fewer than 4 (p+1)(q+1) operations on a numerator may underflow, too: 2^-1075 each.
"""
from fractions import Fraction as F
from math import lcm

from knots_of import BASES, clamped, families, inner_knots
from rational import Choices, bound_of, gamma, head, nearest, row, span, up, window

ORDERS = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
# Which earlier results enter each derivative's quotient: (order of w, index of D, factor).
PARTS = [[], [((1, 0), 0, 1)], [((0, 1), 0, 1)], [((1, 0), 1, 2), ((2, 0), 0, 1)],
         [((1, 0), 2, 1), ((0, 1), 1, 1), ((1, 1), 0, 1)], [((0, 1), 2, 2), ((0, 2), 0, 1)]]
U = F(1, 2**53)


def common(values):
    """Numerators over one denominator."""
    d = lcm(*(v.denominator for v in values))
    return [v.numerator * (d // v.denominator) for v in values], d


class Surface:
    def __init__(self, c, p, u, q, v, rational, draw=None, weight=None):
        self.p, self.u, self.q, self.v = p, u, q, v
        self.nu, self.nv = len(u) - p - 1, len(v) - q - 1
        n = self.nu * self.nv
        draw = draw or (lambda: c.real(-1, 1) if c.upto(9) == 0 else (c.upto(512) - 256) / 64.0)
        weight = weight or (lambda: (c.upto(24) + 8) / 16.0)
        self.P = [[draw() for _ in range(3)] for _ in range(n)]
        self.w = [weight() for _ in range(n)] if rational else None
        self.finish()

    def finish(self):
        """Homogeneous control points as integers over one denominator."""
        flat = [x for k, P in enumerate(self.P) for x in self.lifted(k, P)]
        whole, self.scale = common(flat)
        self.H = [whole[4 * k:4 * k + 4] for k in range(len(self.P))]
        self.cache = {}
        return self

    def lifted(self, k, P):
        w = F(self.w[k]) if self.w else F(1)
        return [w] + [w * F(t) for t in P]

    def args(self):
        a = [self.p, self.q, self.nu, self.nv, int(self.w is not None)] + self.u + self.v + [x for P in self.P for x in P]
        return a + (self.w or [])

    def basis(self, which, x, d, sign):
        key = (which, x, d, sign)
        if key not in self.cache:
            u, p = (self.u, self.p) if which == 0 else (self.v, self.q)
            k = span(u, p, x)
            self.cache[key] = (k - p, *common(window(u, p, k, min(max(x, u[p]), u[-p - 1]), d, sign)))
        return self.cache[key]

    def tensor(self, u, v, order, sign):
        i, N, a = self.basis(0, u, order[0], sign)
        j, M, b = self.basis(1, v, order[1], sign)
        total = [0] * 4
        for r, x in enumerate(N):
            if x:
                part = [0] * 4
                for s, y in enumerate(M):
                    H = self.H[(i + r) * self.nv + j + s]
                    part = [t + y * (h if sign == -1 else abs(h)) for t, h in zip(part, H)]
                total = [t + x * y for t, y in zip(total, part)]
        return [F(t, a * b * self.scale) for t in total]

    def derivatives(self, u, v, orders=6):
        """All six, and bounds of their errors."""
        D, E = [], []
        m = 7 * (self.p + self.q) + 12
        g, g8, g3 = up(gamma(m)), up(gamma(8)), up(gamma(3 * m))
        A = {o: self.tensor(u, v, o, -1) for o in ORDERS[:orders]}
        S = {o: [up(x) for x in self.tensor(u, v, o, 1)] for o in ORDERS[:orders]}
        if not self.w:
            for o in ORDERS[:orders]:
                D.append(A[o][1:])
                E.append([up(g * s) for s in S[o][1:]])
            return D, E
        w = A[(0, 0)][0]
        least = 1 / up(1 / w)
        size_of = {o: up(abs(A[o][0])) for o in A}
        for k, o in enumerate(ORDERS[:orders]):
            D.append([])
            E.append([])
            lost = F(4 * (self.p + 1) * (self.q + 1), 2**1075) if k == 0 else 0
            for a in range(3):
                value, error, size = A[o][a + 1], g * S[o][a + 1] + lost, up(abs(A[o][a + 1]))
                for wo, d, f in PARTS[k]:
                    part = up(abs(D[d][a]))
                    value -= f * A[wo][0] * D[d][a]
                    error += f * (g * S[wo][0] * (part + E[d][a]) + size_of[wo] * E[d][a])
                    size += f * S[wo][0] * (part + E[d][a])
                value /= w
                D[k].append(value)
                E[k].append(up((up(error + g8 * (size + error)) / least + (g + lost / least) * up(abs(value))) * (1 + g3 + 2 * lost / least)))
        return D, E

    def point(self, u, v):
        D, E = self.derivatives(u, v, 1)
        return D[0], max(E[0]) + max(abs(x) for x in D[0]) * U


def corner(s, u, v):
    k = (s.nu - 1 if u else 0) * s.nv + (s.nv - 1 if v else 0)
    return s.P[k]


def clean(x):
    return 0.0 if x == 0 else x


def points_row(s, why, spots):
    values = [s.point(a, b) for a, b in spots]
    row("surface_points", "abs " + bound_of(max(e for _, e in values)), why, s.args() + [len(spots)] + [t for x in spots for t in x],
        [t for S, _ in values for t in S])


def grid_row(s, why, A, B):
    values = [s.point(a, b) for a in A for b in B]
    row("surface_grid", "abs " + bound_of(max(e for _, e in values)), why, s.args() + [len(A), len(B)] + A + B, [t for S, _ in values for t in S])


def point_row(s, why, a, b):
    S, bound = s.point(a, b)
    row("surface_point", "abs " + bound_of(bound), why, s.args() + [a, b], S)


def ders_rows(s, why, a, b, which):
    D, E = s.derivatives(a, b)
    for k in which:
        if any(nearest(abs(x)) > 1e300 for x in D[k] + E[k]):
            continue                               # its terms may overflow
        bound = max(E[k]) + max(abs(x) for x in D[k]) * U
        row("surface_ders", "abs " + bound_of(bound), why, s.args() + [k, a, b], D[k])


def valid_rows(c, s, why):
    row("surface_valid", "exact", why, s.args(), [1])
    at = 5 + len(s.u) + len(s.v)
    for what, x in (("zero", 0.0), ("negative", -1.0), ("not a number", float("nan")), ("infinite", float("inf"))):
        bad = s.args()
        bad[-1] = x
        row("surface_valid", "exact", why + ", last number " + what, bad, [int(not s.w and x - x == 0)])
    for what, x in (("not a number", float("nan")), ("infinite", float("-inf"))):
        bad = s.args()
        bad[at + c.upto(3 * s.nu * s.nv - 1)] = x
        row("surface_valid", "exact", why + ", a coordinate " + what, bad, [0])
        bad = s.args()
        bad[5 + c.upto(len(s.u) + len(s.v) - 1)] = x
        row("surface_valid", "exact", why + ", a knot " + what, bad, [0])
    bad = s.args()
    i, j = 5 + s.p, 5 + len(s.u) - s.p - 1
    bad[i], bad[j] = bad[j], bad[i]
    row("surface_valid", "exact", why + ", decreasing", bad, [0])
    bad = s.args()
    j = 5 + len(s.u) + s.q
    bad[j:j + len(s.v) - 2 * s.q] = [s.v[s.q]] * (len(s.v) - 2 * s.q)
    row("surface_valid", "exact", why + ", empty domain", bad, [0])


def spots_of(c, s):
    """(category, u, v)"""
    u, p, v, q = s.u, s.p, s.v, s.q
    lo, hi, low, high = u[p], u[-p - 1], v[q], v[-q - 1]
    some = lambda a, b: a + (b - a) * c.short(0.125, 0.875, 6)
    inside = [t for t in u if lo < t < hi]
    yield "end of domain", c.of((lo, hi)), c.of((low, high))
    yield "end of domain", c.of((lo, hi)), some(low, high)
    yield "end of domain", some(lo, hi), c.of((low, high))
    if inside:
        yield "at a knot", c.of(inside), some(low, high)
    yield "between", some(lo, hi), some(low, high)
    yield "between", c.real(lo, hi), c.real(low, high)
    if lo - 1.0 > -1e300:
        yield "outside the domain", c.of((lo - 1.0, hi + 1.0)), c.of((low - 1.0, high + 1.0))


def tabulate(c, s, why, ders=True):
    spots = list(spots_of(c, s))
    for where, a, b in spots:
        point_row(s, why + ", " + where, a, b)
    if ders:
        for where, a, b in spots[c.upto(1)::2]:
            side = ", one-sided derivative" if where in ("at a knot", "end of domain") else ", " + where
            ders_rows(s, why + side, a, b, sorted({c.between(1, 5), c.upto(5)}))
    if c.upto(3) == 0:
        points_row(s, why, [(a, b) for _, a, b in spots])
    if c.upto(3) == 0:
        grid_row(s, why, [a for _, a, _ in spots[:3]], [b for _, _, b in spots[2:4]])


def small(c, degrees=4):
    """Degree and knots of a small direction."""
    p = c.between(1, degrees)
    inner = c.of((0, 0, 1, 2))
    return p, clamped(p, inner_knots(c, inner, p, 16))


def reshape(s, change):
    for i in range(s.nu):
        for j in range(s.nv):
            change(s, i, j, i * s.nv + j)
    return s.finish()


def pole(s, i, j, k):
    if i == 0:
        s.P[k] = s.P[0]


def two_poles(s, i, j, k):
    if i in (0, s.nu - 1):
        s.P[k] = s.P[i * s.nv]


def coincident(s, i, j, k):
    s.P[k] = s.P[0]


def closed(s, i, j, k):
    if i == s.nu - 1:
        s.P[k] = s.P[j]
        if s.w:
            s.w[k] = s.w[j]


def pair(s, i, j, k):
    if k == 1:
        s.P[k] = s.P[0]


def categories(c, rounds):
    """(surface, category, whether derivatives can be tabulated)"""
    few = lambda: (c.upto(64) - 32) / 8.0
    for n in range(rounds):
        d = lambda: small(c)
        make = lambda rational, draw=few, weight=None: Surface(c, *d(), *d(), rational, draw, weight)
        for rational in (False, True):
            yield make(rational), "random", True
            yield reshape(make(rational), (pole, two_poles)[n % 2]), "degenerate geometry, pole", True
            yield reshape(make(rational), (coincident, pair)[n % 2]), "degenerate geometry, coincident points", True
            yield reshape(make(rational), closed), "seam and closure", True
        e = (1e307, -1e307, 1e300, 2.0**1022)[n % 4]
        yield make(False, lambda: c.short(-1, 1, 16) * e), "extreme scale, coordinates", False
        yield make(False, lambda: c.short(-1, 1, 16) * 2.0**-1000), "extreme scale, coordinates", True
        yield make(n % 2, lambda: 1e9 + c.short(-1, 1, 16)), "extreme scale, offset", True
        yield make(True, few, lambda: c.of((1.0, 1e16, 1e-16, 1e8))), "weight ratios of 1e16", True
        yield make(True, few, lambda: c.of((2.0**-900, 2.0**-1000, 3 * 2.0**-950))), "all-tiny weights", False
        yield make(True, few, lambda: (c.upto(24) + 8) * 2.0**-800), "all-tiny weights", True
    for n, (p, u, why) in enumerate(families(c, rounds // 2 + 1, 3)):
        q, v = small(c, 3)
        a = (p, u, q, v) if n % 2 == 0 else (q, v, p, u)
        yield Surface(c, *a, n % 3 == 2, few), why, "scale" not in why
    for p in range(0, 26, 1):
        q, v = (1, clamped(1, [])) if p > 5 else (p + 1, clamped(p + 1, []))
        a = (p, clamped(p, []), q, v) if p % 2 == 0 else (q, v, p, clamped(p, []))
        yield Surface(c, *a, p % 3 == 1, few), "degree %d" % p, True


def first(c):
    CLAMPED = [0.0] * 4 + [0.1, 0.3, 0.7] + [1.0] * 4
    BERNSTEIN = [0.0] * 4 + [1.0] * 4
    LINE, HALF = [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0]
    KINDS = [(3, BERNSTEIN, 3, BERNSTEIN, False, "Bezier"), (3, BERNSTEIN, 3, BERNSTEIN, True, "rational Bezier"),
             (3, CLAMPED, 3, BERNSTEIN, False, "bicubic"), (3, BERNSTEIN, 3, CLAMPED, True, "rational bicubic"),
             (1, LINE, 2, HALF, False, "degrees 1 and 2"), (2, HALF, 1, LINE, True, "degrees 2 and 1"),
             (0, [0.0, 0.5, 1.0], 3, BERNSTEIN, False, "degree 0"),
             (3, BASES[2][1], 2, BASES[9][1], False, "near-equal knots"), (3, BASES[4][1], 1, BASES[8][1], True, "repeated knots")]
    for p, u, q, v, rational, why in KINDS:
        s = Surface(c, p, u, q, v, rational)
        valid_rows(c, s, why)
        ends = [(a, b) for a in (u[p], u[-p - 1]) for b in (v[q], v[-q - 1])]
        spots = ends + [(u[p], c.real(v[q], v[-q - 1])), (c.real(u[p], u[-p - 1]), v[-q - 1]), (-9.0, 99.0)]
        spots += [(c.real(u[p], u[-p - 1]), c.real(v[q], v[-q - 1])) for _ in range(3)]
        spots += [(u[min(p + 1, len(u) - p - 1)], c.real(v[q], v[-q - 1]))]
        for a, b in spots:
            point_row(s, why, a, b)
        if not rational and u in (BERNSTEIN, CLAMPED) and v == BERNSTEIN:
            for a, b in ends:
                row("surface_point", "exact", why + ", end of domain, corner", s.args() + [a, b], [clean(x) for x in corner(s, a, b)])
        for a, b in spots[3:4] + spots[7:8] + spots[-1:]:
            ders_rows(s, why, a, b, range(6))
        points_row(s, why, spots)
        grid_row(s, why, [u[p], c.real(u[p], u[-p - 1]), u[-p - 1], -7.0], [c.real(v[q], v[-q - 1]), v[-q - 1], v[q]])
    for a in (0.0, 0.25, 0.5, 0.75, 1.0):
        for b in (0.5, 0.25, 1.0):
            s = Surface(c, 3, BERNSTEIN, 3, BERNSTEIN, False, lambda: float(c.upto(16) - 8))
            row("surface_point", "exact", "integers at quarters: no rounding", s.args() + [a, b], s.point(a, b)[0])


def main():
    head("surface", "points, derivatives and grids")
    c = Choices(13)
    first(c)
    for n, (s, why, ders) in enumerate(categories(c, 9)):
        tabulate(c, s, why, ders)
        if n % 5 == 0:
            valid_rows(c, s, why)


main()
