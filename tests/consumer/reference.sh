#!/bin/sh
# What the other tests expect: the final state of the program compiled against Debian's libode-dev and run
# on Debian's libode8. Debian has no library of single precision; there it is the state with our shared one.
. "$(dirname "$0")/expect.sh"
program=$SCRATCH/reference_program
if [ "$PRECISION" = dDOUBLE ]; then
    "$CC" -I/usr/include "$here/stacks.c" -o "$program" "$DEBIAN/libode.so.8"
    export LD_LIBRARY_PATH="$DEBIAN"
else
    echo "Debian has no libode of single precision to compare with."
    "$CC" -I"$prefix/include" "$here/stacks.c" -o "$program" "$prefix/$LIBDIR/libode.so"
    export LD_LIBRARY_PATH="$prefix/$LIBDIR"
fi
expect_library "$program" "$LD_LIBRARY_PATH"
"$program" | grep hash >"$SCRATCH/reference"
cat "$SCRATCH/reference"
