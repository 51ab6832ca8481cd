#!/usr/bin/env python3
"""Golden rows of conform/campaign: names, the table of categories, and the draws whose rule is short enough to be written down twice: those of the
double net and of knot rules.

The generator is written here from its definition: splitmix64 for the streams, MT19937 as initialised in 2002, Lemire's index.  A campaign's case
comes from the stream stream(stream(stream(stream(seed, operation), category), number), attempt); its first draw is whether there are weights."""

OPERATIONS = ("span multiplicity greville basis basis_ders curve_point curve_ders surface_point surface_ders surface_normal curve_insert "
              "curve_remove curve_elevate surface_insert surface_remove surface_elevate parameters parameters_grid knots fit_curve fit_grid "
              "fit_scattered approximate curve_nearest surface_nearest surface_error net_counts net_class net_node seam_gap").split()
CATEGORIES = ("plain end_of_domain near_knots repeated_knots editing degenerate fit_failure seam inversion size extreme_scale weights degrees "
              "bad_input").split()
RELATIONS = 42

# Which operations have which categories, read off the specification: all of them have plain, size and bad_input.
EVALUATION = OPERATIONS[5:10]
EDITING = OPERATIONS[10:16]
INSERTION = ["curve_insert", "surface_insert"]
FITS = OPERATIONS[19:22]
NEAREST = ["curve_nearest", "surface_nearest"]
LINES = ["parameters", "parameters_grid"]
NET = ["net_class", "net_node"]
HAS = {
    "plain": OPERATIONS, "size": OPERATIONS, "bad_input": OPERATIONS,
    "end_of_domain": ["span", "multiplicity", "basis", "basis_ders"] + EVALUATION + INSERTION + FITS + ["surface_error"] + NET,
    "near_knots": OPERATIONS[:10] + INSERTION + FITS + ["surface_error"],
    "repeated_knots": OPERATIONS[:16] + ["knots"] + FITS + NEAREST + ["surface_error", "seam_gap"],
    "editing": EDITING,
    "degenerate": EVALUATION + EDITING + LINES + FITS + ["approximate"] + NEAREST + ["surface_error", "seam_gap"],
    "fit_failure": FITS,
    "seam": EVALUATION + LINES + ["fit_grid", "approximate"] + NEAREST + ["surface_error", "seam_gap"] + NET,
    "inversion": NEAREST,
    "extreme_scale": [o for o in OPERATIONS if not o.startswith("net")],
    "weights": EVALUATION + EDITING + NEAREST + ["surface_error", "seam_gap"],
    "degrees": ["span", "greville", "basis", "basis_ders", "knots", "approximate", "surface_error", "seam_gap"]
               + EVALUATION + EDITING + FITS + NEAREST,
}

M64 = 2 ** 64 - 1


def mix(z):
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & M64
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB & M64
    return z ^ (z >> 31)


def stream(seed, k):
    return mix(seed + (k + 1) * 0x9E3779B97F4A7C15 & M64)


class Twister:
    def __init__(self, seed):
        # A seed of more than 32 bits is mixed down; 0 means 4357.
        seed = seed if seed < 2 ** 32 else mix(seed) & 0xFFFFFFFF
        mt = [seed or 4357]
        for i in range(1, 624):
            mt.append(1812433253 * (mt[-1] ^ mt[-1] >> 30) + i & 0xFFFFFFFF)
        self.mt, self.at = mt, 624

    def word(self):
        mt = self.mt
        if self.at == 624:
            for i in range(624):
                y = mt[i] & 0x80000000 | mt[(i + 1) % 624] & 0x7FFFFFFF
                mt[i] = mt[(i + 397) % 624] ^ y >> 1 ^ (0x9908B0DF if y & 1 else 0)
            self.at = 0
        y = mt[self.at]
        self.at += 1
        y ^= y >> 11
        y ^= y << 7 & 0x9D2C5680
        y ^= y << 15 & 0xEFC60000
        return y ^ y >> 18

    def index(self, n):
        while True:
            k = self.word() * n
            if k & 0xFFFFFFFF >= 2 ** 32 % n:
                return k >> 32


def rng_of(op, category, seed, number):
    own = stream(stream(stream(seed, OPERATIONS.index(op)), CATEGORIES.index(category)), number)
    rng = Twister(stream(own, 0))
    rng.index(2)                                             # weights, of which these have none
    return rng


def knots(category, seed, number):
    """rule, degree, control points, parameters: the ends are 0 and 1, the others sorted."""
    rng = rng_of("knots", category, seed, number)
    rule = number % 4
    p = (3, 2, 1, 3, 4, 2, 5, 3)[rng.index(8)]
    p = max((number * 9 + 12) % 2 ** 64 % 26, 1) if category == "degrees" else p
    n = p + 1 + rng.index(9)
    more = rng.index(12)
    count = (n + more, n, n + more, 2 + more % 10)[rule]
    style, t = rng.index(3), []
    for i in range(count):
        if style == 0:
            x = i / (count - 1)
        elif style == 1:
            x = rng.index(1025) / 1024
        else:
            high = rng.word() / 2 ** 32
            x = high + rng.word() / 2 ** 32 * 2.0 ** -32
        t.append(rng.index(5) / 4 if category == "repeated_knots" else x)
    t.sort()
    return [rule, p, n, count] + [x.hex() for x in [0.0] + t[1:-1] + [1.0]]


def net(op, category, seed, number):
    rng = rng_of(op, category, seed, number)
    nx, ny = 2 + rng.index(10), 2 + rng.index(10)
    i, j = rng.index(nx), rng.index(ny)
    turn = number % 4
    if category == "end_of_domain":
        i, j = (nx - 1 if turn & 2 else 0), (ny - 1 if turn & 1 else 0)
    elif category == "seam":
        i = {0: 0, 1: nx - 1}.get(turn, i)
        j = {2: 0, 3: ny - 1}.get(turn, j)
    view, nov = rng.index(2), 2 * (nx * ny - nx - ny + 2)
    if op == "net_counts":
        return [nx, ny]
    if op == "net_class":
        return [nx, ny, view, i, j]
    if category == "plain":
        return [nx, ny, 1 + rng.index(nov)]
    return [nx, ny, i * ny + j + 1 if view else (nov if number % 8 >= 4 else nx * ny)]


def main():
    print("# campaign: names, categories, and the double net's draws")
    print("# Written by tests/golden/campaign.py from the rules; not from Etalon.")
    print("# function\tclass\treason\targuments\twanted")
    for k, name in enumerate(CATEGORIES + ["none", "none"]):
        print(f"campaign_name\texact\tthe published list\t{k}\t{name}")
    print(f"campaign_relations\texact\tthe list of docs/campaign.md\t0\t{RELATIONS}")
    for op in OPERATIONS:
        print(f"campaign_has\texact\tthe specification's categories\t{op}\t" + " ".join(str(int(op in HAS.get(c, []))) for c in CATEGORIES))
    for op in ("net_counts", "net_class", "net_node"):
        for category in ("plain", "end_of_domain", "seam"):
            if op not in HAS[category]:
                continue
            far = [(2 ** 64 - 1, 3), (2 ** 32, 2 ** 64 - 1), (12345678901234567890, 10 ** 6)]
            for seed, number in [(s, n) for s in (0, 1, 7) for n in range(9)] + far:
                print(f"campaign_draw\tbits\treplay\t{op} {category} {seed} {number}\t" + " ".join(map(str, net(op, category, seed, number))))
    for category in ("plain", "degrees", "repeated_knots"):
        for seed, number in [(s, n) for s in (0, 5) for n in range(14)] + [(2 ** 63, 2 ** 64 - 3)]:
            print(f"campaign_draw\tbits\treplay\tknots {category} {seed} {number}\t" + " ".join(map(str, knots(category, seed, number))))


main()
