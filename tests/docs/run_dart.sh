#!/bin/sh
# The command of docs/start.md for DART, if python3-dartpy is installed: the same states on Debian's library and on ours, which
# DART does load: run_dart.sh LIBRARY_FOLDER
set -eu
cd "$(dirname "$0")/samples"
export PYTHONDONTWRITEBYTECODE=1 ODE_MT_LOG=info ODE_MT_ALGORITHM=lcp
dpkg-query -W python3-dartpy >/dev/null 2>&1 || { echo "skipped: python3-dartpy is not installed"; exit 77; }
/usr/bin/python3 -c "import dartpy"  # needs python3-numpy, which its package only recommends
grep dart_pile programs.sh | sed "s,/opt/ode_mt/lib auto 9,$1 2 2," | sh -e 2>errors.$$ && status=0 || status=$?
text=$(cat errors.$$)
rm -f errors.$$
echo "$text"
[ $status = 0 ] || exit $status
case $text in *"ODE_MT info: threads 2"*) ;; *) echo "FAILED: DART does not run on our library"; exit 1 ;; esac
