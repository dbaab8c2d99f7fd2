# Which upstream release the fork is made of. Each release has a folder in releases/, and nothing else in the repository knows
# its number:
#
#   pin.cmake         its archive, and Debian's package of it
#   upstream_facts.h  what ode_mt/ has to know of its internal structures
#   seams.cmake       seams that it alone needs (ode/seams.cmake has the others)
#   new_functions.txt, gone_functions.txt   what its public headers declare that earlier ones did not, and the other way round
#
# A further release is a further folder (docs/overview.md).
file(GLOB _pins RELATIVE "${CMAKE_CURRENT_LIST_DIR}/releases" "${CMAKE_CURRENT_LIST_DIR}/releases/*/pin.cmake")
string(REPLACE "/pin.cmake" "" ODE_MT_UPSTREAM_RELEASES "${_pins}")
list(SORT ODE_MT_UPSTREAM_RELEASES COMPARE NATURAL)
list(GET ODE_MT_UPSTREAM_RELEASES -1 _newest)

# Sets `out` to the release of a library by the number behind its file's name, libode.so.8.0.2, which changes with each; empty where
# no release here has it.
function(_ode_mt_release_of library out)
    set(${out} "" PARENT_SCOPE)
    file(REAL_PATH "${library}" file)
    foreach(release IN LISTS ODE_MT_UPSTREAM_RELEASES)
        include("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/releases/${release}/pin.cmake")
        if(file MATCHES "/libode\\.so\\.${ODE_MT_UPSTREAM_LIBRARY}$")
            set(${out} ${release} PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# The release of the system's own libode; else the newest.
set(_default ${_newest})
if(NOT CMAKE_SCRIPT_MODE_FILE)
    find_library(ODE_MT_SYSTEM_LIBRARY NAMES libode.so.8 DOC "The system's own libode.so.8")
    mark_as_advanced(ODE_MT_SYSTEM_LIBRARY)
    set(ODE_MT_SYSTEM_RELEASE "")
    if(ODE_MT_SYSTEM_LIBRARY)
        _ode_mt_release_of("${ODE_MT_SYSTEM_LIBRARY}" ODE_MT_SYSTEM_RELEASE)
        if(ODE_MT_SYSTEM_RELEASE)
            set(_default ${ODE_MT_SYSTEM_RELEASE})
        endif()
        # As where the package libode8-mt is installed: what we compare with would be ours.
        file(STRINGS "${ODE_MT_SYSTEM_LIBRARY}" _ours REGEX "dToggleODE_MT" LIMIT_COUNT 1)
        if(_ours)
            message(WARNING
                "The system's libode.so.8, ${ODE_MT_SYSTEM_LIBRARY}, is ODE_MT itself: bench and tests compare with Debian's, which is fetched")
            set(ODE_MT_SYSTEM_LIBRARY "")
            set(ODE_MT_SYSTEM_RELEASE "")
        endif()
    endif()
endif()

list(JOIN ODE_MT_UPSTREAM_RELEASES ", " _known)
set(ODE_MT_UPSTREAM ${_default} CACHE STRING "Release of ODE that the library is made of: ${_known}")
set_property(CACHE ODE_MT_UPSTREAM PROPERTY STRINGS ${ODE_MT_UPSTREAM_RELEASES})
list(FIND ODE_MT_UPSTREAM_RELEASES "${ODE_MT_UPSTREAM}" _place)
if(_place EQUAL -1)
    message(FATAL_ERROR "ODE_MT_UPSTREAM is '${ODE_MT_UPSTREAM}'; known: ${_known}")
endif()
set(ODE_MT_RELEASE_DIR "${CMAKE_CURRENT_LIST_DIR}/releases/${ODE_MT_UPSTREAM}")
set(ODE_MT_UPSTREAM_ARCHIVE ode_${ODE_MT_UPSTREAM}.orig.tar.gz)  # as Debian calls it
include("${ODE_MT_RELEASE_DIR}/pin.cmake")

# Public functions that this release has and the oldest one here has not: tests call these where they are there.
set(ODE_MT_UPSTREAM_ADDED "")
foreach(release IN LISTS ODE_MT_UPSTREAM_RELEASES)
    set(_list "${CMAKE_CURRENT_LIST_DIR}/releases/${release}/new_functions.txt")
    if(release VERSION_LESS_EQUAL ODE_MT_UPSTREAM AND EXISTS "${_list}")
        file(STRINGS "${_list}" _functions REGEX "^[^#]")
        list(TRANSFORM _functions REPLACE "^[^ ]+ +" "")
        list(APPEND ODE_MT_UPSTREAM_ADDED ${_functions})
    endif()
endforeach()
