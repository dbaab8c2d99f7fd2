#!/bin/sh
# The installed tree is used by way of ode-config, which answers as Debian's does.
. "$(dirname "$0")/expect.sh"
ours=$prefix/bin/ode-config
debian=/usr/bin/ode-config
triplet=$(basename "$DEBIAN")

expect "version" "$("$ours" --version)" "$VERSION"
expect "prefix" "$("$ours" --prefix)" "$(readlink -f "$prefix")"
# Debian's answers begin with a prefix and its libraries lie in a folder named after the machine.
for options in --version "--prefix=/p --prefix" "--prefix=/p --exec-prefix" "--exec-prefix=/e --exec-prefix" \
    "--exec-prefix=/e --prefix=/p --prefix --exec-prefix" "--prefix=/p --cflags" "--prefix=/p --cflags --libs"; do
    answer=$("$debian" $options | sed "s,/lib/$triplet,/$LIBDIR,")
    expect "ode-config $options" "$("$ours" $options)" "$answer"
done
for options in "" --unknown; do
    if "$ours" $options 2>/dev/null; then fail "ode-config $options succeeds"; fi
    "$ours" $options 2>&1 >/dev/null | grep -q '^Usage: ode-config' || fail "ode-config $options shows no usage"
done

"$CC" $("$ours" --cflags) "$here/stacks.c" -o "$SCRATCH/config_c" $("$ours" --libs)
"$CXX" $("$ours" --cflags) "$here/stacks_odecpp.cpp" -o "$SCRATCH/config_odecpp" $("$ours" --libs)
export LD_LIBRARY_PATH="$prefix/$LIBDIR"
for program in config_c config_odecpp; do
    expect_library "$SCRATCH/$program" "$LD_LIBRARY_PATH"
    expect_state "$SCRATCH/$program"
done

# The line of docs/start.md as it is written, but for the folder, gives programs that run on ours without more.
unset LD_LIBRARY_PATH
cp "$here/stacks.c" "$here/stacks.h" "$SCRATCH"
cd "$SCRATCH"
line=$(grep '^cc program.c .*ode-config' "$here/../../docs/start.md" | sed "s,/opt/ode_mt/lib,$prefix/$LIBDIR,; s,/opt/ode_mt,$prefix,; s,^cc program.c,$CC stacks.c -o as_documented,")
eval "$line"
expect_library "$SCRATCH/as_documented" "$prefix/$LIBDIR"
expect_state "$SCRATCH/as_documented"
