# Read by the scripts beside it. Their environment (tests/consumer/CMakeLists.txt):
#   SCRATCH    folder of these tests; SCRATCH/moved is the installed tree
#   CMAKE PYTHON CC CXX   the tools of this build
#   LIBDIR     where libraries are, relative to the installed tree
#   PRECISION  dDOUBLE or dSINGLE
#   VERSION    of ODE
#   DEBIAN     folder of Debian's libode.so.8
set -eu
here=$(cd "$(dirname "$0")" && pwd)
prefix=$SCRATCH/moved
export PKG_CONFIG_PATH="$prefix/$LIBDIR/pkgconfig"
unset LD_LIBRARY_PATH LIBRARY_PATH CPATH $(env | sed -n 's/^\(ODE_MT_[A-Z_]*\)=.*/\1/p')  # users set none of tests/run's

fail() { echo "FAILED: $*" >&2; exit 1; }
expect() { [ "$2" = "$3" ] || fail "$1 is '$2', expected '$3'"; }

# expect_library PROGRAM FOLDER: PROGRAM loads the libode.so.8 of FOLDER.
expect_library() {
    found=$(ldd "$1" | sed -n 's/.*libode\.so\.8 => \([^ ]*\) .*/\1/p')
    expect "libode.so.8 of $1" "$(readlink -f "$found")" "$(readlink -f "$2/libode.so.8")"
}

# expect_static PROGRAM: PROGRAM has the library in itself.
expect_static() {
    if readelf -d "$1" | grep -q libode; then fail "$1 needs a shared libode"; fi
}

# expect_state COMMAND...: it ends in the state of the reference program.
expect_state() {
    state=$("$@") || fail "$* ended with status $?"
    expect "final state of $*" "$(echo "$state" | grep hash)" "$(cat "$SCRATCH/reference")"
    echo "$*: $(echo $state)"
}
