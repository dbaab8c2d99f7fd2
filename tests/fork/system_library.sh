#!/bin/sh
# A libode.so.8 of the system's that is ODE_MT, by its file or a link, is not taken for upstream's: nothing would be compared but ours with ours.
# Environment: ODE, CMAKE, OURS and ORACLE (files of libode.so.8), VERSION (the release that ours is made of), SCRATCH.
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
cat >"$SCRATCH/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(system_library NONE)
include("$ODE/release.cmake")
message(STATUS "library (\${ODE_MT_SYSTEM_LIBRARY}) release (\${ODE_MT_SYSTEM_RELEASE}) fork of (\${ODE_MT_UPSTREAM})")
END
# seen FILE: what the build finds where this is the system's library, twice, as a build folder is configured again.
seen() {
    rm -rf "$SCRATCH/build"
    "$CMAKE" -S "$SCRATCH" -B "$SCRATCH/build" "-DODE_MT_SYSTEM_LIBRARY=$1" >"$SCRATCH/first" 2>&1 || fail "$(cat "$SCRATCH/first")"
    "$CMAKE" "$SCRATCH/build" 2>&1
}
ln -s "$OURS" "$SCRATCH/libode.so.8"
for ours in "$OURS" "$SCRATCH/libode.so.8"; do
    said=$(seen "$ours" | tr -s ' \n' ' ')
    case $said in *"$ours, is ODE_MT itself"*"library () release () fork of ($VERSION)"*) ;; *) fail "$said" ;; esac
done
said=$(seen "$ORACLE")
case $said in *"is ODE_MT"*) fail "$said" ;; *"library ($ORACLE) release ($VERSION) fork of ($VERSION)"*) ;; *) fail "$said" ;; esac
