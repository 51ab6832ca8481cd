#!/usr/bin/env python3
"""Golden rows of doublenet: the source's tables as printed (one misprint corrected), and hard sizes by enumeration or in unbounded integers.

Usage: doublenet.py > golden/doublenet.tsv
"""

# You 2023, Table 4.2 and Figure 4.3, net 4 x 5: the class of node (view, i, j), a line a view and an i.
TABLE_4_2 = (((1, 2, 3, 4, 5), (6, 7, 8, 9, 10), (11, 12, 13, 14, 15), (16, 17, 18, 19, 20)),
             ((1, 2, 3, 4, 5), (6, 21, 22, 23, 10), (11, 24, 25, 26, 15), (16, 17, 18, 19, 20)))
# Table 4.3: index vectors of the classes 1 .. 26.
TABLE_4_3 = ((0, 0, 1), (0, 1, 1), (0, 2, 1), (0, 3, 1), (0, 4, 1), (1, 0, 1), (1, 1, 0), (1, 2, 0), (1, 3, 0), (1, 4, 1), (2, 0, 1), (2, 1, 0),
             (2, 2, 0), (2, 3, 0), (2, 4, 1), (3, 0, 1), (3, 1, 1), (3, 2, 1), (3, 3, 1), (3, 4, 1), (1, 1, 2), (1, 2, 2), (1, 3, 2), (2, 1, 2),
             (2, 2, 2), (2, 3, 2))
# Table 4.4: dist^2 from class 7 to the classes 1 .. 26.
TABLE_4_4 = (3, 2, 3, 6, 11, 2, 0, 1, 4, 10, 3, 1, 2, 5, 11, 6, 5, 6, 9, 14, 4, 5, 8, 5, 6, 9)
# Tables 4.9, 4.13 and 4.14: nx, ny, NON, NOV, NOR.
COUNTS = (("4.9", ((10, 10, 200, 164, 36), (20, 20, 800, 724, 76), (30, 30, 1800, 1684, 116))),
          ("4.13", ((10, 8, 160, 128, 32), (20, 12, 480, 420, 60), (18, 30, 1080, 988, 92))),
          ("4.14", ((2, 3, 12, 6, 6), (3, 4, 24, 14, 10), (4, 5, 40, 26, 14), (5, 6, 60, 42, 18), (6, 7, 84, 62, 22), (7, 8, 112, 86, 26))))
# Table 5.1: CN_x, CN_y, the corners' classes; 6 x 7 prints 35 for 36.
TABLE_5_1 = ((3, 4, 1, 4, 9, 12), (4, 5, 1, 5, 16, 20), (5, 6, 1, 6, 25, 30), (6, 7, 1, 7, 36, 42), (7, 8, 1, 8, 49, 56))
SIZE_MAX = 2**64 - 1


def row(function, reason, args, want):
    print("doublenet_" + function, "exact", reason, " ".join(map(str, args)), " ".join(map(str, want)), sep="\t")


def vectors(nx, ny):
    """The set of distinct index vectors, in the order in which bottom and top are walked, and the number of nodes."""
    seen, nodes = [], 0
    for view in range(2):
        for i in range(nx):
            for j in range(ny):
                v = (i, j, 1 if i in (0, nx - 1) or j in (0, ny - 1) else 2 * view)
                nodes += 1
                if v not in seen:
                    seen.append(v)
    return seen, nodes


def walk(nx, ny):
    """The border as a turtle walks it."""
    i, j, di, dj, path = 0, 0, 0, 1, []
    while not path or (i, j) != (0, 0):
        path.append(i * ny + j + 1)
        if not (0 <= i + di < nx and 0 <= j + dj < ny):
            di, dj = dj, -di
        i, j = i + di, j + dj
    return path


def tables():
    for view in range(2):
        for i in range(4):
            for j in range(5):
                row("class", "table 4.2", (4, 5, view, i, j), (TABLE_4_2[view][i][j],))
    for c, v in enumerate(TABLE_4_3, 1):
        row("index", "table 4.3", (4, 5, c), v)
        row("dist2", "table 4.4", TABLE_4_3[6] + v, (TABLE_4_4[c - 1],))
    for table, rows in COUNTS:
        for nx, ny, non, nov, nor in rows:
            row("non", "table " + table, (nx, ny), (non,))
            row("nov", "table " + table, (nx, ny), (nov,))
            row("nor", "table " + table, (nx, ny), (nor,))
    for nx, ny, *corners in TABLE_5_1:
        row("corners", "table 5.1" + (", which prints 35" if nx == 6 else ""), (nx, ny), corners)


def enumerated():
    for nx, ny in ((2, 2), (2, 50), (50, 2), (3, 3), (2, 9)):
        seen, nodes = vectors(nx, ny)
        row("non", "enumerated", (nx, ny), (nodes,))
        row("nov", "enumerated", (nx, ny), (len(seen),))
        row("nor", "enumerated", (nx, ny), (nodes - len(seen),))
        row("index", "last class", (nx, ny, len(seen)), seen[-1])
        row("class", "top of the last node", (nx, ny, 1, nx - 1, ny - 1), (seen.index((nx - 1, ny - 1, 1)) + 1,))
    for nx, ny in ((2, 2), (2, 5), (5, 2), (3, 3), (4, 5), (18, 30)):
        row("seam", "walked", (nx, ny), walk(nx, ny))


def extremes():
    for nx, ny in ((0, 0), (1, 5), (5, 1), (2, 0), (2, 2), (2, SIZE_MAX // 4), (2, SIZE_MAX // 4 + 1), (SIZE_MAX // 4, 2), (SIZE_MAX // 4 + 1, 2),
                   (2**32, 2**31), (2**32, 2**31 - 1), (2**31, 2**32 - 1), (SIZE_MAX, SIZE_MAX), (2**32, 2**32), (3, SIZE_MAX // 6),
                   (3, SIZE_MAX // 6 + 1)):
        row("valid", "limit", (nx, ny), (int(nx >= 2 and ny >= 2 and 2 * nx * ny <= SIZE_MAX),))
    nx, ny = 2**32, 2**31 - 1
    nov = nx * ny + (nx - 2) * (ny - 2)
    row("nov", "near the limit", (nx, ny), (nov,))
    row("index", "near the limit", (nx, ny, nov), (nx - 2, ny - 2, 2))
    row("class", "near the limit", (nx, ny, 1, nx - 2, ny - 2), (nov,))
    nx, ny = 2**27 - 1, 2**25 + 1
    row("corners", "large", (nx, ny), (1, ny, ny * (nx - 1) + 1, nx * ny))
    for a, b, want in (((1, 1, 0), (1, 1, 2), 0), ((1, 1, 0), (1, 2, 0), 1), ((1, 1, 0), (0, 1, 1), 1), ((1, 1, 2), (1, 0, 1), 1),
                       ((1, 1, 0), (2, 2, 0), 0), ((1, 1, 0), (3, 1, 0), 0), ((0, 0, 1), (0, 0, 1), 1), ((5, 5, 0), (5, 6, 2), 0), ((0, 0, 1), (SIZE_MAX, 0, 1), 0),
                       ((0, 0, 1), (0, SIZE_MAX, 1), 0), ((1, 1, 1), (0, 0, 1), 0)):
        row("adjacent", "rule", a + b, (want,))
    row("dist2", "large", (0, 0, 0, 2**31, 2**31, 2), (2**63 + 4,))


def sides():
    """Every node, class and count of small nets, and of nets large in one or both sides."""
    for nx, ny in ((2, 2), (2, 3), (3, 2), (3, 3), (4, 3), (6, 7), (5, 5), (9, 4), (12, 9), (2, 17), (17, 2)):
        seen, nodes = vectors(nx, ny)
        place = {v: c for c, v in enumerate(seen, 1)}
        for view in range(2):
            for i in range(nx):
                for j in range(ny):
                    edge = i in (0, nx - 1) or j in (0, ny - 1)
                    row("class", "seam and closure" if edge else "inside", (nx, ny, view, i, j), (place[i, j, 1 if edge else 2 * view],))
        for c, v in enumerate(seen, 1):
            row("index", "seam and closure" if v[2] == 1 else "inside", (nx, ny, c), v)
    for nx in range(2, 31):
        for ny in {2, 3, 4, 5, 8, 12, 18, 20, 30} | {nx}:
            seen, nodes = vectors(nx, ny)
            row("non", "size", (nx, ny), (nodes,))
            row("nov", "size", (nx, ny), (len(seen),))
            row("nor", "size", (nx, ny), (nodes - len(seen),))
            path = walk(nx, ny)
            turn = [path[0], path[ny - 1], path[-(nx - 1)], path[ny - 1 + nx - 1]]
            row("corners", "size", (nx, ny), turn)
            if nx < 13 and ny < 13:
                row("seam", "seam and closure", (nx, ny), path)
    for k in range(2, 32):
        nx, ny = 2**k + k % 3, 2 ** (62 - k) - k % 5
        nov = nx * ny + (nx - 2) * (ny - 2)
        row("valid", "size", (nx, ny), (int(2 * nx * ny <= SIZE_MAX),))
        if 2 * nx * ny <= SIZE_MAX:
            row("non", "size", (nx, ny), (2 * nx * ny,))
            row("nov", "size", (nx, ny), (nov,))
            row("nor", "size", (nx, ny), (2 * nx * ny - nov,))
            row("corners", "size", (nx, ny), (1, ny, ny * (nx - 1) + 1, nx * ny))
            row("index", "size, last class", (nx, ny, nov), (nx - 2, ny - 2, 2))
            row("class", "size, last class", (nx, ny, 1, nx - 2, ny - 2), (nov,))
            row("index", "size, first of the top", (nx, ny, nx * ny + 1), (1, 1, 2))


def pairs():
    """Distances and neighbours of every class of a net to a few, and far away."""
    for nx, ny, chosen in ((4, 5, (0, 6, 7, 13, 20, 25)), (3, 3, range(10)), (2, 4, range(8))):
        seen, _ = vectors(nx, ny)
        for a in chosen:
            for b in seen:
                near = sum((x - y) ** 2 for x, y in zip(seen[a][:2], b[:2])) <= 1 and abs(seen[a][2] - b[2]) <= 1
                row("adjacent", "pair", seen[a] + b, (int(near),))
                row("dist2", "pair", seen[a] + b, (sum((x - y) ** 2 for x, y in zip(seen[a], b)),))
    for k in range(1, 32):
        a, b = (2**k, 2 ** (31 - k), k % 3), (2**k + 2 ** (k % 7), 0, (k + 1) % 3)
        row("dist2", "size", a + b, (sum((x - y) ** 2 for x, y in zip(a, b)),))
        row("adjacent", "size", a + b, (0,))
        row("adjacent", "size", a + a, (1,))


print("# function\tclass\treason\tnx ny and node (view i j) or class; two index vectors\twanted")
print("# made by tests/golden/doublenet.py from the tables of You 2023, by enumeration and in integers")
tables()
enumerated()
extremes()
sides()
pairs()
