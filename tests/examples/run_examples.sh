#!/bin/sh
# Each example is compiled without a warning, ends well, and prints the same with one thread and with several; the one in Python also
# on Debian's library. (many_worlds.cpp calls nothing of ODE_MT's either, but aborts there: libode8's steps of several threads share a queue.)
# Its environment:
#   EXAMPLES   folder of the examples             SCRATCH  a folder for files of this test
#   PREFIX     the installed tree                 LIBDIR   where libraries are in it
#   DEBIAN     folder of Debian's libode.so.8     CMAKE CC CXX   the tools of this build
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }
unset LD_LIBRARY_PATH
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"

for file in "$EXAMPLES"/*.c "$EXAMPLES"/*.cpp "$EXAMPLES"/*.py; do
    [ "$(wc -l <"$file")" -lt 120 ] || fail "$file has 120 lines or more"
    grep -q "\`${file##*/}\`" "$EXAMPLES/README.md" || fail "examples/README.md does not list ${file##*/}"
done

"$CMAKE" -S "$EXAMPLES" -B "$SCRATCH/build" -DCMAKE_PREFIX_PATH="$PREFIX" -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" \
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DCMAKE_BUILD_TYPE=Debug >"$SCRATCH/log" 2>&1 || { cat "$SCRATCH/log"; fail "cmake"; }
"$CMAKE" --build "$SCRATCH/build" --parallel "$(nproc)" >"$SCRATCH/log" 2>&1 || { cat "$SCRATCH/log"; fail "the examples do not compile"; }

# outcome FOLDER COMMAND...: what the command prints on the libode.so.8 of FOLDER.
outcome() {
    folder=$1
    shift
    LD_LIBRARY_PATH=$folder "$@" 2>"$SCRATCH/errors" || { cat "$SCRATCH/errors"; fail "$* ends with an error"; }
}
# compare COMMAND...: with one thread, with several.
compare() {
    alone=$(outcome "$PREFIX/$LIBDIR" env ODE_MT_THREADS=1 "$@")
    [ -n "$alone" ] || fail "$* prints nothing"
    for variables in "ODE_MT_THREADS=2 ODE_MT_ALGORITHM=lcp" "ODE_MT_THREADS=4 ODE_MT_ALGORITHM=lcp ODE_MT_THREAD_MANAGER=openmp" ODE_MT_THREADS=auto; do
        # shellcheck disable=SC2086  # variables are words
        [ "$(outcome "$PREFIX/$LIBDIR" env $variables "$@")" = "$alone" ] || fail "$* prints something else with $variables"
    done
    echo "$1: $(echo "$alone" | tail -n 1)"
}

for program in $(cd "$EXAMPLES" && ls ./*.c ./*.cpp | sed 's,^\./,,; s/\.[a-z]*$//'); do
    case $program in
        load_sdf)
            [ -x "$SCRATCH/build/load_sdf" ] || fail "TinyXML-2 was not found"
            compare "$SCRATCH/build/load_sdf" "$EXAMPLES/three_balls.sdf"
            if "$SCRATCH/build/load_sdf" /nowhere.sdf >/dev/null 2>&1; then fail "load_sdf succeeds without a world"; fi ;;
        *) compare "$SCRATCH/build/$program" ;;
    esac
done

# Debian's interpreter, which has Debian's packages.
python=/usr/bin/python3
if (cd / && "$python" -c 'import ode; ode.World()') 2>/dev/null; then
    compare "$python" "$EXAMPLES/pendulums.py"
    [ "$(outcome "$DEBIAN" "$python" "$EXAMPLES/pendulums.py")" = "$alone" ] || fail "pendulums.py prints something else on Debian's library"
else
    echo "pendulums.py skipped: python3-pyode is not installed"
fi
