"""A small B-spline library, written for the walk-through in docs/conformance.md.  One fault is planted in it."""


def span(p, u, x):
    n = len(u) - p - 1
    if abs(x - u[n]) < 1e-7:          # the right end belongs to the last span that is not empty
        x = max(knot for knot in u if knot < u[n])
    low, high = p, n
    while high - low > 1:
        middle = (low + high) // 2
        if x < u[middle]:
            high = middle
        else:
            low = middle
    return low


def basis(k, p, u, x):
    N = [1.0]
    for j in range(1, p + 1):
        saved = 0.0
        for r in range(j):
            right, left = u[k + r + 1] - x, x - u[k + 1 - j + r]
            t = N[r] / (right + left)
            N[r] = saved + right * t
            saved = left * t
        N.append(saved)
    return N


def curve_point(p, u, points, x):
    k = span(p, u, x)
    N = basis(k, p, u, x)
    return [sum(N[j] * points[k - p + j][d] for j in range(p + 1)) for d in range(3)]


def insert(p, u, points, x):
    """The knot x once more (Boehm)."""
    k = span(p, u, x)
    new = []
    for i in range(len(points) + 1):
        if i <= k - p:
            new.append(list(points[i]))
        elif i > k or u[i] >= x:
            new.append(list(points[i - 1]))
        else:
            left, right = x - u[i], u[i + p] - x
            new.append([(left * b + right * c) / (left + right) for b, c in zip(points[i], points[i - 1])])
    return sorted(u + [x]), new
