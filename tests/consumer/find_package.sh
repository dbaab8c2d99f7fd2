#!/bin/sh
# The installed tree is used by way of CMake's find_package(ode), shared and static.
. "$(dirname "$0")/expect.sh"
build=$SCRATCH/find_package
"$CMAKE" -S "$here/find_package" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_CXX_COMPILER="$CXX" -DEXPECTED_PRECISION="$PRECISION" -DEXPECTED_VERSION="$VERSION"
"$CMAKE" --build "$build"
for program in stacks_c stacks_odecpp; do
    expect_library "$build/$program" "$prefix/$LIBDIR"
    expect_state "$build/$program"
    expect_static "$build/${program}_static"
    expect_state "$build/${program}_static"
done
