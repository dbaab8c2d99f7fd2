#!/bin/sh
# In a Debian system of its own: our packages take the place of Debian's, a program of Debian's runs with them and computes the same,
# an upgrade works, and when they are removed and Debian's are installed again, the system is as it was. Then the commands of docs/start.md are
# run as by a new user.
. "$(dirname "$0")/common.sh"
command -v mmdebstrap >/dev/null || skip "mmdebstrap is not installed"
root=$SCRATCH/root
rm -rf "$root"
# apt's archive and lists are the system's own; a machine without network or rights has none.
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mmdebstrap --quiet --variant=apt --include="$THEIRS",libode-dev,python3-pyode \
    --customize-hook='cp "$EXAMPLES/pendulums.py" "$1/root/"' --customize-hook='mkdir "$1/packages" && cp "$SCRATCH"/packages/libode*.deb "$1/packages/"' \
    --customize-hook="sh '$(cd "$(dirname "$0")" && pwd)/system_steps.sh' \"\$1\"" --skip=cleanup/apt \
    "$suite" "$root.tar" >"$SCRATCH/system.log" 2>&1 && status=0 || status=$?
cat "$SCRATCH/system.log"
rm -rf "$root.tar"
[ $status = 0 ] && exit 0
grep -q '^SYSTEM: ' "$SCRATCH/system.log" || skip "mmdebstrap makes no system here"
fail "see above"
