#!/usr/bin/env python3
"""Etalon by its command line: adapter.py ETALON [exact].  Each request becomes a surface file, which `etalon evaluate` reads."""
import json
import math
import os
import subprocess
import sys
import tempfile

ETALON, EXACT = sys.argv[1], sys.argv[2:] == ["exact"]
REFUSES = 3                                # exit codes of the command: 2 usage, 3 input that cannot be used


class Refused(Exception):
    pass


def real(word):
    return float.fromhex(word) if "x" in word.lower() else float(word)


def take(words, each=1):
    n = int(next(words))
    return [real(next(words)) for _ in range(each * n)]


def number(x):
    """JSON has no word for NaN and infinity, and neither has a surface file."""
    if not math.isfinite(x):
        raise Refused("a number is not finite")
    return x


def surface(words):
    p, q = int(next(words)), int(next(words))
    u, v, P, w = take(words), take(words), take(words, 3), take(words)
    nu, nv = len(u) - p - 1, len(v) - q - 1
    if nu < 1 or nv < 1 or len(P) != 3 * nu * nv or len(w) not in (0, nu * nv):
        raise Refused("control points, weights and knots do not fit in number")
    for x in u + v + P + w:
        number(x)
    points = [P[3 * k:3 * k + 3] for k in range(nu * nv)]
    return {"p": p, "q": q, "nu": nu, "nv": nv, "u": u, "v": v, "points": points, "weights": w or None}


def file_of(view):
    """A shell of which both views are the surface; what is said of its fit does not matter here."""
    line = {"s": [0.0, 1.0], "r": [0.0, 1.0]}
    return {"format": "etalon-surface", "version": 1,
            "fit": {"approach": "conventional", "parameters": "chord", "knots": "piegl", "algebra": "qr", "corners": "default",
                    "p": view["p"], "q": view["q"], "nx": view["nu"], "ny": view["nv"]},
            "error": {"nov": 0.0, "non": 0.0, "greatest": 0.0, "corner": 0.0}, "seam_gap": 0.0,
            "frame": {"offset": [0.0, 0.0, 0.0], "scale": [1.0, 1.0, 1.0]},
            "data": {"nx": 2, "ny": 2, "flat": 0, "bottom": line, "top": line, "uv": None}, "views": {"bottom": view, "top": view}}


def evaluate(words, order):
    view = surface(words)
    x, y = number(real(next(words))), number(real(next(words)))
    sides = [next(words), next(words)]
    order = int(next(words)) if order is None else order
    if sides != ["any", "any"] or min(view["p"], view["q"]) < 1 or min(view["nu"], view["nv"]) < 2:
        return "unsupported"
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "s.json")
        with open(path, "w") as f:
            json.dump(file_of(view), f)
        command = [ETALON, "evaluate", path, "-", "--order", str(order), "--hex"] + (["--exact"] if EXACT or order > 2 else [])
        done = subprocess.run(command, input=f"{x!r} {y!r}\n", capture_output=True, text=True)
    if done.returncode == REFUSES:
        raise Refused(" ".join(done.stderr.split())[:100])
    if done.returncode != 0:
        sys.exit(f"etalon evaluate: exit code {done.returncode}: {done.stderr}")
    return "ok " + " ".join(done.stdout.splitlines()[1].split(",")[2:])


OPERATIONS = {"surface_point": 0, "surface_ders": None}


def main():
    version = subprocess.run([ETALON, "--version"], capture_output=True, text=True).stdout.split()[1]
    for line in sys.stdin:
        ident, op, *words = line.split()
        if op == "hello":
            reply = f"ok protocol=1 name=Etalon-command version={version} rational=1 sides=any ops=" + ",".join(OPERATIONS)
        elif op not in OPERATIONS:
            reply = "unsupported"
        else:
            try:
                reply = evaluate(iter(words), OPERATIONS[op])
            except Refused as e:
                reply = f"refused {e}"
        print(ident, reply, flush=True)


main()
