"""Golden rows of spline/surface: sums over all control points in rationals.

Polynomial: abs gamma(7(p+q)) sum N M |x|.  Rational: numerator gamma(7(p+q)+1), denominator gamma(7(p+q)), one division; in all at most
gamma(14(p+q)+2) sum N M w |x| / sum N M w.  Derivatives: 7(p+q)+8 roundings of each term, and by Leibniz' rule those of the lower ones.
"""
from fractions import Fraction as F

from knots_of import BASES
from rational import Choices, above, cox_derivative, gamma, head, row, span

ORDERS = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
# Which earlier results enter each derivative's quotient: (order of w, index of D, factor).
PARTS = [[], [((1, 0), 0, 1)], [((0, 1), 0, 1)], [((1, 0), 1, 2), ((2, 0), 0, 1)], [((1, 0), 2, 1), ((0, 1), 1, 1), ((1, 1), 0, 1)], [((0, 1), 2, 2), ((0, 2), 0, 1)]]


class Surface:
    def __init__(self, c, p, u, q, v, rational, integer=False):
        self.p, self.u, self.q, self.v = p, u, q, v
        self.nu, self.nv = len(u) - p - 1, len(v) - q - 1
        n = self.nu * self.nv
        draw = (lambda: float(c.upto(16) - 8)) if integer else (lambda: c.real(-1, 1) if c.upto(9) == 0 else (c.upto(512) - 256) / 64.0)
        self.P = [[draw() for _ in range(3)] for _ in range(n)]
        self.w = [(c.upto(24) + 8) / 16.0 for _ in range(n)] if rational else None

    def args(self):
        a = [self.p, self.q, self.nu, self.nv, int(self.w is not None)] + self.u + self.v + [x for P in self.P for x in P]
        return a + (self.w or [])

    def tensor(self, u, v, order, sign):
        ku, kv = span(self.u, self.p, u), span(self.v, self.q, v)
        u = min(max(u, self.u[self.p]), self.u[-self.p - 1])
        v = min(max(v, self.v[self.q]), self.v[-self.q - 1])
        N = cox_derivative(self.u, self.p, ku, F(u), order[0], sign)
        M = cox_derivative(self.v, self.q, kv, F(v), order[1], sign)
        total = [F(0)] * 4
        for i in range(self.nu):
            for j in range(self.nv):
                k, b = i * self.nv + j, N[i] * M[j]
                if b == 0:
                    continue
                w = F(self.w[k]) if self.w else F(1)
                for a, x in enumerate([F(1)] + [F(t) for t in self.P[k]]):
                    total[a] += b * w * (abs(x) if sign == 1 else x)
        return total

    def derivatives(self, u, v):
        """All six, and bounds of their errors."""
        D, E = [], []
        m = 7 * (self.p + self.q) + 12
        A = {o: self.tensor(u, v, o, -1) for o in ORDERS}
        S = {o: self.tensor(u, v, o, 1) for o in ORDERS}
        if not self.w:
            for o in ORDERS:
                D.append(A[o][1:])
                E.append([gamma(m) * s for s in S[o][1:]])
            return D, E
        w = A[(0, 0)][0]
        for k, o in enumerate(ORDERS):
            D.append([])
            E.append([])
            for a in range(3):
                value, error, size = A[o][a + 1], gamma(m) * S[o][a + 1], abs(A[o][a + 1])
                for wo, d, f in PARTS[k]:
                    value -= f * A[wo][0] * D[d][a]
                    error += f * (gamma(m) * S[wo][0] * (abs(D[d][a]) + E[d][a]) + abs(A[wo][0]) * E[d][a])
                    size += f * S[wo][0] * (abs(D[d][a]) + E[d][a])
                D[k].append(value / w)
                E[k].append(((error + gamma(8) * (size + error)) / w + gamma(m) * abs(value / w)) * (1 + gamma(3 * m)))
        return D, E

    def point(self, u, v):
        D, E = self.derivatives(u, v)
        return D[0], max(E[0]) + max(abs(x) for x in D[0]) * F(1, 2**53)


def corner(s, u, v):
    k = (s.nu - 1 if u else 0) * s.nv + (s.nv - 1 if v else 0)
    return s.P[k]


head("surface", "points, derivatives and grids")
c = Choices(13)
CLAMPED = [0.0] * 4 + [0.1, 0.3, 0.7] + [1.0] * 4
BERNSTEIN = [0.0] * 4 + [1.0] * 4
KINDS = [(3, BERNSTEIN, 3, BERNSTEIN, False, "Bezier"), (3, BERNSTEIN, 3, BERNSTEIN, True, "rational Bezier"), (3, CLAMPED, 3, BERNSTEIN, False, "bicubic"),
         (3, BERNSTEIN, 3, CLAMPED, True, "rational bicubic"), (1, [0.0, 0.0, 1.0, 1.0], 2, [0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0], False, "degrees 1 and 2"),
         (2, [0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0], 1, [0.0, 0.0, 1.0, 1.0], True, "degrees 2 and 1"), (0, [0.0, 0.5, 1.0], 3, BERNSTEIN, False, "degree 0"),
         (3, BASES[2][1], 2, BASES[9][1], False, "one ulp apart; not clamped"), (3, BASES[4][1], 1, BASES[8][1], True, "multiplicity p + 1")]
for p, u, q, v, rational, why in KINDS:
    s = Surface(c, p, u, q, v, rational)
    row("surface_valid", "exact", why, s.args(), [1])
    for b in (-1.0, 0.0):
        bad = s.args()
        bad[-1] = b
        row("surface_valid", "exact", why + ", last number %g" % b, bad, [int(not rational)])
    bad = s.args()
    bad[5 + p], bad[5 + len(u) - p - 1] = bad[5 + len(u) - p - 1], bad[5 + p]
    row("surface_valid", "exact", why + ", knots exchanged", bad, [0])
    ends = [(a, b) for a in (u[p], u[-p - 1]) for b in (v[q], v[-q - 1])]
    spots = ends + [(u[p], c.real(v[q], v[-q - 1])), (c.real(u[p], u[-p - 1]), v[-q - 1]), (-9.0, 99.0)]
    spots += [(c.real(u[p], u[-p - 1]), c.real(v[q], v[-q - 1])) for _ in range(3)]
    spots += [(u[min(p + 1, len(u) - p - 1)], c.real(v[q], v[-q - 1]))]
    for a, b in spots:
        S, bound = s.point(a, b)
        row("surface_point", "abs " + above(bound), why, s.args() + [a, b], S)
    if not rational and u in (BERNSTEIN, CLAMPED) and v == BERNSTEIN:
        for a, b in ends:
            row("surface_point", "exact", why + ", corner", s.args() + [a, b], corner(s, a, b))
    for a, b in spots[3:4] + spots[7:8] + spots[-1:]:
        D, E = s.derivatives(a, b)
        for k in range(6):
            bound = max(E[k]) + max(abs(x) for x in D[k]) * F(1, 2**53)
            row("surface_ders", "abs " + above(bound), why, s.args() + [k, a, b], D[k])
    values = [s.point(a, b) for a, b in spots]
    row("surface_points", "abs " + above(max(e for _, e in values)), why, s.args() + [len(spots)] + [t for x in spots for t in x],
        [t for S, _ in values for t in S])
    A, B = [u[p], c.real(u[p], u[-p - 1]), u[-p - 1], -7.0], [c.real(v[q], v[-q - 1]), v[-q - 1], v[q]]
    values = [s.point(a, b) for a in A for b in B]
    row("surface_grid", "abs " + above(max(e for _, e in values)), why, s.args() + [len(A), len(B)] + A + B, [t for S, _ in values for t in S])
for a in (0.0, 0.25, 0.5, 0.75, 1.0):
    s = Surface(c, 3, BERNSTEIN, 3, BERNSTEIN, False, True)
    row("surface_point", "exact", "integers at quarters: no rounding", s.args() + [a, 0.5], s.point(a, 0.5)[0])
