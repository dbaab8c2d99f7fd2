#!/bin/sh
# Runs the commands of docs/start.md against a tree that is installed for them: run_samples.sh BUILD SCRATCH LIBDIR
# The program must print the same with Debian's library and with ours, and say which one it runs with.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1 scratch=$2 libdir=$3
unset LD_LIBRARY_PATH PKG_CONFIG_PATH ODE_MT_THREADS ODE_MT_ALGORITHM
rm -rf "$scratch"
mkdir -p "$scratch"
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
cp "$here/samples/first_world.c" "$scratch"
cd "$scratch"
sed "s,/opt/ode_mt/lib,$scratch/prefix/$libdir,g" "$here/samples/start.sh" >start.sh
sh -e start.sh >out 2>log
cat out log
heights=$(grep -c '^height' out)
[ "$heights" -ge 4 ] || { echo "FAILED: $heights runs printed a height"; exit 1; }
[ "$(grep '^height' out | sort -u | wc -l)" = 1 ] || { echo "FAILED: the libraries gave other heights"; exit 1; }
grep -q "libode.so.8 => $scratch/prefix/" out || { echo "FAILED: the program does not run with our library"; exit 1; }
grep -q '^ODE_MT info: threads ' log || { echo "FAILED: ODE_MT_LOG=info did not tell the settings"; exit 1; }
