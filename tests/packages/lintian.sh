#!/bin/sh
# lintian finds no error in the packages. Warnings are shown.
. "$(dirname "$0")/common.sh"
command -v lintian >/dev/null || skip "lintian is not installed"
lintian --allow-root --fail-on error --display-level ">=warning" "$SCRATCH"/packages/*.deb || fail "lintian finds errors"
