#!/bin/sh
# The names and values of the library's variables are the same, in the same order, where they are read (dxEnvironment.cpp), in the table of
# docs/settings.md and in ode_MT.h; no other page has a table of them; nothing in ode_mt/ reads the environment by another way; and each
# setter of ode_MT.h is in that table.
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
table=$(sed -n 's/^| `\(ODE_MT_[A-Z_]*=[^`]*\)` |.*/\1/p' docs/settings.md | tr -d '\\')
[ "$table" = "$code" ] || fail "docs/settings.md has
$table
and dxEnvironment.cpp
$code"
if grep -lE '^\| `ODE_MT_[A-Z_]*=' README.md CONTRIBUTING.md docs/*.md | grep -v '^docs/settings.md$'; then fail "a second table of variables"; fi
for setter in $(sed -n 's/^ODE_API .*\b\(dODE_MT_Set[A-Za-z]*\)(.*/\1/p' include/ode/ode_MT.h); do
    grep -q "^|.*\`$setter\`" docs/settings.md || fail "docs/settings.md has no $setter"
done
# What the library leaves to others is read there.
others=$(sed -n '/kVariablesOfOthers\[\]/,/};/p' ode_mt/core/dxEnvironment.cpp | grep -oE '"ODE_MT_[A-Z_]+"' | tr -d '"')
[ "$(echo "$others" | wc -l)" -ge 5 ] || fail "no kVariablesOfOthers in dxEnvironment.cpp"
for other in $others; do
    grep -rqE "(env|environment|Environment)\(.*\"$other\"|\\\$\{$other|$other=" worlds tests/run tests --include=run --include='*.cpp' --include='*.h' --include='*.sh' ||
        fail "nothing reads $other, which dxEnvironment.cpp leaves to others"
done
for name in $(grep -rhoE '(env|Environment)\([^)]*"ODE_MT_[A-Z_]+"' worlds tests --include='*.cpp' --include='*.h' | grep -oE 'ODE_MT_[A-Z_]+'); do
    echo "$code $others" | grep -qE "\b$name\b" || fail "$name is read in worlds/ or tests/, and the library would report it: kVariablesOfOthers of dxEnvironment.cpp"
done
# But for MPI's variables, the system's, and those of the worker, which is a program.
if grep -rnE '\bgetenv *\(' ode_mt | grep -vE '^ode_mt/remote/(mpi|worker)/'; then fail "read past the table"; fi
if grep -rnE '\bgetenv *\("ODE_MT' ode_mt; then fail "read past the table"; fi
[ "$(grep -rlE 'secure_getenv *\(' ode_mt)" = ode_mt/core/dxEnvironment.cpp ] || fail "read past the table"
