#!/bin/sh
# fetch-debian-library.sh SUITE PACKAGE FOLDER: unpacks libode.so.8 of a Debian release's PACKAGE into FOLDER.
set -eu
suite=$1 package=$2 folder=$3
. "$(dirname "$0")/debian-apt.sh"

open_archive "$suite"
(cd "$archive_folder" && in_archive apt-get download "$package")
dpkg-deb --fsys-tarfile "$archive_folder/$package"_*.deb | tar -x -C "$archive_folder" --wildcards '*/libode.so.8*'
mkdir -p "$folder"
# The link comes last: whoever finds it finds the library.
cp -P "$archive_folder"/usr/lib/*/libode.so.8.* "$folder"
cp -P "$archive_folder"/usr/lib/*/libode.so.8 "$folder"
