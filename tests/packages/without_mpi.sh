#!/bin/sh
# Where CMake finds no MPI, all is configured, packed and installed but what needs it. As in single.sh nothing is compiled: this build's library
# stands in for the one without MPI.
. "$(dirname "$0")/common.sh"
folder=$SCRATCH.without_mpi
rm -rf "$folder"
mkdir -p "$folder"
"$CMAKE" -S "$SOURCE" -B "$folder/build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DODE_MT_PRECISION="$PRECISION" -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON \
    -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" >"$folder/log" 2>&1 ||
    { cat "$folder/log"; fail cmake; }
mkdir -p "$folder/build/lib"
cp -P "$BUILD"/lib/libode.* "$folder/build/lib/"
"$CMAKE" --install "$folder/build" --prefix "$folder/installed" >"$folder/log" 2>&1 || { cat "$folder/log"; fail "cmake --install"; }
[ -n "$(find "$folder/installed" -name libode.so.8)" ] || fail "no library is installed"
rest=$(find "$folder/installed" -name '*mpi*' -o -name 'odemt_worker*')
[ -z "$rest" ] || fail "installed without MPI: $rest"
(cd "$folder/build" && "$CPACK" -G DEB -B "$folder/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -D CPACK_CMAKE_GENERATOR=Ninja) >"$folder/log" 2>&1 ||
    { cat "$folder/log"; fail cpack; }
names=$(find "$folder/packages" -maxdepth 1 -name '*.deb' | sed 's/.*\///; s/_.*//' | sort)
expect "packages without MPI" "$(echo $names)" "$(echo "$development $library $library-dbgsym" | tr ' ' '\n' | sort | tr '\n' ' ' | sed 's/ $//')"
rm -rf "$folder"
