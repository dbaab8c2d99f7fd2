#!/bin/sh
# build.sh RELEASE: builds the library alone of another upstream release. Environment (CMakeLists.txt):
#   CMAKE   cmake                  BUILD    the folder to build in
#   SOURCE  the repository         OPTIONS  of cmake
set -eu
release=$1
"$CMAKE" -S "$SOURCE" -B "$BUILD" $OPTIONS -DODE_MT_UPSTREAM="$release" -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF
"$CMAKE" --build "$BUILD" --parallel 2 --target ode
