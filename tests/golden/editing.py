"""editing: knots inserted and removed, degrees elevated, in rationals, for the golden rows of spline/curve and spline/surface.

A net is a list of control points, each a list of rationals (w, w x, w y, w z, or several points' one after the other): all operations are linear and work on
each number for itself.  Insertion is Boehm's; elevation takes the polynomials of single spans in Bernstein form, raises them, and reads the control
points off their polar forms, so that it shares nothing with discrete B-splines; removal solves from the left and looks whether all equations hold.
"""
from fractions import Fraction as F

from rational import gamma

U = F(1, 2**53)
TINY = F(1, 2**1074)


def mix(a, P, b, Q):
    return [a * x + b * y for x, y in zip(P, Q)]


def insert(u, p, H, x, times):
    """Knots and net with x so often more."""
    u, H, x = list(u), list(H), float(x)
    for _ in range(times):
        k = max(i for i, t in enumerate(u) if t <= x)
        s = sum(t == x for t in u)
        new = H[:k - p + 1]
        for i in range(k - p + 1, k - s + 1):
            a = (F(x) - F(u[i])) / (F(u[i + p]) - F(u[i]))
            new.append(mix(a, H[i], 1 - a, H[i - 1]))
        H = new + H[k - s:]
        u = u[:k + 1] + [x] + u[k + 1:]
    return u, H


def polar(u, p, H, k, arguments):
    """The polar form of span k's polynomial (de Boor's algorithm, an argument a step)."""
    d = H[k - p:k + 1]
    for j, t in enumerate(arguments, 1):
        for r in range(p, j - 1, -1):
            lo, hi = F(u[k - p + r]), F(u[k + 1 + r - j])
            d[r] = mix((t - lo) / (hi - lo), d[r], (hi - t) / (hi - lo), d[r - 1])
    return d[p]


def raised(b):
    """Bernstein coefficients of a degree more."""
    p = len(b) - 1
    return [b[0]] + [mix(F(i, p + 1), b[i - 1], 1 - F(i, p + 1), b[i]) for i in range(1, p + 1)] + [b[p]]


def elevate(u, p, H, times):
    """Knots and net of degree p + times."""
    q, v = p + times, []
    for i, t in enumerate(u):
        v += [t] * (1 + (times if i + 1 == len(u) or t < u[i + 1] else 0))
    pieces = {}
    for k in range(p, len(u) - p - 1):
        if u[k] < u[k + 1]:
            a, b = F(u[k]), F(u[k + 1])
            piece = [polar(u, p, H, k, [a] * (p - j) + [b] * j) for j in range(p + 1)]
            for _ in range(times):
                piece = raised(piece)
            pieces[u[k]] = (a, b, piece)
    new = []
    for i in range(len(v) - q - 1):
        k = next(k for k in range(i, i + q + 1) if v[k] < v[k + 1])
        a, b, d = pieces[v[k]]
        d = list(d)
        for t in v[i + 1:i + q + 1]:
            t = (F(t) - a) / (b - a)
            d = [mix(1 - t, d[r], t, d[r + 1]) for r in range(len(d) - 1)]
        new.append(d[0])
    return v, new


def shares(u, p, i, x):
    a = (F(x) - F(u[i])) / (F(u[i + p + 1]) - F(u[i]))
    return a, 1 - a


def remove(u, p, H, x):
    """Knots and net with x once less if that is the same spline, else None."""
    s, r = sum(t == x for t in u), max(i for i, t in enumerate(u) if t == x)
    new = H[:r - p]
    for i in range(r - p, r - s + 1):
        a, b = shares(u, p, i, x)
        new.append([(P - b * Q) / a for P, Q in zip(H[i], new[-1])])
    if s <= p and new[-1] != H[r - s + 1] or s > p and H[r - p - 1] != H[r - p]:
        return None
    new = new[:r - s] + H[r - s + 1:] if s <= p else H[:r - p - 1] + H[r - p:]
    return u[:r] + u[r + 1:], new


def removal_errors(u, p, H, E, x):
    """What A5.8 in doubles makes of control points H that are off by E: the errors of the points it leaves, and the greatest difference or residual it finds
    (exactly: what a removable net's roundings come to).  Each point solved for satisfies its equation within five roundings of the terms."""
    s, r = sum(t == x for t in u), max(i for i, t in enumerate(u) if t == x)
    equations = max(p + 1 - s, 0)
    half, g = equations // 2, gamma(6)
    P, E = [list(h) for h in H], [list(e) for e in E]
    for k in range(half):
        for i, other, left in ((r - p + k, -1, True), (r - s - k, 1, False)):
            a, b = shares(u, p, i, x)
            a, b = (a, b) if left else (b, a)
            for c in range(len(P[i])):
                near, off = P[i + other][c], E[i + other][c]
                value = (P[i][c] - b * near) / a
                E[i][c] = (E[i][c] + b * off + g * (abs(P[i][c]) + E[i][c] + 2 * b * (abs(near) + off))) / a
                P[i][c] = value
    odd = equations % 2
    m = r - p + half - (0 if odd else 1)
    found = []
    for c in range(len(P[m])):
        if odd:
            a, b = shares(u, p, m, x)
            d = abs(P[m][c] - a * P[m + 1][c] - b * P[m - 1][c])
            e = E[m][c] + a * E[m + 1][c] + b * E[m - 1][c]
            e += g * (a * (abs(P[m + 1][c]) + E[m + 1][c]) + b * (abs(P[m - 1][c]) + E[m - 1][c]) + abs(P[m][c]))
        else:
            d, e = abs(P[m][c] - P[m + 1][c]), (E[m][c] + E[m + 1][c]) * (1 + g) + U * abs(P[m][c])
        found.append((d, e))
    return P[:m] + P[m + 1:], E[:m] + E[m + 1:], found


def representable(H):
    return all(F(float(t)) == t for P in H for t in P if abs(t) < F(2) ** 1000)


def lifted(points, weights):
    """(w, w x, w y, w z) of each point."""
    return [[F(w)] + [F(w) * F(t) for t in P] for P, w in zip(points, weights or [1] * len(points))]


def projected(H, rational):
    """Coordinates, then weights if there are any."""
    return [t / P[0] for P in H for t in P[1:]] + ([P[0] for P in H] if rational else [])


def bound(H, S, rational, m, small):
    """The greatest error of coordinates and weights: a weight m roundings of S, its numerator one more, the division one.  S may be errors if m is None."""
    worst = F(0)
    for P, s in zip(H, S):
        w, ew = P[0], (gamma(m) * s[0] if m is not None else s[0]) if rational else 0
        for t, e in zip(P[1:], s[1:]):
            e = gamma(m + (1 if rational else 0)) * e if m is not None else e
            worst = max(worst, (e + small + abs(t / w) * ew) / (w - ew) + U * abs(t / w) if rational else e + small)
        worst = max(worst, ew)
    return worst * (1 + F(1, 2**40)) + TINY


def magnitudes(H):
    return [[abs(t) for t in P] for P in H]
