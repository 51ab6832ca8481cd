"""scoreboard.py FOLDER: the reports of `etalon conform --json` in the folder become docs/scoreboard.md, on standard output."""
import glob
import json
import os
import sys

ORDER = ("library", "serve", "exact", "command", "gsl", "sisl", "occt", "scipy", "fitpack")
WHAT = {"library": "the library's fast functions", "serve": "`etalon serve`", "exact": "`etalon serve --exact`", "command": "`etalon evaluate`, a file a request",
        "gsl": "libgsl", "sisl": "libsisl", "occt": "libocct", "scipy": "scipy.interpolate.BSpline, make_lsq_spline",
        "fitpack": "scipy's FITPACK: splev, insert, bisplev, LSQBivariateSpline"}
BAD = ("inaccurate", "wrong", "non_finite", "wrongly_accepted", "wrongly_refused", "crash", "timeout", "nondeterministic")
SHOWN = 240                                  # characters of a request


def short(text):
    text = " ".join(text.split()).replace("|", "\\|")
    return text if len(text) <= SHOWN else text[:SHOWN] + f" ... ({len(text)} characters)"


def row(cells):
    return "| " + " | ".join(str(c) for c in cells) + " |"


def counts(v):
    asked = sum(n for k, n in v.items() if k != "unsupported" and k != "worst")
    return [asked, v["correctly_rounded"], v["within_bound"]] + [v[k] or "" for k in BAD] + [v["unsupported"] or ""]


HEAD = ["judged", "correctly rounded", "within bound"] + [k.replace("_", " ") for k in BAD] + ["unsupported"]


def table(first, rows):
    print(row([first] + HEAD))
    print(row(["---"] * (len(HEAD) + 1)))
    for name, v in rows:
        print(row([name] + counts(v)))
    print()


def name_of(report):
    return f"{report['adapter']['name']} {report['adapter']['version']}"


def findings(report):
    """The least request of each operation, category and verdict."""
    best = {}
    for f in report["findings"]:
        request = f.get("shrunk") or f.get("request") or ""
        key = f["operation"], f["verdict"]
        if key not in best or len(request) < len(best[key][0]):
            best[key] = request, f
    for (operation, verdict), (request, f) in sorted(best.items()):
        issue = f" ([{f['issue'].split('github.com/')[-1]}]({f['issue']}))" if f.get("issue") else ""
        where = f" [{f['category']}]" if f.get("category") else ""
        print(f"* **{operation}, {verdict.replace('_', ' ')}**{where}: {short(f.get('text') or '')}{issue}")
        if request:
            print(f"  `{short(request)}`")
    print()


def main():
    reports = []
    for key in ORDER:
        path = os.path.join(sys.argv[1], key + ".json")
        if os.path.exists(path):
            reports.append((key, json.load(open(path))))
    print("# Scoreboard\n")
    print("Made by `make conformance`: each adapter in `tests/adapters` asked at level 2, that is level 0, the frozen vectors of `golden/conformance/` and seeded")
    print(f"cases (seed {reports[0][1]['seed']}). The table says what these versions, as Debian 12 ships them, answered through these adapters; it claims nothing of others. What an adapter")
    print("refuses or does not support in its library's stead its source says. [findings](findings.md) goes through the classes of faults by hand.\n")
    table("adapter", [(f"{name_of(r)} ({WHAT[k]})", r["verdicts"]) for k, r in reports])
    for key, r in reports:
        print(f"## {name_of(r)}: {WHAT[key]}\n")
        used = [(c, v) for c, v in r["categories"].items() if sum(counts(v)[0:1])]
        table("category", used)
        ratios = [f"{op} {v['worst']:.2g}" for op, v in r["operations"].items() if v.get("worst")]
        print("Worst error / bound: " + (", ".join(ratios) or "none") + ".\n")
        if r["findings"]:
            findings(r)


main()
