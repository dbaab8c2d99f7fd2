#!/bin/sh
# with_workers.sh NUMBER WORKER PROGRAM ARGUMENTS...: a job of mpirun (MPIRUN, with the options JOB_OPTIONS) whose first process is the program and
# whose others are workers. Where mpirun cannot start two programs, as Open MPI 5 of Debian 13 (its issue 13303), each process chooses by its rank.
set -eu
number=$1 worker=$2
shift 2
# shellcheck disable=SC2086  # options are words
if timeout 60 "$MPIRUN" -np 1 true : -np 1 true </dev/null >/dev/null 2>&1; then  # mpirun reads its input ahead: the program's stays
    exec "$MPIRUN" ${JOB_OPTIONS:-} -np 1 "$@" : -np "$number" "$worker"
fi
exec "$MPIRUN" ${JOB_OPTIONS:-} -np "$((number + 1))" sh -c '[ "$OMPI_COMM_WORLD_RANK" != 0 ] || exec "$@"; exec "$0"' "$worker" "$@"
