#!/bin/sh
# The installed tree is used by way of pkg-config, shared and static.
. "$(dirname "$0")/expect.sh"
pkg-config --validate ode || fail "ode.pc is not valid"
expect "version" "$(pkg-config --modversion ode)" "$VERSION"
expect "precision" "$(pkg-config --variable=precision ode)" "$PRECISION"

# One field a line; the values of those that may differ (folders, private libraries) removed.
fields() {
    sed -n -e 's/^\([a-z_]*=\).*/\1/p' -e 's/^\(Libs.private:\).*/\1/p' -e '/^Libs.private/!{/^[A-Z]/p}' "$1"
}
debian_pc=$DEBIAN/pkgconfig/ode.pc
expect "list of fields of ode.pc" "$(fields "$PKG_CONFIG_PATH/ode.pc")" "$(fields "$debian_pc")"

shared=$(pkg-config --cflags --libs ode)
# Both libraries are installed side by side: the static one is asked for by its file name.
static=$(pkg-config --static --cflags --libs ode | sed 's/-lode\>/-l:libode.a/')
"$CC" "$here/stacks.c" -o "$SCRATCH/pkg_c" $shared
"$CXX" "$here/stacks_odecpp.cpp" -o "$SCRATCH/pkg_odecpp" $shared
"$CC" "$here/stacks.c" -o "$SCRATCH/pkg_c_static" $static
"$CXX" "$here/stacks_odecpp.cpp" -o "$SCRATCH/pkg_odecpp_static" $static

for program in pkg_c_static pkg_odecpp_static; do
    expect_static "$SCRATCH/$program"
    expect_state "$SCRATCH/$program"
    expect_state env ODE_MT_THREADS=2 ODE_MT_ALGORITHM=lcp "$SCRATCH/$program"
done
export LD_LIBRARY_PATH="$prefix/$LIBDIR"
for program in pkg_c pkg_odecpp; do
    expect_library "$SCRATCH/$program" "$LD_LIBRARY_PATH"
    expect_state "$SCRATCH/$program"
done
