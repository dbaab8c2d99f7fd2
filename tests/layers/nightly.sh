#!/bin/sh
# Each line of tests/nightly.txt names tests that exist: nightly.sh LIST BUILD_FOLDER CTEST PACKAGES
# Skipped where one of the Debian packages that these tests need (.ci/packages.nightly) is missing, as some tests are then.
set -eu
is_installed() { dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed; }
missing=$(grep -v '^#' "$4" | while IFS='|' read -r package alternative; do
    # shellcheck disable=SC2086  # names without blanks around them
    is_installed $package || { [ -n "$alternative" ] && is_installed $alternative; } || echo "$package"
done)
[ -z "$missing" ] || { echo "SKIPPED: not installed:" $missing && exit 77; }
tests=$("$3" --test-dir "$2" -N | sed -n 's/^ *Test *#[0-9]*: //p')
[ -n "$tests" ]
status=0
while read -r part names; do
    case $part in
    '#') continue ;;
    [0-9]) ;;
    *) echo "part $part is not one of 0 to 9" && status=1 && continue ;;
    esac
    echo "$tests" | grep -qE "$names" || { echo "no test is named $names" && status=1; }
done < "$1"
exit $status
