#!/usr/bin/env python3
"""The adapter of the small library beside it: reads requests, calls spline.py, writes replies (docs/conformance.md).

To the extent possible under law, the authors have waived all rights to this file (CC0 1.0)."""
import math
import sys

import spline


def reals(words, size=1):
    return [float.fromhex(next(words)) for _ in range(size * int(next(words)))]


def answer(op, words):
    p, u = int(next(words)), reals(words)
    flat, w = (reals(words, 3), reals(words)) if op != 'span' else ([], [])
    x = float.fromhex(next(words))
    n = len(u) - p - 1
    if n <= p or not all(map(math.isfinite, u + flat)) or u != sorted(u) or not u[p] < u[n] or not u[p] <= x <= u[n]:
        return 'refused'
    points = [flat[i:i + 3] for i in range(0, len(flat), 3)]
    if op == 'span':
        return 'ok %d' % spline.span(p, u, x)
    if len(points) != n or w:
        return 'refused'
    if op == 'curve_point':
        return 'ok ' + ' '.join(c.hex() for c in spline.curve_point(p, u, points, x))
    times = int(next(words))
    if u.count(x) + times > p + 1:
        return 'refused'
    if u.count(x) + times > p or p == 0:
        return 'unsupported'
    for _ in range(times):
        u, points = spline.insert(p, u, points, x)
    numbers = [p, len(u), *u, len(points), *(c for q in points for c in q), 0]
    return 'ok ' + ' '.join(float(c).hex() for c in numbers)


for line in sys.stdin:
    number, op, *rest = line.split()
    if op == 'hello':
        print(number, 'ok protocol=1 name=sample version=0.1 ops=span,curve_point,curve_insert', flush=True)
    elif op in ('span', 'curve_point', 'curve_insert'):
        print(number, answer(op, iter(rest)), flush=True)
    else:
        print(number, 'unsupported', flush=True)
