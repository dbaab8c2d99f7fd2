#!/bin/sh
# The archive of all, unpacked anywhere, serves programs.
. "$(dirname "$0")/common.sh"
folder=$SCRATCH.archive
rm -rf "$folder"
mkdir -p "$folder"
(cd "$BUILD" && "$CPACK" -G TGZ -B "$folder/packed") >"$folder/log" 2>&1 || { cat "$folder/log"; fail cpack; }
tar -C "$folder" -xzf "$folder"/packed/*.tar.gz
set -- "$folder"/ode_mt-*
expect "number of folders in the archive" $# 1
prefix=$1
pc=$(find "$prefix" -name ode.pc)
# shellcheck disable=SC2046  # options are words
"$CC" "$(dirname "$0")/../consumer/stacks.c" -o "$folder/stacks" $(PKG_CONFIG_PATH=${pc%/*} pkg-config --cflags --libs ode)
LD_LIBRARY_PATH=${pc%/pkgconfig/ode.pc} "$folder/stacks"
rm -rf "$folder"
