#!/bin/sh
# build.sh RELEASE: builds the library alone of another upstream release. Environment (CMakeLists.txt):
#   CMAKE   cmake                  BUILD    the folder to build in
#   SOURCE  the repository         OPTIONS  of cmake
set -eu
release=$1
# Not optimised as a whole, which takes a seventh of the time and changes no bit: where the release is the system's own, all tests are of such a library.
"$CMAKE" -S "$SOURCE" -B "$BUILD" $OPTIONS -DODE_MT_UPSTREAM="$release" -DODE_MT_LTO=OFF -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF
"$CMAKE" --build "$BUILD" --parallel 2 --target ode
