#!/bin/sh
# Every symbol that Debian's library exports under a C name is exported by ours with the same type and, for
# data, the same size. What ours adds is declared in ode_MT.h, and what that declares is there.
. "$(dirname "$0")/common.sh"

# Upstream's C++ variables: see suppressions.abignore.
internal='g_ccTrimeshCollidersCache\|g_VertFlag[A-Za-z]*Indices'

symbols "$DEBIAN" | grep -v "^\($internal\) " >"$SCRATCH/debian"
symbols "$OURS" >"$SCRATCH/ours"
count=$(wc -l <"$SCRATCH/debian")
[ "$count" -ge 600 ] || fail "only $count C symbols found in $DEBIAN"

missing=$(comm -23 "$SCRATCH/debian" "$SCRATCH/ours")
[ -z "$missing" ] || fail "missing in ours or of another type or size:
$missing"

comm -13 "$SCRATCH/debian" "$SCRATCH/ours" | cut -d ' ' -f 1 >"$SCRATCH/added"
grep -o 'ODE_API.*(' "$HEADERS/ode_MT.h" | sed 's/.*[ *]\(d[A-Za-z_0-9]*\)($/\1/' | sort >"$SCRATCH/declared"
diff "$SCRATCH/declared" "$SCRATCH/added" || fail "declared in ode_MT.h (<) and exported by ours alone (>) differ"

if nm -D --defined-only "$OURS" | grep ' _Z'; then fail "ours exports C++ internals"; fi
echo "$count C symbols of Debian's, $(wc -l <"$SCRATCH/added") of ours"
