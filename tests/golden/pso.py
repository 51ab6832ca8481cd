#!/usr/bin/env python3
"""golden/pso.tsv: the swarm of the header, written anew on Python's floats.  python3 tests/golden/pso.py > golden/pso.tsv"""
from search import SHARED, drawn, head, rows


def prepare(s):
    n, m = s.o['n'], s.o['population']
    s.velocity = [[0.0] * n for _ in range(m)]
    s.memory = [(list(x), f) for x, f in zip(s.x, s.value)]


def step(s):
    o, n = s.o, s.o['n']
    if not hasattr(s, 'velocity'):
        prepare(s)
    swarm = list(s.best)
    for i in range(o['population']):
        r1 = [s.rng.uniform() for _ in range(n)]
        r2 = [s.rng.uniform() for _ in range(n)]
        own, old = s.memory[i][0], s.x[i]
        if o['immediate']:
            swarm = list(s.best)
        v = [o['K'] * ((s.velocity[i][k] + o['c1'] * r1[k] * (own[k] - old[k])) + o['c2'] * r2[k] * (swarm[k] - old[k])) for k in range(n)]
        if o['vmax'] > 0:
            v = [min(max(w, -o['vmax']), o['vmax']) for w in v]
        free = [old[k] + v[k] for k in range(n)]
        s.x[i] = s.clamped(free)
        s.velocity[i] = [w if not o['absorb'] or a == b else 0.0 for w, a, b in zip(v, free, s.x[i])]
        s.value[i] = s.evaluate(s.x[i])
        if s.value[i] < s.memory[i][1]:
            s.memory[i] = (list(s.x[i]), s.value[i])


CASES = SHARED + [
    ('no_vmax', dict(n=4, vmax=0.0, box=0.0, generations=10, population=6)),
    ('tight_vmax', dict(n=4, vmax=2.0**-6, generations=10, population=6)),
    ('no_memory', dict(n=4, c1=0.0, generations=10, population=6)),
    ('no_swarm', dict(n=4, c2=0.0, generations=10, population=6)),
    ('no_constriction', dict(n=4, K=1.0, generations=10, population=6)),
    ('immediate', dict(n=4, immediate=1, generations=12, population=6)),
    ('absorb', dict(n=4, absorb=1, box=0.125, generations=12, population=6)),
    ('immediate_and_absorb', dict(n=6, group=3, immediate=1, absorb=1, box=0.25, generations=12, population=8)),
    ('table_6.1', dict(n=30, group=3, population=40, spread=5e-6, box=5e-6, vmax=5e-6, generations=30)),
]

if __name__ == '__main__':
    head('pso.py')
    rows('pso_step', step, CASES + drawn(67, 80, K=(0.729, 1.0), c1=(2.05, 0.0), c2=(2.05, 0.0), immediate=(0, 1), absorb=(0, 1)))
