#!/bin/sh
# A program compiled against Debian's libode-dev runs on our library without being linked again, on one
# thread and on two, and ends in the same state.
. "$(dirname "$0")/expect.sh"
"$CC" -I/usr/include "$here/stacks.c" -o "$SCRATCH/debian_c" "$DEBIAN/libode.so.8"
"$CXX" -I/usr/include "$here/stacks_odecpp.cpp" -o "$SCRATCH/debian_odecpp" "$DEBIAN/libode.so.8"
for program in debian_c debian_odecpp; do
    export LD_LIBRARY_PATH="$prefix/$LIBDIR"
    expect_library "$SCRATCH/$program" "$prefix/$LIBDIR"
    expect_state "$SCRATCH/$program"
    expect_state env ODE_MT_THREADS=2 "$SCRATCH/$program"
    expect_state env ODE_MT_THREADS=2 ODE_MT_ALGORITHM=lcp "$SCRATCH/$program"
    steps=$(echo "$state" | sed -n 's/^parallel steps //p')
    [ "$steps" -gt 0 ] || fail "no step of $program ran in parallel"
    export LD_LIBRARY_PATH="$DEBIAN"
    expect_library "$SCRATCH/$program" "$DEBIAN"
    expect_state "$SCRATCH/$program"
done
