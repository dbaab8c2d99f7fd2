#!/bin/sh
# A program that knows nothing of the timeline writes one: by the environment, and by odemt_bench --trace.
# Its environment: BENCH, CHILD, LIBRARY_DIR, PYTHON, SCRATCH.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
fail() { echo "FAILED: $*" >&2; exit 1; }
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
cd "$SCRATCH"

# check FILE STEPS NAME...
check() { "$PYTHON" "$here/check_trace.py" "$@" || fail "$1"; }

# run WORLD FRAMES FILE VARIABLE...
run() {
    world=$1 frames=$2 file=$3
    shift 3
    echo "{\"frames\":$frames}" | env "$@" ODE_MT_TRACE="$file" LD_LIBRARY_PATH="$LIBRARY_DIR" "$CHILD" --world "$world" 2>"errors" |
        sed -n 's/.*"hash":"\([0-9a-f]*\)".*/\1/p'
}

stages="collide near-callbacks step pairs islands contacts rows threads"
serial=$(run pile:200 60 serial.json ODE_MT_THREADS=0)
# shellcheck disable=SC2086  # names are words
check serial.json 60 $stages "island search" "islands in order" "broad phase"
run ragdolls:8 40 islands.json ODE_MT_THREADS=0 >/dev/null
# shellcheck disable=SC2086
check islands.json 40 $stages island solver
shared=$(run pile:200 80 shared.json ODE_MT_THREADS=2 ODE_MT_ALGORITHM=lcp)
# shellcheck disable=SC2086
check shared.json 80 $stages "island search" "broad phase" "narrow-phase prefetch" boxes
[ -n "$serial" ] && [ -n "$shared" ] || fail "no state: $(cat errors)"
[ "$serial" = "$(run pile:200 60 "" ODE_MT_THREADS=0)" ] || fail "another state than without a trace"

# A file that cannot be written is reported, and the program goes on.
bad=$(echo '{"frames":60}' | ODE_MT_TRACE=/nonexistent/trace.json LD_LIBRARY_PATH="$LIBRARY_DIR" "$CHILD" --world pile:200 2>bad.errors)
case $bad in *"$serial"*) ;; *) fail "another state without a file" ;; esac
grep -q "the trace '/nonexistent/trace.json' cannot be written: No such file or directory" bad.errors || fail "$(cat bad.errors)"

"$BENCH" --worlds stacks:3,rover --engines ours:0,ours:2/lcp --frames 40 --warm-up 0 --seconds 5 --json bench.json --csv bench.csv \
    --trace bench/trace.json >bench.out 2>&1 || fail "$(cat bench.out)"
for name in stacks-3-ours-0 stacks-3-ours-2-lcp rover-ours-0 rover-ours-2-lcp; do
    [ -s "bench/trace-$name.json" ] || fail "no bench/trace-$name.json: $(ls bench)"
    "$PYTHON" -c 'import json, sys; json.load(open(sys.argv[1]))' "bench/trace-$name.json" || fail "$name"
done
