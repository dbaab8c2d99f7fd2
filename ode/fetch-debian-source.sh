#!/bin/sh
# fetch-debian-source.sh ARCHIVE FILE: downloads the original archive of the Debian source package `ode`,
# which there has the name ARCHIVE, as FILE.
#
# Needs neither root nor a deb-src entry on the machine: it copies the system's package sources into a
# private folder, turns `deb` into `deb-src` there and points apt at that folder.
set -eu
archive=$1
file=$2
command -v apt-get >/dev/null || { echo "apt-get is not installed" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/sources" "$work/lists/partial"

for list in /etc/apt/sources.list.d/*.sources; do
    [ -f "$list" ] || continue
    sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/sources/${list##*/}"
done
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$list" ] || continue
    sed -n 's/^deb[[:space:]]/deb-src /p' "$list" >"$work/sources/system-${list##*/}"
done

apt() {
    apt-get -qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/sources" \
        -o Dir::State::lists="$work/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}
apt update
cd "$work"
apt -o APT::Sandbox::User=root source --download-only ode
cp "$archive" "$file"
