#!/bin/sh
# Builds the library in another folder and compares it with the first build ($FIRST; empty: that is built here, too).
set -eu

fail() {
    echo "$*" >&2
    exit 1
}

# build FOLDER: the libraries lie in FOLDER/lib then.
build() {
    mkdir -p "$1.source"
    for part in CMakeLists.txt ode ode_mt include; do
        cp -R "$SOURCE/$part" "$1.source/"
    done
    "$CMAKE" -G "$GENERATOR" -S "$1.source" -B "$1" $OPTIONS -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF \
        -DCMAKE_C_COMPILER="$C_COMPILER" -DCMAKE_CXX_COMPILER="$CXX_COMPILER" \
        -DCMAKE_C_FLAGS="$C_FLAGS" -DCMAKE_CXX_FLAGS="$CXX_FLAGS" \
        -DCMAKE_C_COMPILER_LAUNCHER= -DCMAKE_CXX_COMPILER_LAUNCHER= > "$1.log" 2>&1 || { cat "$1.log"; exit 1; }
    "$CMAKE" --build "$1" --parallel "$JOBS" --target ode ode_static > "$1.log" 2>&1 || { tail -n 50 "$1.log"; exit 1; }
}

# Names of upstream's files in the texts of assertions. What lies before a text in memory may look like a part of it.
assertion_files() {
    objcopy -O binary --only-section=.rodata "$1" "$SCRATCH/texts"
    strings -a "$SCRATCH/texts" | grep -v ode_mt/ | grep -oE '(\.\./)*[a-z][a-z0-9_/]*\.(cpp|h)$' | sort -u
}

rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
build "$SCRATCH/a_folder_with_a_longer_name"
second="$SCRATCH/a_folder_with_a_longer_name/lib"
if [ -z "$FIRST" ]; then
    build "$SCRATCH/first"
    FIRST="$SCRATCH/first/lib"
fi

for library in libode.so.8 libode.a; do
    cmp "$FIRST/$library" "$second/$library" || fail "$library is not the same in another folder"
    ! strings -a "$second/$library" | grep -F -m 5 "$SCRATCH" || fail "$library names the folder that it was built in"
done
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
