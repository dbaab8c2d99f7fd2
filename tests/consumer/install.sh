#!/bin/sh
# The build installs into a folder of its own, which is then moved: nothing in it may know where it was.
. "$(dirname "$0")/expect.sh"
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
"$CMAKE" --install "$BUILD" --prefix "$SCRATCH/installed" >/dev/null
mv "$SCRATCH/installed" "$prefix"

lib=$prefix/$LIBDIR
expect "SONAME" "$(readelf -d "$lib/libode.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')" libode.so.8
expect "libode.so.8" "$(readlink -f "$lib/libode.so.8")" "$(readlink -f "$lib/libode.so.8.0.2")"
if readelf -d "$lib/libode.so" | grep -E 'R(UN)?PATH'; then fail "the library has a path in it"; fi
if grep -r -e "$SCRATCH" -e "$BUILD" "$prefix/bin" "$prefix/include" "$lib/pkgconfig" "$lib/cmake"; then
    fail "an installed file knows a folder of this build"
fi
for header in "$BUILD"/include/ode/*.h; do
    cmp "$header" "$prefix/include/ode/${header##*/}"
done
