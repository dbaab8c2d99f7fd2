# Writes library_releases.h: the number in the file name of each release's shared library (ode/releases/*/pin.cmake), by which
# platform.cpp tells what another libode than ours is made of.
function(ode_mt_write_library_releases file)
    set(rows "")
    foreach(release IN LISTS ODE_MT_UPSTREAM_RELEASES)
        include("${PROJECT_SOURCE_DIR}/ode/releases/${release}/pin.cmake")
        string(APPEND rows "    {\"${ODE_MT_UPSTREAM_LIBRARY}\", \"${release}\"},\n")
    endforeach()
    file(CONFIGURE OUTPUT "${file}" @ONLY CONTENT "// Written by library_releases.cmake.
#pragma once

struct NumberedRelease {
    const char *number;   // behind libode.so.
    const char *release;  // of ODE
};

constexpr NumberedRelease kNumberedReleases[] = {
@rows@};
")
endfunction()
