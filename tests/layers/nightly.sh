#!/bin/sh
# Each line of tests/nightly.txt names tests that exist: nightly.sh LIST BUILD_FOLDER CTEST REPOSITORY
# Skipped where one of the Debian packages that these tests need (.ci/packages.nightly) is missing, as some tests are then.
set -eu
missing=$("$4/.ci/missing" "$4/.ci/packages.nightly")
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
