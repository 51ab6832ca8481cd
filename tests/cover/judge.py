"""judge.py COVER.json UNREACHED.tsv: shares by room, the bars, and the lines that nothing reaches and nobody has explained."""
import json
import sys

BARS = (("all but io and cli", lambda room: room not in ("io", "cli"), 98.0), ("all", lambda room: True, 92.0))


def explained(path):
    """(file, text of the line) -> reason; `*` stands for any file."""
    entries = {}
    for number, line in enumerate(open(path), 1):
        if line.strip() and not line.startswith("#"):
            fields = line.rstrip("\n").split("\t")
            if len(fields) != 3 or not fields[2]:
                sys.exit(f"{path}:{number}: not file, line and reason")
            entries[fields[0], fields[1].strip()] = [fields[2], number, 0]
    return entries


def share(reached, of):
    return f"{100 * reached / of if of else 100:6.2f} % ({reached} of {of})"


def main():
    report, entries = json.load(open(sys.argv[1])), explained(sys.argv[2])
    rooms, failed, passed = {}, 0, 0
    for f in report["files"]:
        source = open(f["file"]).read().split("\n")
        counts = rooms.setdefault(f["file"].split("/")[1], [0, 0, 0, 0])
        for line in f["lines"]:
            if line.get("gcovr/noncode"):
                continue
            counts[0] += line["count"] > 0
            counts[1] += 1
            if line["count"] > 0:             # branches of a line that is not reached are told by the line
                counts[2] += sum(b["count"] > 0 for b in line["branches"])
            counts[3] += len(line["branches"])
            text = source[line["line_number"] - 1].strip()
            if line["count"] == 0:
                entry = entries.get((f["file"], text)) or entries.get(("*", text))
                if entry:
                    entry[2] += 1
                else:
                    failed += 1
                    print(f"FAIL cover {f['file']}:{line['line_number']}: not reached, and not explained: {text}")
    for room, c in sorted(rooms.items()):
        print(f"{room:8} lines {share(c[0], c[1])}  branches {share(c[2], c[3])}")
    for name, chosen, bar in BARS:
        c = [sum(v[k] for room, v in rooms.items() if chosen(room)) for k in range(4)]
        good = 100 * c[2] >= bar * c[3]
        passed, failed = passed + good, failed + (not good)
        print(f"{'ok' if good else 'FAIL'} cover {name}: lines {share(c[0], c[1])}, branches {share(c[2], c[3])}, wanted {bar} %")
    for (path, text), (_, number, used) in entries.items():
        if not used:
            print(f"note: {sys.argv[2]}:{number}: {path}: {text}: reached after all, or gone")
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed > 0)


main()
