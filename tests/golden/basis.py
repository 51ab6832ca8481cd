"""Golden rows of spline/basis: Cox and de Boor's recursion in rationals.

A value within (1-u)^-(6p-1) of the exact one is less than 6p - 1 ulps off, and the wanted one is rounded once: ulp 6p.
A derivative's bound is gamma(6p+2) times the sum of its terms' magnitudes; one more rounding for the wanted value.
"""
from fractions import Fraction as F

from knots_of import BASES
from rational import Choices, above, cox, cox_derivative, gamma, head, row, span

head("basis", "basis functions and their derivatives")
for p, d in [(0, 0), (0, 1), (3, 0), (3, 1), (3, 2), (9, 0), (9, 5), (100, 0), (100, 2)]:
    row("basis_work", "exact", "doubles", [p, d], [(p + 1) * (2 if d == 0 else p + 5)])
for p, d in [(2**64 - 1, 0), (2**63, 1), (2**32, 2)]:
    row("basis_work", "exact", "does not fit", [p, d], [2**64 - 1])
c = Choices(11)
for p, u, why in BASES:
    lo, hi = u[p], u[-p - 1]
    xs = sorted({lo, hi, c.real(lo, hi)} | {x for x in u if lo <= x <= hi and c.upto(2) == 0})
    for x in xs:
        k = span(u, p, x)
        args = [p, 0, len(u)] + u + [x]
        values = cox(u, p, k, F(x))[k - p:k + 1]
        kind = "exact" if p == 0 or max(values) == 1 else "ulp %d" % (6 * p)
        row("basis_eval", kind, why, args, values)
        for d in (1, 2, min(p + 1, 5)):
            args[1] = d
            D = cox_derivative(u, p, k, F(x), d)[k - p:k + 1]
            M = cox_derivative(u, p, k, F(x), d, 1)[k - p:k + 1]
            bound = max(gamma(6 * p + 2) * m + F(1, 2**53) * abs(v) for m, v in zip(M, D))
            row("basis_ders", "exact" if d > p else "abs " + above(bound), why, args, D)
