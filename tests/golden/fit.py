#!/usr/bin/env python3
"""golden/fit.tsv: least squares of small double nets by rational arithmetic, at parameters and knots that doubles hold exactly.

Each stage is exact and rounded once: control points; the errors at the rounded control points; averages of parameters, then their means over
views.
Bounds: a backward stable solution's forward error, c u k (1 + k) |b| |A+|, k = |A| |A+|; with normal equations once more times k.
"""
from fractions import Fraction as F

from lines import grid
from rational import Choices, bound_of, decided, nearest, root as cut, show

U = F(1, 2**53)
APPROACH = ["conventional", "improved", "joint"]
KNOTS = ["piegl", "faithful", "uniform"]
OK, EINVAL, ERANK = 0, 1, 5


def hexf(x):
    return show(nearest(F(x)))


def root(x, bits=100):
    return cut(x, 2, bits)[0]


def is_double(x):
    return F(float(x)) == x


def class_of(n, w, i, j):
    nx, ny = n
    if w == 0 or i in (0, nx - 1) or j in (0, ny - 1):
        return i * ny + j
    return nx * ny + (i - 1) * (ny - 2) + j - 1


def nov(n):
    return 2 * (n[0] * n[1] - n[0] - n[1] + 2)


def uniform(n):
    t = [F(i, n - 1) for i in range(n)]
    assert all(is_double(x) for x in t)
    return t


def knots(kind, p, control, t):
    spans, inner = control - p, []
    for j in range(1, spans):
        if kind == "piegl":
            jd = F(j * len(t), spans)
            i = jd.numerator // jd.denominator
            inner.append((1 - (jd - i)) * t[i - 1] + (jd - i) * t[i])
        elif kind == "uniform":
            inner.append(F(j, spans))
        else:
            inner.append(sum(t[j:j + p]) / p)
    assert all(is_double(x) for x in inner), (kind, p, control)
    return [F(0)] * (p + 1) + inner + [F(1)] * (p + 1)


def basis(u, i, p, x):
    if p == 0:
        return F(int(u[i] <= x < u[i + 1] or (x == 1 and u[i] < u[i + 1] == 1)))
    a = (x - u[i]) / (u[i + p] - u[i]) * basis(u, i, p - 1, x) if u[i + p] > u[i] else F(0)
    b = (u[i + p + 1] - x) / (u[i + p + 1] - u[i + 1]) * basis(u, i + 1, p - 1, x) if u[i + p + 1] > u[i + 1] else F(0)
    return a + b


def inverse(A):
    n = len(A)
    M = [list(r) + [F(int(i == j)) for j in range(n)] for i, r in enumerate(A)]
    for c in range(n):
        k = next(i for i in range(c, n) if M[i][c] != 0)
        M[c], M[k] = M[k], M[c]
        M[c] = [x / M[c][c] for x in M[c]]
        for i in range(n):
            if i != c and M[i][c] != 0:
                f = M[i][c]
                M[i] = [x - f * y for x, y in zip(M[i], M[c])]
    return [r[n:] for r in M]


def frobenius(A):
    return root(sum(x * x for r in A for x in r))


class Net:
    def __init__(self, rule, p, q, n, k, data, s=None, r=None, method=0):
        self.p, self.q, self.n, self.k, self.data, self.condition = p, q, n, k, data, F(1)
        self.rule, self.method = rule, method
        s, r = s or uniform(n[0]), r or uniform(n[1])
        u, v = knots(rule, p, k[0], s), knots(rule, q, k[1], r)
        self.Nu = [[basis(u, a, p, x) for a in range(k[0])] for x in s]
        self.Nv = [[basis(v, b, q, x) for b in range(k[1])] for x in r]

    def head(self, approach, algebra, fixed):
        a = [approach, self.method, KNOTS.index(self.rule), algebra, 2 if fixed else 1, self.p, self.q, *self.n, *self.k]
        return " ".join([str(x) for x in a] + [hexf(c) for D in self.data for c in D])

    def deficient(self):
        """Conventional and improved: a direction's matrix is, without its end columns too if corners are fixed or not."""
        return [rank(N) < len(N[0]) for N in (self.Nu, self.Nv)]

    def is_corner(self, a, b):
        return a in (0, self.k[0] - 1) and b in (0, self.k[1] - 1)

    def corner(self, a, b):
        return self.data[class_of(self.n, 0, self.n[0] - 1 if a else 0, self.n[1] - 1 if b else 0)]

    def solve(self, views, fixed):
        """Control points {(w, a, b): point} that minimise the squares over the classes of the views, and a bound on a solver's error."""
        number, rows, rhs, done = {}, [], [], set()
        for w in views:
            for a in range(self.k[0]):
                for b in range(self.k[1]):
                    if not (fixed and self.is_corner(a, b)):
                        number.setdefault(class_of(self.k, w, a, b), len(number))
        for w in views:
            for i in range(self.n[0]):
                for j in range(self.n[1]):
                    c = class_of(self.n, w, i, j)
                    if c in done:
                        continue
                    done.add(c)
                    line, right = [F(0)] * len(number), [F(x) for x in self.data[c]]
                    for a in range(self.k[0]):
                        for b in range(self.k[1]):
                            x = self.Nu[i][a] * self.Nv[j][b]
                            if fixed and self.is_corner(a, b):
                                right = [y - x * e for y, e in zip(right, self.corner(a, b))]
                            else:
                                line[number[class_of(self.k, w, a, b)]] += x
                    rows.append(line)
                    rhs.append(right)
        if not number:
            return {(w, a, b): self.corner(a, b) for w in views for a in range(self.k[0]) for b in range(self.k[1])}, U
        G = [[sum(x * y for x, y in zip(c, d)) for d in zip(*rows)] for c in zip(*rows)]
        H = [[sum(x * y for x, y in zip(c, d)) for d in zip(*rhs)] for c in zip(*rows)]
        V = inverse(G)
        X = [[sum(x * y for x, y in zip(r, d)) for d in zip(*H)] for r in V]
        inv = root(frobenius(V))
        k = frobenius(rows) * inv
        size = frobenius(rhs) + frobenius(self.data)
        error = 64 * (len(rows) + 8) * (len(number) + 8) * U * (1 + k) ** 2 * inv * size + F(1, 2**1000)
        self.condition = max(self.condition, 1 + k)
        point = lambda w, a, b: self.corner(a, b) if fixed and self.is_corner(a, b) else X[number[class_of(self.k, w, a, b)]]
        return {(w, a, b): point(w, a, b) for w in views for a in range(self.k[0]) for b in range(self.k[1])}, error

    def fit(self, approach, fixed):
        if approach == "joint":
            return self.solve([0, 1], fixed)
        P, error = {}, U
        for w in (0, 1):
            Q, e = self.solve([w], fixed and approach == "conventional")
            P.update(Q)
            error = max(error, e)
        if approach == "improved":
            for a in range(self.k[0]):
                for b in range(self.k[1]):
                    if a in (0, self.k[0] - 1) or b in (0, self.k[1] - 1):
                        m = [(x + y) / 2 for x, y in zip(P[0, a, b], P[1, a, b])]
                        P[0, a, b] = P[1, a, b] = self.corner(a, b) if fixed and self.is_corner(a, b) else m
        return P, error

    def squares(self, P):
        """{(w, i, j): |D - S|^2} at control points that are rounded."""
        P = {at: [F(nearest(x)) for x in point] for at, point in P.items()}
        out = {}
        for w in (0, 1):
            for i in range(self.n[0]):
                columns = [[sum(x * P[w, a, b][c] for a, x in enumerate(self.Nu[i]) if x) for c in range(3)] for b in range(self.k[1])]
                for j in range(self.n[1]):
                    S = [sum(y * columns[b][c] for b, y in enumerate(self.Nv[j]) if y) for c in range(3)]
                    out[w, i, j] = sum((F(x) - y) ** 2 for x, y in zip(self.data[class_of(self.n, w, i, j)], S))
        return out


def rank(A):
    M, r = [list(x) for x in A], 0
    for c in range(len(A[0])):
        k = next((i for i in range(r, len(M)) if M[i][c] != 0), None)
        if k is None:
            continue
        M[r], M[k] = M[k], M[r]
        for i in range(r + 1, len(M)):
            if M[i][c] != 0:
                f = M[i][c] / M[r][c]
                M[i] = [x - f * y for x, y in zip(M[i], M[r])]
        r += 1
    return r


def sum_of_roots(squares):
    """The double nearest to a sum of square roots."""
    def ends(bits):
        low = high = F(0)
        for q in squares:
            x, whole = cut(q, 2, bits)
            low += x if whole else x - F(1, 2**bits)
            high += x if whole else x + F(1, 2**bits)
        return low, high
    return decided(ends)


def pillow(n, seed):
    """Whole numbers from a small generator of its own."""
    data, x = [], seed
    for c in range(nov(n)):
        p = []
        for _ in range(3):
            x = (x * 1103515245 + 12345) % 2**31
            p.append(F((x >> 16) % 9 - 4))
        data.append(p)
    return data


def rows(reason, net, approaches=(0, 1, 2), algebras=3):
    n, k = net.n, net.k
    for ap in approaches:
        for fixed in (False, True):
            P, error = net.fit(APPROACH[ap], fixed)
            want = [hexf(P[w, a, b][c]) for w in (0, 1) for a in range(k[0]) for b in range(k[1]) for c in range(3)]
            d = net.squares(P)
            classes = {class_of(n, w, i, j): d[w, i, j] for w in (1, 0) for i in range(n[0]) for j in range(n[1])}
            ends = [d[w, i, j] for w in (0, 1) for i in (0, n[0] - 1) for j in (0, n[1] - 1)]
            sums = [sum_of_roots(x) for x in (classes.values(), d.values(), [max(d.values())], [max(ends)])]
            for algebra in range(algebras if k[0] * k[1] < 9 else 1):
                text = net.head(ap, algebra, fixed)
                print("fit_make", "abs " + bound_of(error * (net.condition if algebra == 1 else 1)), reason, text, " ".join(want), sep="\t")
                if algebra == 0:
                    bound = bound_of(4 * error * (2 * n[0] * n[1] + 4))
                    print("fit_measure", "abs " + bound, reason, text, " ".join(show(x) for x in sums), sep="\t")


def parameters(reason, approach, method, n, data):
    s, r, flat = [], [], 0
    for w in (0, 1):
        D = [[data[class_of(n, w, i, j)] for j in range(n[1])] for i in range(n[0])]
        lost, along, across = grid(D, method)
        flat += lost
        s.append(along)
        r.append(across)
    if approach > 0:
        s = [[nearest((F(x) + F(y)) / 2) for x, y in zip(*s)]] * 2
        r = [[nearest((F(x) + F(y)) / 2) for x, y in zip(*r)]] * 2
    args = [str(approach), str(method), str(n[0]), str(n[1])] + [hexf(c) for D in data for c in D]
    want = [str(flat)] + [show(x) for w in (0, 1) for x in s[w] + r[w]]
    print("fit_parameters", "abs " + bound_of((2 * max(n) + 36) * U), reason, " ".join(args), " ".join(want), sep="\t")


def walked(c, n, total, steps):
    """A walk along a line of n points with whole steps, some zero, forwards and backwards; its chord parameters, i / total."""
    lengths = [c.of(steps) for _ in range(n - 2)]
    while sum(lengths) > total:
        lengths = [c.of(steps) for _ in range(n - 2)]
    lengths.append(total - sum(lengths))
    x, t = [F(0)], [F(0)]
    for d in lengths:
        x.append(x[-1] + d * c.of((1, 1, -1)))
        t.append(t[-1] + F(d, total))
    return x, t


def sheet(n, x, y):
    """Both views one plane: every line of the grid has the chord parameters of its walk."""
    data = [None] * nov(n)
    for w in (0, 1):
        for i in range(n[0]):
            for j in range(n[1]):
                data[class_of(n, w, i, j)] = [x[i], y[j], F(5)]
    return data


def fits(c):
    """(reason, net) that is solvable"""
    def data(n, how):
        draw = {"random": lambda: F(c.real(-1, 1)), "whole": lambda: F(c.upto(16) - 8), "extreme scale, 1e100": lambda: F(1e100 * (c.upto(8) - 4)),
                "extreme scale, 1e-100": lambda: F(1e-100 * (c.upto(8) - 4)), "extreme scale, offset": lambda: F(10**9) + F(c.upto(16), 16)}[how]
        return [[draw() for _ in range(3)] for _ in range(nov(n))]
    hows = ("random", "whole", "extreme scale, 1e100", "extreme scale, 1e-100", "extreme scale, offset")
    shapes = [("uniform", 1, 1, (3, 3), (3, 2)), ("uniform", 2, 1, (5, 3), (4, 2)), ("piegl", 1, 2, (5, 5), (2, 3)), ("piegl", 1, 1, (3, 5), (2, 2)),
              ("faithful", 2, 1, (5, 3), (4, 2)), ("uniform", 3, 1, (5, 2), (4, 2)), ("piegl", 2, 2, (5, 5), (3, 3)),
              ("uniform", 1, 1, (2, 9), (2, 3)),
              ("uniform", 1, 1, (5, 5), (3, 3)), ("piegl", 4, 1, (9, 2), (5, 2))]
    for k, (rule, p, q, n, m) in enumerate(shapes):
        for how in (hows[k % 5], hows[(k + 2) % 5]):
            yield how, Net(rule, p, q, n, m, data(n, how))
    n = (3, 3)
    one = data(n, "whole")
    yield "degenerate geometry, pole", Net("piegl", 1, 1, n, (2, 2), [one[0]] * 3 + one[3:])
    yield "coincident points, all", Net("piegl", 1, 1, n, (2, 2), [one[0]] * nov(n))
    closed = one[:6] + one[:3] + one[9:]
    yield "seam and closure", Net("uniform", 2, 1, n, (3, 2), closed)
    walks = (((5, 5), (3, 3), 2, 1, "uniform", (1, 2, 3)), ((7, 5), (3, 2), 2, 1, "piegl", (1, 2, 0)), ((6, 4), (4, 3), 1, 2, "uniform", (1, 2, 4)),
             ((9, 3), (4, 2), 3, 1, "uniform", (1, 1, 2)), ((8, 4), (4, 2), 2, 1, "faithful", (1, 2)), ((5, 5), (4, 3), 3, 2, "piegl", (0, 1, 4)))
    for n, m, p, q, rule, steps in walks:
        for _ in range(40):
            (x, s), (y, r) = walked(c, n[0], 16, steps), walked(c, n[1], 8, steps)
            try:
                net = Net(rule, p, q, n, m, sheet(n, x, y), s, r, 1)
            except AssertionError:                         # a knot that is no double
                continue
            if not any(net.deficient()):
                yield "chord parameters on walks", net
                break


def failures(c):
    """(reason, net, whether singular); the parameters are chord lengths of walks, i / 16 and i / 8."""
    repeated, violated, singular = "repeated sites", "Schoenberg-Whitney violated", "singular"
    walks = (((6, 3), (4, 2), 1, 1, "uniform", (0, 0, 1), repeated), ((5, 3), (5, 2), 1, 1, "uniform", (1, 1, 2), violated),
             ((7, 3), (5, 2), 3, 1, "uniform", (0, 1), repeated), ((5, 5), (2, 5), 1, 1, "uniform", (0, 1), repeated),
             ((9, 4), (9, 2), 1, 1, "uniform", (1,), violated), ((6, 4), (6, 2), 2, 1, "uniform", (1, 2), violated),
             ((3, 6), (2, 5), 1, 2, "faithful", (0, 1), singular), ((6, 3), (5, 2), 2, 1, "faithful", (0, 1), singular))
    for n, m, p, q, rule, steps, why in walks:
        made = 0
        for _ in range(60):
            if made == 4:
                break
            (x, s), (y, r) = walked(c, n[0], 16, steps), walked(c, n[1], 8, (1, 2) if n[1] < 5 else steps)
            try:
                net = Net(rule, p, q, n, m, sheet(n, x, y), s, r, 1)
            except AssertionError:
                continue
            made += 1
            yield why if any(net.deficient()) else why + " not, but nearly", net, any(net.deficient())


def main():
    print("# function\tclass\treason\tapproach method knots algebra corners p q nx ny cx cy data; or approach method nx ny data"
          "\tcontrol points, bottom then top; or nov non greatest corner; or flat s r s r")
    print("# made by tests/golden/fit.py")
    for k, name in enumerate(APPROACH + ["null"]):
        print("fit_name", "exact", "order", k, name, sep="\t")
    rows("smallest", Net("piegl", 1, 1, (2, 2), (2, 2), pillow((2, 2), 1)))
    rows("one interior node a view", Net("piegl", 1, 1, (3, 3), (2, 2), pillow((3, 3), 2)))
    rows("interpolation", Net("uniform", 1, 1, (3, 3), (3, 3), pillow((3, 3), 3)))
    rows("mixed degrees", Net("uniform", 2, 1, (5, 3), (4, 2), pillow((5, 3), 4)))
    rows("turned", Net("uniform", 1, 2, (3, 5), (2, 4), pillow((3, 5), 4)))
    rows("crowded knots", Net("faithful", 2, 2, (5, 5), (4, 3), pillow((5, 5), 5)))
    rows("no interior knot", Net("piegl", 3, 2, (5, 5), (4, 3), pillow((5, 5), 6)))
    rows("narrow", Net("piegl", 1, 1, (2, 5), (2, 3), pillow((2, 5), 7)))
    for approach in range(3):
        for method in range(4):
            for n, seed in [((3, 4), 8), ((5, 3), 9)]:
                parameters("whole numbers", approach, method, n, pillow(n, seed))
        parameters("coincident points, all", approach, 1, (3, 3), [[F(1)] * 3] * nov((3, 3)))
    c = Choices(31)
    for reason, net in fits(c):
        rows(reason, net, algebras=2)
    for reason, net, singular in failures(c):
        for approach in (0, 1):
            for algebra in (0, 1, 2):
                print("fit_make_status", "exact", reason, net.head(approach, algebra, False), ERANK if singular and algebra < 2 else OK, sep="\t")
    plain = pillow((4, 4), 11)
    for approach, method, knots_rule, algebra, corners, p, q, cx, cy, why in (
            (3, 1, 0, 0, 1, 1, 1, 3, 3, "unknown approach"), (0, 4, 0, 0, 1, 1, 1, 3, 3, "unknown method"),
            (0, 1, 4, 0, 1, 1, 1, 3, 3, "unknown rule"),
            (0, 1, 0, 3, 1, 1, 1, 3, 3, "unknown algebra"), (0, 1, 0, 0, 3, 1, 1, 3, 3, "unknown corners"), (0, 1, 0, 0, 1, 0, 1, 3, 3, "degree 0"),
            (0, 1, 0, 0, 1, 1, 0, 3, 3, "degree 0"), (0, 1, 0, 0, 1, 3, 1, 3, 3, "too few coefficients"),
            (0, 1, 0, 0, 1, 1, 3, 3, 3, "too few coefficients"),
            (0, 1, 0, 0, 1, 1, 1, 5, 3, "more coefficients than data"), (0, 1, 0, 0, 1, 1, 1, 3, 5, "more coefficients than data"),
            (2, 1, 0, 0, 1, 25, 1, 3, 3, "degree 25"), (1, 1, 0, 0, 2, 1, 1, 1, 3, "too few coefficients")):
        args = [approach, method, knots_rule, algebra, corners, p, q, 4, 4, cx, cy]
        print("fit_make_status", "exact", why, " ".join([str(x) for x in args] + [hexf(x) for D in plain for x in D]), EINVAL, sep="\t")
    for k in range(12):
        n = (c.between(2, 5), c.between(2, 4))
        data = [[F(c.real(-1, 1)) if k % 2 else F(1e9) + F(c.upto(64), 64) for _ in range(3)] for _ in range(nov(n))]
        if k % 3 == 2:
            data[:n[1]] = [data[0]] * n[1]
        for approach in (0, 1 + k % 2):
            for method in range(4):
                why = ("random" if k % 2 else "extreme scale, offset") + (", degenerate geometry, pole" if k % 3 == 2 else "")
                parameters(why, approach, method, n, data)


main()
