"""SciPy: RectBivariateSpline's evaluation (FITPACK bispev) of three coordinates on the grid; prints VERSION SECONDS RESIDUAL."""
import sys
import time

import numpy as np
import scipy
from scipy.interpolate import RectBivariateSpline

SIDE, GRID = 20, 1000
if len(sys.argv) < 2 or sys.argv[1] != "surface_grid":
    sys.exit(1)


def random53(k):
    z = (k + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return ((z ^ (z >> np.uint64(31))) >> np.uint64(11)).astype(float) * 2.0**-53


knots = np.clip((np.arange(SIDE + 4) - 3.0) / (SIDE - 3), 0.0, 1.0)
net = [np.repeat(np.arange(SIDE) / (SIDE - 1), SIDE), np.tile(np.arange(SIDE) / (SIDE - 1), SIDE),
       random53(np.uint64(1 << 40) | np.arange(SIDE * SIDE, dtype=np.uint64))]
splines = []
for c in net:                       # the constructor interpolates: give it any data, then put our own coefficients and knots
    s = RectBivariateSpline(np.arange(SIDE), np.arange(SIDE), np.zeros((SIDE, SIDE)))
    s.tck, s.degrees = (knots, knots, c), (3, 3)
    splines.append(s)
t = np.arange(GRID) / (GRID - 1.0)
best = None
for _ in range(6):
    start = time.process_time()
    values = [s(t, t) for s in splines]
    spent = time.process_time() - start
    best = spent if best is None else min(best, spent)
print("SciPy_%s %.17g %.17g" % (scipy.__version__, best / GRID**2, sum(v.sum() for v in values)))
