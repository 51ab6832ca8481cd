#!/usr/bin/env python3
"""The rows by which Tie.v holds the Coq models of src/spline against the C code: tie.py [--check] [ROOT].

Inputs: those of golden/basis.tsv (function basis_eval), and some of its own, which are nasty: knots one ulp apart, graded by powers of two,
subnormal values.  Wanted: the bits the C code itself gives, compiled here from src/, since the question is whether model and code are one; that
the values are right, the golden rows and Rounding.v say.  Some rows more for et_basis_ders, et_curve_point and et_curve_insert.  Writes proofs/coq/TieRows.v; --check fails if it would be another.
"""
import bisect
import math
import os
import random
import subprocess
import sys
import tempfile

DRIVER = r"""
#include "etalon/spline/basis.h"
#include "etalon/spline/curve.h"
#include "etalon/spline/knots.h"
#include <stdio.h>
#include <stdlib.h>

static double work[4096], out[4096];

/* Lines "KIND p nu knots... x number n coordinates..."; replies "span values...". */
int main(void)
{
    char kind;
    size_t p, nu, number, n;
    while (scanf(" %c %zu %zu", &kind, &p, &nu) == 3) {
        double *u = calloc(nu, sizeof *u), x;
        for (size_t i = 0; i < nu; i++) {
            if (scanf("%la", &u[i]) != 1) {
                return 1;
            }
        }
        if (scanf("%la %zu %zu", &x, &number, &n) != 3 || !et_knots_valid(u, nu, p)) {
            return 1;
        }
        et_curve c = {p, n, u, calloc(n + 1, sizeof *c.points), NULL}, t;
        for (size_t i = 0; i < n; i++) {
            if (scanf("%la", &c.points[i].x) != 1) {
                return 1;
            }
        }
        size_t span = et_knots_span(u, nu, p, x), values = p + 1;
        if (kind == 'b') {
            et_basis_eval(out, u, nu, p, span, x, work, 2 * p + 2);
        } else if (kind == 'd') {
            et_basis_ders(out, number, u, nu, p, span, x, work, (p + 1) * (p + 5));
            values = (number + 1) * (p + 1);
        } else if (kind == 'c') {
            out[0] = et_curve_point(&c, x, work, et_curve_work(&c, 0)).x;
            values = 1;
        } else {
            int refused = et_curve_insert(&t, &c, x, number) != ET_OK;
            values = refused ? 0 : t.n;
            for (size_t i = 0; i < values; i++) {
                out[i] = t.points[i].x;
            }
            if (!refused) {
                et_curve_free(&t);
            }
        }
        printf("%zu", span);
        for (size_t r = 0; r < values; r++) {
            printf(" %a", out[r]);
        }
        printf("\n");
        et_curve_free(&c);
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


def more():
    """Derivatives up to the third, points and insertions, of low degrees (the models of derivatives are slow)."""
    g = random.Random(2)
    chosen = [(p, u, x) for p, u, x in nasty() if 1 <= p <= 5]
    for p, u, x in chosen:
        n = len(u) - p - 1
        points = [g.uniform(-10.0, 10.0) for _ in range(n)]
        yield "d", p, u, x, g.randint(1, 3), []
        yield "c", p, u, x, 0, points
        s, inside = u.count(x), u[p] <= x <= u[n]
        if inside and s <= p:
            yield "i", p, u, x, g.randint(1, p + 1 - s), points


def ask(root, cases):
    with tempfile.TemporaryDirectory() as tmp:
        source, program = os.path.join(tmp, "driver.c"), os.path.join(tmp, "driver")
        with open(source, "w") as f:
            f.write(DRIVER)
        parts = [os.path.join(root, "src", m + ".c") for m in ("spline/basis", "spline/knots", "spline/curve", "spline/curve_edit", "spline/curve_net",
                                                               "spline/curve_elevate", "base/size", "base/vec3")]
        subprocess.run(["gcc", "-std=c99", "-O2", "-ffp-contract=off", "-D_POSIX_C_SOURCE=200809L", "-I" + os.path.join(root, "include"),
                        "-I" + os.path.join(root, "src"), source, *parts, "-lm", "-o", program], check=True)
        text = "".join("%s %d %d %s %s %d %d %s\n" % (kind, p, len(u), " ".join(v.hex() for v in u), x.hex(), number, len(c),
                                                      " ".join(v.hex() for v in c)) for kind, p, u, x, number, c in cases)
        lines = subprocess.run([program], input=text, stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    assert len(lines) == len(cases)
    for line in lines:
        words = line.split()
        yield int(words[0]), [float.fromhex(w) for w in words[1:]]


def literal(v):
    """A short literal with the same bits: small integers, else an integer times a power of two."""
    if v == 0.0:
        return "-0" if math.copysign(1.0, v) < 0.0 else "0"
    if not math.isfinite(v):
        return "nan" if v != v else "infinity" if v > 0.0 else "neg_infinity"
    if v == int(v) and abs(v) < 1e6:
        return "%d" % v
    m, e = math.frexp(v)
    m, e = int(math.ldexp(m, 53)), e - 53
    while m % 2 == 0:
        m, e = m // 2, e + 1
    return "%s0x%xp%d" % ("-" if m < 0 else "", abs(m), e)


def numbers(values):
    return "[%s]%%float" % "; ".join(map(literal, values))


def others(root):
    """Rows (degree, knots, span or place, number, parameter, coordinates, wanted)."""
    rows = {"d": [], "c": [], "i": []}
    cases = list(more())
    for (kind, p, u, x, number, c), (span, want) in zip(cases, ask(root, cases)):
        place = bisect.bisect_right(u, x) - 1 if kind == "i" else span
        if want:               # knots too near to each other are refused
            rows[kind].append("(%d, %s, %d, %d, %s%%float, %s, %s)" % (p, numbers(u), place, number, literal(x), numbers(c), numbers(want)))
    for kind, name in (("d", "derivatives"), ("c", "points"), ("i", "insertions")):
        yield "\nDefinition %s : list (nat * list float * nat * nat * float * list float * list float) := [\n%s]%%nat.\n" % (
            name, ";\n".join(rows[kind]))


def main():
    arguments = sys.argv[1:]
    check = "--check" in arguments
    roots = [a for a in arguments if a != "--check"]
    root = roots[0] if roots else os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
    cases = list(dict.fromkeys(list(golden(root)) + list(nasty())))
    vectors = {}
    for (p, u, x), (span, N) in zip(cases, ask(root, [("b", p, u, x, 0, []) for p, u, x in cases])):
        vectors.setdefault((p, u), []).append("(%d%%nat, %s, [%s])" % (span, literal(x), "; ".join(map(literal, N))))
    lists = ["(%d%%nat, [%s],\n [%s])" % (p, "; ".join(map(literal, u)), ";\n  ".join(rows)) for (p, u), rows in vectors.items()]
    pieces = [lists[i:i + PIECE] for i in range(0, len(lists), PIECE)]
    text = HEAD
    for i, piece in enumerate(pieces):
        text += "Definition rows_%d : list (nat * list float * list (nat * float * list float)) := [\n%s].\n\n" % (i, ";\n".join(piece))
    text += "Definition rows := %s.\n" % " ++ ".join("rows_%d" % i for i in range(len(pieces)))
    text += "".join(others(root))
    path = os.path.join(root, "proofs/coq/TieRows.v")
    if check:
        if open(path).read() != text:
            sys.exit("proofs/coq/TieRows.v is not what tie.py writes")
    else:
        with open(path, "w") as f:
            f.write(text)
    print("%d rows, %d vectors of knots, %d bytes" % (len(cases), len(vectors), len(text)))


main()
