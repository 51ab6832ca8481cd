"""Golden rows of conform/reply: replies and hellos by the rules of docs/conformance.md."""
from rational import head, row
from request import EFORMAT, OPS, codes, hexed, number

NAMES = [name for name, _ in OPS]
NONE = 2**53 + 1                                     # stands for SIZE_MAX


def offered(*names):
    """The operations as bits, fifteen at a time."""
    bits = sum(1 << NAMES.index(n) for n in names)
    return [bits & 0x7fff, bits >> 15]


def hello(words, reason, want):
    row("reply_hello", "exact", reason, words.split(" "), want)


def main():
    head("reply", "replies and hellos")
    for line, reason in [
        ("1 ok 0x1p+0", "one number"), ("0 ok", "no number"), ("9007199254740992 ok 0 -0 0.1", "the greatest number of a request"),
        ("18 ok inf -inf nan", "what is not finite"), ("18 ok Infinity -INF NaN -nan", "capitals"), ("7 ok 1 2 3", "counts are reals"),
        ("7 ok 1e400 0x1p-1075 0x1.8p-1074", "beyond the range"), ("3 ok 0.30000000000000004 1.7976931348623157e+308 5e-324", "17 digits"),
        ("3 ok 0x1.00000000000008p+0 0x1.00000000000018p+0", "ties go to even"),
    ]:
        id, _, *values = line.split()
        values = [number(v) for v in values]
        row("reply_parse", "exact", reason, line.split(" "), [0, int(id), 0] + values)
        row("reply_print", "exact", reason, line.split(" "), codes(" ".join([id, "ok"] + [hexed(v) for v in values])))
    for line, reason, kind in [("5 refused", "no reason", 1), ("5 refused outside the domain", "a reason", 1), ("5 unsupported", "no reason", 2), ("5 unsupported 1 2", "numbers are no values here", 2)]:
        row("reply_parse", "exact", reason, line.split(" "), [0, 5, kind])
        row("reply_print", "exact", reason, line.split(" "), codes(line))
    for line, reason in [
        ("ok 1", "no number of a request"), ("1", "no kind"), ("1 OK 1", "kinds have no capitals"), ("1 okay", "no such kind"), ("1 o", "part of a kind"), ("-1 ok 0", "a negative number"),
        ("1.0 ok 0", "a real for the number"), ("9007199254740993 ok", "above 2^53"), ("1 ok x", "not a number"), ("1 ok 1 2 3,", "a comma"), ("1 ok 1 0x", "half a hex float"), ("x ok", "a word for the number"),
    ]:
        row("reply_parse", "exact", reason, line.split(" "), [EFORMAT])
    for a, b, reason, same in [
        ("ok 1 2", "ok 1 2", "equal", 1), ("ok 1 2", "ok 1", "fewer", 0), ("ok 1 2", "ok 1 2.0000000000000004", "one ulp", 0), ("ok 0", "ok -0", "the sign of zero", 0), ("ok nan", "ok -nan", "any NaN", 1),
        ("ok nan", "ok inf", "NaN and infinity", 0), ("ok", "refused", "another kind", 0), ("refused so", "refused because", "another reason", 1), ("refused", "unsupported", "another kind", 0),
        ("ok 1 2", "ok 2 1", "another order", 0), ("ok 0.5 0x1p+4", "ok 0x1p-1 16", "another notation", 1), ("ok 2 1", "ok 1 1", "the first", 0),
    ]:
        row("reply_same", "exact", reason, ("1 %s | 2 %s" % (a, b)).split(" "), [same])
    base = "protocol=1 name=a version=2 ops=span"
    plain = [NONE, 3, 0, 1, 0, 0, 0.0, 0]
    hello(base, "nothing but what must be", [0] + plain + offered("span"))
    hello("ops=span version=2 name=a protocol=1", "another order", [0] + plain + offered("span"))
    hello("protocol=1 name=a version=2 ops=" + ",".join(NAMES), "all operations", [0] + plain + offered(*NAMES))
    for n in NAMES:
        hello("protocol=1 name=a version=2 ops=" + n, "one operation", [0] + plain + offered(n))
    hello("protocol=1 name=a version=2 ops=", "no operation", [0] + plain + offered())
    hello("protocol=1 name=a version=2 ops=fold,span,spa,basis", "unknown ones", [0] + plain[:-1] + [2] + offered("span", "basis"))
    for key, k, values in [("degree", 0, [0, 3, 9007199254740992]), ("order", 1, [0, 1, 12]), ("rational", 2, [0, 1])]:
        for v in values:
            hello("%s %s=%d" % (base, key, v), key, [0] + plain[:k] + [v] + plain[k + 1:] + offered("span"))
    for word, bits in [("any", [1, 0, 0]), ("left", [0, 0, 1]), ("right", [0, 1, 0]), ("left,right", [0, 1, 1]), ("any,left,right", [1, 1, 1])]:
        hello(base + " sides=" + word, "sides", [0] + plain[:3] + bits + plain[6:] + offered("span"))
    for word in ("0", "1e-9", "0x1p-20"):
        hello(base + " knot_tolerance=" + word, "knot tolerance", [0] + plain[:6] + [number(word)] + plain[7:] + offered("span"))
    hello(base + " colour=blue x=", "keys that are not known", [0] + plain + offered("span"))
    for words, reason in [
        ("name=a version=2 ops=span", "no protocol"), ("protocol=1 version=2 ops=span", "no name"), ("protocol=1 name=a ops=span", "no version"), ("protocol=1 name=a version=2", "no operations"),
        ("protocol=2 name=a version=2 ops=span", "another protocol"), ("protocol=11 name=a version=2 ops=span", "another protocol"), ("protocol= name=a version=2 ops=span", "no value"),
        ("protocol=1 name= version=2 ops=span", "no value"), (base + " degree=-1", "a negative degree"), (base + " degree=x", "a word"), (base + " order=1.5", "a real"), (base + " rational=2", "neither yes nor no"),
        (base + " sides=both", "no such side"), (base + " sides=", "no side"), (base + " sides=any,up", "no such side"), (base + " knot_tolerance=-1", "negative"), (base + " knot_tolerance=nan", "not a number"),
        (base + " knot_tolerance=inf", "infinite"), (base + " name=b", "twice"), (base + " blue", "not key=value"), (base + " ops=basis", "twice"),
    ]:
        hello(words, reason, [EFORMAT])


if __name__ == "__main__":
    main()
