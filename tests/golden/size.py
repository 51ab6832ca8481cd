"""Golden rows of base/size: products of 64-bit sizes; wanted are the status (4: ENOMEM) and the product (0 when it does not fit)."""
from rational import Choices, head, row

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
STATUS = lambda a, b: [0 if a * b <= MAX else 4, a * b if a * b <= MAX else 0]
for k in range(64):
    for d in (-1, 0, 1):
        a, b = 2**k + d, 2 ** (64 - k) - 1 if k else MAX
        if 0 <= a <= MAX:
            row("size_mul", "exact", "size, powers of two", [a, b], STATUS(a, b))
            row("size_mul", "exact", "size, powers of two", [min(b + 1, MAX), a], STATUS(min(b + 1, MAX), a))
c = Choices(17)
for _ in range(60):
    a = c.bits(c.between(1, 64)) | 1
    q = MAX // a
    for b in (q, q + 1):
        if b <= MAX:
            row("size_mul", "exact", "size, the greatest factor" if b == q else "size, one more", [a, b], STATUS(a, b))
