"""Golden rows of spline/curve: the sums of its definition in rationals, the bounds as the header states them.

After the curve's arguments (p, n, rational, knots, points, weights if rational): x for a point; k, x for the k-th derivative, which alone is wanted.
With g = gamma(8p+5), M_k and W_i the sums of the terms' magnitudes, Leibniz' rule bounds the errors E_k of a rational curve's derivatives one
after the other:  w_0 (1 - g) E_k <= sum C(k,i) |w_i| E_(k-i) + g (M_k + sum C(k,i) W_i (|D_(k-i)| + E_(k-i)) + w_0 |D_k|),  i = 1..k.
"""
from fractions import Fraction as F
from math import comb, nextafter

from knots_of import BASES
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
