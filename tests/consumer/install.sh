#!/bin/sh
# The build installs into a folder of its own, which is then moved: nothing in it may know where it was.
. "$(dirname "$0")/expect.sh"
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
DESTDIR="$SCRATCH/destination" "$CMAKE" --install "$BUILD" --prefix /opt/ode_mt >/dev/null
cp "$BUILD/install_manifest.txt" "$SCRATCH/"
[ -e "$SCRATCH/destination/opt/ode_mt/$LIBDIR/libode.so.8" ] || fail "nothing lies in DESTDIR"
# What was there before, and the folder of it, is kept; all else goes.
mkdir -p "$SCRATCH/destination/opt/ode_mt/bin"
touch "$SCRATCH/destination/opt/ode_mt/bin/another"
DESTDIR="$SCRATCH/destination" "$CMAKE" --build "$BUILD" --target uninstall >/dev/null || fail "uninstall ends with an error"
expect "files after uninstall" "$(cd "$SCRATCH/destination" && find . -type f)" ./opt/ode_mt/bin/another
expect "folders after uninstall" "$(cd "$SCRATCH/destination" && find . -type d -empty)" ""
if "$CMAKE" --build "$BUILD" --target uninstall >/dev/null 2>&1; then fail "what is removed can be removed again"; fi

"$CMAKE" --install "$BUILD" --prefix "$SCRATCH/installed" >/dev/null
mv "$SCRATCH/installed" "$prefix"

lib=$prefix/$LIBDIR
expect "SONAME" "$(readelf -d "$lib/libode.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')" libode.so.8
expect "libode.so.8" "$(readlink -f "$lib/libode.so.8")" "$(readlink -f "$lib/libode.so.$NUMBER")"
if readelf -d "$lib/libode.so" | grep -E 'R(UN)?PATH'; then fail "the library has a path in it"; fi
if grep -rI -e "$SCRATCH" -e "$BUILD" "$prefix/bin" "$prefix/include" "$lib/pkgconfig" "$lib/cmake"; then
    fail "an installed file knows a folder of this build"
fi
for header in "$BUILD"/include/ode/*.h; do
    cmp "$header" "$prefix/include/ode/${header##*/}"
done

# Libraries are stripped, and the debug symbols of the shared one lie where debuggers look for its build ID.
if readelf --sections --wide "$lib/libode.so.8" | grep -E ' \.(debug_info|symtab) '; then fail "libode.so.8 is not stripped"; fi
if readelf --sections --wide "$lib/libode.a" 2>/dev/null | grep -m 1 ' \.debug_info '; then fail "libode.a has debug information"; fi
id=$(readelf --notes "$lib/libode.so.8" | sed -n 's/.*Build ID: //p')
if [ -n "$id" ]; then
    symbols=$lib/debug/.build-id/$(echo "$id" | cut -c1-2)/$(echo "$id" | cut -c3-).debug
    readelf --sections --wide "$symbols" | grep -q ' \.debug_info ' || fail "there are no debug symbols in $symbols"
fi

# The programs find the library and the worlds from their own place.
if [ -x "$prefix/bin/odemt_info" ]; then
    "$prefix/bin/odemt_info" | grep -q "^library  *$(readlink -f "$lib/libode.so.8")$" || fail "odemt_info: $("$prefix/bin/odemt_info")"
    ODE_MT_THREADS=3 "$prefix/bin/odemt_info" --json | "$PYTHON" -c '
import json, sys
facts = json.load(sys.stdin)
assert facts["precision"] == "'"${PRECISION#d}"'".lower(), facts
assert facts["threads"] == 3 and facts["environment"] == {"ODE_MT_THREADS": "3"}, facts
for name in ("ODE_MT", "ODE", "upstream", "upstream sha256", "vectors", "cores", "thread manager", "algorithm", "solver"): assert facts[name], name'
    if "$prefix/bin/odemt_info" moon 2>/dev/null; then fail "odemt_info takes any option"; else expect "exit code" $? 2; fi
    [ -f "$lib/ode_mt/libodemt_observer.so" ] || fail "odemt_check has no observer"
    "$prefix/bin/odemt_check" -- sh -c true | grep -q "^No process of 'sh' was seen to use libode.so.8" || fail "odemt_check does not observe"
    printf '{"worlds": "chain:3", "frames": 1}' >plan.json
    "$prefix/bin/odemt_batch" plan.json -j1 --list | grep -q '"world":"chain:3"' || fail "odemt_batch does not read a plan"
    "$prefix/bin/odemt_top" --once -- true | grep -q "^No world was seen to be stepped" || fail "odemt_top does not run a program"
    "$prefix/bin/odemt_bench" --list | grep -q "^SDF worlds in $(readlink -f "$prefix")/share/ode_mt/worlds" || fail "odemt_bench finds other worlds"
fi
