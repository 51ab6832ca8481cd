#!/usr/bin/env python3
"""golden/linalg.tsv: least squares of integer matrices by rational arithmetic, R by Gram and Schmidt in rationals."""
from decimal import Decimal, getcontext
from fractions import Fraction as F

from rational import Choices, bound_of, nearest, root, show

getcontext().prec = 60
U = F(1, 2**53)


def hexf(x):
    return show(nearest(F(x)))


def mul(A, B):
    return [[sum(a * b for a, b in zip(row, col)) for col in zip(*B)] for row in A]


def transpose(A):
    return [list(c) for c in zip(*A)]


def solve(A, B):
    n = len(A)
    M = [list(map(F, a)) + list(map(F, b)) for a, b in zip(A, B)]
    for c in range(n):
        k = next(i for i in range(c, n) if M[i][c] != 0)
        M[c], M[k] = M[k], M[c]
        M[c] = [x / M[c][c] for x in M[c]]
        for i in range(n):
            if i != c:
                M[i] = [x - M[i][c] * y for x, y in zip(M[i], M[c])]
    return [r[n:] for r in M]


def echelon(A):
    M, pivots = [list(map(F, r)) for r in A], []
    for c in range(len(A[0])):
        k = next((i for i in range(len(pivots), len(M)) if M[i][c] != 0), None)
        if k is None:
            continue
        r = len(pivots)
        M[r], M[k] = M[k], M[r]
        M[r] = [x / M[r][c] for x in M[r]]
        for i in range(len(M)):
            if i != r:
                M[i] = [x - M[i][c] * y for x, y in zip(M[i], M[r])]
        pivots.append(c)
    return M[:len(pivots)], pivots


def norm(A):
    s = sum(F(x) ** 2 for r in A for x in r)
    return F((Decimal(s.numerator) / Decimal(s.denominator)).sqrt())


def least_norm(A, B):
    """A = C E with E the echelon rows and C the pivot columns: A+ = E'(EE')^-1 (C'C)^-1 C'."""
    E, pivots = echelon(A)
    C = [[r[c] for c in pivots] for r in A]
    Y = solve(mul(transpose(C), C), mul(transpose(C), B))
    X = mul(transpose(E), solve(mul(E, transpose(E)), Y))
    pinv = mul(transpose(E), solve(mul(E, transpose(E)), solve(mul(transpose(C), C), transpose(C))))
    return len(pivots), X, norm(pinv)


def bound(A, B, inverse, method):
    """c u k (1 + k) (|x| + ..): the forward error of a backward stable solution; normal equations once more by k."""
    k = norm(A) * inverse
    c = 64 * (len(A) + 4) * (len(A[0]) + 4)
    return c * U * (1 + k) ** 2 * ((1 + k) if method == 1 else 1) * inverse * (norm(B) + 1)


def power(x):
    return "abs " + bound_of(x)


def flat(A):
    return [hexf(x) for r in A for x in r]


def lsq(reason, A, B):
    m, n, k = len(A), len(A[0]), len(B[0])
    rank, X, inverse = least_norm(A, B)
    for method in range(3):
        args = " ".join([str(method), str(m), str(n), str(k)] + flat(A) + flat(B))
        if rank < n and method < 2:
            print("linalg_lsq", "exact", reason, args, rank, sep="\t")
        else:
            print("linalg_lsq", power(bound(A, B, inverse, method)), reason, args, " ".join([str(rank)] + flat(X)), sep="\t")


def band(reason, start, rows, n, B):
    w, m, k = len(rows[0]), len(rows), len(B[0])
    A = [[0] * s + r + [0] * (n - w - s) for s, r in zip(start, rows)]
    rank, X, inverse = least_norm(A, B)
    for method in range(3):
        args = " ".join([str(method), str(m), str(n), str(w), str(k)] + [str(s) for s in start] + flat(rows) + flat(B))
        if rank < n and method < 2:
            print("linalg_band_lsq", "exact", reason, args, rank, sep="\t")
        else:
            print("linalg_band_lsq", power(bound(A, B, inverse, method)), reason, args, " ".join([str(rank)] + flat(X)), sep="\t")


def qr(reason, A, B):
    m, n, k = len(A), len(A[0]), len(B[0])
    # Gram and Schmidt without roots: V_i orthogonal, R_ij = V_i'a_j / |V_i|.
    V = [[F(x) for x in c] for c in transpose(A)]
    over = lambda x, d: (1 if x > 0 else -1) * root(x * x / d)[0]
    R, C = [[F(0)] * n for _ in range(n)], []
    for i in range(n):
        d = sum(x * x for x in V[i])
        for j in range(i, n):
            f = sum(x * y for x, y in zip(V[i], V[j]))
            R[i][j] = over(f, d)
            if j > i:
                V[j] = [y - f / d * x for x, y in zip(V[i], V[j])]
        C.append([over(sum(x * F(y) for x, y in zip(V[i], c)), d) for c in transpose(B)])
    inverse = least_norm(A, [[0]] * m)[2]
    t = 64 * (m + 4) * (n + 4) * U * (1 + norm(A) * inverse) * (norm(A) + norm(B))
    args = " ".join([str(m), str(n), str(k)] + flat(A) + flat(B))
    print("linalg_qr", power(t), reason, args, " ".join(flat(R) + flat(C)), sep="\t")


def main():
    print("# function\tclass\treason\tmethod m n k A B; or m n k A B; or method m n w k start a B\trank X (the rank alone where deficient); or R C")
    print("# made by tests/golden/linalg.py")
    for k, name in enumerate(["qr", "cholesky", "svd", "null"]):
        print("linalg_name", "exact", "order", k, name, sep="\t")
    line = [[1, x] for x in range(5)]
    lsq("mean", [[1]] * 4, [[1], [2], [4], [9]])
    lsq("straight_line", line, [[1, 0], [3, 1], [4, 0], [4, 2], [7, 5]])
    lsq("parabola", [[1, x, x * x] for x in range(-2, 4)], [[3], [0], [0], [1], [5], [8]])
    lsq("square", [[2, 1], [1, 3]], [[1], [2]])
    lsq("permuted", [[0, 0, 2], [0, 3, 0], [5, 0, 0], [0, 0, 0]], [[2], [6], [10], [7]])
    lsq("hilbert_like", [[60, 30, 20], [30, 20, 15], [20, 15, 12], [15, 12, 10]], [[1], [1], [1], [1]])
    lsq("equal_columns", [[1, 1], [2, 2], [3, 3]], [[1], [1], [2]])
    lsq("sum_of_columns", [[1, 2, 3], [0, 1, 1], [2, 1, 3], [1, 1, 2]], [[1], [2], [3], [4]])
    lsq("zero_column", [[1, 0], [2, 0], [3, 0]], [[1], [0], [1]])
    lsq("zero_first_column", [[0, 1], [0, 2], [0, 3]], [[1], [0], [1]])
    lsq("wide", [[1, 2, 3], [0, 1, 1]], [[1], [2]])
    lsq("one_by_one", [[-4]], [[6]])
    lsq("rank_one", [[1, 2, -1], [2, 4, -2], [0, 0, 0]], [[1], [1], [5]])
    band("bidiagonal", [0, 0, 1, 1, 2, 2], [[1, 0], [1, 1], [2, 1], [1, 2], [1, 1], [0, 1]], 4, [[1], [2], [3], [4], [5], [6]])
    band("hats", [0, 0, 0, 0, 1, 1, 1, 1, 1], [[4, 0], [3, 1], [2, 2], [1, 3], [4, 0], [3, 1], [2, 2], [1, 3], [0, 4]], 3,
         [[x * x % 7, x] for x in range(9)])
    band("quadratic", [0, 0, 0, 0, 0, 1, 1, 1, 1, 2], [[2, 0, 0], [1, 1, 0], [1, 4, 1], [1, 3, 2], [0, 1, 1], [2, 3, 1], [1, 4, 1], [1, 2, 1],
                                                   [0, 1, 1],
                                                   [0, 0, 2]], 5, [[x % 4] for x in range(10)])
    band("full_width", [0, 0, 0], [[1, 2], [3, 4], [5, 6]], 2, [[1], [0], [2]])
    band("width_one", [0, 0, 1, 2], [[1], [2], [3], [4]], 3, [[5], [5], [6], [8]])
    band("column_without_entry", [0, 0, 2, 2], [[1], [2], [3], [4]], 3, [[5], [5], [6], [8]])
    band("too_few_rows_at_the_end", [0, 0, 0, 0, 2], [[1, 2], [2, 1], [1, 1], [0, 1], [1, 1]], 4, [[1], [1], [2], [3], [5]])
    band("fewer_rows", [0, 1], [[1, 1], [1, 1]], 3, [[1], [2]])
    qr("identity", [[1, 0], [0, 1], [0, 0]], [[1], [2], [3]])
    qr("pythagorean", [[3, 1], [4, 2]], [[1], [0]])
    qr("line", line, [[1], [3], [4], [4], [7]])
    qr("negative", [[-2, 1, 0], [1, -3, 1], [0, 1, -4], [2, 2, 2]], [[1, 0], [0, 1], [2, 2], [-1, 3]])
    c = Choices(73)
    whole = lambda m, n, most=4: [[c.between(0, 2 * most) - most for _ in range(n)] for _ in range(m)]
    for k in range(40):
        n = c.between(1, 4)
        m = n + c.upto(3)
        A, B = whole(m, n), whole(m, c.between(1, 2), 9)
        why = "random"
        if k % 4 == 1 and n > 1:
            A, why = [r[:-1] + [r[0] * 2] for r in A], "singular, proportional columns"
        elif k % 4 == 2:
            s = 2.0 ** c.of((300, -300, 100))
            A, why = [[x * s for x in r] for r in A], "extreme scale"
        elif k % 4 == 3:
            A, why = [A[0]] * (m - 1) + [A[-1]], "repeated sites"
        if not any(x for r in A for x in r):
            A[0][0] = 1
        if echelon(A)[1] and (why != "extreme scale" or len(echelon(A)[1]) == n):
            lsq(why, A, B)
    for k in range(30):
        n = c.between(2, 6)
        w = c.between(1, min(n, 3))
        start = sorted(c.upto(n - w) for _ in range(n + c.upto(3)))
        rows = whole(len(start), w)
        if k % 3 == 0:
            start = [0] * (len(start) - 1) + [n - w]
        A = [[0] * s + r + [0] * (n - w - s) for s, r in zip(start, rows)]
        if any(x for r in A for x in r):
            full = len(echelon(A)[1]) == n
            band("random" if full else "Schoenberg-Whitney violated" if k % 3 == 0 else "singular", start, rows, n, whole(len(start), 1, 9))
    for k in range(40):
        n = c.between(1, 4)
        A = whole(n + c.upto(3), n)
        if len(echelon(A)[1]) == n:
            qr("random", A, whole(len(A), c.between(1, 2)))


main()
