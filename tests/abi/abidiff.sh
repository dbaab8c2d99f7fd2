#!/bin/sh
# libabigail finds nothing removed or changed in our library, and finds it in libraries that are altered.
#
# Debian's libode8 has no debug information, and Debian keeps that of its packages (libode8-dbgsym) in an
# archive of its own that is not among a machine's package sources. So abidiff compares SONAME, machine and
# symbols with their kinds here; types are compared by the headers (headers.sh).
. "$(dirname "$0")/common.sh"

compare() { abidiff --suppressions "$here/suppressions.abignore" --no-added-syms "$1" "$2"; }
must_differ() {
    if compare "$DEBIAN" "$1"; then fail "abidiff finds no difference: $2"; fi
}

# Stripped as Debian's is, so that abidiff reads from both what the dynamic loader reads.
strip -o "$SCRATCH/ours.so" "$OURS"
compare "$DEBIAN" "$SCRATCH/ours.so" || fail "our library differs from Debian's"

echo "--- The differences below are wanted: libraries altered on purpose."
# alter FROM TO: our library with a name overwritten by another of the same length.
alter() { LC_ALL=C sed "s/\x00$1\x00/\x00$2\x00/g" "$SCRATCH/ours.so" >"$SCRATCH/altered.so"; }
alter dWorldQuickStep dWorldQuickStup
must_differ "$SCRATCH/altered.so" "dWorldQuickStep is missing"
alter libode.so.8 libode.so.9
must_differ "$SCRATCH/altered.so" "the SONAME is another"
