#!/usr/bin/env python3
"""golden/seam.tsv: gaps whose greatest sample is a whole or rational distance, and any gaps.

Each view's point errs by gamma(7(p+q)) max|P| in each coordinate, the distance by at most sqrt(3) times both, and by 3.5u of itself.
"""
from fractions import Fraction as F

from knots_of import clamped
from rational import Choices, bound_of, gamma, nearest, root, show, span, up, window

U = F(1, 2**53)


def hexf(x):
    return show(nearest(F(x)))


def flat_net(nu, nv):
    return [[[F(i), F(j), F(0)] for j in range(nv)] for i in range(nu)]


def row(reason, p, q, nu, nv, samples, knots, moves, want, cls="exact"):
    """knots: interior ones (u bottom, v bottom, u top, v top); moves: {(i, j): displacement of the top's point}."""
    bottom, top = flat_net(nu, nv), flat_net(nu, nv)
    for (i, j), d in moves.items():
        top[i][j] = [x + F(y) for x, y in zip(top[i][j], d)]
    args = [str(x) for x in (p, q, nu, nv, samples)] + [hexf(x) for k in knots for x in k]
    args += [hexf(c) for net in (bottom, top) for line in net for point in line for c in point]
    print("seam_gap", cls, reason, " ".join(args), " ".join(hexf(x) for x in want), sep="\t")


def main():
    print("# function\tclass\treason\tp q nu nv samples, interior knots u v u v, points bottom then top\tdistance u v")
    print("# made by tests/golden/seam.py")
    none, half = [[], [], [], []], [F(1, 2)]
    row("closed", 1, 1, 2, 2, 3, none, {}, (0, 0, 0))
    row("closed_around_another_interior", 2, 2, 3, 3, 3, none, {(1, 1): (0, 0, 5)}, (0, 0, 0))
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)]:
        row("corner", 1, 1, 2, 2, 2, none, {(i, j): (3, 4, 0)}, (5, i, j))
    mid = [half, [], half, []]
    row("knot_on_an_edge", 1, 1, 3, 2, 0, mid, {(1, 0): (2, 3, 6)}, (7, F(1, 2), 0))
    row("knot_on_the_far_edge", 1, 1, 3, 2, 0, mid, {(1, 1): (2, 3, 6)}, (7, F(1, 2), 1))
    row("equal_gaps_the_first", 1, 1, 3, 2, 4, mid, {(1, 0): (0, 0, 1), (1, 1): (0, 0, -1)}, (1, F(1, 2), 0))
    wide = [[], half, [], half]
    row("edge_u_0", 1, 1, 2, 3, 0, wide, {(0, 1): (1, 2, 2)}, (3, 0, F(1, 2)))
    row("edge_u_1", 1, 1, 2, 3, 0, wide, {(1, 1): (1, 2, 2)}, (3, 1, F(1, 2)))
    row("the_greater", 1, 1, 2, 3, 0, wide, {(1, 1): (1, 2, 2), (0, 1): (3, 4, 12)}, (13, 0, F(1, 2)))
    # Quadratic without interior knots: the middle control point's share is 2 t (1 - t).
    row("between_the_samples", 2, 1, 3, 2, 0, none, {(1, 0): (0, 0, 4)}, (0, 0, 0))
    row("one_sample", 2, 1, 3, 2, 1, none, {(1, 0): (0, 0, 4)}, (2, F(1, 2), 0))
    row("three_samples", 2, 1, 3, 2, 3, none, {(1, 0): (0, 0, 4)}, (2, F(1, 2), 0))
    # Samples at the doubles next to 1/3 and 2/3: 3 t (1 - t)^2 is flat at 1/3, so that its 4/9 there is rounded to what it is at 1/3 itself.
    third = F(float(F(1, 3)))
    row("two_samples", 3, 1, 4, 2, 2, none, {(1, 0): (0, 0, 9)}, (27 * third * (1 - third) ** 2, third, 0), "abs " + hexf(F(128, 2**53)))
    row("quadratic_in_v", 1, 2, 2, 3, 1, none, {(1, 1): (0, 4, 0)}, (2, 1, F(1, 2)))
    # Cubic: the second control point's share is 3 t (1 - t)^2, 27/64 at a quarter.
    row("cubic", 3, 1, 4, 2, 3, none, {(1, 0): (0, 0, 64)}, (27, F(1, 4), 0))
    # One border, other knots: degree 1 runs along it at another pace, greatest where a view's knot stands.
    row("other_knots", 1, 1, 3, 2, 0, [half, [], [F(1, 4)], []], {}, (F(1, 2), F(1, 4), 0))
    row("other_knots_above", 1, 1, 3, 2, 0, [[F(1, 4)], [], half, []], {}, (F(1, 2), F(1, 4), 0))
    row("other_knots_in_v", 1, 1, 2, 3, 0, [[], half, [], [F(3, 4)]], {}, (F(1, 2), 0, F(3, 4)))

class Border:
    """A view's control points and knots; a border point by its border's control points alone, the knots being clamped."""

    def __init__(self, p, q, u, v, P):
        self.p, self.q, self.u, self.v, self.P = p, q, u, v, P

    def curve(self, p, u, points, t):
        k = span(u, p, t)
        N = window(u, p, k, t)
        return [sum(n * F(P[c]) for n, P in zip(N, points[k - p:])) for c in range(3)]

    def at(self, u, v):
        if u in (0.0, 1.0):
            return self.curve(self.q, self.v, self.P[0 if u == 0 else -1], v)
        return self.curve(self.p, self.u, [line[0 if v == 0 else -1] for line in self.P], u)


def samples_of(a, b, samples):
    """The library's own parameters, as it computes them in doubles."""
    t = sorted(set(a) | set(b))
    return [x + (y - x) * (i / (samples + 1)) for x, y in zip(t, t[1:]) for i in range(samples + 1)] + [t[-1]]


def drawn(c, reason, draw, p, q, inner, samples, change):
    """change(i, j, nu, nv): whether the top's control point differs."""
    knots = [clamped(d, list(x)) for d, x in zip((p, q, p, q), inner)]
    nu, nv = len(knots[0]) - p - 1, len(knots[1]) - q - 1
    bottom = [[[draw() for _ in range(3)] for _ in range(nv)] for _ in range(nu)]
    top = [[[draw() for _ in range(3)] if change(i, j, nu, nv) else bottom[i][j] for j in range(nv)] for i in range(nu)]
    A, B = Border(p, q, knots[0], knots[1], bottom), Border(p, q, knots[2], knots[3], top)
    s, r = samples_of(knots[0], knots[2], samples), samples_of(knots[1], knots[3], samples)
    spots = [(w, t) for t in r for w in (0.0, 1.0)] + [(t, w) for t in s for w in (0.0, 1.0)]
    gaps = [sum((x - y) ** 2 for x, y in zip(A.at(*at), B.at(*at))) for at in spots]
    d2 = max(gaps)
    at = spots[gaps.index(d2)] if d2 else (0.0, 0.0)
    # Another place must not win by rounding.
    if d2 and any(d2 * (1 - F(1, 2**30)) < g for g, x in zip(gaps, spots) if x != at):
        return
    most = max(abs(F(x)) for net in (bottom, top) for line in net for P in line for x in P)
    d = root(d2, 2, 120)[0]
    bound = 4 * up(gamma(7 * (p + q))) * most + 5 * U * d
    args = [str(x) for x in (p, q, nu, nv, samples)] + [show(x) for k in inner for x in k]
    args += [show(x) for net in (bottom, top) for line in net for P in line for x in P]
    print("seam_gap", "abs " + bound_of(bound) if d2 else "exact", reason, " ".join(args), " ".join(show(x) for x in (nearest(d), *at)), sep="\t")


def border(i, j, nu, nv):
    return i in (0, nu - 1) or j in (0, nv - 1)


def many(c):
    kinds = [("random", lambda: c.real(-1, 1)), ("short", lambda: c.short(-4, 4, 32)), ("extreme scale, offset", lambda: 1e9 + c.short(-1, 1)),
             ("extreme scale, 1e150", lambda: 1e150 * c.short(-1, 1)), ("extreme scale, 1e-100", lambda: 1e-100 * c.short(-1, 1))]
    changes = [("open everywhere", border), ("closed", lambda *a: not border(*a)), ("one corner open", lambda i, j, nu, nv: i == 0 and j == nv - 1),
               ("one control point", lambda i, j, nu, nv: i == nu // 2 and j == 0), ("one edge", lambda i, j, nu, nv: i == nu - 1)]
    for name, draw in kinds:
        for where, change in changes:
            for k in range(9):
                p, q = c.between(1, 3), c.between(1, 3)
                n, m = c.upto(2), c.upto(2)
                inner = [sorted(c.short(0.125, 0.875, 6) for _ in range(x)) for x in (n, m, n, m)]
                if k % 3:
                    inner[2:] = inner[:2]
                why = "seam and closure, " + where + ", " + name
                drawn(c, why + (", other knots" if inner[:2] != inner[2:] else ""), draw, p, q, inner, c.of((0, 1, 2, 3, 7)), change)


main()
many(Choices(41))
