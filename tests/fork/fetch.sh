#!/bin/sh
# fetch.sh CASE: how ode/fetch.cmake finds and checks upstream's archive. Works on a copy of ode/, so that
# the unpacked sources of this checkout are not touched. Environment (tests/fork/CMakeLists.txt):
#   ODE      the folder ode/                  CACHE     the cache that this build was made from
#   NAME     name of upstream's archive       VERSION   of ODE
#   CMAKE    cmake                            SCRATCH   a folder for this case
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }

rm -rf "$SCRATCH"
mkdir -p "$SCRATCH/ode" "$SCRATCH/bin"
cp -r "$ODE"/*.cmake "$ODE"/*.sh "$ODE/releases" "$SCRATCH/ode"
pin=$SCRATCH/ode/releases/$VERSION/pin.cmake
archive=$CACHE/$NAME
cache=$SCRATCH/cache
unpacked=$SCRATCH/ode/upstream/ode-$VERSION

# No package source and no address answers: apt-get is not in PATH and the address is that of no server.
for tool in sh sed mktemp dirname rm mkdir cp tar gzip; do ln -s "$(command -v $tool)" "$SCRATCH/bin/"; done
sed -i 's,https://.*\.tar\.gz,https://no-such-server.invalid/ode.tar.gz,' "$pin"
grep -q no-such-server "$pin" || fail "$pin has no address to replace"

# unpack OPTION...: runs the script without network; its output goes to SCRATCH/output.
unpack() {
    PATH=$SCRATCH/bin "$CMAKE" -DODE_MT_UPSTREAM="$VERSION" -DODE_MT_CACHE_DIR="$cache" "$@" -P "$SCRATCH/ode/unpack.cmake" >"$SCRATCH/output" 2>&1
}
must_unpack() { unpack "$@" || fail "not unpacked: $(cat "$SCRATCH/output")"; }
must_stop() { if unpack "$@"; then fail "unpacked in spite of an error"; fi; }
# CMake breaks the lines of a message; here they do not matter.
must_say() { tr -s '\n ' '  ' <"$SCRATCH/output" | grep -qF -- "$1" || fail "'$1' is not in: $(cat "$SCRATCH/output")"; }
fill_cache() { mkdir -p "$cache"; cp "$archive" "$cache/$NAME"; }

# A build whose sources were unpacked before needs no archive, and may have none.
[ -f "$archive" ] || { echo "skipped: there is no $archive"; exit 77; }

case $1 in
nothing_found)
    must_stop -DODE_MT_UPSTREAM_TARBALL=/no/such/$NAME
    must_say "ODE_MT_UPSTREAM_TARBALL=/no/such/$NAME: no such file"
    must_say "$cache/$NAME: no such file"
    must_say "Debian source package \`ode\` (apt-get source): apt-get is not installed"
    must_say "https://no-such-server.invalid/ode.tar.gz:"
    must_say "-DODE_MT_UPSTREAM_TARBALL=/path/to/$NAME"
    ! ls -d "$SCRATCH"/ode/upstream/ode-* >/dev/null 2>&1 || fail "something was unpacked"
    [ -z "$(ls "$cache")" ] || fail "something was left in the cache: $(ls "$cache")"
    ;;
wrong_given)
    echo "another archive" >"$SCRATCH/$NAME"
    must_stop -DODE_MT_UPSTREAM_TARBALL="$SCRATCH/$NAME"
    must_say "$SCRATCH/$NAME is not ODE $VERSION: its SHA-256 is $(sha256sum "$SCRATCH/$NAME" | cut -d ' ' -f 1)"
    ;;
wrong_cached)
    fill_cache
    echo "one byte more" >>"$cache/$NAME"
    must_stop
    must_say "$cache/$NAME is not ODE $VERSION"
    ;;
wrong_download)
    # Nothing wrong may stay in the cache, or every later try would fail on it.
    echo "another archive" >"$SCRATCH/$NAME"
    sed -i "s,https://no-such-server.*,file://$SCRATCH/$NAME)," "$pin"
    must_stop
    must_say "is not ODE $VERSION"
    [ -z "$(ls "$cache")" ] || fail "something was left in the cache: $(ls "$cache")"
    fill_cache
    must_unpack
    ;;
downloaded)
    sed -i "s,https://no-such-server.*,file://$archive)," "$pin"
    must_unpack
    cmp "$archive" "$cache/$NAME" || fail "the cache does not keep the archive"
    ;;
from_cache)
    fill_cache
    must_unpack
    must_say "unpacked in $unpacked"
    [ -f "$unpacked/ode/src/ode.cpp" ] || fail "no sources in $unpacked"
    rm -r "$cache"
    must_unpack  # unpacked and unchanged: not even the cache is needed
    ;;
from_given)
    must_unpack -DODE_MT_UPSTREAM_TARBALL="$archive"
    cmp "$archive" "$cache/$NAME" || fail "the cache does not keep the archive"
    rm -r "$SCRATCH/ode/upstream"
    must_unpack
    ;;
edited_sources)
    fill_cache
    must_unpack
    original=$(sha256sum <"$unpacked/ode/src/ode.cpp")
    for edit in "echo edited >>$unpacked/ode/src/ode.cpp" "rm $unpacked/ode/src/ode.cpp" \
        "touch $unpacked/ode/src/added.cpp"; do
        eval "$edit"
        must_unpack
        must_say "differs from the pinned archive; it is unpacked again"
        [ "$(sha256sum <"$unpacked/ode/src/ode.cpp")" = "$original" ] || fail "not restored after: $edit"
        [ ! -e "$unpacked/ode/src/added.cpp" ] || fail "not restored after: $edit"
    done
    must_unpack
    if grep -q differs "$SCRATCH/output"; then fail "unchanged sources are unpacked again"; fi
    ;;
no_network)
    # The unchanged pin, in a network namespace without any interface, with apt-get in PATH.
    cp "$ODE/releases/$VERSION/pin.cmake" "$pin"
    unshare -rn true 2>/dev/null || { echo "this machine does not let unshare take the network away"; exit 77; }
    run() { unshare -rn "$CMAKE" -DODE_MT_UPSTREAM="$VERSION" -DODE_MT_CACHE_DIR="$cache" -P "$SCRATCH/ode/unpack.cmake" >"$SCRATCH/output" 2>&1; }
    if run; then fail "unpacked from nowhere"; fi
    must_say "ODE_MT_UPSTREAM_TARBALL: not given"
    must_say "$cache/$NAME: no such file"
    must_say "Debian source package"
    must_say "bitbucket.org"
    fill_cache
    run || fail "not unpacked from the cache: $(cat "$SCRATCH/output")"
    ;;
unknown_release)
    must_stop -DODE_MT_UPSTREAM=0.15
    must_say "ODE_MT_UPSTREAM is '0.15'; known:"
    must_say "$VERSION"
    ;;
*) fail "no case '$1'" ;;
esac
