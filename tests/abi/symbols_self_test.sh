#!/bin/sh
# The comparison of symbols fails for libraries in which one thing is wrong.
. "$(dirname "$0")/common.sh"

# must_fail WHAT OURS: symbols.sh with OURS in place of our library fails and says why.
must_fail() {
    if OURS=$2 sh "$here/symbols.sh" >"$SCRATCH/answer" 2>&1; then fail "symbols.sh passes: $1"; fi
    grep -q "$1" "$SCRATCH/answer" || fail "symbols.sh does not name $1: $(cat "$SCRATCH/answer")"
}

stub() { "$CC" -shared -fPIC -x c - -o "$1"; }
# A library with all of Debian's C symbols as functions and data of the right size, then changed by `sed`.
imitate() {
    symbols "$DEBIAN" | sed "$2" | awk '
        $2 == "OBJECT" { print "char " $1 "[" $3 "] = {1};"; next } { print "void " $1 "(void) {}" }' | stub "$1"
}
imitate "$SCRATCH/missing.so" /^dWorldStep/d
must_fail "dWorldStep FUNC" "$SCRATCH/missing.so"
imitate "$SCRATCH/data.so" 's/^dWorldStep FUNC.*/dWorldStep OBJECT 8/'
must_fail "dWorldStep FUNC" "$SCRATCH/data.so"
symbols "$OURS" >"$SCRATCH/ours"
data=$(symbols "$DEBIAN" | awk -v ours="$SCRATCH/ours" 'BEGIN { while ((getline line < ours) > 0) { split(line, word); isOurs[word[1]] = 1 } }
    $2 == "OBJECT" && $1 in isOurs { print $1; exit }')
[ -n "$data" ] || fail "Debian's library and ours have no data in common"
imitate "$SCRATCH/size.so" "s/^$data OBJECT .*/$data OBJECT 999/"
must_fail "$data OBJECT" "$SCRATCH/size.so"
imitate "$SCRATCH/unfinished.so" ''
must_fail "dToggleODE_MT" "$SCRATCH/unfinished.so"
