#!/usr/bin/env python3
"""golden/enclosure.tsv: the exact least-squares control points of small double nets, each coordinate rounded once, by rational arithmetic."""
from fractions import Fraction as F
from math import nextafter

from rational import Choices, cox, head, row, span

CONVENTIONAL, IMPROVED, JOINT = range(3)
DEFAULT, FREE, INTERPOLATED = range(3)


def class_of(n, w, i, j):
    nx, ny = n
    if w == 0 or i in (0, nx - 1) or j in (0, ny - 1):
        return i * ny + j
    return nx * ny + (i - 1) * (ny - 2) + j - 1


def nov(n):
    return 2 * (n[0] * n[1] - n[0] - n[1] + 2)


def is_corner(k, a, b):
    return a in (0, k[0] - 1) and b in (0, k[1] - 1)


def is_border(k, a, b):
    return a in (0, k[0] - 1) or b in (0, k[1] - 1)


def collocation(u, p, t):
    v = [F(x) for x in u]
    return [cox(v, p, span(v, p, F(x)), F(x)) for x in t]


def eliminate(A, B):
    """X of A X = B, or None."""
    n = len(A)
    M = [list(a) + list(b) for a, b in zip(A, B)]
    for c in range(n):
        k = next((i for i in range(c, n) if M[i][c] != 0), None)
        if k is None:
            return None
        M[c], M[k] = M[k], M[c]
        for i in range(c + 1, n):
            if M[i][c] != 0:
                f = M[i][c] / M[c][c]
                M[i] = [x - f * y if y else x for x, y in zip(M[i], M[c])]
    X = [None] * n
    for i in reversed(range(n)):
        right = M[i][n:]
        for j in range(i + 1, n):
            if M[i][j] != 0:
                right = [x - M[i][j] * y for x, y in zip(right, X[j])]
        X[i] = [x / M[i][i] for x in right]
    return X


def solve(net, views, fixed):
    """{(w, a, b): point} for the views together: normal equations in all their unknowns."""
    n, k, data, basis = net["n"], net["k"], net["data"], net["basis"][views[0]]
    number, normal, right, done = {}, {}, {}, set()
    for w in views:
        for a in range(k[0]):
            for b in range(k[1]):
                if not (fixed and is_corner(k, a, b)):
                    number.setdefault(class_of(k, w, a, b), len(number))
    corner = lambda a, b: data[class_of(n, 0, n[0] - 1 if a else 0, n[1] - 1 if b else 0)]
    for w in views:
        for i in range(n[0]):
            for j in range(n[1]):
                c = class_of(n, w, i, j)
                if c in done:
                    continue
                done.add(c)
                line, d = {}, [F(x) for x in data[c]]
                for a, x in enumerate(basis[0][i]):
                    for b, y in enumerate(basis[1][j]):
                        if x * y == 0:
                            continue
                        if fixed and is_corner(k, a, b):
                            d = [e - x * y * F(z) for e, z in zip(d, corner(a, b))]
                        else:
                            line[number[class_of(k, w, a, b)]] = x * y
                for s in line:
                    for t in line:
                        normal[s, t] = normal.get((s, t), 0) + line[s] * line[t]
                    right[s] = [e + line[s] * f for e, f in zip(right.get(s, [0, 0, 0]), d)]
    m = len(number)
    X = eliminate([[normal.get((s, t), F(0)) for t in range(m)] for s in range(m)], [right.get(s, [F(0)] * 3) for s in range(m)])
    if X is None:
        return None
    point = lambda w, a, b: [F(x) for x in corner(a, b)] if fixed and is_corner(k, a, b) else X[number[class_of(k, w, a, b)]]
    return {(w, a, b): point(w, a, b) for w in views for a in range(k[0]) for b in range(k[1])}


def fit(net, approach, fixed):
    k, P = net["k"], {}
    if approach == JOINT:
        return solve(net, [0, 1], fixed)
    for w in (0, 1):
        Q = solve(net, [w], fixed and approach == CONVENTIONAL)
        if Q is None:
            return None
        P.update(Q)
    if approach == IMPROVED:
        n, data = net["n"], net["data"]
        for a in range(k[0]):
            for b in range(k[1]):
                if is_border(k, a, b):
                    m = [(x + y) / 2 for x, y in zip(P[0, a, b], P[1, a, b])]
                    if fixed and is_corner(k, a, b):
                        m = [F(x) for x in data[class_of(n, 0, n[0] - 1 if a else 0, n[1] - 1 if b else 0)]]
                    P[0, a, b] = P[1, a, b] = m
    return P


def clear_of_ties(P, data):
    """No coordinate nearer to a rounding boundary, or to a zero that only cancels, than 2^-90 of the data: what twice the precision decides."""
    for c in range(3):
        most = max(abs(F(d[c])) for d in data)
        for p in P.values():
            x = float(p[c])
            if most == 0:
                continue
            if x == 0:
                return False
            for side in (float("inf"), float("-inf")):
                if abs(p[c] - (F(x) + F(nextafter(x, side))) / 2) < most / 2**90:
                    return False
    return True


def write(reason, net, approach, corners):
    views = (0, 1) if approach == CONVENTIONAL else (0,)
    fixed = corners == INTERPOLATED or (corners == DEFAULT and approach == IMPROVED)
    P = fit(net, approach, fixed)
    if P is None or not clear_of_ties(P, net["data"]):
        return False
    k = net["k"]
    args = [approach, corners, net["p"], net["q"], *net["n"], *k]
    for w in views:
        args += net["s"][w] + net["r"][w] + net["u"][w] + net["v"][w]
    args += [float(x) for d in net["data"] for x in d]
    row("enclosure_refine", "exact", reason, args, [P[w, a, b][c] for w in (0, 1) for a in range(k[0]) for b in range(k[1]) for c in range(3)])
    return True


def inner(g, n, kind):
    """Parameters from 0 to 1: of thirty-seconds, of all bits, or with two neighbours near each other."""
    if kind == "grid":
        t = sorted({1 + g.upto(30) for _ in range(n - 2)})
        while len(t) < n - 2:
            t = sorted(set(t) | {1 + g.upto(30)})
        return [0.0] + [x / 32.0 for x in t] + [1.0]
    t = sorted(g.real(0.05, 0.95) for _ in range(n - 2))
    if kind == "close" and n > 3:
        t[1] = t[0] + 2.0**-12
        t.sort()
    return [0.0] + t + [1.0]


def knots(g, p, k, t):
    """Clamped, with interior knots among the parameters so that every span holds one."""
    m, spans, inside = len(t), k - p, []
    for j in range(1, spans):
        i = j * m // spans
        inside.append(t[i - 1] + (t[i] - t[i - 1]) * (1 + g.upto(6)) / 8)
    return [0.0] * (p + 1) + sorted(inside) + [1.0] * (p + 1)


def make(g, n, k, p, q, kind, value, shared):
    net = {"n": n, "k": k, "p": p, "q": q, "s": [], "r": [], "u": [], "v": [], "basis": []}
    for w in (0, 1):
        if w == 1 and shared:
            for x in "sruv":
                net[x].append(net[x][0])
        else:
            net["s"].append(inner(g, n[0], kind))
            net["r"].append(inner(g, n[1], kind))
            net["u"].append(knots(g, p, k[0], net["s"][w]))
            net["v"].append(knots(g, q, k[1], net["r"][w]))
        net["basis"].append((collocation(net["u"][w], p, net["s"][w]), collocation(net["v"][w], q, net["r"][w])))
    net["data"] = [[value(g, c) for c in range(3)] for _ in range(nov(n))]
    return net


def whole(g, c):
    return float(g.upto(18) - 9)


def bits(g, c):
    return g.real(-1.0, 1.0)


def pillow(g, c):
    return 1.0 + g.real(0.0, 2.0**-20)


def huge(g, c):
    return g.real(-1.0, 1.0) * 2.0**1000


def tiny(g, c):
    return g.real(-1.0, 1.0) * 2.0**-1015


def mixed(g, c):
    return g.real(-1.0, 1.0) * (2.0**-300, 1.0, 2.0**300)[c]


def flat(g, c):
    return 0.0 if c == 1 else g.real(-1.0, 1.0)


CASES = [
    ("smallest", (2, 2), (2, 2), 1, 1, "grid", bits), ("two_control_points_a_side", (3, 3), (2, 2), 1, 1, "grid", whole),
    ("interpolation", (3, 3), (3, 3), 1, 1, "bits", bits), ("interpolation_cubic", (4, 4), (4, 4), 3, 3, "grid", whole),
    ("mixed_degrees", (5, 3), (4, 2), 2, 1, "grid", bits), ("turned", (3, 5), (2, 4), 1, 2, "bits", bits),
    ("narrow", (2, 6), (2, 4), 1, 3, "grid", whole), ("interior_knots", (6, 5), (5, 4), 2, 2, "grid", bits),
    ("all_bits", (5, 4), (4, 3), 2, 2, "bits", bits), ("neighbours_close", (5, 5), (4, 4), 3, 2, "close", bits),
    ("nearly_flat", (5, 5), (4, 3), 2, 2, "grid", pillow), ("huge", (4, 4), (3, 3), 2, 2, "grid", huge),
    ("tiny_results_subnormal", (4, 4), (3, 3), 2, 1, "grid", tiny), ("scales_mixed", (4, 5), (3, 4), 2, 3, "bits", mixed),
    ("zero_coordinate", (4, 4), (3, 3), 1, 2, "grid", flat), ("linear", (6, 6), (4, 5), 1, 1, "grid", whole),
    ("no_interior_control_point", (6, 5), (2, 4), 1, 2, "bits", bits),
]


def main():
    head("enclosure", "exact least-squares control points, rounded once")
    print("# args: approach corners p q nx ny cx cy; s r u v of the shared view, or of bottom and top (conventional); data by class"
          "; want: control points, bottom then top")
    for number, (reason, n, k, p, q, kind, value) in enumerate(CASES):
        for approach in (CONVENTIONAL, IMPROVED, JOINT):
            for corners in (FREE, INTERPOLATED):
                wanted = 2
                for seed in range(40):
                    if wanted > 0:
                        g = Choices(1000 * number + 100 * approach + 50 * corners + seed)
                        wanted -= write(reason, make(g, n, k, p, q, kind, value, approach != CONVENTIONAL), approach, corners)
        if number < 6:
            g = Choices(77 + number)
            write(reason + "_default_corners", make(g, n, k, p, q, kind, value, True), number % 3 if number % 3 else IMPROVED, DEFAULT)


main()
