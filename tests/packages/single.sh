#!/bin/sh
# The packages of the single-precision library: names, files, what they say of others, and that dpkg refuses them beside those of the other
# precision. Made from a configured build without compiling: this build's library stands in for the single-precision one, of which nothing is
# looked at here but its name. A build of the preset `single` has the same tests with its own (docs/packages.md).
. "$(dirname "$0")/common.sh"
here=$(dirname "$0")
double=$SCRATCH/packages single=$SCRATCH.single
rm -rf "$single"
mkdir -p "$single"
"$CMAKE" -S "$SOURCE" -B "$single/build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DODE_MT_PRECISION=single -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF \
    -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" >"$single/log" 2>&1 || { cat "$single/log"; fail cmake; }
mkdir -p "$single/build/lib"
cp -P "$BUILD"/lib/libode* "$single/build/lib/"
# CPack builds nothing first where the generator is another one.
for script in build contents dependencies; do
    BUILD=$single/build SCRATCH=$single/scratch PRECISION=single MPIRUN= CPACK_OPTIONS="-D CPACK_CMAKE_GENERATOR=Ninja" sh "$here/$script.sh" || fail "$script.sh"
done

# refused FIRST SECOND: dpkg unpacks the one, and not the other beside it.
unpack() { dpkg --root="$root" --force-not-root --force-script-chrootless --no-triggers --unpack "$@" >"$single/dpkg" 2>&1; }
refused() {
    root=$single/root
    rm -rf "$root"
    mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
    : >"$root/var/lib/dpkg/status"
    unpack "$1" || { cat "$single/dpkg"; fail "dpkg does not unpack $1"; }
    ! unpack "$2" || fail "dpkg unpacks $2 beside $1"
    grep -q "conflict" "$single/dpkg" || { cat "$single/dpkg"; fail "no conflict of $2 with $1 is told"; }
}
for pair in "libode8-mt libode8sp-mt" "libode-mt-dev libode-sp-mt-dev"; do
    set -- $pair
    refused "$(echo "$double/$1"_*.deb)" "$(echo "$single/scratch/packages/$2"_*.deb)"
    refused "$(echo "$single/scratch/packages/$2"_*.deb)" "$(echo "$double/$1"_*.deb)"
done
rm -rf "$single"
