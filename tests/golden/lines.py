"""lines: parameters of lines and grids of points (Eqs. 2.8, 5.1, 5.2), each rounded once, for the generators that need them.

A power of a distance is a root of a rational; roots are enclosed, and the enclosures narrowed until the quotient's ends round to one double.  The
exponential method's power is exactly 4/5: the fifth root of the square of the squared distance.
"""
from fractions import Fraction as F

from rational import decided, iroot

UNIFORM, CHORD, CENTRIPETAL, EXPONENTIAL = range(4)
ROOT = {CHORD: (2, 1), CENTRIPETAL: (4, 1), EXPONENTIAL: (5, 2)}


class Line:
    def __init__(self, points, method):
        self.d2 = [sum((F(y) - F(x)) ** 2 for x, y in zip(a, b)) for a, b in zip(points, points[1:])]
        self.method = method
        self.flat = int(method != UNIFORM and not any(self.d2))
        greatest = max(self.d2)
        if method == UNIFORM or self.flat:
            self.d2 = None
            self.n = len(points) - 1
        else:
            e = (greatest.numerator.bit_length() - greatest.denominator.bit_length()) // 2
            self.d2 = [x / F(4) ** e for x in self.d2]
            self.n = len(self.d2)
        self.known = {}

    def sums(self, bits):
        """Lower and upper ends of the sums of powers up to each point."""
        if bits not in self.known:
            degree, power = ROOT[self.method]
            low, high = [0], [0]
            for x in self.d2:
                y = x ** power
                n = (y.numerator << bits * degree) // y.denominator
                r = iroot(n, degree)
                whole = r ** degree * y.denominator == y.numerator << bits * degree
                low.append(low[-1] + r)
                high.append(high[-1] + r + (not whole))
            self.known[bits] = low, high
        return self.known[bits]

    def at(self, i, bits):
        """Ends of t_i."""
        if self.d2 is None:
            return F(i, self.n), F(i, self.n)
        low, high = self.sums(bits)
        a, b, rest, most = low[i], high[i], low[-1] - low[i], high[-1] - high[i]
        return (F(a, a + most) if a else F(0)), (F(b, b + rest) if b else F(0))

    def exact(self):
        """All lengths are rational."""
        if self.d2 is None:
            return True
        low, high = self.sums(256)
        return low == high

    def parameters(self):
        return [decided(lambda bits: self.at(i, bits)) for i in range(self.n + 1)]


def averages(lines):
    """The mean of the lines' parameters at each place, rounded once."""
    def mean(i):
        def ends(bits):
            low, high = zip(*(line.at(i, bits) for line in lines))
            return sum(low) / len(lines), sum(high) / len(lines)
        return ends
    return [decided(mean(i)) for i in range(lines[0].n + 1)]


def grid(rows, method):
    """flat, s, r of the grid rows[i][j]."""
    along = [Line([row[j] for row in rows], method) for j in range(len(rows[0]))]
    across = [Line(row, method) for row in rows]
    return sum(x.flat for x in along + across), averages(along), averages(across)
