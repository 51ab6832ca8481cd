#!/bin/sh
# Every C text that a Coq file quotes (between "QUOTE path" and "END") must still stand in that file, word for word but for annotations: quote.sh [ROOT].
root=${1:-$(dirname "$0")/../..}
python3 - "$root" <<'PYTHON'
import glob, os, re, sys
root, count, lost = sys.argv[1], 0, 0


def plain(text):
    """Without ACSL, which no compiler sees."""
    return re.sub(r"^[ \t]*//@.*\n", "", re.sub(r"^[ \t]*/\*@.*?\*/[ \t]*\n", "", text, flags=re.S | re.M), flags=re.M)


for path in sorted(glob.glob(os.path.join(root, "proofs/coq/*.v"))):
    for source, text in re.findall(r"QUOTE (\S+)\n(.*?)^END", open(path).read(), re.S | re.M):
        count += 1
        if text not in plain(open(os.path.join(root, source)).read()):
            lost += 1
            print("%s quotes what %s does not say:\n%s" % (os.path.relpath(path, root), source, text))
print("%d quotations, %d lost" % (count, lost))
sys.exit(lost > 0 or count == 0)
PYTHON
