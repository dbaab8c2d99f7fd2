#!/bin/sh
# CPack makes the packages, with the names and no others.
. "$(dirname "$0")/common.sh"
rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
# Quickly compressed: what is compressed does not depend on how well.
(cd "$BUILD" && "$CPACK" -G DEB ${CPACK_OPTIONS:-} -B "$SCRATCH/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip) >"$SCRATCH/log" 2>&1 || { cat "$SCRATCH/log"; fail cpack; }
for package in $packages; do
    [ -f "$(deb "$package")" ] || fail "no $package"
    mkdir -p "$(unpacked "$package")"
    dpkg-deb -x "$(deb "$package")" "$(unpacked "$package")"
done
# shellcheck disable=SC2086,SC2012  # packages are words, and names of files ours
expect "number of packages" "$(ls "$SCRATCH"/packages/*.deb | wc -l)" "$(echo $packages | wc -w)"
rm -rf "$SCRATCH/packages/_CPack_Packages"
