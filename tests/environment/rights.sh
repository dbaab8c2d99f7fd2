#!/bin/sh
# A program that runs with rights that its caller does not have (set-user-ID) reads none of the library's variables.
# Its environment: PROGRAM, settings_in_force; SCRATCH, a folder for files of this test.
set -eu
fail() { echo "FAILED: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $*"; exit 77; }

[ "$(id -u)" = 0 ] || skip "only root gives a program to another user"
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
cp "$PROGRAM" "$SCRATCH/own"
cp "$PROGRAM" "$SCRATCH/set_user_id"
chown nobody "$SCRATCH/set_user_id"
chmod u+s "$SCRATCH/set_user_id"

variables=$(sed -n 's/^ *{"\(ODE_MT_[A-Z_]*\)", ".*"},$/\1/p' "$(dirname "$0")/../../ode_mt/core/dxEnvironment.cpp" | grep -v ODE_MT_TRACE)  # a file may have any name
# run PROGRAM KIND: without variables (none), with values other than the defaults (set), with nonsense (wrong).
run() {
    case $2 in
        none) values= ;;
        set) values="ODE_MT_THREADS=3 ODE_MT_ALGORITHM=static ODE_MT_CALLBACKS=concurrent ODE_MT_HEURISTICS=cells
                     ODE_MT_GRID_CELLS=7 ODE_MT_THREAD_MANAGER=openmp ODE_MT_LOG=debug ODE_MT_TRACE=$SCRATCH/$1.trace ODE_MT_STATISTICS=$SCRATCH/none ODE_MT_PERTURB=1" ;;
        wrong) values="$(for name in $variables; do echo "$name=nonsense"; done) ODE_MT_THREAD=2" ;;
    esac
    # shellcheck disable=SC2086  # values are words
    env $values "$SCRATCH/$1" >"$SCRATCH/$1.$2" 2>"$SCRATCH/$1.$2.reported" || fail "$1 $2: $(cat "$SCRATCH/$1.$2.reported")"
}
for kind in none set wrong; do
    run own $kind
    run set_user_id $kind
done
case $(cat "$SCRATCH/set_user_id.none") in "secure 1 "*) ;; *) skip "this file system or process knows no set-user-ID" ;; esac

# The program's own caller sees every variable at work, so that the silence of the other says something.
settings() { head -n 1 "$SCRATCH/$1" | cut -d' ' -f3-; }
expected="threads 3 algorithm static callbacks concurrent heuristics cells cells 7 manager openmp"
case $(settings own.set) in "$expected") ;; *) fail "as itself it has: $(settings own.set)" ;; esac
for name in $variables; do
    grep -q "^.*$name is 'nonsense'" "$SCRATCH/own.wrong.reported" || fail "as itself it does not report $name"
done
grep -q "is ODE_MT_THREADS meant" "$SCRATCH/own.wrong.reported" || fail "as itself it does not report ODE_MT_THREAD"
[ -s "$SCRATCH/own.set.reported" ] || fail "ODE_MT_LOG=debug reports nothing"

[ -s "$SCRATCH/own.trace" ] || fail "ODE_MT_TRACE writes nothing"
[ ! -e "$SCRATCH/set_user_id.trace" ] || fail "with another user's rights it writes a file that its caller has named"

for kind in set wrong; do
    [ "$(settings set_user_id.$kind)" = "$(settings own.none)" ] ||
        fail "with another user's rights it has: $(settings set_user_id.$kind)"
    [ ! -s "$SCRATCH/set_user_id.$kind.reported" ] ||
        fail "with another user's rights it reports: $(cat "$SCRATCH/set_user_id.$kind.reported")"
done
