# awk -f prune.awk ieee_float.unused ieee_float.mlw: Why3's library of floats without the axioms and lemmas of module GenericFloat that are named in the first
# file, and without the goals of its clones that stand for them.  A name that is not found is an error: the library is another one than was thought.
FNR == NR {
    if ($1 != "" && $1 !~ /^#/) unused[$1] = 1
    next
}
/^module/ { module = $2 }
module == "GenericFloat" && ($1 == "axiom" || $1 == "lemma") {
    name = $2
    sub(/:.*/, "", name)
    dropped = name in unused
    if (dropped) found[name] = 1
}
dropped && (/^ *$/ || /^end/ || $1 ~ /^(function|predicate|val|constant)$/ || $1 ~ /^\(\*/) { dropped = 0 }
module != "GenericFloat" && $1 == "goal" {
    name = $2
    sub(/,.*/, "", name)
    if (name in unused) next
}
!dropped { print }
END {
    for (name in unused) if (!(name in found)) { print "prune.awk: no axiom " name > "/dev/stderr"; missing = 1 }
    exit missing
}
