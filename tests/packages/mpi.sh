#!/bin/sh
# Islands are solved by workers with the files of the packages alone: those of the job, and those that the program starts, which is found by the
# library; also in the tree that `cmake --install` makes, at another place. The state is that of a run without workers.
. "$(dirname "$0")/common.sh"
set -a; . "$(dirname "$0")/../../bench/scale/mpi_environment"; set +a
timeout 60 "$MPIRUN" -np 2 true >"$SCRATCH/mpi.log" 2>&1 || { cat "$SCRATCH/mpi.log"; skip "mpirun does not work here"; }
files=$(tree system "$library" "$development" libode-mt-mpi libode-mt-tools)
system=$files/usr
"$CC" "$(dirname "$0")/../consumer/stacks.c" -o "$SCRATCH/stacks" -I"$system/include" -L"$files/$LIB" -lode
export ODE_MT_LOG=info ODE_MT_ALGORITHM=lcp  # all islands go out

# solved LIBRARIES PATH WORKERS COMMAND...: some are solved elsewhere, and the state is the same.
solved() {
    libraries=$1 path=$2 workers=$3
    shift 3
    LD_LIBRARY_PATH=$libraries PATH=$path ODE_MT_WORKERS=$workers timeout -k 5 100 "$@" >"$SCRATCH/mpi.out" 2>"$SCRATCH/mpi.log" ||
        { cat "$SCRATCH/mpi.out" "$SCRATCH/mpi.log"; fail "$*"; }
    expect "state of $*" "$(grep hash "$SCRATCH/mpi.out")" "$alone"
    grep -q '[1-9][0-9]* islands sent, [1-9]' "$SCRATCH/mpi.log" || { cat "$SCRATCH/mpi.log"; fail "$*: nothing was solved elsewhere"; }
    echo "$workers: $(grep -o '[0-9]* islands sent.*' "$SCRATCH/mpi.log")"
}
alone=$(LD_LIBRARY_PATH=$files/$LIB "$SCRATCH/stacks" 2>/dev/null | grep hash)
with_workers=$(dirname "$0")/../../bench/scale/with_workers.sh
export MPIRUN
solved "$files/$LIB" "$system/bin:$PATH" mpi sh "$with_workers" 2 odemt_worker "$SCRATCH/stacks"
case $("$MPIRUN" --version) in
*"Open MPI"* | *OpenRTE*) solved "$files/$LIB" "$PATH" mpi:2 "$MPIRUN" -np 1 "$SCRATCH/stacks" ;;
esac

# Measures with a worker; what is predicted is for other tests.
(unset ODE_MT_LOG ODE_MT_ALGORITHM
 LD_LIBRARY_PATH=$files/$LIB PATH=$system/bin:$PATH odemt_scale --worlds humanoids:3 --seconds 0.2 --networks 1GbE --workers 2) >"$SCRATCH/mpi.out" 2>&1 ||
    { cat "$SCRATCH/mpi.out"; fail odemt_scale; }
grep -q '^humanoids:3: a frame takes' "$SCRATCH/mpi.out" || { cat "$SCRATCH/mpi.out"; fail "odemt_scale measures nothing"; }

# Gives programs a link to the library.
(unset ODE_MT_LOG
 LD_LIBRARY_PATH=$files/$LIB PATH=$system/bin:$PATH ODE_MT_WORKERS=mpi timeout -k 5 100 odemt_top --once -- \
     sh "$with_workers" 2 odemt_worker "$SCRATCH/stacks") >"$SCRATCH/mpi.out" 2>&1 || { cat "$SCRATCH/mpi.out"; fail odemt_top; }
grep -q 'remote workers: 2; solved' "$SCRATCH/mpi.out" || { cat "$SCRATCH/mpi.out"; fail "odemt_top shows no workers"; }

"$CMAKE" --install "$BUILD" --prefix "$SCRATCH.system/opt" >/dev/null
mv "$SCRATCH.system/opt" "$SCRATCH.system/moved"
moved=$SCRATCH.system/moved
libraries=$(dirname "$(find "$moved" -name libode.so.8)")
solved "$libraries" "$moved/bin:$PATH" mpi sh "$with_workers" 2 odemt_worker "$SCRATCH/stacks"
rm -rf "$SCRATCH.system"
