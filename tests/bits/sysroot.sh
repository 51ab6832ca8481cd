#!/bin/sh
# sysroot.sh ARCHITECTURE TRIPLET FOLDER PACKAGE...: headers and libraries of another architecture, unpacked under FOLDER.
# apt takes them from the sources of this machine, but keeps its books in FOLDER: neither the machine's packages nor its architectures are changed,
# and root is not needed.  A folder that is complete is left as it is.
set -u
[ $# -ge 4 ] || { echo "sysroot.sh ARCHITECTURE TRIPLET FOLDER PACKAGE..." >&2; exit 2; }
arch=$1 triplet=$2 folder=$3
shift 3
[ "$(cat "$folder/ready" 2> /dev/null)" = "$*" ] && exit 0
rm -rf "$folder"
mkdir -p "$folder/apt/state/lists/partial" "$folder/apt/cache/archives/partial" "$folder/apt/log" || exit 2
folder=$(cd "$folder" && pwd)
: > "$folder/apt/status"
cat > "$folder/apt/conf" << END
#clear APT::Architectures;
#clear APT::Update::Pre-Invoke;
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
#clear DPkg::Pre-Invoke;
#clear DPkg::Post-Invoke;
#clear DPkg::Pre-Install-Pkgs;
APT::Architecture "$arch";
APT::Architectures { "$arch"; };
APT::Install-Recommends "false";
APT::Sandbox::User "";
Dir::State "$folder/apt/state";
Dir::State::status "$folder/apt/status";
Dir::Cache "$folder/apt/cache";
Dir::Log "$folder/apt/log";
END
# A source without this architecture is no reason to stop: what counts is whether the packages can be had.
apt-get -c "$folder/apt/conf" -q update > "$folder/log" 2>&1 < /dev/null
if ! apt-get -c "$folder/apt/conf" -q -y --download-only install "$@" >> "$folder/log" 2>&1 < /dev/null; then
    grep -E '^[EW]:|Unable|Err' "$folder/log" | tail -n 5 >&2
    echo "the packages of $arch cannot be had: $*" >&2
    exit 1
fi
for deb in "$folder"/apt/cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$folder" --no-same-owner --exclude=./usr/share --exclude=./etc || exit 1
done
rm -rf "$folder/apt"
# Links from the root on, and those that Debian's alternatives would make.
find "$folder" -type l | while read -r link; do
    case $(readlink "$link") in /*) ln -sfr "$folder$(readlink "$link")" "$link" ;; esac
done
for l in blas lapack; do
    for f in "$folder/usr/lib/$triplet/$l/lib$l".so*; do
        [ -e "$f" ] && ln -sfr "$f" "$folder/usr/lib/$triplet/${f##*/}"
    done
done
echo "$*" > "$folder/ready"
