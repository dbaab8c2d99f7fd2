# The library that results are compared with, bit by bit: the libode.so.8 of the Debian release that has the same release of ODE. It is
# the system's own where that is this release; another Debian release's is fetched into the cache, and runs with the system's C
# library, libm and libccd, as ours does.
set(ODE_MT_ORACLE "" CACHE STRING
    "The libode.so.8 to compare with: a path, or the name of a Debian release (bookworm, trixie); empty: the one that has ODE_MT_UPSTREAM")

# Sets `out` to libode.so.8 of `package` in the Debian release `suite`, fetched into the cache at first; empty, with the reason in
# `error`, where it cannot be had.
function(_ode_mt_fetch_library suite package out error)
    set(folder "${ODE_MT_CACHE_DIR}/${package}-${suite}")
    set(${out} "${folder}/libode.so.8" PARENT_SCOPE)
    if(EXISTS "${folder}/libode.so.8")
        return()
    endif()
    message(STATUS "Fetching ${package} of Debian ${suite}, to compare results with")
    execute_process(COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch-debian-library.sh" ${suite} ${package} "${folder}"
                    OUTPUT_QUIET ERROR_VARIABLE said)
    if(NOT EXISTS "${folder}/libode.so.8")
        set(${out} "" PARENT_SCOPE)
        set(${error} "${package} of Debian ${suite} cannot be fetched:\n${said}" PARENT_SCOPE)
    endif()
endfunction()

# The same for the Debian release that has `release`.
function(ode_mt_find_oracle release out error)
    if(release STREQUAL ODE_MT_SYSTEM_RELEASE)
        set(${out} "${ODE_MT_SYSTEM_LIBRARY}" PARENT_SCOPE)
        return()
    endif()
    include("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/releases/${release}/pin.cmake")
    _ode_mt_fetch_library(${ODE_MT_DEBIAN_SUITE} ${ODE_MT_DEBIAN_PACKAGE} library said)
    set(${out} "${library}" PARENT_SCOPE)
    set(${error} "${said}" PARENT_SCOPE)
endfunction()

# Sets `out` to the release that the Debian release `suite` has.
function(_ode_mt_release_of_suite suite out)
    foreach(release IN LISTS ODE_MT_UPSTREAM_RELEASES)
        include("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/releases/${release}/pin.cmake")
        if(ODE_MT_DEBIAN_SUITE STREQUAL suite)
            set(${out} ${release} PARENT_SCOPE)
            return()
        endif()
    endforeach()
    message(FATAL_ERROR "ODE_MT_ORACLE is '${suite}', neither a path nor a Debian release of ode/releases/")
endfunction()

if(ODE_MT_ORACLE MATCHES "/")
    set(ODE_MT_ORACLE_LIBRARY "${ODE_MT_ORACLE}")
    if(NOT EXISTS "${ODE_MT_ORACLE}")
        message(FATAL_ERROR "ODE_MT_ORACLE=${ODE_MT_ORACLE}: no such file")
    endif()
else()
    set(_release ${ODE_MT_UPSTREAM})
    if(ODE_MT_ORACLE)
        _ode_mt_release_of_suite("${ODE_MT_ORACLE}" _release)
    endif()
    ode_mt_find_oracle(${_release} ODE_MT_ORACLE_LIBRARY _error)
    if(NOT ODE_MT_ORACLE_LIBRARY)
        message(FATAL_ERROR "${_error}\nGive a library to compare with by -DODE_MT_ORACLE=/path/to/libode.so.8")
    endif()
endif()
message(STATUS "ODE ${ODE_MT_UPSTREAM}, compared with ${ODE_MT_ORACLE_LIBRARY}")
