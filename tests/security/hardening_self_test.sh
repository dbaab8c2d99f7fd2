#!/bin/sh
# The check of hardening fails for a library or a program in which one property is missing, and names it.
# Its environment: CC, a C compiler; SCRATCH, a folder for files of this test.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
fail() { echo "FAILED: $*" >&2; exit 1; }

cat >"$SCRATCH/source.c" <<'END'
#include <stdio.h>
int print(const char *format, int number) {
    char text[64];
    snprintf(text, sizeof text, format, number);
    return puts(text);
}
int main(void) { return print("%d", 1) < 0; }
END

compile='-O2 -fPIC -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2'
link='-Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack -Wl,-z,text'
library='-shared -Wl,-soname,libhardened.so.1'
program='-pie'
export COMPILED=1 FORTIFIED=1

# check KIND OPTION...: the answer of the check for what these options, after all of the right ones, give.
check() {
    kind=$1
    shift
    # shellcheck disable=SC2086  # options are words
    if [ "$kind" = library ]; then set -- $library "$@"; else set -- $program "$@"; fi
    # shellcheck disable=SC2086
    "$CC" $compile "$SCRATCH/source.c" -o "$SCRATCH/file" $link "$@"
    sh "$here/hardening.sh" "$SCRATCH/file" 2>"$SCRATCH/answer"
}
must_name() {
    what=$1
    shift
    if check "$@"; then fail "passes: $*"; fi
    grep -q -e "$what" "$SCRATCH/answer" || fail "$* is not named $what: $(cat "$SCRATCH/answer")"
    [ "$(wc -l <"$SCRATCH/answer")" = 1 ] || fail "$* is named other things, too: $(cat "$SCRATCH/answer")"
}

for kind in library program; do
    check "$kind" || fail "a hardened $kind does not pass: $(cat "$SCRATCH/answer")"
    must_name '-z relro' "$kind" -Wl,-z,norelro
    must_name '-z now' "$kind" -Wl,-z,lazy
    must_name '-z noexecstack' "$kind" -Wl,-z,execstack
    must_name '-fstack-protector-strong' "$kind" -fno-stack-protector
    must_name 'snprintf unchecked' "$kind" -U_FORTIFY_SOURCE
done
must_name 'looks for others in /somewhere' library -Wl,-rpath,/somewhere
must_name 'depends on where it runs' program '-Wl,-rpath,$ORIGIN/lib'
must_name 'depends on where it runs' program -Wl,-rpath,/somewhere::/else
must_name '-pie' program -no-pie
