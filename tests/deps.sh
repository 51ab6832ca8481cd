#!/bin/sh
# deps.sh PACKAGE...: see that these Debian packages are there; install what is missing if that may be done.
set -u
missing=
for p in "$@"; do
    dpkg-query -W -f '${Status}' "$p" 2> /dev/null | grep -q 'install ok installed' || missing="$missing $p"
done
[ -z "$missing" ] && exit 0
if [ "$(id -u)" -eq 0 ]; then
    root=
elif command -v sudo > /dev/null && sudo -n true 2> /dev/null; then
    root='sudo -n'
else
    echo "These packages are missing, and only root can install them: apt-get install$missing" >&2
    exit 2
fi
export DEBIAN_FRONTEND=noninteractive
echo "installing$missing"
log=$(mktemp) || exit 2
get() { $root apt-get update && $root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing; }
if ! get > "$log" 2>&1 < /dev/null; then
    tail -n 20 "$log" >&2
    echo "could not install:$missing" >&2
    rm -f "$log"
    exit 2
fi
rm -f "$log"
