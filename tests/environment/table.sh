#!/bin/sh
# The names and values of the library's variables are the same where they are read (dxEnvironment.cpp), in README.md,
# in docs/linking.md and in ode_MT.h, and nothing in ode_mt/ reads the environment by another way.
set -eu
cd "$(dirname "$0")/../.."
fail() { echo "FAILED: $*" >&2; exit 1; }
code=$(sed -n 's/^ *{"\(ODE_MT_[A-Z_]*\)", "\(.*\)"},$/\1=\2/p' ode_mt/core/dxEnvironment.cpp)
[ "$(echo "$code" | wc -l)" -ge 8 ] || fail "no table in dxEnvironment.cpp"
header=$(sed -n 's/^ \*   \(ODE_MT_[A-Z_]*=.*\)$/\1/p' include/ode/ode_MT.h)
[ "$header" = "$code" ] || fail "ode_MT.h has
$header
and dxEnvironment.cpp
$code"
for file in README.md docs/linking.md; do
    table=$(sed -n 's/^| `\(ODE_MT_[A-Z_]*=[^`]*\)` |.*/\1/p' "$file" | tr -d '\\')
    [ "$table" = "$code" ] || fail "$file has
$table
and dxEnvironment.cpp
$code"
done
rows() { grep '^| `ODE_MT_' "$1" | sed 's,(docs/,(,g'; }
[ "$(rows README.md)" = "$(rows docs/linking.md)" ] || fail "the tables of README.md and docs/linking.md differ"
if grep -rnE '\bgetenv *\(' ode_mt; then fail "read past the table"; fi
[ "$(grep -rlE 'secure_getenv *\(' ode_mt)" = ode_mt/core/dxEnvironment.cpp ] || fail "read past the table"
