#!/bin/sh
# Runs the command of docs/start.md with few boxes, if python3-pyode is installed: run_pile.sh LIBRARY_FOLDER
set -eu
cd "$(dirname "$0")/samples"
export PYTHONDONTWRITEBYTECODE=1
/usr/bin/python3 -c "import ode" 2>/dev/null || { echo "skipped: python3-pyode is not installed"; exit 77; }
sed "s,/opt/ode_mt/lib auto 9,$1 2 2,; s/1000 200/200 50/; /dart/d" programs.sh | sh -e
