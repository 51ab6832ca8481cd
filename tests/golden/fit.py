#!/usr/bin/env python3
"""golden/fit.tsv: least squares of small double nets by rational arithmetic, at parameters and knots that doubles hold exactly."""
from decimal import Decimal, getcontext
from fractions import Fraction as F

getcontext().prec = 60
U = F(1, 2**53)
APPROACH = ["conventional", "improved", "joint"]
KNOTS = ["piegl", "faithful", "uniform"]


def hexf(x):
    return float(x).hex()


def root(x):
    return F((Decimal(x.numerator) / Decimal(x.denominator)).sqrt())


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
    def __init__(self, rule, p, q, n, k, data):
        self.p, self.q, self.n, self.k, self.data, self.condition = p, q, n, k, data, F(1)
        s, r = uniform(n[0]), uniform(n[1])
        u, v = knots(rule, p, k[0], s), knots(rule, q, k[1], r)
        self.Nu = [[basis(u, a, p, x) for a in range(k[0])] for x in s]
        self.Nv = [[basis(v, b, q, x) for b in range(k[1])] for x in r]

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
        error = 64 * (len(rows) + 8) * (len(number) + 8) * U * (1 + k) ** 2 * inv * (frobenius(rhs) + 1)
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

    def distances(self, P):
        """{(w, i, j): |D - S|}"""
        out = {}
        for w in (0, 1):
            for i in range(self.n[0]):
                for j in range(self.n[1]):
                    S = [sum(self.Nu[i][a] * self.Nv[j][b] * F(P[w, a, b][c]) for a in range(self.k[0]) for b in range(self.k[1])) for c in range(3)]
                    out[w, i, j] = root(sum((F(x) - y) ** 2 for x, y in zip(self.data[class_of(self.n, w, i, j)], S)))
        return out


def power(x):
    e = 0
    while F(2) ** e > x:
        e -= 1
    while F(2) ** e < x:
        e += 1
    return "abs " + hexf(F(2) ** e)


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


def rows(reason, rule, p, q, n, k, data):
    net = Net(rule, p, q, n, k, data)
    for ap, approach in enumerate(APPROACH):
        for fixed in (False, True):
            P, error = net.fit(approach, fixed)
            want = [hexf(P[w, a, b][c]) for w in (0, 1) for a in range(k[0]) for b in range(k[1]) for c in range(3)]
            d = net.distances(P)
            classes = {class_of(n, w, i, j): d[w, i, j] for w in (1, 0) for i in range(n[0]) for j in range(n[1])}
            ends = [d[w, i, j] for w in (0, 1) for i in (0, n[0] - 1) for j in (0, n[1] - 1)]
            sums = [sum(classes.values()), sum(d.values()), max(d.values()), max(ends)]
            for algebra in range(3 if k[0] * k[1] < 9 else 1):
                args = [ap, 0, KNOTS.index(rule), algebra, 2 if fixed else 1, p, q, n[0], n[1], k[0], k[1]]
                text = " ".join([str(x) for x in args] + [hexf(c) for D in data for c in D])
                print("fit_make", power(error * (net.condition if algebra == 1 else 1)), reason, text, " ".join(want), sep="\t")
                if algebra == 0:
                    print("fit_measure", power(4 * error * (2 * n[0] * n[1] + 4)), reason, text, " ".join(hexf(x) for x in sums), sep="\t")


def parameters(reason, approach, method, n, data):
    def line(points):
        d = []
        for a, b in zip(points, points[1:]):
            e = root(sum((F(y) - F(x)) ** 2 for x, y in zip(a, b)))
            d.append([F(1), e, root(e), F((Decimal(e.numerator) / Decimal(e.denominator)) ** Decimal("0.8")) if e else F(0)][method])
        flat = method != 0 and sum(d) == 0
        d = [F(1)] * len(d) if flat else d
        t = [sum(d[:i]) / sum(d) for i in range(len(d) + 1)]
        return int(flat), t
    flat, s, r = 0, [], []
    for w in (0, 1):
        D = [[data[class_of(n, w, i, j)] for j in range(n[1])] for i in range(n[0])]
        along = [line([D[i][j] for i in range(n[0])]) for j in range(n[1])]
        across = [line(D[i]) for i in range(n[0])]
        flat += sum(x[0] for x in along) + sum(x[0] for x in across)
        s.append([sum(c) / len(along) for c in zip(*[x[1] for x in along])])
        r.append([sum(c) / len(across) for c in zip(*[x[1] for x in across])])
    if approach > 0:
        s = [[(x + y) / 2 for x, y in zip(*s)]] * 2
        r = [[(x + y) / 2 for x, y in zip(*r)]] * 2
    args = [str(approach), str(method), str(n[0]), str(n[1])] + [hexf(c) for D in data for c in D]
    want = [str(flat)] + [hexf(x) for w in (0, 1) for x in s[w] + r[w]]
    print("fit_parameters", "abs " + hexf((2 * max(n) + 36) * U), reason, " ".join(args), " ".join(want), sep="\t")


def main():
    print("# function\tclass\treason\tapproach method knots algebra corners p q nx ny cx cy data; or approach method nx ny data"
          "\tcontrol points, bottom then top; or nov non greatest corner; or flat s r s r")
    print("# made by tests/golden/fit.py")
    for k, name in enumerate(APPROACH + ["null"]):
        print("fit_name", "exact", "order", k, name, sep="\t")
    rows("smallest", "piegl", 1, 1, (2, 2), (2, 2), pillow((2, 2), 1))
    rows("one_interior_node_a_view", "piegl", 1, 1, (3, 3), (2, 2), pillow((3, 3), 2))
    rows("interpolation", "uniform", 1, 1, (3, 3), (3, 3), pillow((3, 3), 3))
    rows("mixed_degrees", "uniform", 2, 1, (5, 3), (4, 2), pillow((5, 3), 4))
    rows("turned", "uniform", 1, 2, (3, 5), (2, 4), pillow((3, 5), 4))
    rows("crowded_knots", "faithful", 2, 2, (5, 5), (4, 3), pillow((5, 5), 5))
    rows("no_interior_knot", "piegl", 3, 2, (5, 5), (4, 3), pillow((5, 5), 6))
    rows("narrow", "piegl", 1, 1, (2, 5), (2, 3), pillow((2, 5), 7))
    for approach in range(3):
        for method in range(4):
            for n, seed in [((3, 4), 8), ((5, 3), 9)]:
                parameters("whole_numbers", approach, method, n, pillow(n, seed))
        parameters("all_equal", approach, 1, (3, 3), [[F(1)] * 3] * nov((3, 3)))


main()
