#!/bin/sh
# registry.sh TEST.c...: the C tables of every `verdict prop_NAME(gen *g)`, `verdict gold_NAME(const row *r)` and
# `verdict true_NAME(const row *r)` defined there.
set -eu
echo '#include "gen.h"'
echo '#include "golden.h"'
list() { grep -hoE "^verdict $1_[a-z0-9_]+\($2\)$" $files | sed -E "s/^verdict $1_([a-z0-9_]+).*/\1/" | sort; }
files=$*
props=$(list prop 'gen \*g') || props=
golds=$(list gold 'const row \*r') || golds=
truths=$(list true 'const row \*r') || truths=
for n in $props; do echo "verdict prop_$n(gen *g);"; done
for n in $golds; do echo "verdict gold_$n(const row *r);"; done
for n in $truths; do echo "verdict true_$n(const row *r);"; done
echo 'const property properties[] = {'
for n in $props; do echo "    { \"$n\", prop_$n, $(grep -hB 1 "^verdict prop_$n(gen \*g)$" $files | sed -nE 's|^/\* One case in ([1-9][0-9]*)\..*|\1|p' | grep . || echo 1) },"; done
echo '    { 0, 0, 0 } };'
echo 'const golden goldens[] = {'
for n in $golds; do echo "    { \"$n\", gold_$n },"; done
echo '    { 0, 0 } };'
echo 'const golden truths[] = {'
for n in $truths; do echo "    { \"$n\", true_$n },"; done
echo '    { 0, 0 } };'
