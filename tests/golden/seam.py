#!/usr/bin/env python3
"""golden/seam.tsv: gaps whose greatest sample is a whole or rational distance."""
from fractions import Fraction as F


def hexf(x):
    return float(x).hex()


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
    third = (F(16, 9), F(1, 3), 0)
    row("two_samples", 2, 1, 3, 2, 2, none, {(1, 0): (0, 0, 4)}, third, "abs " + hexf(F(32, 2**53)))
    row("quadratic_in_v", 1, 2, 2, 3, 1, none, {(1, 1): (0, 4, 0)}, (2, 1, F(1, 2)))
    # Cubic: the second control point's share is 3 t (1 - t)^2, 27/64 at a quarter.
    row("cubic", 3, 1, 4, 2, 3, none, {(1, 0): (0, 0, 64)}, (27, F(1, 4), 0))
    # One border, other knots: degree 1 runs along it at another pace, greatest where a view's knot stands.
    row("other_knots", 1, 1, 3, 2, 0, [half, [], [F(1, 4)], []], {}, (F(1, 2), F(1, 4), 0))
    row("other_knots_above", 1, 1, 3, 2, 0, [[F(1, 4)], [], half, []], {}, (F(1, 2), F(1, 4), 0))
    row("other_knots_in_v", 1, 1, 2, 3, 0, [[], half, [], [F(3, 4)]], {}, (F(1, 2), 0, F(3, 4)))


main()
