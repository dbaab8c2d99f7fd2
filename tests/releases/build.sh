#!/bin/sh
# build.sh RELEASE: builds the library alone of another upstream release. Environment (CMakeLists.txt):
#   CMAKE   cmake                  BUILD    the folder to build in
#   SOURCE  the repository         OPTIONS  of cmake
set -eu
release=$1
# Not optimised as a whole, and without debug information, which take a seventh and a third of the time and change no bit: where the release is the
# system's own, all tests are of such a library.
"$CMAKE" -S "$SOURCE" -B "$BUILD" $OPTIONS -DODE_MT_UPSTREAM="$release" -DODE_MT_LTO=OFF -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF \
    "-DCMAKE_C_FLAGS_RELWITHDEBINFO=-O2 -DNDEBUG" "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2 -DNDEBUG"
"$CMAKE" --build "$BUILD" --parallel 2 --target ode
