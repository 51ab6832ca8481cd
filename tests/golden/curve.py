"""Golden rows of spline/curve: the sums of its definition in rationals, the bounds as the header states them.

After the curve's arguments (p, n, rational, knots, points, weights if rational): x for a point; k, x for the k-th derivative, which alone is wanted.
With g = gamma(8p+5), M_k and W_i the sums of the terms' magnitudes, Leibniz' rule bounds the errors E_k of a rational curve's derivatives one
after the other:  w_0 (1 - g) E_k <= sum C(k,i) |w_i| E_(k-i) + g (M_k + sum C(k,i) W_i (|D_(k-i)| + E_(k-i)) + w_0 |D_k|),  i = 1..k.
"""
from fractions import Fraction as F
from math import comb, gcd, nextafter

import editing
from knots_of import BASES, valid
from rational import Choices, above, cox_derivative, gamma, head, row, span

INF = float("inf")
TINY = F(1, 2**1074)
MORE = [
    (4, [0.0] * 5 + [0.25, 0.25, 0.5] + [1.0] * 5, "degree 4"),
    (9, [0.0] * 10 + [0.375] + [1.0] * 10, "degree 9"),
    (12, [0.0] * 13 + [1.0] * 13, "degree 12"),
    (3, [2.0**500 * t for t in [0.0] * 4 + [0.3, 0.6] + [1.0] * 4], "knots times 2^500"),
    (3, [2.0**-300 * t for t in [0.0] * 4 + [0.3, 0.6] + [1.0] * 4], "knots times 2^-300"),
    (2, [1e9, 1e9, 1e9, 1e9 + 0.25, 1e9 + 0.5, 1e9 + 0.5, 1e9 + 0.5], "knots far from 0"),
    (1, [0.0, 0.0, 2.0**-1022, 1.0, 1.0], "the smallest span"),
    (3, [-0.0, 0.0, -0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 1.0], "zeros of both signs"),
]
POINTS = [("", lambda c: (c.upto(512) - 256) / 64.0), ("; any coordinates", lambda c: c.real(-1, 1)),
          ("; far away", lambda c: 1e9 + c.upto(64) / 64.0), ("; huge", lambda c: c.real(-1, 1) * 1e307),
          ("; subnormal", lambda c: (c.upto(2000) - 1000) * 2.0**-1074),
          ("; mixed scales", lambda c: c.real(-1, 1) * 10.0**(c.upto(40) - 20)), ("; coincident", lambda c: 0.3)]
WEIGHTS = [("", lambda c: (c.upto(24) + 8) / 16.0), ("; weights 1e-8 to 1e8", lambda c: 10.0**(c.upto(16) - 8)), ("; equal weights", lambda c: 0.1),
           ("; tiny weights", lambda c: c.real(1, 2) * 1e-150)]


class Curve:
    def __init__(self, p, u, points, weights=None):
        self.p, self.u, self.n, self.P, self.w = p, u, len(u) - p - 1, points, weights

    def args(self):
        return [self.p, self.n, int(self.w is not None)] + self.u + [x for P in self.P for x in P] + (self.w or [])

    def sums(self, x, k, sign):
        """The k-th derivatives of w, w x, w y, w z; with sign = 1 the sums of the terms' magnitudes."""
        at = span(self.u, self.p, x)
        x = min(max(x, self.u[self.p]), self.u[-self.p - 1])
        N = cox_derivative(self.u, self.p, at, F(x), k, sign)
        total = [F(0)] * 4
        for i in range(at - self.p, at + 1):
            w = F(self.w[i]) if self.w else F(1)
            for a, c in enumerate([F(1)] + [F(t) for t in self.P[i]]):
                total[a] += N[i] * w * (abs(c) if sign == 1 else c)
        return total

    def derivatives(self, x, d):
        """D[0..d] and bounds of their errors."""
        A = [self.sums(x, k, -1) for k in range(d + 1)]
        M = [self.sums(x, k, 1) for k in range(d + 1)]
        small = TINY * (self.p + 2)
        if not self.w:
            bounds = [gamma(7 * self.p + (3 if k else 0)) for k in range(d + 1)]
            return [a[1:] for a in A], [[g * m + small for m in Mk[1:]] for g, Mk in zip(bounds, M)]
        D, E, g, w0 = [], [], gamma(8 * self.p + 5), A[0][0]
        for k in range(d + 1):
            D.append([])
            E.append([])
            for a in range(3):
                value, error, size = A[k][a + 1], small, M[k][a + 1]
                for i in range(1, k + 1):
                    value -= comb(k, i) * A[i][0] * D[k - i][a]
                    error += comb(k, i) * abs(A[i][0]) * E[k - i][a] + small
                    size += comb(k, i) * M[i][0] * (abs(D[k - i][a]) + E[k - i][a])
                D[k].append(value / w0)
                E[k].append((error + g * (size + abs(value))) / (w0 * (1 - g)) + small)
        return D, E


def fits(x):
    """Neither this nor what it is made of over- or underflows."""
    return x == 0 or F(2)**-900 < abs(x) < F(2)**1000


def point_row(c, x, why, kind=None):
    D, E = c.derivatives(x, 0)
    bound = max(E[0]) + max(abs(t) for t in D[0]) * F(1, 2**53) + TINY
    row("curve_point", kind or "abs " + above(bound), why, c.args() + [x], D[0])


def ders_rows(c, x, d, why, kind=None):
    D, E = c.derivatives(x, max(d))
    for k in d:
        bound = max(E[k]) + max(abs(t) for t in D[k]) * F(1, 2**53) + TINY
        zero = not c.w and k > c.p
        if zero or all(fits(t) for t in D[k] + E[k]):
            row("curve_ders", "exact" if zero else kind or "abs " + above(bound), why, c.args() + [k, x], D[k])


def places(c, u, p):
    """Parameters: ends, knots, their neighbours, places between, beyond."""
    lo, hi = u[p], u[-p - 1]
    inner = sorted(x for x in set(u) if lo <= x <= hi)
    some = [inner[c.upto(len(inner) - 1)] for _ in range(2)]
    at = [lo, hi, nextafter(lo, hi), nextafter(hi, lo)] + some + [nextafter(x, INF) for x in some] + [nextafter(some[0], -INF)]
    at += [lo + (hi - lo) * (c.upto(14) + 1) / 16.0] + [c.real(lo, hi) for _ in range(3)] + [lo - 1.5 * (hi - lo), hi + (hi - lo)]
    return list(dict.fromkeys(at))


head("curve", "points and derivatives")
c = Choices(17)
for p, d in [(0, 0), (0, 5), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 40), (9, 5), (100, 2), (7, 7), (7, 8)]:
    row("curve_work", "exact", "doubles", [p, d], [(min(d, p) + 1) * (p + 1) + (p + 1) * (p + 5) + 2 * (d + 1)])
for p, d in [(2**64 - 1, 0), (2**63, 1), (2**32, 2), (3, 2**64 - 1), (3, 2**63), (3 * 2**30, 3 * 2**30), (2877612000, 2**64 // 5)]:
    row("curve_work", "exact", "does not fit", [p, d], [2**64 - 1])
count = 0
for p, u, why in BASES + MORE:
    n = len(u) - p - 1
    for rational in (False, True):
        for again in range(3 if p <= 3 else 2):
            what, draw = POINTS[count % len(POINTS)]
            and_what, weigh = WEIGHTS[count // 2 % len(WEIGHTS)] if rational else ("", None)
            if rational and what in ("; huge", "; subnormal", "; mixed scales") and and_what:
                what, draw = POINTS[1]
            count += 1
            s = Curve(p, u, [[draw(c) for _ in range(3)] for _ in range(n)], [weigh(c) for _ in range(n)] if rational else None)
            label = ("rational, " if rational else "") + why + what + and_what
            row("curve_valid", "exact", label, s.args(), [1])
            at = places(c, u, p)
            for x in at[:4] + at[4 + again::3]:
                point_row(s, x, label)
            if what not in ("; huge", "; subnormal"):
                for x in (at[again], at[4 + again % 2], at[-3]):
                    ders_rows(s, x, sorted({1, 2, 3, p, p + 1}), label)
for p, u, why in BASES + MORE:
    for bad, value, what in [(-1, -1.0, "last number -1"), (-1, 0.0, "last number 0"), (-1, INF, "last number infinite"),
                             (3 + p, float("nan"), "a knot NaN"), (3, 1e300, "knots decrease")]:
        for rational in (0, 1):
            n = len(u) - p - 1
            a = Curve(p, u, [[1.0, 2.0, 3.0]] * n, [1.0] * n if rational else None).args()
            a[bad] = value
            row("curve_valid", "exact", why + ", " + what, a, [int(bad == -1 and (value in (-1.0, 0.0)) and not rational)])
    if u[0] == u[p] and u[-1] == u[-p - 1]:
        n = len(u) - p - 1
        s = Curve(p, u, [[c.real(-9, 9) for _ in range(3)] for _ in range(n)])
        point_row(s, u[0], why + ", the first control point", "exact")
        point_row(s, u[-1], why + ", the last control point", "exact")
for p in range(0, 8):
    for rational in (False, True):
        for x in (0.0, 0.125, 0.5, 0.75, 1.0):
            s = Curve(p, [0.0] * (p + 1) + [1.0] * (p + 1), [[float(c.upto(16) - 8) for _ in range(3)] for _ in range(p + 1)],
                      [2.0**-3] * (p + 1) if rational else None)
            point_row(s, x, "integers at eighths: no rounding", "exact")
            if not rational and p > 0:
                ders_rows(s, x, [k for k in (1, 2, 3, 5) if k <= p], "integers at eighths: no rounding", "exact")
R = 0.7071067811865476
ARC = Curve(2, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], [1.0, R, 1.0])
CIRCLE = Curve(2, [0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0],
               [[1.0, 0.0, 2.0], [1.0, 1.0, 2.0], [0.0, 1.0, 2.0], [-1.0, 1.0, 2.0], [-1.0, 0.0, 2.0], [-1.0, -1.0, 2.0], [0.0, -1.0, 2.0],
                [1.0, -1.0, 2.0], [1.0, 0.0, 2.0]], [1.0, R, 1.0, R, 1.0, R, 1.0, R, 1.0])
for k in range(17):
    for s, why in ((ARC, "a quarter of a circle"), (CIRCLE, "a circle")):
        point_row(s, k / 16.0, why)
        if k % 4 == 1 or k in (0, 4, 16):
            ders_rows(s, k / 16.0, [1, 2, 3, 4, 7], why)


# ---- edits, sides.  After the curve: x, times (insert); x, times, tolerance (remove); times (elevate); k, x, side (0 right, 1 left) for a derivative.
# Wanted is a curve written as those of the arguments are: p, n, rational, knots, points, weights if rational; of a removal before it how often it was made.


def left(u, p, x):
    """The span of x from the left."""
    some = [k for k in range(p, len(u) - p - 1) if u[k] < u[k + 1]]
    return max([k for k in some if u[k] < x] or some[:1])


def side_rows(s, x, d, why):
    back = Curve(s.p, [-t for t in s.u[::-1]], s.P[::-1], s.w[::-1] if s.w else None)       # its right is our left
    D, E = back.derivatives(-x, max(d))
    for k in d:
        D[k] = [(-1)**k * t for t in D[k]]
        limit = max(E[k]) + max(abs(t) for t in D[k]) * F(1, 2**53) + TINY
        zero = not s.w and k > s.p
        if zero or all(fits(t) and abs(t) < F(2)**900 for t in D[k] + E[k]):
            row("curve_ders_side", "exact" if zero else "abs " + above(limit), why + ", one-sided derivative", s.args() + [k, x, 1], D[k])


def curve_of(p, u, H, rational):
    return [p, len(H), int(bool(rational))] + u + editing.projected(H, rational)


def insert_row(s, x, times, why, kind=None):
    H = editing.lifted(s.P, s.w)
    v, new = editing.insert(s.u, s.p, H, x, times)
    _, S = editing.insert(s.u, s.p, editing.magnitudes(H), x, times)
    limit = editing.bound(new, S, s.w, 5 * min(times, s.p), TINY * 8 * (times + 1))
    row("curve_insert", kind or "abs " + above(limit), why, s.args() + [x, times], curve_of(s.p, v, new, s.w))


def elevate_row(s, times, why, kind=None):
    H = editing.lifted(s.P, s.w)
    v, new = editing.elevate(s.u, s.p, H, times)
    _, S = editing.elevate(s.u, s.p, editing.magnitudes(H), times)
    m = sum(7 * (s.p + k) + 2 for k in range(times))
    limit = editing.bound(new, S, s.w, m, TINY * (s.p + times + 4) * (times + 1))
    row("curve_elevate", kind or "abs " + above(limit), why, s.args() + [times], curve_of(s.p + times, v, new, s.w))


def remove_row(s, x, times, why):
    """Nothing is written where roundings might decide."""
    H = editing.lifted(s.P, s.w)
    E = [[(F(1, 2**53) * abs(t) if s.w and a else F(0)) for a, t in enumerate(P)] for P in H]
    least, most = min(P[0] for P in H), max(sum(abs(t / P[0]) for t in P[1:]) for P in H)
    tolerance = 2.0**-20 * float(max(abs(F(t)) for P in s.P for t in P) or 1)
    allowed, reach = least * F(tolerance), most + F(tolerance)
    u, spent, count = s.u, F(0), 0
    while count < times and x in u:
        P, errors, found = editing.removal_errors(u, s.p, H, E, x)
        found = [(reach * d, reach * e) for d, e in found[:1] if s.w] + found[1:]
        next_one = editing.remove(u, s.p, H, x)
        if next_one is None:
            if max(d - e for d, e in found) <= 2 * allowed:
                return
            break
        spent += sum(e for _, e in found)
        if spent > allowed / 2:
            return
        u, H = next_one
        assert H == P
        E = errors
        count += 1
    limit = editing.bound(H, E, s.w, None, TINY * 64)
    row("curve_remove", "abs " + above(limit) if count else "exact", why + (", %d times" % count if count else ", not removable"),
        s.args() + [x, times, tolerance], [count] + curve_of(s.p, u, H, s.w))


def removable(c, p, u, x, times, weights=None):
    """A curve whose knot x, there so often more, can be removed again: points are integers times what divides."""
    n = len(u) - p - 1
    P = [[F(c.upto(64) - 32) for _ in range(3)] for _ in range(n)]
    _, unit = editing.insert(u, p, [[F(int(i == j)) for j in range(n)] for i in range(n)], x, times)
    factor = 1
    for t in (t for one in unit for t in one):
        factor = factor * t.denominator // gcd(factor, t.denominator)
    P = [[t * factor for t in one] for one in P]
    w = [F(t) for t in weights] if weights else None
    v, H = editing.insert(u, p, editing.lifted(P, w), x, times)
    points, ws = [[t / h[0] for t in h[1:]] for h in H], [h[0] for h in H]
    if not editing.representable(points) or not editing.representable([ws]):
        return None
    return Curve(p, v, [[float(t) for t in one] for one in points], [float(t) for t in ws] if weights else None)


def edits(c):
    count = 0
    for p, u, why in BASES + MORE:
        n, lo, hi = len(u) - p - 1, u[p], u[-p - 1]
        for rational in (False, True):
            what, draw = POINTS[count % len(POINTS)]
            and_what, weigh = WEIGHTS[count // 2 % len(WEIGHTS)] if rational else ("", None)
            if rational and what in ("; huge", "; subnormal", "; mixed scales"):
                what, draw = POINTS[count % 3]
            count += 1
            s = Curve(p, u, [[draw(c) for _ in range(3)] for _ in range(n)], [weigh(c) for _ in range(n)] if rational else None)
            label = ("rational, " if rational else "") + why + what + and_what
            for k, x in enumerate(dict.fromkeys(places(c, u, p)[:8])):
                m = sum(t == x for t in u)
                if lo <= x <= hi and m <= p + 1 and valid(sorted(u + [x]), p):
                    times = c.upto(p + 1 - m)
                    there = "editing, new knot" if m == 0 else "editing, repeated knots"
                    if not (times == 0 and c.upto(3)):
                        insert_row(s, x, times, label + ", " + there + (", to multiplicity p + 1" if m + times == p + 1 else ""))
                if k % 4 == 0:
                    row("curve_insert_status", "exact", label + ", too often", s.args() + [x, p + 2 - m if m <= p + 1 else 1], [1])
                    row("curve_insert_status", "exact", label + ", too often", s.args() + [x, 2**40], [1])
                if what not in ("; huge", "; subnormal") and k % 3 == 1:
                    side_rows(s, x, sorted({0, 1, 2, min(p + 1, 3)}), label)
            for x in (c.of((lo - 1.0, hi + 1.0)), c.of((INF, float("nan")))):
                if not lo <= x <= hi:
                    row("curve_insert_status", "exact", label + ", outside the domain", s.args() + [x, 1], [1])
            if u[0] == lo and u[-1] == hi and max(u.count(t) for t in u) <= p + 1:
                for times in (1, 2) if p < 8 else (1,):
                    elevate_row(s, times, label + ", editing, degree elevated")
            for x in sorted({t for t in u if lo < t < hi}):
                remove_row(s, x, 1 + c.upto(2), label + ", editing")


def more_edits(c):
    for p in [*range(10), 15, 20, 25, 26]:
        for inner in ([], [0.5] * min(p + 1, 3)) if p < 10 else ([],):
            s = Curve(p, [0.0] * (p + 1) + inner + [1.0] * (p + 1), [[float(c.upto(64) - 32) for _ in range(3)] for _ in range(p + 1 + len(inner))],
                      [(c.upto(24) + 8) / 16.0 for _ in range(p + 1 + len(inner))] if p % 3 == 1 else None)
            elevate_row(s, 1 + p % 2, "degree %d, editing, degree elevated" % p)
            insert_row(s, 0.375, 1 + c.upto(p), "degree %d, editing, new knot" % p)
    for p in range(1, 6):
        u = [0.0] * (p + 1) + [0.25, 0.5, 0.5][:p] + [1.0] * (p + 1)
        for x in (0.125, 0.25, 0.5, 0.75):
            for times in range(1, p + 2 - u.count(x)):
                for weights in (None, [4.0] * (len(u) - p - 1)):
                    s = removable(c, p, u, x, times, weights)
                    if s:
                        remove_row(s, x, times, "editing, inserted before")
                        remove_row(s, x, times + 1, "editing, inserted before, asked for more")
    for p, weights in [(1, [1, 3]), (1, [7, 1]), (2, [1, 3, 1]), (2, [3, 5, 11]), (2, [1, 7, 1]), (3, [1, 1, 3, 5])]:
        for times in (1, 2):
            s = removable(c, p, [0.0] * (p + 1) + [1.0] * (p + 1), 0.5, times, weights) if times <= p else None
            if s:
                remove_row(s, 0.5, times, "rational, editing, inserted before")
    for p in (2, 3, 4):
        u = [0.0] * (p + 1) + [2.0**-1000] + [2.0**900] * (p + 1)
        s = Curve(p, u, [[float(c.upto(64) - 32) for _ in range(3)] for _ in range(p + 2)])
        elevate_row(s, 1, "extreme scale, spans, editing, degree elevated")
    big, loose = [2.0**996 * t for t in [0.0] * 4 + [1.0] * 4], [float(k) for k in range(12)]
    for p, u, x, why in [(3, big, 2.0**994, "knots of 1e300"), (3, [0.0] * 4 + [2.0**-996] * 4, 2.0**-998, "knots of 1e-300"),
                         (3, loose, 3.0, "not clamped, at the left end"), (3, loose, 8.0, "not clamped, at the right end"), (3, loose, 4.5, "not clamped")]:
        for times in (1, 2, 3):
            n = len(u) - p - 1
            s = Curve(p, u, [[c.real(-1, 1) * 1e300 for _ in range(3)] for _ in range(n)])
            insert_row(s, x, times, why + ", points of 1e300, editing, new knot")
            s = Curve(p, u, [[c.real(-1, 1) for _ in range(3)] for _ in range(n)], [c.real(1, 2) * 1e300 for _ in range(n)])
            insert_row(s, x, times, why + ", weights of 1e300, editing, new knot")
            s = Curve(p, u, [[c.real(-1, 1) for _ in range(3)] for _ in range(n)], [10.0**(c.upto(16) - 8) for _ in range(n)])
            insert_row(s, x, times, why + ", weights 1e-8 to 1e8, editing, new knot")


c = Choices(23)
edits(c)
more_edits(c)
