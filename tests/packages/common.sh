# Read by the scripts beside it. Their environment (tests/packages/CMakeLists.txt):
#   BUILD      the build folder             SCRATCH  folder of these tests; SCRATCH/packages holds the packages
#   EXAMPLES   folder of the examples       LIB      folder of the system's libraries, without the leading slash
#   PRECISION  double or single             VERSION  of the packages
#   UPSTREAM   release of ODE               THEIRS   Debian's package of it
#   SOURCE     the repository               MPIRUN   that of the MPI for which there is a package; empty: there is none
#   CMAKE CPACK CC CXX   the tools of this build
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $*"; exit 77; }
expect() { [ "$2" = "$3" ] || fail "$1 is '$2', expected '$3'"; }

if [ "$PRECISION" = double ]; then
    library=libode8-mt development=libode-mt-dev
    packages="$library $library-dbgsym $development libode-mt-tools libode-mt-doc${MPIRUN:+ libode-mt-mpi}"
else
    library=libode8sp-mt development=libode-sp-mt-dev
    packages="$library $library-dbgsym $development"
fi
# deb PACKAGE: its file.
deb() { echo "$SCRATCH/packages/$1_${VERSION}"_*.deb; }
# unpacked PACKAGE: the folder of its files.
unpacked() { echo "$SCRATCH/unpacked/$1"; }
# tree NAME PACKAGE...: a folder with the files of these, as a system has them.
tree() {
    rm -rf "$SCRATCH.$1"
    mkdir -p "$SCRATCH.$1"
    for package in $(shift; echo "$@"); do cp -a "$(unpacked "$package")/usr" "$SCRATCH.$1/"; done
    echo "$SCRATCH.$1"
}
field() { dpkg-deb --field "$(deb "$1")" "$2"; }
