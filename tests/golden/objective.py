#!/usr/bin/env python3
"""golden/objective.tsv: the sum of distances in rational arithmetic.  python3 tests/golden/objective.py > golden/objective.tsv

Basis functions by the recursion of Cox and de Boor (not by the triangular scheme of the code).  Rows `exact`: everything, the roots included, is
representable.  Rows `abs T`: T is proved as follows, u = 2^-53.  Each computed basis value is within (6p - 1) u of its own, a contraction over p + 1
terms adds (p + 1) u: a coordinate of a point is within 7 (p + q) u max|P|, its distance within sqrt(3) of that and 3.5 u of itself, the sum over
at most 2^10 classes within 24 u more; 1.01 covers the higher orders.
"""
from decimal import Decimal, getcontext
from fractions import Fraction as Q
from math import isqrt

from rational import Choices, show

getcontext().prec = 60


def basis(i, p, u, x):
    """N_{i,p}(x) on clamped knots u; the last span that is not empty is closed; 0/0 = 0."""
    if p == 0:
        last = x == u[-1] and u[i] < u[i + 1] == u[-1]
        return Q(1) if u[i] <= x < u[i + 1] or last else Q(0)
    left = Q(x - u[i]) / (u[i + p] - u[i]) if u[i + p] != u[i] else Q(0)
    right = Q(u[i + p + 1] - x) / (u[i + p + 1] - u[i + 1]) if u[i + p + 1] != u[i + 1] else Q(0)
    return left * basis(i, p - 1, u, x) + right * basis(i + 1, p - 1, u, x)


def number(nx, ny, view, i, j):
    """The class - 1 of a node."""
    inside = 0 < i < nx - 1 and 0 < j < ny - 1
    return nx * ny + (i - 1) * (ny - 2) + j - 1 if view and inside else i * ny + j


def nodes(nx, ny):
    """(view, i, j) by class."""
    bottom = [(0, i, j) for i in range(nx) for j in range(ny)]
    return bottom + [(1, i, j) for i in range(1, nx - 1) for j in range(1, ny - 1)]


class Case:
    def __init__(self, p, q, u, v, s, r):
        self.p, self.q = p, q
        self.u, self.v, self.s, self.r = ([Q(t) for t in a] for a in (u, v, s, r))
        self.nu, self.nv, self.nx, self.ny = len(u) - p - 1, len(v) - q - 1, len(s), len(r)
        self.N = [[basis(i, p, self.u, t) for i in range(self.nu)] for t in self.s]
        self.M = [[basis(j, q, self.v, t) for j in range(self.nv)] for t in self.r]

    def classes(self):
        return len(nodes(self.nu, self.nv))

    def surface(self, x):
        """The surface point of each data class; x: a triple of rationals by control class."""
        out = []
        for view, a, b in nodes(self.nx, self.ny):
            S = [Q(0)] * 3
            for i in range(self.nu):
                for j in range(self.nv):
                    w = self.N[a][i] * self.M[b][j]
                    if w:
                        P = x[number(self.nu, self.nv, view, i, j)]
                        S = [c + w * d for c, d in zip(S, P)]
            out.append(S)
        return out

    def error(self, data, x):
        """The sum of distances: a Fraction when all roots are rational, else a Decimal."""
        squares = [sum((a - b) ** 2 for a, b in zip(D, S)) for D, S in zip(data, self.surface(x))]
        roots = [Q(isqrt(s.numerator), isqrt(s.denominator)) for s in squares]
        if all(t * t == s for t, s in zip(roots, squares)):
            return sum(roots)
        return sum((Decimal(s.numerator) / Decimal(s.denominator)).sqrt() for s in squares)

    def row(self, reason, data, candidates):
        values = [self.error(data, x) for x in candidates]
        exact = all(isinstance(v, Q) for v in values)
        greatest = max(abs(c) for x in candidates for P in x for c in P)
        bound = 1.01 * 2.0**-53 * (len(data) * 1.7321 * 7 * (self.p + self.q) * float(greatest) + 27.5 * float(max(values)))
        wide = [real(c) for rows in [data] + candidates for P in rows for c in P]
        args = [str(k) for k in (self.p, self.q, self.nu, self.nv, self.nx, self.ny)] + [real(t) for t in self.u + self.v + self.s + self.r] + wide
        if exact:
            assert all(Q(float(v)) == v for v in values)
        kind = 'exact' if exact else 'abs ' + show(bound)
        print('\t'.join(('objective_eval', kind, reason, ' '.join(args), ' '.join(show(float(v)) for v in values))))


def real(x):
    assert Q(float(x)) == x
    return show(float(x))


def pseudo(k, m):
    """Dyadic numbers in [0, 1), without pattern enough."""
    return Q((k * 2654435761 + m * 40503 + (k * k * 977) % 4093) % 4096, 4096)


def control(case, m):
    return [[pseudo(3 * c + d, m) for d in range(3)] for c in range(case.classes())]


OFFSETS = [(3, 4, 0), (2, 3, 6), (0, 0, 0), (1, 2, 2), (0, 5, 12), (-8, 9, 12), (6, -2, 3), (0, 0, -1), (2, 10, -11)]


def exact_row(reason, case, m, scale=Q(1)):
    """Data at Pythagorean offsets from the surface: every distance is a whole number of scales."""
    x = control(case, m)
    S = case.surface(x)
    data = [[a + scale * b for a, b in zip(P, OFFSETS[(k + m) % len(OFFSETS)])] for k, P in enumerate(S)]
    case.row(reason, data, [x])


def general_row(reason, case, m):
    """Random data; then one control point moved, one of the border moved, and the first again."""
    data = [[pseudo(7 * k + d, m + 1) for d in range(3)] for k in range(len(nodes(case.nx, case.ny)))]
    x = control(case, m)
    y = [list(P) for P in x]
    y[-1][0] += Q(1, 4)
    z = [list(P) for P in y]
    z[1][2] -= Q(3, 8)
    case.row(reason, data, [x, y, z, x])


def drawn_row(c, reason, case):
    """Short numbers; candidates that differ in one control point, coincident ones, and far away ones."""
    scale, offset = c.of(((1, 0), (1, 0), (Q(1, 2**100), 0), (2**100, 0), (1, 10**9)))
    draw = lambda: [offset + scale * Q(c.upto(64) - 32, 16) for _ in range(3)]
    data = [draw() for _ in nodes(case.nx, case.ny)]
    x = [draw() for _ in range(case.classes())]
    y = [list(P) for P in x]
    y[c.upto(len(y) - 1)] = draw()
    z = [list(y[0]) for _ in y]
    why = reason if (scale, offset) == (1, 0) else 'extreme scale, ' + reason
    case.row(why + ', coincident points', data, [x, y, z])


def clamped(p, inner):
    return [0] * (p + 1) + inner + [1] * (p + 1)


def even(n):
    return [float(i) / (n - 1) for i in range(n)]


def dyadic(n, m):
    return [Q(i, m) for i in range(n - 1)] + [Q(1)]


def main():
    print('# function\tclass\treason\tp q nu nv nx ny, knots u v, parameters s r, data, candidates\tvalues')
    print('# made by tests/golden/objective.py')
    one = clamped(1, [])
    exact_row('two_by_two', Case(1, 1, one, one, [0, 1], [0, 1]), 0)
    exact_row('two_by_two_control_more_data', Case(1, 1, one, one, dyadic(5, 4), dyadic(3, 2)), 1)
    exact_row('bilinear', Case(1, 1, clamped(1, [Q(1, 2)]), clamped(1, [Q(1, 4), Q(1, 2)]), dyadic(5, 4), dyadic(4, 8)), 2)
    exact_row('bezier_quadratic', Case(2, 2, clamped(2, []), clamped(2, []), dyadic(5, 4), dyadic(4, 4)), 3)
    exact_row('bezier_cubic', Case(3, 3, clamped(3, []), clamped(3, []), dyadic(5, 4), dyadic(4, 4)), 4)
    exact_row('cubic_by_linear', Case(3, 1, clamped(3, []), clamped(1, [Q(1, 2)]), dyadic(4, 4), dyadic(5, 4)), 5)
    exact_row('linear_by_cubic', Case(1, 3, clamped(1, [Q(1, 2)]), clamped(3, []), dyadic(5, 4), dyadic(4, 4)), 6)
    exact_row('full_multiplicity', Case(2, 2, clamped(2, [Q(1, 2), Q(1, 2)]), clamped(2, []), dyadic(5, 4), dyadic(3, 4)), 7)
    exact_row('equal_parameters', Case(3, 3, clamped(3, []), clamped(3, []), [0, 0, Q(1, 2), Q(1, 2), 1], [0, 1, 1]), 8)
    exact_row('tiny', Case(1, 1, one, one, dyadic(3, 2), dyadic(3, 2)), 9, Q(1, 2**20))
    exact_row('more_lanes_than_one_block', Case(1, 1, clamped(1, [Q(1, 2)]), clamped(1, [Q(1, 2)]), dyadic(9, 8), dyadic(3, 2)), 10)
    general_row('cubic_faithful_knots', Case(3, 3, clamped(3, [0.1, 0.2, 0.3]), clamped(3, [0.15, 0.35]), even(9), even(8)), 11)
    general_row('cubic', Case(3, 3, clamped(3, [0.3, 0.5, 0.8]), clamped(3, [0.4, 0.6]), even(10), even(7)), 12)
    general_row('cubic_many_control_points', Case(3, 3, clamped(3, even(7)[1:-1]), clamped(3, even(6)[1:-1]), even(12), even(9)), 13)
    general_row('quadratic_by_cubic', Case(2, 3, clamped(2, [0.3]), clamped(3, [0.7]), even(6), even(7)), 14)
    general_row('quartic', Case(4, 4, clamped(4, [0.3]), clamped(4, [0.6]), even(6), even(6)), 15)
    general_row('double_knots', Case(3, 3, clamped(3, [0.5, 0.5]), clamped(3, [0.25, 0.75, 0.75]), even(8), even(8)), 16)
    general_row('knots_one_ulp_apart', Case(3, 3, clamped(3, [0.5, 0.5 + 2.0**-53]), clamped(3, [0.25]), even(7), even(6)), 17)
    general_row('more_control_than_data', Case(3, 3, clamped(3, [0.2, 0.4, 0.6, 0.8]), clamped(3, [0.5, 0.75]), even(3), even(4)), 18)
    general_row('one_row_each', Case(3, 3, clamped(3, [0.5]), clamped(3, [0.5]), [0, 1], [0, 1]), 19)
    c = Choices(71)
    for k in range(60):
        p, q = c.between(1, 3), c.between(1, 3)
        u, v = (clamped(d, sorted(c.short(0.125, 0.875, 6) for _ in range(c.upto(2)))) for d in (p, q))
        s, r = ([0] + sorted(c.short(0, 1, 16) for _ in range(c.between(0, 3))) + [1] for _ in range(2))
        case = Case(p, q, u, v, s, r)
        if case.classes() * 3 + len(nodes(case.nx, case.ny)) * 3 < 160:
            sites = len(set(s)) < len(s) or len(set(r)) < len(r)
            why = 'repeated sites' if sites else 'repeated knots' if len(set(u[p:-p])) < len(u[p:-p]) else 'random'
            drawn_row(c, why, case)


if __name__ == '__main__':
    main()
