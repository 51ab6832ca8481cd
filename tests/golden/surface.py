"""Golden rows of spline/surface: sums over the control points in rationals.

Polynomial: abs gamma(7(p+q)) sum N M |x|.  Rational: numerator gamma(7(p+q)+1), denominator gamma(7(p+q)), one division; in all at most
gamma(14(p+q)+2) sum N M w |x| / sum N M w.  Derivatives: 7(p+q)+8 roundings of each term, and by Leibniz' rule those of the lower ones.
Where weights are tiny, each of fewer than 4 (p+1)(q+1) operations on a numerator may underflow, too: 2^-1075 each.
"""
from fractions import Fraction as F
from math import comb, lcm

import editing
from knots_of import BASES, clamped, families, inner_knots, valid
from rational import Choices, bound_of, gamma, head, nearest, root, row, span, up, window

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


# ---- edits, sides, normals.  After the surface: direction (0 u, 1 v), x, times (insert); direction, x, times, tolerance (remove); direction, times (elevate);
# a, b, u, v, sides along u and v (0 right, 1 left) for the derivative a times in u and b times in v (partials); u, v (normal and its status).  Wanted is a
# surface written as those of the arguments are: p, q, nu, nv, rational, knots, points, weights if rational; of a removal before it how often it was made.

class Given(Surface):
    """A surface of given control points."""

    def __init__(self, p, u, q, v, points, weights):
        self.p, self.u, self.q, self.v = p, u, q, v
        self.nu, self.nv = len(u) - p - 1, len(v) - q - 1
        self.P, self.w = points, weights
        self.finish()


def net_of(s, along):
    """The net along a direction: the points of a line across one after the other, (w, w x, w y, w z) each."""
    H = editing.lifted(s.P, s.w)
    n, lines = (s.nu, s.nv) if along == 0 else (s.nv, s.nu)
    at = lambda i, j: i * s.nv + j if along == 0 else j * s.nv + i
    return [[t for j in range(lines) for t in H[at(i, j)]] for i in range(n)]


def points_of(H, along):
    """The same as points in the surface's order."""
    lines = len(H[0]) // 4
    P = [[H[i][4 * j:4 * j + 4] for j in range(lines)] for i in range(len(H))]
    return [P[i][j] for i in range(len(H)) for j in range(lines)] if along == 0 else [P[i][j] for j in range(lines) for i in range(len(H))]


def edited(s, along, p, u, H):
    P = points_of(H, along)
    q, v = (s.q, s.v) if along == 0 else (s.p, s.u)
    lines = len(H[0]) // 4
    sizes = [p, q, len(H), lines] if along == 0 else [q, p, lines, len(H)]
    return sizes + [int(bool(s.w))] + (list(u) + v if along == 0 else v + list(u)) + editing.projected(P, s.w)


def direction(s, along):
    return (s.p, s.u) if along == 0 else (s.q, s.v)


def edit_row(name, s, along, args, change, m, why):
    p, u = direction(s, along)
    H = net_of(s, along)
    v, new = change(u, p, H)
    _, S = change(u, p, editing.magnitudes(H))
    limit = editing.bound(points_of(new, along), points_of(S, along), s.w, m, F(1, 2**1060))
    row(name, "abs " + bound_of(limit), why, s.args() + [along] + args, edited(s, along, p + (args[0] if name == "surface_elevate" else 0), v, new))


def insert_row(s, along, x, times, why):
    p = direction(s, along)[0]
    edit_row("surface_insert", s, along, [x, times], lambda u, p, H: editing.insert(u, p, H, x, times), 5 * min(times, p), why)


def elevate_row(s, along, times, why):
    p = direction(s, along)[0]
    edit_row("surface_elevate", s, along, [times], lambda u, p, H: editing.elevate(u, p, H, times), sum(7 * (p + k) + 2 for k in range(times)), why)


def remove_row(s, along, x, times, why):
    """As for curves: nothing is written where roundings might decide."""
    p, u = direction(s, along)
    H = net_of(s, along)
    E = [[(U * abs(t) if s.w and a % 4 else F(0)) for a, t in enumerate(P)] for P in H]
    flat = points_of(H, along)
    least, most = min(P[0] for P in flat), max(sum(abs(t / P[0]) for t in P[1:]) for P in flat)
    tolerance = 2.0**-20 * float(max(abs(F(t)) for P in s.P for t in P) or 1)
    allowed, reach = least * F(tolerance), most + F(tolerance)
    spent, count = F(0), 0
    while count < times and x in u:
        P, errors, found = editing.removal_errors(u, p, H, E, x)
        found = [((reach if s.w else 0) * d, (reach if s.w else 0) * e) if a % 4 == 0 else (d, e) for a, (d, e) in enumerate(found)]
        next_one = editing.remove(u, p, H, x)
        if next_one is None:
            if max(d - e for d, e in found) <= 2 * allowed:
                return
            break
        spent += 4 * max(e for _, e in found)
        if spent > allowed / 2:
            return
        u, H = next_one
        E = errors
        count += 1
    limit = editing.bound(points_of(H, along), points_of(E, along), s.w, None, F(1, 2**1060))
    row("surface_remove", "abs " + bound_of(limit) if count else "exact", why + (", %d times" % count if count else ", not removable"),
        s.args() + [along, x, times, tolerance], [count] + edited(s, along, p, u, H))


def inserted(c, s, along, x, times):
    """The surface, its points integers times what divides, with the knot so often more."""
    p, u = direction(s, along)
    n = len(u) - p - 1
    _, unit = editing.insert(u, p, [[F(int(i == j)) for j in range(n)] for i in range(n)], x, times)
    factor = lcm(*(t.denominator for one in unit for t in one))
    P = [[F(c.upto(64) - 32) * factor for _ in range(3)] for _ in s.P]
    w = [F(4)] * len(P) if s.w else None
    whole = Given(s.p, s.u, s.q, s.v, P, w)
    v, H = editing.insert(u, p, net_of(whole, along), x, times)
    flat = points_of(H, along)
    points, weights = [[float(t / h[0]) for t in h[1:]] for h in flat], [float(h[0]) for h in flat] if w else None
    return Given(s.p, list(v), s.q, s.v, points, weights) if along == 0 else Given(s.p, s.u, s.q, list(v), points, weights)


def side_of(u, p, x, left):
    some = [k for k in range(p, len(u) - p - 1) if u[k] < u[k + 1]]
    return (max([k for k in some if u[k] < x] or some[:1])) if left else span(u, p, x)


def partials(s, x, y, left_u, left_v, a, b):
    """The derivative and a bound of its error: those of lower order before, by Leibniz' rule."""
    i, j = side_of(s.u, s.p, x, left_u), side_of(s.v, s.q, y, left_v)
    x, y = min(max(x, s.u[s.p]), s.u[-s.p - 1]), min(max(y, s.v[s.q]), s.v[-s.q - 1])
    H = editing.lifted(s.P, s.w)

    def tensor(k, l, sign):
        N, M = window(s.u, s.p, i, x, k, sign), window(s.v, s.q, j, y, l, sign)
        total = [F(0)] * 4
        for r, n in enumerate(N):
            for t, m in enumerate(M):
                h = H[(i - s.p + r) * s.nv + j - s.q + t]
                total = [z + n * m * (e if sign == -1 else abs(e)) for z, e in zip(total, h)]
        return total

    A = {(k, l): tensor(k, l, -1) for k in range(a + 1) for l in range(b + 1)}
    M = {(k, l): [up(t) for t in tensor(k, l, 1)] for k in range(a + 1) for l in range(b + 1)}
    if not s.w:
        return A[a, b][1:], [gamma(7 * (s.p + s.q) + 6) * t for t in M[a, b][1:]]
    g, w = gamma(7 * (s.p + s.q) + (s.p + 1) * (s.q + 1) + 8), A[0, 0][0]
    D, E = {}, {}
    for k in range(a + 1):
        for l in range(b + 1):
            D[k, l], E[k, l] = [], []
            for n in range(3):
                value, error, size = A[k, l][n + 1], F(0), M[k, l][n + 1]
                for r in range(k + 1):
                    for t in range(l + 1):
                        if r + t:
                            f = comb(k, r) * comb(l, t)
                            value -= f * A[r, t][0] * D[k - r, l - t][n]
                            error += f * abs(A[r, t][0]) * E[k - r, l - t][n]
                            size += f * M[r, t][0] * (abs(D[k - r, l - t][n]) + E[k - r, l - t][n])
                D[k, l].append(value / w)
                E[k, l].append(up((error + g * (size + 2 * abs(value))) / (w * (1 - g))))
    return D[a, b], E[a, b]


def partials_row(s, why, x, y, left_u, left_v, a, b):
    D, E = partials(s, x, y, left_u, left_v, a, b)
    if any(abs(t) > F(2)**900 for t in D + E) or any(0 < abs(t) < F(2)**-900 for t in D):
        return
    zero = not s.w and (a > s.p or b > s.q)
    bound = max(E) + max(abs(t) for t in D) * U + F(1, 2**1060)
    side = ", one-sided derivative" if left_u or left_v else ""
    row("surface_partials", "exact" if zero else "abs " + bound_of(bound), why + side, s.args() + [a, b, x, y, int(left_u), int(left_v)], D)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normal_row(s, why, x, y):
    """The bound of the header: magnitudes of what is seen from the control point of the greatest share."""
    i, j = span(s.u, s.p, x), span(s.v, s.q, y)
    x, y = min(max(x, s.u[s.p]), s.u[-s.p - 1]), min(max(y, s.v[s.q]), s.v[-s.q - 1])
    N, M = [window(s.u, s.p, i, x, k) for k in (0, 1)], [window(s.v, s.q, j, y, k) for k in (0, 1)]
    mN, mM = window(s.u, s.p, i, x, 1, 1), window(s.v, s.q, j, y, 1, 1)
    order = lambda n: sorted(range(len(n)), key=lambda r: -n[r])
    if len(order(N[0])) > 1 and nearest(N[0][order(N[0])[0]]) == nearest(N[0][order(N[0])[1]]):
        return                                     # which of two is the greatest might depend on roundings
    if len(order(M[0])) > 1 and nearest(M[0][order(M[0])[0]]) == nearest(M[0][order(M[0])[1]]):
        return
    O = [F(t) for t in s.P[(i - s.p + order(N[0])[0]) * s.nv + j - s.q + order(M[0])[0]]]
    sums = [[F(0)] * 4 for _ in range(6)]
    for r in range(s.p + 1):
        for t in range(s.q + 1):
            k = (i - s.p + r) * s.nv + j - s.q + t
            w = F(s.w[k]) if s.w else F(1)
            h = [w] + [w * (F(e) - o) for e, o in zip(s.P[k], O)]
            for z, f in enumerate((N[0][r] * M[0][t], N[1][r] * M[0][t], N[0][r] * M[1][t])):
                sums[z] = [e + f * d for e, d in zip(sums[z], h)]
            for z, f in enumerate((N[0][r] * M[0][t], mN[r] * M[0][t], N[0][r] * mM[t])):
                sums[3 + z] = [e + f * abs(d) for e, d in zip(sums[3 + z], h)]
    A, size = sums[0], sums[3]
    T = [[A[0] * d - D[0] * a for a, d in zip(A[1:], D[1:])] if s.w else D[1:] for D in sums[1:3]]
    S = [[size[0] * d + D[0] * a for a, d in zip(size[1:], D[1:])] if s.w else D[1:] for D in sums[4:6]]
    c = cross(*T)
    B = [S[0][1] * S[1][2] + S[0][2] * S[1][1], S[0][2] * S[1][0] + S[0][0] * S[1][2], S[0][0] * S[1][1] + S[0][1] * S[1][0]]
    squares, limit = sum(t * t for t in c), gamma(28 * (s.p + s.q) + 16)
    if squares == 0:
        row("surface_normal_status", "exact", why + ", no normal", s.args() + [x, y], [5])
        return
    ratio = up(root(up(sum(t * t for t in B) / squares, 60))[0] * (1 + F(1, 2**60)) * limit)       # |B|/|c|, not less
    if ratio < F(1, 1000):
        # The square root of a square's quotient, far beyond what a double tells.
        want = [(1 if t > 0 else -1) * root(t * t / squares, 2, 300)[0] if t else F(0) for t in c]
        row("surface_normal", "abs " + bound_of(2 * ratio * (1 + 2 * ratio) + 6 * U), why, s.args() + [x, y], want)


def edits(c):
    few = lambda: (c.upto(64) - 32) / 8.0
    kinds = [(s, why) for s, why, _ in categories(c, 3) if "extreme" not in why or "coordinates" not in why]
    for n, (s, why) in enumerate(kinds):
        if s.p > 6 or s.q > 6:
            continue
        for along in (0, 1):
            p, u = direction(s, along)
            lo, hi = u[p], u[-p - 1]
            inside = [t for t in u if lo < t < hi]
            x = c.of(inside) if inside and c.upto(1) else lo + (hi - lo) * c.short(0.125, 0.875, 6)
            m = u.count(x)
            if m <= p and valid(sorted(u + [x]), p) and lo <= x <= hi and n % 2 == along:
                insert_row(s, along, x, c.between(1, p + 1 - m), why + (", editing, repeated knots" if m else ", editing, new knot"))
            if u[0] == lo and u[-1] == hi and max(u.count(t) for t in u) <= p + 1 and n % 3 == along:
                elevate_row(s, along, c.between(1, 2), why + ", editing, degree elevated")
            if inside and n % 2 == along:
                remove_row(s, along, c.of(inside), c.between(1, 2), why + ", editing")
            if n % 4 == 2 * along and hi - lo < 1e6:
                x, times = c.of((0.25, 0.5, 0.75)), c.between(1, p)
                unit = Surface(c, 3, clamped(3, [0.25, 0.5]), 2, clamped(2, [0.5]), bool(s.w), few)
                if direction(unit, along)[1].count(x) + times <= direction(unit, along)[0] + 1:
                    made = inserted(c, unit, along, x, times)
                    remove_row(made, along, x, times + c.upto(1), ("rational, " if s.w else "") + "editing, inserted before")
        spots = list(spots_of(c, s))
        for where, x, y in spots[n % 2::2]:
            if "scale, spans" not in why:
                a, b = c.upto(3), c.upto(3)
                partials_row(s, why + ", " + where, x, y, c.upto(1) == 1, c.upto(1) == 1, a, b)
                normal_row(s, why + ", " + where, x, y)
    for p, q, rational in [(3, 3, False), (2, 3, True), (1, 1, False), (0, 2, True), (4, 1, True)]:
        s = Surface(c, p, clamped(p, [0.5] * (p + 1)), q, clamped(q, [0.25] * q + [0.75]), rational, few)
        for x in (0.0, 0.5, 1.0):
            for y in (0.25, 0.75, 0.375):
                for sides in range(4):
                    a, b = c.upto(p + 1), c.upto(q + 1)
                    partials_row(s, "repeated knots", x, y, sides // 2 == 1, sides % 2 == 1, a, b)
                normal_row(s, "repeated knots", x, y)
        for k in range(p + 3):
            partials_row(s, "high orders", 0.375, 0.5, False, False, k, 4)
    for p, q, d in [(0, 0, 0), (3, 3, 0), (3, 3, 2), (3, 3, 3), (3, 2, 5), (2, 5, 4), (9, 1, 20), (1, 9, 20), (25, 25, 3), (7, 7, 7), (7, 7, 8)]:
        a, b = min(d, p) + 1, min(d, q) + 1
        most = max((p + 1) * (p + 5), (q + 1) * (q + 5))
        row("surface_partials_work", "exact", "doubles", [p, q, d], [a * (p + 1) + b * (q + 1) + 4 * a * (q + 1) + most + (d + 1) * (d + 2)])
    for p, q, d in [(2**64 - 1, 0, 0), (0, 2**64 - 1, 0), (2**63, 1, 1), (1, 2**62, 1), (3, 3, 2**64 - 1), (3, 3, 2**63), (3, 3, 2**32), (2**31, 2**32, 2**31)]:
        row("surface_partials_work", "exact", "does not fit", [p, q, d], [2**64 - 1])


def main():
    head("surface", "points, derivatives and grids")
    c = Choices(13)
    first(c)
    for n, (s, why, ders) in enumerate(categories(c, 9)):
        tabulate(c, s, why, ders)
        if n % 5 == 0:
            valid_rows(c, s, why)
    edits(Choices(29))


main()
