#!/usr/bin/env python3
"""The rows by which Tie.v holds the Coq model of et_basis_eval against the C code: tie.py [--check] [ROOT].

Inputs: those of golden/basis.tsv (function basis_eval), and some of its own, which are nasty: knots one ulp apart, graded by powers of two,
subnormal values.  Wanted: the bits the C code itself gives, compiled here from src/, since the question is whether model and code are one; that
the values are right, the golden rows and Rounding.v say.  Writes proofs/coq/TieRows.v; --check fails if it would be another.
"""
import math
import os
import random
import subprocess
import sys
import tempfile

DRIVER = r"""
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <stdio.h>
#include <stdlib.h>

/* Lines "p nu knots... x"; replies "span values...". */
int main(void)
{
    size_t p, nu;
    while (scanf("%zu %zu", &p, &nu) == 2) {
        double *u = calloc(nu, sizeof *u), *N = calloc(3 * p + 3, sizeof *N), x;
        for (size_t i = 0; i < nu; i++) {
            if (scanf("%la", &u[i]) != 1) {
                return 1;
            }
        }
        if (scanf("%la", &x) != 1 || !et_knots_valid(u, nu, p)) {
            return 1;
        }
        size_t span = et_knots_span(u, nu, p, x);
        et_basis_eval(N, u, nu, p, span, x, N + p + 1, 2 * p + 2);
        printf("%zu", span);
        for (size_t r = 0; r <= p; r++) {
            printf(" %a", N[r]);
        }
        printf("\n");
        free(u);
        free(N);
    }
    return 0;
}
"""

HEAD = """(* Written by proofs/coq/tie.py: (degree, knots, [(span, parameter, what et_basis_eval gives)]). *)
Require Import List Floats.
Import ListNotations.
Local Open Scope float_scope.
Local Open Scope list_scope.

"""
PIECE = 40    # vectors of knots in one definition


def golden(root):
    for line in open(os.path.join(root, "golden/basis.tsv")):
        field = line.rstrip("\n").split("\t")
        if field[0] == "basis_eval":
            a = field[3].split()
            nu = int(a[2])
            yield int(a[0]), tuple(float.fromhex(v) for v in a[3:3 + nu]), float.fromhex(a[3 + nu])


def nasty():
    """Knots of every kind a degree allows, parameters at them and one ulp beside them."""
    g = random.Random(1)
    for p in range(10):
        for kind in range(6):
            inner, u = g.randint(0, 4), []
            if kind == 0:          # graded
                u = sorted(math.ldexp(1.0, -g.randint(0, 60)) for _ in range(inner))
            elif kind == 1:        # one ulp apart
                v = g.uniform(0.25, 0.75)
                for _ in range(inner):
                    u.append(v)
                    v = math.nextafter(v, 1.0) if g.random() < 0.7 else v
            elif kind == 2:        # repeated up to p times
                for _ in range(inner):
                    u += [g.uniform(0.1, 0.9)] * g.randint(1, max(1, p))
                u.sort()
            else:
                u = sorted(g.uniform(0.0, 1.0) for _ in range(inner))
            scale, shift = (math.ldexp(1.0, -400), 0.0) if kind == 4 else (3.7, -1.3) if kind == 3 else (1.0, 0.0)
            lo, hi = [0.0] * (p + 1), [1.0] * (p + 1)
            if kind == 5:          # not clamped
                lo, hi = sorted(g.uniform(-1.0, 0.0) for _ in range(p + 1)), sorted(g.uniform(1.0, 2.0) for _ in range(p + 1))
            u = tuple(v * scale + shift for v in lo + u + hi)
            knots = sorted(set(u[p:len(u) - p]))
            xs = {g.choice(knots), math.nextafter(g.choice(knots), -math.inf), math.nextafter(g.choice(knots), math.inf), u[0] - 1.0, u[-1] + 1.0}
            xs |= {g.uniform(u[p], u[-p - 1]) for _ in range(2)}
            for x in sorted(xs):
                yield p, u, x


def ask(root, cases):
    with tempfile.TemporaryDirectory() as tmp:
        source, program = os.path.join(tmp, "driver.c"), os.path.join(tmp, "driver")
        with open(source, "w") as f:
            f.write(DRIVER)
        parts = [os.path.join(root, "src", m) for m in ("spline/basis.c", "spline/knots.c", "base/size.c")]
        subprocess.run(["gcc", "-std=c99", "-O2", "-ffp-contract=off", "-D_POSIX_C_SOURCE=200809L", "-I" + os.path.join(root, "include"),
                        "-I" + os.path.join(root, "src"), source, *parts, "-lm", "-o", program], check=True)
        text = "".join("%d %d %s %s\n" % (p, len(u), " ".join(v.hex() for v in u), x.hex()) for p, u, x in cases)
        lines = subprocess.run([program], input=text, stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    assert len(lines) == len(cases)
    for line in lines:
        words = line.split()
        yield int(words[0]), [float.fromhex(w) for w in words[1:]]


def literal(v):
    """A short literal with the same bits: small integers, else an integer times a power of two."""
    if v == 0.0:
        return "-0" if math.copysign(1.0, v) < 0.0 else "0"
    if v == int(v) and abs(v) < 1e6:
        return "%d" % v
    m, e = math.frexp(v)
    m, e = int(math.ldexp(m, 53)), e - 53
    while m % 2 == 0:
        m, e = m // 2, e + 1
    return "%s0x%xp%d" % ("-" if m < 0 else "", abs(m), e)


def main():
    arguments = sys.argv[1:]
    check = "--check" in arguments
    roots = [a for a in arguments if a != "--check"]
    root = roots[0] if roots else os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
    cases = list(dict.fromkeys(list(golden(root)) + list(nasty())))
    vectors = {}
    for (p, u, x), (span, N) in zip(cases, ask(root, cases)):
        vectors.setdefault((p, u), []).append("(%d%%nat, %s, [%s])" % (span, literal(x), "; ".join(map(literal, N))))
    lists = ["(%d%%nat, [%s],\n [%s])" % (p, "; ".join(map(literal, u)), ";\n  ".join(rows)) for (p, u), rows in vectors.items()]
    pieces = [lists[i:i + PIECE] for i in range(0, len(lists), PIECE)]
    text = HEAD
    for i, piece in enumerate(pieces):
        text += "Definition rows_%d : list (nat * list float * list (nat * float * list float)) := [\n%s].\n\n" % (i, ";\n".join(piece))
    text += "Definition rows := %s.\n" % " ++ ".join("rows_%d" % i for i in range(len(pieces)))
    path = os.path.join(root, "proofs/coq/TieRows.v")
    if check:
        if open(path).read() != text:
            sys.exit("proofs/coq/TieRows.v is not what tie.py writes")
        return
    with open(path, "w") as f:
        f.write(text)
    print("%d rows, %d vectors of knots, %d bytes" % (len(cases), len(vectors), len(text)))


main()
