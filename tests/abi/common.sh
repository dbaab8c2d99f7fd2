# Read by the scripts beside it. Their environment (tests/abi/CMakeLists.txt):
#   DEBIAN   Debian's libode.so.8       OURS     our libode.so.8
#   HEADERS  our public headers         SCRATCH  a folder for files of these tests
#   CC       the C compiler
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$SCRATCH"

fail() { echo "FAILED: $*" >&2; exit 1; }

# symbols LIBRARY: what it exports without C++ mangling, one line each: name, type, and for data the size.
symbols() {
    readelf --dyn-syms --wide "$1" | awk '$7 != "UND" && $5 != "LOCAL" && $8 !~ /^_Z/ && $1 ~ /^[0-9]+:$/ {
        print $8, $4, ($4 == "OBJECT" ? $3 : "") }' | sort
}
