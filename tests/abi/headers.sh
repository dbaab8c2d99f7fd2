#!/bin/sh
# Our headers are Debian's, byte by byte: so are all types and constants of the interface. The one exception,
# ode.h, has one line more; and there is one header more.
. "$(dirname "$0")/common.sh"
debian_headers=/usr/include/ode

names() { (cd "$1" && ls ./*.h); }
[ "$(names "$debian_headers" | wc -l)" -ge 25 ] || fail "no headers in $debian_headers: is libode-dev installed?"
added=$( (names "$debian_headers"; names "$HEADERS") | sort | uniq -u)
[ "$added" = ./ode_MT.h ] || fail "headers in one folder only: $added"
for header in $(names "$debian_headers"); do
    [ "$header" = ./ode.h ] || cmp "$debian_headers/$header" "$HEADERS/$header"
done
difference=$(diff "$debian_headers/ode.h" "$HEADERS/ode.h" | grep '^[<>]') || true
[ "$difference" = "> #include <ode/ode_MT.h>" ] || fail "ode.h differs otherwise: $difference"
