#!/bin/sh
# The library and the tools are hardened as ode/hardening.cmake says: hardening.sh FILE... reads each property off
# the file itself. Its environment:
#   COMPILED   1: built with ODE_MT_HARDENING; 0: only the linker's part is checked
#   FORTIFIED  1: copies are checked, too (not in Debug)
# A shared library may have no path to look for libraries in; programs, which stay in the build folder, only whole ones.
set -eu
failures=0
complain() { echo "FAILED: $file: $*" >&2; failures=1; }

# has WORD TEXT: whether a line of TEXT matches WORD.
has() { printf '%s\n' "$2" | grep -qE "$1"; }

for file in "$@"; do
    dynamic=$(readelf --wide --dynamic "$file")
    segments=$(readelf --wide --program-headers "$file")
    imports=$(readelf --wide --dyn-syms "$file" | awk '$7 == "UND" { sub(/@.*/, "", $8); print $8 }')

    has ' GNU_RELRO ' "$segments" || complain "no part of it is made read-only after relocation (-z relro)"
    has 'BIND_NOW|Flags:.* NOW' "$dynamic" || complain "functions are bound when first called (-z now)"
    has ' GNU_STACK .* RW ' "$segments" || complain "its stack may hold code (-z noexecstack)"
    if has 'TEXTREL' "$dynamic"; then complain "its code is written to by relocation (-z text)"; fi
    path=$(printf '%s\n' "$dynamic" | sed -n 's/.*(R\(UN\)\{0,1\}PATH).*\[\(.*\)\]/\2/p')
    if has 'SONAME' "$dynamic"; then
        [ -z "$path" ] || complain "a library looks for others in $path"
    elif [ -n "$path" ] && has '^([^/]|:|$)|:([^/]|:|$)' "$path"; then
        complain "looks for libraries in $path, of which a part depends on where it runs"
    fi
    if ! has 'SONAME' "$dynamic" && ! has 'Flags:.* PIE' "$dynamic"; then complain "its place in memory is fixed (-pie)"; fi

    if [ "$COMPILED" = 1 ]; then
        has '^__stack_chk_fail$' "$imports" || complain "no function watches its stack (-fstack-protector-strong)"
        # Every unit that the compiler wrote into the debug information says with which options.
        # Only the exact step's solves are left out (ode_mt/dynamics/world_step/kernels/CMakeLists.txt).
        bare=$(readelf --debug-dump=info --dwarf-depth=1 "$file" 2>/dev/null | awk '
            /DW_AT_producer/ { options = $0 }
            /DW_AT_name/ && options ~ /GNU C(\+\+)?[0-9]/ {
                if (options !~ /-fstack-protector-strong/ || options ~ /-fno-stack-protector/) print $NF
                options = "" }' | grep -vcE 'ode_mt/dynamics/world_step/(kernels/[^/]*|exact/dxForwardSolves)\.cpp$' || true)
        [ "$bare" = 0 ] || complain "$bare units are compiled without -fstack-protector-strong"
    fi
    if [ "$FORTIFIED" = 1 ]; then
        # Of functions with a checked variant those that every compiler calls by it where it is asked for. Not vsnprintf:
        # std::to_string of a double hands it on by its address, which has no checked variant.
        unchecked=$(printf '%s\n' "$imports" | grep -xE '(f|s|sn|d|v|vf|vs|vd)?printf|longjmp|siglongjmp' | tr '\n' ' ')
        [ -z "$unchecked" ] || complain "calls ${unchecked}unchecked (-D_FORTIFY_SOURCE=2)"
    fi
done
exit "$failures"
