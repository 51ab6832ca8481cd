#!/bin/sh
# The IGES files of the command, read back by OpenCASCADE: polynomial, rational, with a gap, in a frame of its own.
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$(dirname "$0")/kit"
flags="-lTKIGES -lTKXSBase -lTKShHealing -lTKTopAlgo -lTKGeomAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel -ljansson"
if ! [ -f /usr/include/opencascade/IGESControl_Reader.hxx ]; then
    echo "skip iges_occt: libocct-data-exchange-dev is not installed"
    exit 0
fi
if ! ${CXX:-g++} -std=c++17 -O1 -isystem /usr/include/opencascade -o read_iges "$root/tests/adapters/occt/read_iges.cpp" $flags 2> err; then
    fail "the adapter compiles" "$(head -c 500 err)"
    finish
fi
read_back() {
    if [ -s "$2" ] && [ -s "$3" ]; then ./read_iges "$2" "$3" > lines || failures=1; sed "s/^\(ok\|FAIL\) iges_occt /&$1: /" lines
    else fail "$1" "nothing to read"; fi
}
"$etalon" generate cube -o c.xyz
awk '{ print 1e3 + 7 * $1, -5 * $2, 0.001 * $3 }' c.xyz > own.xyz
"$etalon" train own.xyz --grid 10x11 --seed 2 -q -o n.json
"$etalon" fit n.json --control 6x7 -q -o s.json --iges s.igs
read_back "improved" s.igs s.json
"$etalon" fit n.json --control 5x5 --degree 2x3 --approach conventional -q -o gap.json --iges gap.igs
read_back "conventional" gap.igs gap.json
"$etalon" refine s.json --net n.json --with ceres-full --seed 3 -q -o full.json --iges full.igs
read_back "rational" full.igs full.json
finish
