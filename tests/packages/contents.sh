#!/bin/sh
# Packages hold what Debian's hold, at the same places; the library is the built one, stripped, and its symbols are apart.
. "$(dirname "$0")/common.sh"
tree=$(unpacked "$library")
headers=$(unpacked "$development")

# files PACKAGE: as Debian's, but for documentation and manual pages.
files() { dpkg-query --listfiles "$1" | while read -r file; do [ -d "$file" ] || echo "${file#/}"; done | grep -v ^usr/share | sort; }
ours() { (cd "$(unpacked "$1")" && find usr -not -type d) | grep -v ^usr/share | sort; }
if [ "$PRECISION" = double ]; then
    expect "files of $library" "$(ours "$library")" "$(files "$THEIRS")"
    added=$(files libode-dev >"$SCRATCH/debian"; ours "$development" | comm -3 "$SCRATCH/debian" - | sed 's/^[[:space:]]*//')
    expect "files of $development beside Debian's" "$(echo $added)" \
        "usr/include/ode/ode_MT.h $LIB/cmake/ode/ode-config-version.cmake $LIB/cmake/ode/ode-config.cmake"
fi

built=$(readelf --notes "$BUILD/lib/libode.so.8" | sed -n 's/.*Build ID: //p')
expect "build ID" "$(readelf --notes "$tree/$LIB/libode.so.8" | sed -n 's/.*Build ID: //p')" "$built"
[ -f "$(unpacked "$library-dbgsym")/usr/lib/debug/.build-id/$(echo "$built" | cut -c1-2)/$(echo "$built" | cut -c3-).debug" ] || fail "no debug symbols"
size=$(stat -Lc %s "$tree/$LIB/libode.so.8")
[ "$size" -lt 5000000 ] || fail "libode.so.8 has $size bytes"

expect "SONAME" "$(readelf -d "$tree/$LIB/libode.so.8" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')" libode.so.8
expect "precision" "$(PKG_CONFIG_PATH=$headers/$LIB/pkgconfig pkg-config --variable=precision ode | tr '[:upper:]' '[:lower:]')" "d$PRECISION"
PKG_CONFIG_PATH=$headers/$LIB/pkgconfig pkg-config --validate ode
expect "flags" "$(PKG_CONFIG_PATH=$headers/$LIB/pkgconfig pkg-config --libs --define-variable=prefix=/usr ode)" \
    "$(PKG_CONFIG_PATH=$headers/$LIB/pkgconfig pkg-config --libs-only-l ode)" # no folder but the system's
if [ "$PRECISION" = double ]; then
    if readelf -d "$(unpacked libode-mt-tools)"/usr/bin/* | grep -E 'R(UN)?PATH'; then fail "a tool looks for libraries in a folder of its own"; fi
    [ -f "$(unpacked libode-mt-tools)/usr/share/ode_mt/worlds/create.sdf" ] || fail "no worlds"
    [ -f "$(unpacked libode-mt-tools)/$LIB/ode_mt/libodemt_observer.so" ] || fail "no observer for odemt_check"
    for program in odemt_scale odemt_scale_child; do [ -x "$(unpacked libode-mt-tools)/usr/bin/$program" ] || fail "no $program"; done
    [ -f "$(unpacked libode-mt-doc)/usr/share/doc/libode-mt-doc/docs/README.md" ] || fail "no documentation"
fi
if [ -n "${MPIRUN:-}" ]; then
    expect "files of libode-mt-mpi" "$(echo $(ours libode-mt-mpi))" "usr/bin/odemt_worker $LIB/ode_mt/libode_mt_mpi.so"
    for file in usr/bin/odemt_worker "$LIB/ode_mt/libode_mt_mpi.so"; do
        if readelf -d "$(unpacked libode-mt-mpi)/$file" | grep -E 'R(UN)?PATH'; then fail "$file looks for libraries in a folder of its own"; fi
    done
fi
