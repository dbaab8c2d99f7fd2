#!/bin/sh
# fetch-debian-source.sh SUITE ARCHIVE FILE: downloads the original archive of the Debian source package `ode`, which there has the name
# ARCHIVE, as FILE: from the system's own release of Debian, or else from SUITE.
set -eu
suite=$1 archive=$2 file=$3
. "$(dirname "$0")/debian-apt.sh"

for release in "" "$suite"; do
    open_archive "$release"
    # What Debian adds to the archive may be missing on a mirror: the archive alone counts.
    (cd "$archive_folder" && in_archive apt-get source --download-only ode) || true
    if [ -f "$archive_folder/$archive" ]; then
        cp "$archive_folder/$archive" "$file"
        exit
    fi
done
echo "no $archive there" >&2
exit 1
