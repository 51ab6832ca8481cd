#!/bin/sh
# The STL file of the command, checked by admesh: one part, every edge shared, nothing to repair, the volume told.
. "$(dirname "$0")/kit"
command -v admesh > /dev/null || { echo "skip stl_admesh: admesh is not installed"; exit 0; }
number() { sed -n "s/^$1 *: *\([-0-9.e+]*\).*/\1/p" report; }
is() { if [ "$2" = "$3" ]; then pass "$1"; else fail "$1" "'$2', not '$3'"; fi; }
"$etalon" generate sphere -o s.xyz
for mesh in 40x31 2x2 2x9 3x3; do
    "$etalon" reconstruct s.xyz --grid 12x12 --control 7x7 --seed 1 --mesh $mesh --no-pictures -q -o d > /dev/null 2> err
    exists "$mesh: the file" d/surface.stl
    admesh --exact --normal-directions --normal-values d/surface.stl > report 2>&1
    open=$(sed -n 's/^Facets with [123] disconnected edges* *: *\([0-9]*\).*/\1/p' report | tr '\n' ' ')
    is "$mesh: no open edge" "$open" "0 0 0 "
    is "$mesh: one part" "$(sed -n 's/^Number of parts *: *\([0-9]*\).*/\1/p' report)" 1
    for what in 'Edges fixed' 'Facets removed' 'Facets added' 'Facets reversed' 'Backwards edges' 'Normals fixed'; do
        is "$mesh: $what" "$(number "$what")" 0
    done
    sed -n 's/.*Volume *: *\([-0-9.]*\).*/\1/p' report > volume
    python3 -c 'import json, sys
want, got = json.load(open("d/summary.json"))["mesh"]["volume"], float(open("volume").read())
sys.exit(0 if want >= 0 and abs(want - got) <= 1e-5 else 1)' && pass "$mesh: volume" || fail "$mesh: volume" "$(cat volume)"
    rm -rf d
done
finish
