#!/bin/sh
# The OpenMP runtime is loaded only where its threads are asked for, and where it cannot be loaded that is reported.
# Its environment: PROGRAM, settings_in_force; LIBRARY, ours; RUNTIME, the runtime's file name; SCRATCH, a folder for files of this test.
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH/broken"

if readelf -d "$LIBRARY" | grep NEEDED | grep -E 'omp'; then fail "the library is linked to an OpenMP runtime"; fi

# loads MANAGER: the program steps with two workers of it, and the dynamic loader tells what it maps.
loads() {
    LD_DEBUG=files ODE_MT_THREAD_MANAGER=$1 "$PROGRAM" 2>&1 >/dev/null | grep -q "file=$RUNTIME.*dynamically loaded by"
}
if loads pthread; then fail "$RUNTIME is loaded with the manager pthread"; fi
loads openmp || fail "$RUNTIME is not loaded with the manager openmp"

echo "no library" >"$SCRATCH/broken/$RUNTIME"
answer=$(LD_LIBRARY_PATH=$SCRATCH/broken ODE_MT_THREAD_MANAGER=openmp "$PROGRAM" 2>&1) || fail "without $RUNTIME: $answer"
echo "$answer" | grep -q "thread manager 'openmp' needs $RUNTIME, which cannot be loaded" || fail "the missing runtime is not reported: $answer"
case $answer in *"manager pthread at the end"*) ;; *) fail "without $RUNTIME the manager is not pthread: $answer" ;; esac
