#!/usr/bin/env python3
"""golden/ga.tsv: the genetic algorithm of the header, written anew on Python's floats.  python3 tests/golden/ga.py > golden/ga.tsv"""
from search import SHARED, at_the_edge, drawn, head, rows


def tournament(s):
    drawn = [s.rng.index(s.o['population']) for _ in range(s.o['tournament'])]
    return min(drawn, key=lambda i: s.value[i])              # min keeps the first of equals


def mutated(s, child):
    if s.rng.uniform() < s.o['mutation']:
        group = s.o['group']
        gene = s.rng.index(s.o['n'] // group)
        radius = s.o['box'] if s.o['box'] > 0 else s.o['spread']
        for k in range(gene * group, gene * group + group):
            child[k] = s.around(k, radius)
    return child


def step(s):
    group = s.o['group']
    i, j = tournament(s), tournament(s)
    a, b = list(s.x[i]), list(s.x[j])
    if s.rng.uniform() < s.o['crossover']:
        for gene in range(s.o['n'] // group):
            if s.rng.uniform() < s.o['swap']:
                part = slice(gene * group, gene * group + group)
                a[part], b[part] = b[part], a[part]
    children = [(i, mutated(s, a)), (j, mutated(s, b))]
    values = [s.evaluate(child) for _, child in children]
    for (parent, child), value in zip(children, values):
        if value < s.value[parent]:
            s.x[parent], s.value[parent] = child, value


CASES = SHARED + [
    ('always_cross', dict(n=6, group=2, crossover=1.0, generations=12, population=5)),
    ('never_cross', dict(n=6, group=2, crossover=0.0, mutation=1.0, generations=12, population=5)),
    ('swap_all', dict(n=6, group=3, crossover=1.0, swap=1.0, mutation=0.5, generations=12, population=5)),
    ('swap_none', dict(n=6, group=3, crossover=1.0, swap=0.0, mutation=0.5, generations=12, population=5)),
    ('always_mutate', dict(n=9, group=3, mutation=1.0, generations=25, population=6)),
    ('mutate_without_a_box', dict(n=9, group=3, mutation=1.0, box=0.0, generations=25, population=6)),
    ('tournament_of_one', dict(n=4, tournament=1, mutation=0.5, generations=25, population=6)),
    ('tournament_of_twelve', dict(n=4, tournament=12, mutation=0.5, generations=25, population=6)),
    at_the_edge(step, 'crossover', 0, n=6, crossover=1.0, spread=1.0),
    *(at_the_edge(step, 'swap', k, n=3, crossover=1.0, tournament=1, seed=seed) for k in (1, 2) for seed in (5, 6, 7, 8)),
    at_the_edge(step, 'mutation', 1, n=6, crossover=0.0, mutation=0.0, seed=2),
    at_the_edge(step, 'mutation', 2, n=6, crossover=0.0, mutation=0.0, seed=3),
    ('table_6.1', dict(n=30, group=3, population=40, spread=5e-6, box=5e-6, generations=200)),
]

if __name__ == '__main__':
    head('ga.py')
    chances = dict(crossover=(0.0, 0.7, 1.0), swap=(0.0, 0.5, 1.0), mutation=(0.0, 0.01, 0.5, 1.0))
    rows('ga_step', step, CASES + drawn(61, 80, tournament=(1, 2, 4, 9), **chances))
