#!/bin/sh
# What the packages say of others: Debian's programs accept ours, precisions are never mixed up, and a program that is built with ours
# depends on what it calls.
. "$(dirname "$0")/common.sh"
expect "dependency of $development" "$(field "$development" Depends)" "$library (= $VERSION)"
theirs=$THEIRS  # and libode8, where Debian's package has another name
[ "$THEIRS" = libode8 ] || [ "$PRECISION" = single ] || theirs="$THEIRS, libode8"
expect "conflicts of $library" "$(field "$library" Conflicts)" "$theirs"
case $(field "$library" Depends) in *gomp* | *libomp*) fail "the library depends on an OpenMP runtime" ;; esac
for package in $packages; do
    if [ $package != libode-mt-mpi ] && field $package Depends | grep mpi; then fail "$package depends on MPI"; fi
done
dpkg-deb --ctrl-tarfile "$(deb "$library")" | tar -tf - | grep -q triggers || fail "$library has no trigger"

# dependencies PROGRAM: what dpkg-shlibdeps says, with our package in the place of Debian's.
mkdir -p "$SCRATCH/source/debian"
control=$SCRATCH/source/debian/$library/DEBIAN
mkdir -p "$control"
cp -a "$(unpacked "$library")/usr" "$SCRATCH/source/debian/$library/"
for file in shlibs symbols; do dpkg-deb --info "$(deb "$library")" $file >"$control/$file"; done
printf 'Source: test\n\nPackage: %s\nArchitecture: any\n' "$library" >"$SCRATCH/source/debian/control"
dependencies() { (cd "$SCRATCH/source" && dpkg-shlibdeps -O "$1" 2>/dev/null) | sed 's/^shlibs:Depends=//' | tr ',' '\n' | sed 's/^ *//' | grep libode; }
program() {
    printf '#include <ode/ode.h>\nint main(void) { dInitODE2(0); %s dCloseODE(); return 0; }\n' "$2" >"$SCRATCH/$1.c"
    "$CC" -I"$(unpacked "$development")/usr/include" "$SCRATCH/$1.c" -o "$SCRATCH/$1" "$(unpacked "$library")/$LIB/libode.so.8"
}
program plain ''
program parallel 'dToggleODE_MT(2);'

if [ "$PRECISION" = single ]; then
    expect "provides of $library" "$(field "$library" Provides)" ""
    expect "dependencies of a program" "$(dependencies "$SCRATCH/plain")" "$library (>= $VERSION)"
    exit 0
fi
debian=$(dpkg-query -W -f '${Version}' "$THEIRS")
expect "provides of $library" "$(field "$library" Provides)" "$(echo "$theirs" | sed "s/,/ (= $debian),/; s/\$/ (= $debian)/")"
expect "dependencies of a program that calls ODE alone" "$(dependencies "$SCRATCH/plain")" "$THEIRS (>= 2:$UPSTREAM)"
expect "dependencies of one that calls ODE_MT" "$(dependencies "$SCRATCH/parallel" | sort)" \
    "$(printf '%s\n' "$THEIRS (>= 2:$UPSTREAM)" "$library (>= $VERSION)" | sort)"
[ -n "${MPIRUN:-}" ] || exit 0
# The library that odemt_worker is linked to, and the mpirun that belongs to it; and the version of the library that welcomes it.
case ", $(field libode-mt-mpi Depends)," in
*", $library (= $VERSION),"*) ;;
*) fail "libode-mt-mpi may be of another version than $library" ;;
esac
case ", $(field libode-mt-mpi Depends)" in
*", libopenmpi"*) field libode-mt-mpi Depends | grep -q openmpi-bin || fail "libode-mt-mpi has no mpirun of Open MPI" ;;
*", libmpich"*) field libode-mt-mpi Depends | grep -q '\bmpich' || fail "libode-mt-mpi has no mpiexec of MPICH" ;;
*) fail "libode-mt-mpi depends on no MPI" ;;
esac
