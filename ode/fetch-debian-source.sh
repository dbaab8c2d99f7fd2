#!/bin/sh
# Downloads the original archive of the Debian source package `ode` into the folder $1.
#
# Needs neither root nor a deb-src entry on the machine: it copies the system's package sources into a
# private folder, turns `deb` into `deb-src` there and points apt at that folder.
set -eu
target=$1
archive=$2
command -v apt-get >/dev/null || { echo "apt-get is not installed" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/sources" "$work/lists/partial"

for file in /etc/apt/sources.list.d/*.sources; do
    [ -f "$file" ] || continue
    sed 's/^Types:.*/Types: deb-src/' "$file" >"$work/sources/${file##*/}"
done
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$file" ] || continue
    sed -n 's/^deb[[:space:]]/deb-src /p' "$file" >"$work/sources/system-${file##*/}"
done

apt() {
    apt-get -qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/sources" \
        -o Dir::State::lists="$work/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}
apt update
cd "$work"
apt -o APT::Sandbox::User=root source --download-only ode
cp "$archive" "$target/"
