#!/bin/sh
# Builds the library in another folder, as part of another project (FetchContent), and compares it with the first build ($FIRST; empty:
# that is built here, too, by itself).
set -eu

fail() {
    echo "$*" >&2
    exit 1
}

# configure_and_build SOURCE FOLDER TARGETS OPTION...
configure_and_build() {
    source=$1 folder=$2 targets=$3
    shift 3
    # shellcheck disable=SC2086  # options and targets are words
    "$CMAKE" -G "$GENERATOR" -S "$source" -B "$folder" $OPTIONS "$@" -DCMAKE_C_COMPILER="$C_COMPILER" -DCMAKE_CXX_COMPILER="$CXX_COMPILER" \
        -DCMAKE_C_FLAGS="$C_FLAGS" -DCMAKE_CXX_FLAGS="$CXX_FLAGS" \
        -DCMAKE_C_COMPILER_LAUNCHER= -DCMAKE_CXX_COMPILER_LAUNCHER= > "$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
    # shellcheck disable=SC2086
    "$CMAKE" --build "$folder" --parallel "$JOBS" --target $targets > "$folder.log" 2>&1 || { tail -n 50 "$folder.log"; exit 1; }
}

# build FOLDER: the libraries lie in FOLDER/lib then.
build() {
    mkdir -p "$1.source"
    for part in CMakeLists.txt LICENSE docs ode ode_mt include; do
        cp -R "$SOURCE/$part" "$1.source/"
    done
    configure_and_build "$1.source" "$1" "ode ode_static" -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF
}

# take_in FOLDER: the same, the libraries lie in FOLDER/_deps/ode_mt-build/lib.
take_in() {
    tar -C "$SOURCE" --exclude=ode/upstream -cf "$1.tar" CMakeLists.txt include ode ode_mt
    configure_and_build "$SOURCE/tests/reproducible/taken_in" "$1" "stacks stacks_static" \
        -DARCHIVE="$1.tar" -DSTACKS="$SOURCE/tests/consumer/stacks.c"
}

# Names of upstream's files in the texts of assertions. What lies before a text in memory may look like a part of it.
assertion_files() {
    objcopy -O binary --only-section=.rodata "$1" "$SCRATCH/texts"
    strings -a "$SCRATCH/texts" | grep -v ode_mt/ | grep -oE '(\.\./)*[a-z][a-z0-9_/]*\.(cpp|h)$' | sort -u
}

rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
take_in "$SCRATCH/a_folder_with_a_longer_name"
second="$SCRATCH/a_folder_with_a_longer_name/_deps/ode_mt-build/lib"
if [ -z "$FIRST" ]; then
    build "$SCRATCH/first"
    FIRST="$SCRATCH/first/lib"
fi

for library in libode.so.8 libode.a; do
    cmp "$FIRST/$library" "$second/$library" || fail "$library is not the same in another folder"
    ! strings -a "$second/$library" | grep -F -m 5 "$SCRATCH" || fail "$library names the folder that it was built in"
done
shared=$("$SCRATCH/a_folder_with_a_longer_name/stacks" | grep hash)
static=$("$SCRATCH/a_folder_with_a_longer_name/stacks_static" | grep hash)
[ "$shared" = "$static" ] || fail "programs of the project that took it in end in two states: $shared, $static"
if [ -n "$DEBIAN" ]; then
    assertion_files "$DEBIAN" > "$SCRATCH/debian"
    assertion_files "$second/libode.so.8" > "$SCRATCH/ours"
    [ "$(wc -l < "$SCRATCH/debian")" -gt 50 ] || fail "found few names of files in $DEBIAN"
    [ "$(wc -l < "$SCRATCH/ours")" -gt 40 ] || fail "found few names of files in libode.so.8"
    ! grep upstream "$SCRATCH/ours" || fail "assertions name the folder of upstream's files"
    while read -r name; do
        while read -r known; do
            case "$name" in *"$known") continue 2 ;; esac
        done < "$SCRATCH/debian"
        fail "no assertion of Debian's names $name"
    done < "$SCRATCH/ours"
fi
rm -rf "$SCRATCH"
