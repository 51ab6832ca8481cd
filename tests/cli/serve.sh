#!/bin/sh
# Etalon answers the conformance protocol, whatever lines it is given.
. "$(dirname "$0")/kit"
# answers NAME WANTED LINE [OPTION]: the reply to one line, as a whole.
answers() {
    got=$(printf '%s\n' "$3" | "$etalon" serve ${4:-} 2> err); code=$?
    if [ "$code" -eq 0 ] && [ "$got" = "$2" ]; then pass "$1"; else fail "$1" "'$got', not '$2' (exit code $code)"; fi
}
# like NAME PATTERN LINE [OPTION]
like() {
    got=$(printf '%s\n' "$3" | "$etalon" serve ${4:-} 2> err); code=$?
    if [ "$code" -eq 0 ] && printf '%s\n' "$got" | grep -qE -- "$2"; then pass "$1"; else fail "$1" "'$got' is not like '$2' (exit code $code)"; fi
}
like 'hello' '^0 ok protocol=1 name=etalon version=[0-9.]+ .*rational=1 sides=any,left,right .*ops=span,' '0 hello 1'
like 'hello, exactly' ',seam_gap$' '0 hello 1' --exact
like 'hello with another number' '^17 ok protocol=1' '17 hello 1'
like 'another protocol' '^0 refused' '0 hello 2'
like 'hello without a version' '^0 refused' '0 hello'
answers 'a basis' '1 ok 0x1.8p-1 0x1p-2' '1 basis 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-2 any'
answers 'in decimals' '1 ok 0x1.8p-1 0x1p-2' '1 basis 1 4 0 0 1 1 0.25 any'
answers 'exactly' '1 ok 0x1.8p-1 0x1p-2' '1 basis 1 4 0 0 1 1 0.25 any' --exact
answers 'the greatest number' '9007199254740992 ok 0x0p+0' '9007199254740992 span 0 2 0 1 0'
like 'a number above' '^0 refused' '9007199254740993 span 0 2 0 1 0'
like 'no number' '^0 refused' 'span 0 2 0 1 0'
like 'a negative number' '^0 refused' '-1 span 0 2 0 1 0'
like 'an empty line' '^0 refused' ''
like 'blanks' '^0 refused' '   '
like 'a number alone' '^5 refused no operation' '5'
like 'no operation' "^5 refused 'fold' is no operation" '5 fold 1 2'
like 'half a request' '^5 refused u: the line ends' '5 span 1 4 0 0 1'
like 'too much' '^5 refused .* one word too many' '5 span 0 2 0 1 0 0'
like 'invalid knots' '^5 refused' '5 span 1 4 0 1 0 1 0'
like 'a count beyond the line' '^5 refused' '5 multiplicity 9007199254740992 0 1'
like 'operations that look like hello' "^5 refused 'hellos'" '5 hellos 1'
answers 'CR' '1 ok 0x1p+0' "$(printf '1 multiplicity 1 0 0\r')"
got=$(printf '1 multiplicity 1 0 0' | "$etalon" serve); [ "$got" = '1 ok 0x1p+0' ] && pass 'the last line without an end' || fail 'the last line without an end' "$got"
got=$(printf '1 multiplicity\0 1 0 0\n2 multiplicity 1 0 0\n' | "$etalon" serve | tr '\n' '|'); case $got in '0 refused'*'|2 ok 0x1p+0|') pass 'a zero byte' ;; *) fail 'a zero byte' "$got" ;; esac
head -c 20000 /dev/urandom | "$etalon" serve > out 2> err; [ $? -eq 0 ] && ! grep -qvE '^[0-9]+ (refused|ok|unsupported)' out && pass 'any bytes' || fail 'any bytes' "$(head -n 3 out)"
{ head -c 300000000 /dev/zero | tr '\0' '7'; printf '\n1 multiplicity 1 0 0\n'; } | "$etalon" serve > out 2> err
[ "$(tr '\n' '|' < out)" = '0 refused the line is too long|1 ok 0x1p+0|' ] && pass 'a line of 300 million bytes' || fail 'a line of 300 million bytes' "$(head -c 200 out)"
got=$(: | "$etalon" serve); [ $? -eq 0 ] && [ -z "$got" ] && pass 'nothing asked' || fail 'nothing asked' "$got"
# Each reply is there before the next request is.
mkfifo in to
"$etalon" serve < in > to & job=$!
exec 5> in 6< to
echo '1 net_counts 2 2' >&5; read -r a <&6; echo '2 net_counts 2 3' >&5; read -r b <&6
case $a/$b in '1 ok 0x1p+3 '*'/2 ok 0x1.8p+3 '*) pass 'replies are flushed' ;; *) fail 'replies are flushed' "$a/$b" ;; esac
exec 5>&-; wait $job; [ $? -eq 0 ] && pass 'ends with its input' || fail 'ends with its input'
exec 6<&-
yes '1 net_counts 2 2' 2> /dev/null | "$etalon" serve > /dev/full 2> err; code=$?
[ $code -eq 4 ] && pass 'a full disk' || fail 'a full disk' "exit code $code"
{ yes '1 net_counts 2 2' | { "$etalon" serve; echo $? > code; } | head -n 1; } > /dev/null 2>&1
[ "$(cat code)" -eq 4 ] && pass 'a closed pipe' || fail 'a closed pipe' "exit code $(cat code)"
mkfifo quiet; "$etalon" serve < quiet > out 2> err & job=$!
exec 5> quiet; sleep 0.5; kill -INT $job; wait $job; code=$?
[ $code -eq 130 ] && pass 'interrupted' || fail 'interrupted' "exit code $code"
exec 5>&-
says 'an argument' 2 'too many' "$etalon" serve now
says 'an option' 2 'unknown option' "$etalon" serve --fast
finish
