#!/usr/bin/env python3
"""An adapter for Etalon's conformance kit: copy it, and put your own code in place of span() and basis().

    etalon conform --adapter 'python3 adapter.py'

To the extent possible under law, the authors have waived all rights to this file (CC0 1.0)."""
import math
import sys


def span(p, u, x):
    """k with u[k] <= x < u[k+1]; at the right end the last span that is not empty (The NURBS Book, A2.1)."""
    k = len(u) - p - 2
    while k > p and (x < u[k] or u[k] == u[-p - 1]):
        k -= 1
    return k


def basis(k, p, u, x):
    """The p+1 basis functions that are not zero in span k (A2.2)."""
    N = [1.0]
    for j in range(1, p + 1):
        saved = 0.0
        for r in range(j):
            t = N[r] / (u[k + r + 1] - u[k + 1 - j + r])
            N[r] = saved + (u[k + r + 1] - x) * t
            saved = (x - u[k + 1 - j + r]) * t
        N.append(saved)
    return N


class Refused(Exception):
    pass


def check(p, u, x):
    if len(u) < 2 * p + 2 or not all(map(math.isfinite, u)) or any(a > b for a, b in zip(u, u[1:])) or not u[p] < u[-p - 1]:
        raise Refused('these are no knots')
    if any(0 < b - a < sys.float_info.min for a, b in zip(u, u[1:])):
        raise Refused('a span by which one cannot divide')          # such requests may be refused
    if not u[p] <= x <= u[-p - 1]:
        raise Refused('outside the domain')


class Words:
    def __init__(self, words):
        self.words = iter(words)

    def count(self):
        return int(next(self.words))

    def real(self):
        return float.fromhex(next(self.words))

    def reals(self, size=1):
        return [self.real() for _ in range(size * self.count())]


def answer(op, words):
    p, u = words.count(), words.reals()
    P, w = (words.reals(3), words.reals()) if op == 'curve_point' else ([], [])
    x = words.real()
    check(p, u, x)
    n, k = len(u) - p - 1, span(p, u, x)
    if op == 'span':
        return [k]
    N = basis(k, p, u, x)
    if op == 'basis':
        return [0.0] * (k - p) + N + [0.0] * (n - k - 1)
    if len(P) != 3 * n or w or not all(map(math.isfinite, P)):
        raise Refused('control points')
    return [sum(N[j] * P[3 * (k - p + j) + d] for j in range(p + 1)) for d in range(3)]


for line in sys.stdin:
    number, op, *rest = line.split()
    if op == 'hello':
        reply = 'ok protocol=1 name=template-py version=1 degree=25 ops=span,basis,curve_point'
    elif op in ('span', 'basis', 'curve_point'):
        try:
            reply = 'ok ' + ' '.join(float(v).hex() for v in answer(op, Words(rest)))
        except Refused as why:
            reply = 'refused ' + str(why)
    else:
        reply = 'unsupported'
    print(number, reply, flush=True)
