# awk -v file=NAME.mlw -f prune.awk unused NAME.mlw: a file of Why3's library, or of WP's, without the declarations that the first file names for it
# (FILE MODULE KIND NAME) and without the modules that it names whole (FILE module NAME).  A clone of GenericFloat states anew, as goals, what it does not
# take over: those of the declarations that are gone go, too.
# A name that is not found is an error: the library is another one than was thought.
FNR == NR {
    if ($1 == file && NF == 3) whole[$2 " " $3] = 1
    if ($1 == file && NF == 4) unused[$2 " " $3 " " $4] = 1
    next
}
/^(module|theory)/ {
    module = $2
    without = ("module " module) in whole
    if (without) found[module] = 1
}
match($0, /^ *((let|val) +)?(use|type|function|predicate|constant|axiom|lemma|clone) +/) {
    kind = substr($0, 1, RLENGTH)
    name = substr($0, RLENGTH + 1)
    sub(/[ :].*/, "", name)
    kind = kind ~ /axiom|lemma/ ? "prop" : kind ~ /use/ ? "use" : "symbol"
    dropped = (module " " kind " " name) in unused
    if (dropped) found[module " " kind " " name] = 1
}
/^ *$/ || /^end/ || $1 ~ /^\(\*/ { dropped = 0 }
$1 == "goal" {
    name = $2
    sub(/,.*/, "", name)
    if (("GenericFloat prop " name) in unused) next
}
!dropped && !without { print }
/^end/ { without = 0 }
END {
    for (name in whole) if (!(substr(name, 8) in found)) missing = missing " " name ","
    for (name in unused) if (!(name in found)) missing = missing " " name ","
    if (missing != "") print "prune.awk: in " file " there is no" missing " which " ARGV[1] " names" > "/dev/stderr"
    exit missing != ""
}
