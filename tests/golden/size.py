"""Golden rows of base/size: products of 64-bit sizes; wanted are the status (4: ENOMEM) and the product (0 when it does not fit)."""
from rational import head, row

MAX = 2**64 - 1
PAIRS = [(0, 0), (0, MAX), (MAX, 0), (1, MAX), (MAX, 1), (2, MAX), (MAX, 2), (2**32, 2**32), (2**32 - 1, 2**32 + 1), (2**32, 2**32 - 1), (2**63, 2),
         (2**63 - 1, 2), (2**63, 1), (3, 6148914691236517205), (3, 6148914691236517206), (6148914691236517205, 3), (6148914691236517206, 3),
         (MAX, MAX), (641, 6700417 * 4294967297), (4294967297, 4294967295), (4294967297, 4294967296), (724, 24), (1000, 1000)]
head("size", "products of sizes of 64 bits")
for a, b in PAIRS:
    if b > MAX:
        continue
    fits = a * b <= MAX
    row("size_mul", "exact", "fits" if fits else "wraps", [a, b], [0 if fits else 4, a * b if fits else 0])
