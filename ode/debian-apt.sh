# For scripts that read Debian's package archives without root and without a change in /etc: sourced, not run.
#
#   open_archive SUITE   Copies the system's package sources into a private folder, with sources and for the Debian release SUITE (the
#                        system's own for "") in place of its own, and reads their lists. Fails where there is no apt-get.
#   in_archive COMMAND   Runs apt-get or apt-cache on those lists: in_archive apt-get source ode.
#
# The folder, $archive_folder, goes when the script ends.

archive_folder=$(mktemp -d)
trap 'rm -rf "$archive_folder"' EXIT

open_archive() {
    command -v apt-get >/dev/null || { echo "apt-get is not installed" >&2; return 1; }
    own=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
    to_suite="s/\<${own:-none}\>/${1:-$own}/g"
    rm -rf "$archive_folder/sources" "$archive_folder/lists"
    mkdir -p "$archive_folder/sources" "$archive_folder/lists/partial"
    for list in /etc/apt/sources.list.d/*.sources; do
        [ -f "$list" ] || continue
        sed -e 's/^Types:.*/Types: deb deb-src/' -e "/^Suites:/$to_suite" "$list" >"$archive_folder/sources/${list##*/}"
    done
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -f "$list" ] || continue
        sed -n -e "$to_suite" -e '/^deb[[:space:]]/p' -e 's/^deb[[:space:]]/deb-src /p' "$list" \
            >"$archive_folder/sources/system-${list##*/}"
    done
    in_archive apt-get update
}

# Installed packages play no part: another Debian release's are read, too.
in_archive() {
    tool=$1
    shift
    : >"$archive_folder/status"
    "$tool" -qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$archive_folder/sources" \
        -o Dir::State::lists="$archive_folder/lists" -o Dir::State::status="$archive_folder/status" \
        -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=root "$@"
}
