#!/bin/sh
# Scenarios of the exactness suite with workers by MPI: what libode8 computes, step by step, is computed with 1, 2 and 4 of them, and with ones that
# this script kills, stops and continues while islands are sent; then workers that the program itself harms, and that are replaced (Open MPI).
#
#   MPIRUN, SCENARIO (odemt_scenario), LIBRARY (folder of libode.so.8), WORKER, STOCK (folder of libode8), FAULTS (odemt_worker_faults),
#   FLIPS (libodemt_flipped_bits.so), LAST_THREAD (last_thread_test), OWN_MPI (odemt_own_mpi), PIPE_END (odemt_pipe_end), SCRATCH
#
# By hand: WHOLE=1 compares every scenario of dWorldStep with 1, 2 and 4 workers, which takes an hour.
#
# Covers dxMpiTransport.cpp, dxOpenMpiTransport.cpp, dxPackedSolver.cpp, dxRemote.cpp, dxRemoteLoader.cpp, odemt_worker.cpp.
set -eu
export MALLOC_PERTURB_=165  # as in the exactness suite
here=$(cd "$(dirname "$0")" && pwd)
set -a; . "$here/../../bench/scale/mpi_environment"; set +a
STEPS=  # as many as the scenario has
LIMIT=100  # s
rm -rf "$SCRATCH"; mkdir -p "$SCRATCH"; cd "$SCRATCH"

# Where mpirun cannot start two processes (no network interface, no shared memory) there is nothing to compare.
if ! timeout 60 "$MPIRUN" -np 2 true > output 2>&1; then cat output; echo "skipped: mpirun does not work here"; exit 77; fi

# A job that goes on without a process that is killed: MPICH's mpiexec has an option for that, but ends all the same.
IS_OPEN_MPI=yes
case $("$MPIRUN" --version 2>&1) in
*"Open MPI) 4."* | *OpenRTE*) ALONE=--enable-recovery ;;
*"Open MPI"*) ALONE="--with-ft ulfm" ;;
*) ALONE=-disable-auto-cleanup IS_OPEN_MPI=no ;;
esac

# States of all stages; the line before them names the library.
states() { sed 's/.*"stages"://' "$1"; }

# Errors go into a pipe, as they do with mpirun: the record would have the text of a file.
of_stock() {  # SCENARIO
    name=$(echo "$1$STEPS" | tr '/ ' __)
    [ -f "$name.json" ] || LD_LIBRARY_PATH=$STOCK "$SCENARIO" "$1" $STEPS --record "$name.json" 2>&1 | grep -a '^ODE Message' > "$name.messages" || true
}

# What has just been run, as it is called, has left the states and messages of of_stock's scenario.
expect_same() {
    states ours.json > ours; states "$name.json" > stock
    cmp ours stock || { echo "$1 has other bits"; cat output; exit 1; }
    grep -a '^ODE Message' output | cmp - "$name.messages" || { echo "$1 has other messages"; cat output; exit 1; }
}

# SCENARIO WORKERS ALGORITHM [what to do meanwhile, a function that is given the workers' processes]
compare() {
    of_stock "$1"
    rm -f ours.json
    ODE_MT_WORKERS=mpi ODE_MT_LOG=info ODE_MT_ALGORITHM=$3 LD_LIBRARY_PATH=$LIBRARY JOB_OPTIONS=$ALONE timeout -k 5 $LIMIT \
        sh "$here/../../bench/scale/with_workers.sh" "$2" "$WORKER" "$SCENARIO" "$1" $STEPS --record ours.json > output 2>&1 &
    job=$!
    if [ $# -ge 4 ]; then "$4" $job; fi
    # Some scenarios end in an error, and so does mpirun then: what they have recorded is compared.
    wait $job || [ -n "${WHOLE:-}" ] || { echo "$1 with $2 workers: mpirun ended with $?"; cat output; exit 1; }
    expect_same "$1 with $2 workers"
    echo "$1, $2 workers: $(grep -o '[0-9]* islands sent.*' output)"
    if [ $# -lt 4 ] && ! grep -q '[1-9][0-9]* islands sent, [1-9]' output; then echo "nothing was solved elsewhere"; cat output; exit 1; fi
}

# Of the job, which is timeout, whose child is mpirun, which has a proxy in between if it is MPICH's.
workers_of() {
    for child in $(pgrep -P "$1"); do
        if [ "$(readlink "/proc/$child/exe")" = "$(realpath "$WORKER")" ]; then echo "$child"; else workers_of "$child"; fi
    done
}

# At most some seconds.
await_workers() {  # JOB COUNT
    for i in $(seq 200); do [ "$(workers_of "$1" | wc -l)" -ge "$2" ] && break; sleep 0.02; done
}

kill_one() {
    await_workers "$1" 1
    sleep 0.6
    victim=$(workers_of "$1" | head -1)
    [ -z "$victim" ] || kill -9 "$victim" || true
}

stop_one() {
    await_workers "$1" 1
    sleep 0.6
    victim=$(workers_of "$1" | head -1)
    [ -z "$victim" ] && return
    kill -STOP "$victim" || true
    sleep 0.5
    kill -CONT "$victim" 2> /dev/null || true
}

# Without mpirun MPI begins by a fork. Workers that the program starts are there, and without their program it stays at home.
alone() {  # SCENARIO LIBRARY WORKERS EXPECTED
    of_stock "$1"
    rm -f ours.json
    { ODE_MT_WORKERS=$3 ODE_MT_LOG=info ODE_MT_ALGORITHM=lcp LD_LIBRARY_PATH=$2 timeout -k 5 100 "$SCENARIO" "$1" $STEPS --record ours.json
      echo $? > status; } 2>&1 | cat > output  # a pipe, as for the other library
    [ "$(cat status)" = 0 ] || { echo "$1 without mpirun has not ended: $(cat status)"; cat output; exit 1; }
    expect_same "$1 without mpirun"
    grep -aq "$4" output || { echo "without mpirun, $3: no '$4'"; cat output; exit 1; }
}

if [ $IS_OPEN_MPI = yes ]; then
    alone joint_feedback/world "$LIBRARY" mpi "none by mpi: there is no other process in its job"
    alone joint_feedback/world "$LIBRARY" mpi:1 "[1-9][0-9]* islands sent, [1-9]"
    # Open MPI's own process must not read what the program's standard input holds, and may start more workers than there are cores.
    printf 'one\ntwo\n' | { alone joint_feedback/world "$LIBRARY" mpi:1 "[1-9][0-9]* islands sent, [1-9]"; cat > input; }
    printf 'one\ntwo\n' | cmp - input || { echo "the program's input is lost"; exit 1; }
    OMPI_MCA_rmaps_base_oversubscribe=0 alone joint_feedback/world "$LIBRARY" mpi:5 "remote workers: 5 of 5"
    # Each worker is a job of its own, which Open MPI would bind to the first core.
    ODE_MT_WORKERS=mpi:2 LD_LIBRARY_PATH=$LIBRARY timeout -k 5 60 "$SCENARIO" shared_scenes/humanoids/world --steps 100000 > output 2>&1 &
    job=$!
    await_workers $job 2
    sleep 0.5  # some time after MPI has begun in them
    processors=$(for worker in $(workers_of $job); do grep Cpus_allowed_list "/proc/$worker/status"; done | sort | uniq -c)
    kill $job; wait $job 2> /dev/null || true
    expected=$(printf '%7d %s' 2 "$(grep Cpus_allowed_list /proc/self/status)")
    [ "$processors" = "$expected" ] || { echo "workers have the processors '$processors', not '$expected'"; cat output; exit 1; }
    # MPI has threads of its own, which do not keep the process.
    status=0
    ODE_MT_WORKERS=mpi:2 LD_LIBRARY_PATH=$LIBRARY timeout -k 5 60 "$LAST_THREAD" main_thread_ends_with_remote_workers > output 2>&1 || status=$?
    [ "$status" = 7 ] || { echo "without mpirun and main thread, the process ends with $status"; cat output; exit 1; }
    for files in kept closed; do
        ODE_MT_WORKERS=mpi:1 ODE_MT_LOG=info LD_LIBRARY_PATH=$LIBRARY timeout -k 5 60 "$PIPE_END" $files > output 2>&1 ||
            { echo "the program's files, $files: $?"; cat output; exit 1; }
        grep -q "remote workers: 1 of 1" output || { echo "the program's files, $files: there is no worker"; cat output; exit 1; }
    done
    # Workers end before the program ends MPI.
    LD_LIBRARY_PATH=$STOCK timeout -k 5 60 "$OWN_MPI" close > stock
    for order in close leave finalise; do
        ODE_MT_WORKERS=mpi:1 ODE_MT_ALGORITHM=lcp ODE_MT_LOG=info LD_LIBRARY_PATH=$LIBRARY timeout -k 5 60 "$OWN_MPI" $order > ours 2> output ||
            { echo "a program with an MPI of its own, $order: $?"; cat output; exit 1; }
        cmp ours stock || { echo "a program with an MPI of its own, $order, has other bits"; exit 1; }
        grep -q '[1-9][0-9]* islands sent, [1-9]' output || { echo "a program with an MPI of its own, $order: nothing was solved elsewhere"; cat output; exit 1; }
    done
    mkdir bare; cp "$LIBRARY/libode.so.8" "$LIBRARY/libode_mt_mpi.so" bare
    alone joint_feedback/world "$SCRATCH/bare" mpi:1 "none by mpi: there is no odemt_worker"
fi

# Also scenarios of which no island goes out.
whatever() { :; }

if [ -n "${WHOLE:-}" ]; then
    LIMIT=1000
    for scenario in $(LD_LIBRARY_PATH=$LIBRARY "$SCENARIO" --list 2> /dev/null | cut -f 1 | grep '/world$'); do
        for workers in 1 2 4; do compare "$scenario" $workers lcp whatever; done
    done
    exit 0
fi

for workers in 1 2 4; do
    compare shared_scenes/humanoids/world $workers lcp
done
compare many_rows/figures/world 2 lcp
compare messages/printed/world 2 lcp
compare float_environment/rounding/world 2 lcp
compare joint_feedback/world 2 lcp
STEPS="--steps 3000"  # still under way when a worker is harmed
if [ $IS_OPEN_MPI = yes ]; then
    compare shared_scenes/humanoids/world 2 lcp kill_one
    # Open MPI does not tell that a process is gone: it is late.
    grep -q 'late [1-9]\|[1-9] workers lost' output || { echo "no worker was missed"; cat output; exit 1; }
fi
compare shared_scenes/humanoids/world 2 lcp stop_one

# The program says how many steps had another hash; mpirun's status is 0 whatever becomes of it. Three times at most: Open MPI's own processes are
# not made for workers that are killed while they join.
harm() {
    ODE_MT_WORKERS=mpi:2 ODE_MT_LOG=info ODE_MT_ALGORITHM=lcp LD_PRELOAD=$FLIPS ODEMT_FAULT_TABLE=$SCRATCH/table LD_LIBRARY_PATH=$LIBRARY \
        timeout -k 5 60 "$MPIRUN" $ALONE -np 1 "$FAULTS" 8 1 20 > output 2>&1 || true
    grep -a 'faults (' output
}

if [ $IS_OPEN_MPI = yes ]; then
    harm || harm || harm || { echo "the program that harms its workers has not ended"; cat output; exit 1; }
    grep -aq '^[1-9].* faults (.*, 0 with another hash' output || { echo "workers that are harmed change bits, or none was harmed"; cat output; exit 1; }
fi
