"""SciPy: make_lsq_spline, one direction after the other, for three coordinates; prints VERSION SECONDS RESIDUAL."""
import sys
import time

import numpy as np
import scipy
from scipy.interpolate import make_lsq_spline

if len(sys.argv) < 3 or sys.argv[1] != "fit":
    sys.exit(1)
n, m = (int(x) for x in sys.argv[2].split("x"))


def random53(k):
    z = (k + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return ((z ^ (z >> np.uint64(31))) >> np.uint64(11)).astype(float) * 2.0**-53


t = np.arange(n) / (n - 1.0)
knots = np.clip((np.arange(m + 4) - 3.0) / (m - 3), 0.0, 1.0)
data = np.empty((n, n, 3))
data[:, :, 0], data[:, :, 1] = t[:, None], t[None, :]
data[:, :, 2] = random53(np.arange(n * n, dtype=np.uint64)).reshape(n, n)
best = None
for _ in range(8):
    start = time.process_time()
    first = make_lsq_spline(t, data, knots, k=3).c
    net = make_lsq_spline(t, first.transpose(1, 0, 2), knots, k=3).c
    spent = time.process_time() - start
    best = spent if best is None else min(best, spent)
print("SciPy_%s %.17g %.17g" % (scipy.__version__, best, net.sum()))
