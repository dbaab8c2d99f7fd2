#!/bin/sh
# Builds the library in another folder, as part of another project (FetchContent), and compares it with the first build ($FIRST; empty:
# that is built here, too, by itself).
#
# All of it takes a quarter of an hour of a processor, so of each target's files only every tenth is compiled in the other folder, other ones
# each day, and libode.a made with the first build's objects of the others. libode.so.8 is not linked again, where the compiler optimises all
# once more, but must not name its folder, and all must have been compiled and linked with the same options. With ODE_MT_EXACTNESS=thorough,
# and where CMake writes no Makefiles, all is built.
set -eu

fail() {
    echo "$*" >&2
    exit 1
}

# configure SOURCE FOLDER OPTION...
configure() {
    source=$1 folder=$2
    shift 2
    # shellcheck disable=SC2086  # options are words
    "$CMAKE" -G "$GENERATOR" -S "$source" -B "$folder" $OPTIONS "$@" -DCMAKE_C_COMPILER="$C_COMPILER" -DCMAKE_CXX_COMPILER="$CXX_COMPILER" \
        -DCMAKE_C_FLAGS="$C_FLAGS" -DCMAKE_CXX_FLAGS="$CXX_FLAGS" \
        -DCMAKE_C_COMPILER_LAUNCHER= -DCMAKE_CXX_COMPILER_LAUNCHER= > "$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
}

# build FOLDER TARGET...
build() {
    folder=$1
    shift
    "$CMAKE" --build "$folder" --parallel "$JOBS" --target "$@" > "$folder.log" 2>&1 || { tail -n 50 "$folder.log"; exit 1; }
}

# build_first FOLDER: the libraries lie in FOLDER/lib then.
build_first() {
    mkdir -p "$1.source"
    for part in CMakeLists.txt LICENSE docs ode ode_mt include; do
        cp -R "$SOURCE/$part" "$1.source/"
    done
    configure "$1.source" "$1" -DODE_MT_BUILD_TESTS=OFF -DODE_MT_BUILD_BENCH=OFF
    build "$1" ode ode_static
}

# take_in FOLDER: the same; FOLDER/_deps/ode_mt-build is the library's build folder.
take_in() {
    tar -C "$SOURCE" --exclude=ode/upstream -cf "$1.tar" CMakeLists.txt include ode ode_mt
    configure "$SOURCE/tests/reproducible/taken_in" "$1" -DARCHIVE="$1.tar" -DSTACKS="$SOURCE/tests/consumer/stacks.c"
    [ -z "$lender" ] || lend_objects "$lender" "$SOURCE" "$1/_deps/ode_mt-build" "$1/_deps/ode_mt-src"
    # shellcheck disable=SC2086  # targets are words
    build "$1" $programs
}

# options FILE BUILD SOURCE: what a target's files are compiled with, or linked, a line each, without the folders' names. How many maps of names
# there are depends on where the folders lie, and whether objects stand on the command line or, where their names are long, in a file.
options() {
    sed -e 's|^# Custom \([a-z]*\): .*/CMakeFiles/|# \1: CMakeFiles/|' "$1" | tr ' ' '\n' | while IFS= read -r word; do
        case $word in
            @*) tr ' ' '\n' < "${1%/CMakeFiles/*}/${word#@}" ;;
            *) printf '%s\n' "$word" ;;
        esac
    done | sed -e "s|$2|BUILD|g" -e "s|$3|SOURCE|g" -e 's|prefix-map=[^ ]*=|prefix-map=FOLDER=|g' | awk '!seen[$0]++'
}

# lend_objects BUILD SOURCE OTHER_BUILD OTHER_SOURCE: of each target's objects all but every tenth, of small targets all but one.
lend_objects() {
    day=$(($(date +%s) / 86400))
    (cd "$3" && find ode ode_mt -name flags.make) | while read -r flags; do
        target=${flags%/flags.make}
        for options in "$flags" "$target/link.txt"; do
            [ -f "$3/$options" ] || continue
            [ -f "$1/$options" ] || fail "the first build has no $options"
            options "$1/$options" "$1" "$2" > "$SCRATCH/options"
            options "$3/$options" "$3" "$4" > "$SCRATCH/other_options"
            diff "$SCRATCH/options" "$SCRATCH/other_options" || fail "$options is another one"
        done
        (cd "$1" && find "$target" -name '*.o' | sort) > "$SCRATCH/objects"
        every=$(wc -l < "$SCRATCH/objects")
        [ "$every" -le 10 ] || every=10
        [ "$every" -gt 0 ] || continue
        awk -v every="$every" -v day="$day" 'NR % every != day % every' "$SCRATCH/objects" | while read -r object; do
            mkdir -p "$3/${object%/*}"
            cp "$1/$object" "$3/$object"
        done
    done
}

# Names of upstream's files in the texts of assertions. What lies before a text in memory may look like a part of it.
assertion_files() {
    objcopy -O binary --only-section=.rodata "$1" "$SCRATCH/texts"
    strings -a "$SCRATCH/texts" | grep -v ode_mt/ | grep -oE '(\.\./)*[a-z][a-z0-9_/]*\.(cpp|h)$' | sort -u
}

rm -rf "$SCRATCH"
mkdir -p "$SCRATCH"
second="$SCRATCH/a_folder_with_a_longer_name/_deps/ode_mt-build/lib" shared=$FIRST lender=${FIRST%/lib} programs=stacks_static compared=libode.a
if [ "${ODE_MT_EXACTNESS:-}" = thorough ] || [ ! -f "$lender/ode_mt/CMakeFiles/ode_mt.dir/flags.make" ]; then
    shared=$second lender='' programs="stacks stacks_static" compared="libode.a libode.so.8"
fi
take_in "$SCRATCH/a_folder_with_a_longer_name"
if [ -z "$FIRST" ]; then
    build_first "$SCRATCH/first"
    FIRST="$SCRATCH/first/lib" SOURCE="$SCRATCH/first.source"
fi

for library in $compared; do
    cmp "$FIRST/$library" "$second/$library" || fail "$library is not the same in another folder"
done
for library in "$shared/libode.so.8" "$second/libode.a"; do
    strings -a "$library" > "$SCRATCH/texts"
    awk -v folder="$SCRATCH" -v other="$SOURCE/" 'index($0, folder) || index($0, other) == 1' "$SCRATCH/texts" > "$SCRATCH/names"
    [ ! -s "$SCRATCH/names" ] || { head -n 5 "$SCRATCH/names"; fail "$library names the folder that it was built in"; }
done
states=$(for program in $programs; do "$SCRATCH/a_folder_with_a_longer_name/$program" | grep hash; done | sort -u)
[ "$(echo "$states" | grep -c hash)" = 1 ] || fail "programs of the project that took it in end in other states than one: $states"
if [ -n "$DEBIAN" ]; then
    assertion_files "$DEBIAN" > "$SCRATCH/debian"
    assertion_files "$shared/libode.so.8" > "$SCRATCH/ours"
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
