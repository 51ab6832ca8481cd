"""Golden rows of spline/basis: Cox and de Boor's recursion in rationals.

A value within (1-u)^-(6p-1) of the exact one is less than 6p - 1 ulps off, and the wanted one is rounded once: ulp 6p.
A derivative's bound is gamma(6p+2) times the sum of its terms' magnitudes; one more rounding for the wanted value.
Where a product may underflow the bound is absolute: an operation then errs by 2^-1075 at most, a quotient is multiplied by a difference D of knots
at most, a value's error passes to the next degree with factors that add up to 1, and there are fewer than 4 p (p + 1) operations.
"""
from fractions import Fraction as F

from knots_of import BASES, families, high_degrees, least
from rational import Choices, bound_of, gamma, head, row, span, window

TINY = F(1, 2**900)


def sizes(u, p, k):
    """The least and the greatest difference of knots around span k."""
    d = [F(u[i + 1]) - F(u[i]) for i in range(k - p, k + p + 1) if u[i] < u[i + 1]]
    return min(d), F(u[k + p + 1]) - F(u[k - p]) if p else max(d)


def eval_class(u, p, k, x, values):
    if p == 0 or max(values) == 1:
        return "exact"
    small, wide = sizes(u, p, k)
    # Each path's product of p quotients (x - u_i) / (u_j - u_i) and of values over differences: out of underflow's reach?
    gaps = [abs(F(x) - F(t)) for t in u[k - p:k + p + 2] if F(t) != F(x)]
    if (min(gaps) / wide) ** p / max(wide, 1) > TINY:
        return "ulp %d" % (6 * p)
    return "abs " + bound_of(gamma(6 * p) + 4 * p * (p + 1) * max(wide, F(1)) * F(1, 2**1074))


def evaluate(why, p, u, x):
    k = span(u, p, x)
    X = min(max(x, u[p]), u[-p - 1])
    values = window(u, p, k, X)
    row("basis_eval", eval_class(u, p, k, X, values), why, [p, 0, len(u)] + u + [x], values)


def derive(why, p, u, x, d):
    """Only where neither the coefficients, products of differences' inverses, nor the values overflow or underflow."""
    k = span(u, p, x)
    X = min(max(x, u[p]), u[-p - 1])
    small, wide = sizes(u, p, k)
    if d <= p:
        gaps = [abs(F(X) - F(t)) for t in u[k - p:k + p + 2] if F(t) != F(X)]
        if (2 * (p + 1) / small) ** d > F(2) ** 1000 or (min([small] + gaps) / wide) ** p / max(wide, F(1)) ** (d + 1) < TINY:
            return
    D, M = window(u, p, k, X, d), window(u, p, k, X, d, 1)
    bound = max(gamma(6 * p + 2) * m + F(1, 2**53) * abs(v) for m, v in zip(M, D))
    row("basis_ders", "exact" if d > p else "abs " + bound_of(bound), why, [p, d, len(u)] + u + [x], D)


def parameters(c, u, p, many):
    """(category, parameter): the domain's ends and their neighbours, knots, neighbours of knots, beyond the domain, between."""
    lo, hi = u[p], u[-p - 1]
    inside = sorted({t for t in u if lo < t < hi})
    out = [("end of domain", lo), ("end of domain", hi)]
    if inside:
        out.append(("at a knot", c.of(inside)))
    k = c.of([i for i in range(p, len(u) - p - 1) if u[i] < u[i + 1]])
    out.append(("between", u[k] + (u[k + 1] - u[k]) * c.short(0.125, 0.875, 6)))
    if many:
        out.append(("between", c.real(lo, hi)))
        out.append(("outside the domain", lo - (hi - lo)))
        out.append(("next to the end", hi - (hi - u[k]) * 2.0**-50))
    return [(w, x) for w, x in out if x - x == 0]


def both(c, why, p, u, many=True):
    for where, x in parameters(c, u, p, many):
        evaluate(why + ", " + where, p, u, x)
        for d in {1, c.between(1, min(p + 1, 5))}:
            one = ", one-sided derivative" if where in ("at a knot", "end of domain") else ""
            derive(why + one, p, u, x, d)


def main():
    head("basis", "basis functions and their derivatives")
    for p, d in [(0, 0), (0, 1), (3, 0), (3, 1), (3, 2), (9, 0), (9, 5), (100, 0), (100, 2)]:
        row("basis_work", "exact", "doubles", [p, d], [(p + 1) * (2 if d == 0 else p + 5)])
    for p, d in [(2**64 - 1, 0), (2**63, 1), (2**32, 2)]:
        row("basis_work", "exact", "does not fit", [p, d], [2**64 - 1])
    c = Choices(11)
    for p in range(26):
        for d in (0, 1, 2, 5):
            row("basis_work", "exact", "degree %d" % p, [p, d], [(p + 1) * (2 if d == 0 else p + 5)])
    for p, u, why in BASES:
        lo, hi = u[p], u[-p - 1]
        xs = sorted({lo, hi, c.real(lo, hi)} | {x for x in u if lo <= x <= hi and c.upto(2) == 0})
        for x in xs:
            evaluate(why, p, u, x)
            for d in (1, 2, min(p + 1, 5)):
                derive(why, p, u, x, d)
    for p, u, why in families(c, 28):
        both(c, why, p, u)
    for p in (1, 2, 3):
        for _, u, why in least(p):
            both(c, why, p, u)
    for p, u, why in high_degrees(c):
        both(c, why, p, u, False)


main()
