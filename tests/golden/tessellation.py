#!/usr/bin/env python3
"""golden/tessellation.tsv: volumes of closed meshes by exact rational arithmetic (prisms over z = 0, not the formula of the library)."""
from fractions import Fraction

from rational import Choices, nearest, show


def volume(points, triangles):
    total = Fraction(0)
    for t in triangles:
        a, b, c = ([Fraction(x) for x in points[k]] for k in t)
        total += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) * (a[2] + b[2] + c[2])
    return total / 6


def row(kind, reason, points, triangles):
    args = [len(points), len(triangles)] + [show(float(x)) for p in points for x in p] + [k for t in triangles for k in t]
    print("tessellation_volume", kind, reason, " ".join(map(str, args)), show(nearest(volume(points, triangles))), sep="\t")


def box(o, s):
    points = [(o[0] + s[0] * i, o[1] + s[1] * j, o[2] + s[2] * k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def turned(triangles):
    return [(a, c, b) for a, b, c in triangles]


TETRA = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
OCTA = [(x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
OCTA = [(x, y, z) if (x + y + z) % 2 == 0 else (x, z, y) for x, y, z in OCTA]
print("# function\tclass\treason\tvertices triangles, coordinates, indices\tvolume")
print("# made by tests/golden/tessellation.py")
row("exact", "unit_cube", *box((0, 0, 0), (1, 1, 1)))
p, t = box((0, 0, 0), (1, 1, 1))
row("exact", "unit_cube_inside_out", p, turned(t))
row("exact", "cube_of_three", *box((-1, -1, -1), (3, 3, 3)))
row("exact", "box", *box((7, -5, 2), (2, 3, 5)))
row("exact", "box_far_away", *box((2**40, -2**41, 2**42), (1, 2, 3)))
row("exact", "tiny_box", *box((0, 0, 0), (2.0**-300, 2.0**-300, 2.0**-300)))
row("exact", "large_box", *box((0, 0, 0), (2.0**300, 2.0**300, 2.0**300)))
row("exact", "flat_box", *box((0, 0, 0), (1, 1, 0)))
row("exact", "tetrahedron", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], TETRA)
row("exact", "tetrahedron_6", [(0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6)], TETRA)
row("exact", "octahedron", [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], OCTA)
row("exact", "no_triangles", [(1, 2, 3)], [])
c = Choices(3)
HEX = box((0, 0, 0), (1, 1, 1))[1]
for n in range(60):
    points = [tuple(c.between(0, 2000) - 1000 for _ in range(3)) for _ in range(8)]
    row("exact", "whole numbers", points, HEX)
for n in range(40):
    s = 2.0 ** (c.upto(500) - 250)
    points = [tuple((c.between(0, 60) - 30) * s for _ in range(3)) for _ in range(8)]
    row("exact", "extreme scale", points, HEX)
for n in range(30):
    points = [(x, y, 0) for x, y in ((c.upto(20), c.upto(20)) for _ in range(8))]
    row("exact", "degenerate geometry, flat", points, HEX)
    points = [points[k // 3] for k in range(8)]
    row("exact", "degenerate geometry, coincident points", points, HEX)
for n in range(40):
    points = [tuple(c.between(0, 40) - 20 for _ in range(3)) for _ in range(4)]
    row("exact", "whole numbers, tetrahedron", points, TETRA if n % 2 else turned(TETRA))
for n in range(40):
    points = [tuple(c.real(-1, 1) for _ in range(3)) for _ in range(8)]
    # 12 terms of size sum |a-o||b-o||c-o| <= 12 * 12^(3/2) < 512, (10 + 12) u each to first order: 2^9 * 2^5 * 2^-53
    row("abs 0x1p-39", "random", points, HEX)
