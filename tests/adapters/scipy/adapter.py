#!/usr/bin/python3
"""SciPy: `adapter.py` answers by BSpline and make_lsq_spline, `adapter.py fitpack` by the FITPACK of splev, insert, bisplev and LSQBivariateSpline."""
import os
import sys
import warnings

import numpy
import scipy
from scipy import interpolate

warnings.simplefilter("ignore")
SIDES = ("any", "right", "left")


class Refused(Exception):
    pass


class Unsupported(Exception):
    pass


class Words:
    """A request's words, taken one after the other."""

    def __init__(self, words):
        self.words, self.at = words, 0

    def word(self):
        if self.at == len(self.words):
            raise Refused("fewer words than the operation has")
        self.at += 1
        return self.words[self.at - 1]

    def count(self):
        return int(self.word())

    def real(self):
        w = self.word()
        return float.fromhex(w) if "x" in w.lower() else float(w)

    def reals(self):
        return numpy.array([self.real() for _ in range(self.count())])

    def points(self):
        n = self.count()
        return numpy.array([self.real() for _ in range(3 * n)]).reshape(n, 3)

    def curve(self):
        """Degree, knots, control points."""
        p, u, P, w = self.count(), self.reals(), self.points(), self.reals()
        if len(w):
            raise Unsupported("weights")
        if len(P) != len(u) - p - 1:
            raise Refused("control points and knots do not fit in number")
        return p, u, P

    def surface(self):
        p, q, u, v, P, w = self.count(), self.count(), self.reals(), self.reals(), self.points(), self.reals()
        if len(w):
            raise Unsupported("weights")
        if len(P) != (len(u) - p - 1) * (len(v) - q - 1):
            raise Refused("control points and knots do not fit in number")
        return p, q, u, v, P


def inside(u, p, x):
    if not u[p] <= x <= u[len(u) - p - 1]:
        raise Refused("outside the domain")


# ---- BSpline ----------------------------------------------------------------------------------------------------------------


def ders(p, u, c, x, d):
    """Rows 0..d: derivatives at x of the spline with coefficients c (each a row)."""
    s = interpolate.BSpline(u, c, p)
    inside(u, p, x)
    return numpy.concatenate([numpy.ravel(s(x, nu=k)) for k in range(d + 1)])


def basis(r, d=None):
    p, u, x, _ = r.count(), r.reals(), r.real(), r.word()
    return ders(p, u, numpy.eye(max(len(u) - p - 1, 0)), x, r.count() if d is None else d)


def curve(r, d=None):
    p, u, P = r.curve()
    x, _ = r.real(), r.word()
    return ders(p, u, P, x, r.count() if d is None else d)


def fit_curve(r):
    p, u, t, P = r.count(), r.reals(), r.reals(), r.points()
    if len(t) and t.min() < t.max():
        order = numpy.argsort(t, kind="stable")      # make_lsq_spline wants them ordered
        t, P = t[order], P[order]
        if len(t) == len(P) and numpy.any(t[1:] == t[:-1]):
            raise Unsupported("make_lsq_spline wants different parameters")
    return numpy.ravel(interpolate.make_lsq_spline(t, P, u, p).c)


# ---- FITPACK ----------------------------------------------------------------------------------------------------------------


def tck(p, u, P):
    if p > 5:
        raise Unsupported("FITPACK has degrees up to 5")
    if p > len(P) - 1:
        raise Refused("too few control points")
    return u, [numpy.ascontiguousarray(P[:, a]) for a in range(3)], p


def fitpack_curve(r, d=None):
    p, u, P = r.curve()
    x, _ = r.real(), r.word()
    d = r.count() if d is None else d
    inside(u, p, x)
    if d > p:
        raise Unsupported("derivatives above the degree")
    return numpy.concatenate([numpy.ravel(interpolate.splev(x, tck(p, u, P), der=k)) for k in range(d + 1)])


def fitpack_surface(r, d=None):
    p, q, u, v, P = r.surface()
    x, y, _, _ = r.real(), r.real(), r.word(), r.word()
    d = r.count() if d is None else d
    inside(u, p, x)
    inside(v, q, y)
    if d >= min(p, q):
        raise Unsupported("bisplev and parder have degrees above the order of the derivative")
    out = []
    for total in range(d + 1):
        for b in range(total + 1):
            out += [float(interpolate.bisplev(x, y, (u, v, numpy.ascontiguousarray(P[:, a]), p, q), dx=total - b, dy=b)) for a in range(3)]
    return numpy.array(out)


def fitpack_insert(r):
    p, u, P = r.curve()
    x, times = r.real(), r.count()
    inside(u, p, x)
    if numpy.count_nonzero(u == x) + times > p + 1:
        raise Refused("more often than degree + 1")
    new, c, _ = interpolate.insert(x, tck(p, u, P), times) if times else tck(p, u, P)
    n = len(new) - p - 1
    points = numpy.array([numpy.asarray(a)[:n] for a in c]).T
    return numpy.concatenate([[p, len(new)], new, [n], points.ravel(), [0]])


def fitpack_scattered(r):
    p, q, u, v, a, b, P = r.count(), r.count(), r.reals(), r.reals(), r.reals(), r.reals(), r.points()
    if len(a) != len(P) or len(b) != len(P):
        raise Refused("parameters and points differ in number")
    if not (1 <= p <= 5 and 1 <= q <= 5):
        raise Unsupported("FITPACK has degrees from 1 to 5")
    for t, k in ((u, p), (v, q)):
        if len(set(t[k + 1:-k - 1])) != len(t[k + 1:-k - 1]):
            raise Unsupported("LSQBivariateSpline wants different inner knots")
        if len(set(t[:k + 1])) != 1 or len(set(t[-k - 1:])) != 1:
            raise Unsupported("knots that are not clamped")
    box = [u[0], u[-1], v[0], v[-1]]
    if len(u) < 2 * p + 2 or len(v) < 2 * q + 2:
        raise Refused("too few knots")
    with warnings.catch_warnings():
        warnings.simplefilter("error")           # a rank deficient system is told by a warning
        try:
            c = [interpolate.LSQBivariateSpline(a, b, P[:, k], u[p + 1:-p - 1], v[q + 1:-q - 1], bbox=box, kx=p, ky=q).get_coeffs() for k in range(3)]
        except UserWarning as e:
            raise Refused(str(e))
    return numpy.array(c).T.ravel()


LIBRARIES = {
    "scipy": ("name=SciPy", {"basis": lambda r: basis(r, 0), "basis_ders": basis, "curve_point": lambda r: curve(r, 0), "curve_ders": curve,
                             "fit_curve": fit_curve}),
    "fitpack": ("name=FITPACK degree=5", {"curve_point": lambda r: fitpack_curve(r, 0), "curve_ders": fitpack_curve,
                                          "surface_point": lambda r: fitpack_surface(r, 0), "surface_ders": fitpack_surface,
                                          "curve_insert": fitpack_insert, "fit_scattered": fitpack_scattered}),
}


def answer(operations, op, words):
    if op not in operations:
        return "unsupported"
    try:
        values = operations[op](Words(words))
    except Unsupported as e:
        return "unsupported " + str(e)
    except (Refused, ValueError, TypeError, IndexError, ZeroDivisionError, numpy.linalg.LinAlgError) as e:
        return "refused " + " ".join(str(e).split())
    return " ".join(["ok"] + [float(x).hex() for x in values])


def main():
    name, operations = LIBRARIES[sys.argv[1] if len(sys.argv) > 1 else "scipy"]
    out = os.fdopen(os.dup(1), "w")          # FITPACK prints now and then: not among the replies
    os.dup2(2, 1)
    for line in sys.stdin:
        words = line.split()
        if words[1] == "hello":
            reply = f"ok protocol=1 {name} version={scipy.__version__} rational=0 sides=any knot_tolerance=0 ops=" + ",".join(operations)
        else:
            reply = answer(operations, words[1], words[2:])
        print(words[0], reply, file=out, flush=True)


main()
