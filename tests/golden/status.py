"""Golden rows of base/status: the exit codes as documented."""
from rational import head, row

head("status", "exit codes of the command line")
NAMES = ["OK", "EINVAL", "EFORMAT", "EIO", "ENOMEM", "ERANK", "ENOCONV", "ESTOPPED", "EINTERNAL", "EDIFFER"]
CODES = [0, 2, 3, 4, 70, 5, 5, 130, 70, 1]
for k, (name, code) in enumerate(zip(NAMES, CODES)):
    row("status_exit", "exact", name, [k], [code])
for k in (-1, 10, 11, 1000):
    row("status_exit", "exact", "outside the enumeration", [k], [70])
for k in range(31):
    row("status_exit", "exact", "outside the enumeration", [2**k + (11 if k < 4 else 0)], [70])
    row("status_exit", "exact", "outside the enumeration", [-(2**k)], [70])
