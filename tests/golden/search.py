#!/usr/bin/env python3
"""golden/search.tsv, and what ga.py, de.py and pso.py share: the generator and the start of a search, from their papers.

Python's floats are IEEE doubles and + - * are correctly rounded, so the rows hold bit for bit.
python3 tests/golden/search.py > golden/search.tsv
"""


from rational import Choices, show


class Rng:
    """mt19937 (Matsumoto and Nishimura 1998, seeding of 2002) on Python's integers; a draw is k / 2^32."""

    def __init__(self, seed):
        s = seed if seed != 0 else 4357                      # GSL's convention for the seed 0
        self.mt = [s]
        for i in range(1, 624):
            s = (1812433253 * (s ^ (s >> 30)) + i) % 2**32
            self.mt.append(s)
        self.draws = 0
        self.log = []                                        # (draw, value) of every uniform

    def word(self):
        mt, k = self.mt, self.draws % 624
        if k == 0:
            for i in range(624):
                y = (mt[i] & 0x80000000) | (mt[(i + 1) % 624] & 0x7FFFFFFF)
                mt[i] = mt[(i + 397) % 624] ^ (y >> 1) ^ (0x9908B0DF if y & 1 else 0)
        y = mt[k]
        y ^= y >> 11
        y ^= (y << 7) & 0x9D2C5680
        y ^= (y << 15) & 0xEFC60000
        y ^= y >> 18
        self.draws += 1
        return y

    def uniform(self):
        u = self.word() / 2.0**32
        self.log.append((self.draws - 1, u))
        return u

    def index(self, n):
        """Lemire 2019: the high word of word * n, drawn again while the low word is below 2^32 mod n."""
        while True:
            m = self.word() * n
            if m % 2**32 >= 2**32 % n:
                return m // 2**32


DEFAULTS = dict(seed=1, population=4, n=2, group=1, generations=1, spread=0.5, box=0.5, tournament=4, crossover=0.7, swap=0.5, mutation=0.01,
                F=0.3, CR=0.8, by_coordinate=0, K=0.729, c1=2.05, c2=2.05, vmax=0.25, immediate=0, absorb=0, x0=None)


class Search:
    """The state of a population search on sum (x_k - k/8)^2."""

    def __init__(self, **options):
        self.o = dict(DEFAULTS, **options)
        o = self.o
        if o['x0'] is None:
            o['x0'] = [0.125 * ((5 * k) % 7) - 0.25 for k in range(o['n'])]
        self.x0, self.rng, self.evaluations, self.best, self.best_value = o['x0'], Rng(o['seed']), 0, None, None
        self.x, self.value = [], []
        for _ in range(o['population']):
            x = self.clamped([self.around(k, o['spread']) for k in range(o['n'])])
            self.x.append(x)
            self.value.append(self.evaluate(x))

    def around(self, k, radius):
        return self.x0[k] + radius * (2.0 * self.rng.uniform() - 1.0)

    def clamped(self, x):
        box = self.o['box']
        return [min(max(a, c - box), c + box) for a, c in zip(x, self.x0)] if box > 0 else list(x)

    def evaluate(self, x):
        f = 0.0
        for k, a in enumerate(x):
            d = a - k * 0.125
            f = f + d * d
        self.evaluations += 1
        if self.best is None or f < self.best_value:
            self.best, self.best_value = list(x), f
        return f

    def row(self, function, reason):
        o = self.o
        sizes = [str(o[k]) for k in ('seed', 'population', 'n', 'group', 'generations')]
        args = sizes + [show(float(o[k])) for k in ('spread', 'box')] + [str(o['tournament'])]
        args += [show(float(o[k])) for k in ('crossover', 'swap', 'mutation', 'F', 'CR')] + [str(o['by_coordinate'])]
        args += [show(float(o[k])) for k in ('K', 'c1', 'c2', 'vmax')] + [str(o['immediate']), str(o['absorb'])] + [show(float(v)) for v in self.x0]
        want = [str(self.rng.draws), str(self.evaluations)] + [show(float(v)) for v in [self.best_value] + self.best + self.value]
        print('\t'.join((function, 'bits', reason, ' '.join(args), ' '.join(want))))


def head(script):
    print('# function\tclass\treason\tseed population n group generations spread box tournament crossover swap mutation F CR by_coordinate K c1 c2 '
          'vmax immediate absorb x0\tdraws evaluations best_value best values')
    print('# made by tests/golden/' + script)


def rows(function, step, cases):
    """Each case: a reason and options that differ from DEFAULTS."""
    for reason, options in cases:
        s = Search(**options)
        for _ in range(s.o['generations']):
            step(s)
        s.row(function, reason)


def at_the_edge(step, name, k, **options):
    """A case whose probability `name` is the very number drawn as the k-th uniform after the start: strictly less must not hold."""
    s = Search(**options)
    start = len(s.rng.log)
    step(s)
    return ('%s_met_exactly_by_draw_%d' % (name, k), dict(options, **{name: s.rng.log[start + k][1]}))


# Cases every algorithm runs.
SHARED = [
    ('simplest', dict()),
    ('no_generation', dict(generations=0)),
    ('seed_0', dict(seed=0)),
    ('second_seed', dict(seed=4294967295)),
    ('one_coordinate', dict(n=1, generations=5)),
    ('control_points', dict(n=12, group=3, generations=6, population=5)),
    ('source_box', dict(n=6, group=3, spread=5e-6, box=5e-6, vmax=5e-6, generations=20, population=6)),
    ('no_box', dict(n=4, group=2, box=0.0, generations=10, population=6)),
    ('box_smaller_than_spread', dict(n=4, box=0.125, generations=10, population=6)),
    ('box_larger_than_spread', dict(n=4, spread=0.125, box=1.0, generations=10, population=6)),
    ('no_spread', dict(n=3, spread=0.0, generations=10)),
    ('ties', dict(n=2, spread=0.0, box=0.0, generations=3, population=7)),
    ('tiny_box', dict(n=3, spread=2.0**-60, box=2.0**-60, generations=4)),
    ('beyond_one_block_of_the_generator', dict(n=18, group=3, generations=30, population=8)),
    ('population_of_forty', dict(n=6, group=3, population=40, generations=20)),
    ('far_from_zero', dict(n=2, x0=[1e6, -1e6], generations=8, population=5)),
    ('long', dict(n=3, group=3, generations=200, population=5, box=0.0)),
]


def drawn(seed, count, **ranges):
    """Options of small searches, none of them at its default; ranges: name = values to choose from."""
    c, cases = Choices(seed), []
    for _ in range(count):
        group = c.between(1, 3)
        scale = c.of((1.0, 1.0, 1.0, 5e-6, 1e6, 2.0**-300, 1e100))
        why = "random" if scale == 1.0 else "extreme scale"
        o = dict(seed=c.bits(32), population=c.between(4, 9), group=group, n=group * c.between(1, 3), generations=c.between(1, 9),
                 spread=scale * c.short(0, 1, 8), box=c.of((0.0, scale, scale / 4)), vmax=c.of((0.0, scale / 8, scale)))
        o['x0'] = [scale * c.short(-1, 1, 16) for _ in range(o['n'])]
        if c.upto(4) == 0:
            o['spread'], why = 0.0, "coincident points"
        for name, values in ranges.items():
            o[name] = c.of(values)
        cases.append((why, o))
    return cases


def clamp_row(reason, box, pairs):
    want = [x if box <= 0 else min(max(x, c - box), c + box) for c, x in pairs]
    args = [show(float(box))] + [show(float(v)) for p in pairs for v in p]
    print('\t'.join(('search_clamp', 'exact', reason, ' '.join(args), ' '.join(show(float(v)) for v in want))))


def main():
    head('search.py')
    print('\t'.join(('search_defaults', 'exact', 'table_6.1', '', ' '.join(['40', '1', '4'] + [show(v) for v in (
        5e-6, 5e-6, 0.7, 0.5, 0.01, 0.3, 0.8, 0.729, 2.05, 2.05, 5e-6)]))))
    up, down = 1.0 + 2.0**-52, 1.0 - 2.0**-53
    clamp_row('inside', 0.5, [(0.0, 0.25), (1.0, 0.75), (-1.0, -1.25)])
    clamp_row('outside', 0.5, [(0.0, 1.0), (0.0, -1.0), (2.0, 7.0), (2.0, -7.0)])
    clamp_row('at_the_ends', 0.5, [(0.0, 0.5), (0.0, -0.5), (0.5, 1.0), (0.5, 0.0)])
    clamp_row('one_ulp_beyond', 1.0, [(0.0, up), (0.0, -up), (0.0, down), (0.0, -down)])
    clamp_row('ends_rounded', 0.1, [(0.2, 1.0), (0.2, -1.0), (0.7, 1.0), (0.7, 0.0), (1e16, 0.0), (1e16, 2e16)])
    clamp_row('no_box', 0.0, [(0.0, 1e300), (1.0, -1e300)])
    clamp_row('negative_box', -1.0, [(0.0, 1e300), (1.0, 0.0)])
    clamp_row('tiny_box', 2.0**-1074, [(0.0, 2.0**-1073), (0.0, -1.0), (1.0, 2.0)])
    rows('search_start', None, [(reason, dict(options, generations=0)) for reason, options in SHARED + drawn(47, 60)])
    c = Choices(53)
    for k in range(150):
        box = c.of((0.5, 0.1, 5e-6, 2.0**-1074, 1e300, 0.0, -0.5, 2.0**-53))
        pairs = []
        for _ in range(c.between(1, 5)):
            x = c.of((c.real(-1, 1), 0.0, 1e16, -1e-300))
            pairs.append((x, c.of((x, x + box, x - box, (x + box) * (1 + 2.0**-52), x - 2 * box, c.real(-2, 2), 1e308))))
        clamp_row('no_box' if box <= 0 else 'extreme scale' if not 1e-9 < box < 1e9 else 'end of domain and random', box, pairs)


if __name__ == '__main__':
    main()
