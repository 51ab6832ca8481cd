#!/usr/bin/env python3
"""golden/de.tsv: rand/1/bin of the header, written anew on Python's floats.  python3 tests/golden/de.py > golden/de.tsv"""
from search import SHARED, at_the_edge, drawn, head, rows


def other_than(s, taken):
    while True:
        r = s.rng.index(s.o['population'])
        if r not in taken:
            return r


def step(s):
    o = s.o
    group = 1 if o['by_coordinate'] else o['group']
    offered = []
    for i in range(o['population']):
        taken = [i]
        for _ in range(3):
            taken.append(other_than(s, taken))
        a, b, c = (s.x[r] for r in taken[1:])
        always = s.rng.index(o['n'] // group)
        crosses = [s.rng.uniform() < o['CR'] or gene == always for gene in range(o['n'] // group)]
        y = s.clamped([a[k] + o['F'] * (b[k] - c[k]) if crosses[k // group] else s.x[i][k] for k in range(o['n'])])
        offered.append((y, s.evaluate(y)))
    for i, (y, value) in enumerate(offered):
        if value <= s.value[i]:
            s.x[i], s.value[i] = y, value


CASES = SHARED + [
    ('by_coordinate', dict(n=6, group=3, by_coordinate=1, generations=8, population=6)),
    ('CR_0', dict(n=6, group=2, CR=0.0, generations=8, population=6)),
    ('CR_1', dict(n=6, group=2, CR=1.0, generations=8, population=6)),
    ('F_0', dict(n=4, F=0.0, generations=8, population=6)),
    ('F_negative', dict(n=4, F=-0.5, generations=8, population=6)),
    ('F_2', dict(n=4, F=2.0, box=0.25, generations=8, population=6)),
    at_the_edge(step, 'CR', 0, n=6, seed=2, population=6),
    at_the_edge(step, 'CR', 3, n=6, seed=3, population=6),
    at_the_edge(step, 'CR', 8, n=6, seed=4, population=6),
    ('table_6.1', dict(n=30, group=3, population=40, spread=5e-6, box=5e-6, generations=30)),
]

if __name__ == '__main__':
    head('de.py')
    rows('de_step', step, CASES + drawn(59, 80, F=(0.3, 0.5, -0.5, 0.9), CR=(0.0, 0.2, 0.8, 1.0), by_coordinate=(0, 1)))
