#!/bin/sh
# Run by mmdebstrap for the folder of a new system ($1): system.sh. Each step says what it is about to do.
. "$(dirname "$0")/common.sh"
root=$1
say() { echo "SYSTEM: $*"; }
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive "$@"; }
install() { inside apt-get -y --no-install-recommends --allow-downgrades install "$@" >"$SCRATCH/apt.log" 2>&1 || { cat "$SCRATCH/apt.log"; fail "apt-get install $*"; }; }
# What the packages of ODE have put into the system, and the loader's table.
state() {
    inside dpkg-query -W -f '${Package} ${Version} ${db:Status-Abbrev}\n'
    inside sh -c 'for package in '"$THEIRS"' libode-dev; do dpkg -L $package | while read -r file; do [ -f "$file" ] && sha256sum "$file"; done; done'
    inside ldconfig -p | grep libode
}
pendulums() { inside env "$@" python3 /root/pendulums.py; }

say "Debian's own packages"
state >"$SCRATCH/before"
expected=$(pendulums ODE_MT_THREADS=2)
debian=$(inside sha256sum "/$LIB/libode.so.8")

say "our library in the place of Debian's: whatever depends on that stays"
install "/packages/$(basename "$(deb libode8-mt)")"
[ "$(inside sha256sum "/$LIB/libode.so.8")" != "$debian" ] || fail "the library is Debian's"
for package in python3-pyode libode-dev libode8-mt; do
    expect "state of $package" "$(inside dpkg-query -W -f '${db:Status-Abbrev}' $package)" "ii "
done
inside dpkg --audit
expect "result with our library" "$(pendulums ODE_MT_THREADS=2 ODE_MT_ALGORITHM=lcp)" "$expected"
expect "result with one thread" "$(pendulums)" "$expected"
case $(pendulums ODE_MT_LOG=info 2>&1) in *ODE_MT*) ;; *) fail "python3-pyode does not run on our library" ;; esac
echo "$expected"

if [ -n "${MPIRUN:-}" ]; then
    say "islands solved by workers, with MPI from Debian's packages alone"
    install "/packages/$(basename "$(deb libode-mt-mpi)")"
    scale=$(dirname "$0")/../../bench/scale
    # shellcheck disable=SC2046  # variables without blanks
    job() { inside env $(grep -v "^#" "$scale/mpi_environment") ODE_MT_WORKERS=mpi ODE_MT_ALGORITHM=lcp "$@"; }
    cp "$scale/with_workers.sh" "$root/root/"
    job MPIRUN=mpirun ODE_MT_LOG=info timeout 100 \
        sh /root/with_workers.sh 2 odemt_worker python3 /root/pendulums.py >"$SCRATCH/job.out" 2>"$SCRATCH/job.log" ||
        { cat "$SCRATCH/job.out" "$SCRATCH/job.log"; fail "mpirun"; }
    expect "result with workers" "$(cat "$SCRATCH/job.out")" "$expected"
    grep '[1-9][0-9]* islands sent, [1-9]' "$SCRATCH/job.log" || { cat "$SCRATCH/job.log"; fail "nothing was solved elsewhere"; }
    inside apt-get -y purge --auto-remove libode-mt-mpi >/dev/null 2>&1
fi

say "Debian's programs that depend on $THEIRS accept ours"
users=$(inside apt-cache rdepends --no-recommends --no-suggests "$THEIRS" | sed -n 's/^  *//p' | grep -vx 'libode8.*\|libode-.*' | sort -u)
[ "$(echo "$users" | wc -l)" -ge 5 ] || fail "few programs depend on $THEIRS: $users"
# shellcheck disable=SC2086  # names are words
plan=$(inside apt-get --simulate --no-install-recommends install $users) || fail "$users cannot be installed with ours"
if echo "$plan" | grep -E "^(Remv|Inst $THEIRS )"; then fail "they want Debian's library"; fi
echo $users

say "our development package in the place of Debian's"
install "/packages/$(basename "$(deb libode-mt-dev)")"
inside test -f /usr/include/ode/ode_MT.h || fail "no ode_MT.h"
if inside dpkg-query -W -f '${db:Status-Abbrev}' libode-dev 2>/dev/null | grep -q ^ii; then fail "both development packages are installed"; fi

say "an upgrade to a later version"
for package in libode8-mt libode-mt-dev; do
    rm -rf "$SCRATCH/later"
    dpkg-deb -R "$(deb $package)" "$SCRATCH/later"
    sed -i "s/${VERSION}/${VERSION}.1/" "$SCRATCH/later/DEBIAN/control"
    dpkg-deb --root-owner-group -Znone -b "$SCRATCH/later" "$root/packages/later-$package.deb" >/dev/null
done
install /packages/later-libode8-mt.deb /packages/later-libode-mt-dev.deb
expect "version" "$(inside dpkg-query -W -f '${Version}' libode8-mt)" "$VERSION.1"
expect "result after the upgrade" "$(pendulums ODE_MT_THREADS=2)" "$expected"

say "Debian's own again"
install "$THEIRS" libode-dev
inside apt-get -y purge 'libode*-mt*' >/dev/null 2>&1 || true
state >"$SCRATCH/after"
# Of what our packages brought along some stays, which apt holds for wanted.
difference=$(diff "$SCRATCH/before" "$SCRATCH/after" | grep '^[<>]' | grep -v '^> [a-z0-9.+-]* [^ ]* ii *$' || true)
difference=$difference$(diff "$SCRATCH/before" "$SCRATCH/after" | grep '^> [^ ]*ode' || true)
[ -z "$difference" ] || fail "the system is not as it was: $difference"
expect "result with Debian's again" "$(pendulums)" "$expected"
left=$(inside find / -xdev \( -name '*ode_mt*' -o -name '*ode_MT*' -o -name 'libode*-mt*' \) -not -path '/proc/*' -not -path '/packages/*')
[ -z "$left" ] || fail "left behind: $left"

say "a new user's commands, without either library at first"
inside apt-get -y purge python3-pyode "$THEIRS" libode-dev >/dev/null 2>&1
cp "$(dirname "$0")/new_user.sh" "$(dirname "$0")/../docs/samples/pile.py" "$root/packages/"
rm -f "$root"/packages/later-*.deb
inside sh -c 'cd /packages && exec bash new_user.sh' >"$SCRATCH/user.log" 2>&1 || { cat "$SCRATCH/user.log"; fail "a command"; }
grep -E '^real|^user|^[0-9a-f]{64}$' "$SCRATCH/user.log"
expect "runs with the same result" "$(grep -E '^[0-9a-f]{64}$' "$SCRATCH/user.log" | sort | uniq -c | sed 's/^ *\([0-9]*\) .*/\1/')" 2
expect "state of libode8-mt" "$(inside dpkg-query -W -f '${db:Status-Abbrev}' libode8-mt)" "ii "
