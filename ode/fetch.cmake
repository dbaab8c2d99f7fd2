# Brings the pinned upstream archive in and unpacks it into ode/upstream/, checked and never edited.
#
# The archive is looked for, in this order: ODE_MT_UPSTREAM_TARBALL (a path given by the user), the
# cache folder (ODE_MT_CACHE_DIR), the Debian source package, upstream's release page. After the first
# success the cache serves, so that later builds need no network.
include(${CMAKE_CURRENT_LIST_DIR}/release.cmake)

set(ODE_MT_UPSTREAM_TARBALL "" CACHE FILEPATH "Path of ${ODE_MT_UPSTREAM_ARCHIVE}; empty: look for it")
if(DEFINED ENV{XDG_CACHE_HOME})
    set(_cache_root "$ENV{XDG_CACHE_HOME}")
else()
    set(_cache_root "$ENV{HOME}/.cache")
endif()
set(ODE_MT_CACHE_DIR "${_cache_root}/ode_mt" CACHE PATH "Folder that keeps what was fetched")

set(_tried "")

# Stops, since a wrong archive under the right name is never what the user wants.
function(_ode_mt_refuse what hash)
    message(FATAL_ERROR "${what} is not ODE ${ODE_MT_UPSTREAM}: its SHA-256 is\n  ${hash}\n"
        "the pinned one is\n  ${ODE_MT_UPSTREAM_SHA256}")
endfunction()

# Sets `result` to whether there is a file `path`; stops if that is not the pinned archive.
function(_ode_mt_accept path result)
    set(${result} FALSE PARENT_SCOPE)
    if(EXISTS "${path}")
        file(SHA256 "${path}" hash)
        if(NOT hash STREQUAL ODE_MT_UPSTREAM_SHA256)
            _ode_mt_refuse("${path}" ${hash})
        endif()
        set(${result} TRUE PARENT_SCOPE)
    endif()
endfunction()

# The same for a file just fetched from `source`, which becomes `cached` only once it is checked: a wrong
# or half archive in the cache would stop every later build.
function(_ode_mt_accept_fetched source fetched cached result)
    set(${result} FALSE PARENT_SCOPE)
    if(EXISTS "${fetched}")
        file(SHA256 "${fetched}" hash)
        if(NOT hash STREQUAL ODE_MT_UPSTREAM_SHA256)
            file(REMOVE "${fetched}")
            _ode_mt_refuse("What came from ${source}" ${hash})
        endif()
        file(RENAME "${fetched}" "${cached}")
        set(${result} TRUE PARENT_SCOPE)
    endif()
endfunction()

function(_ode_mt_find_archive out)
    set(cached "${ODE_MT_CACHE_DIR}/${ODE_MT_UPSTREAM_ARCHIVE}")
    if(ODE_MT_UPSTREAM_TARBALL)
        _ode_mt_accept("${ODE_MT_UPSTREAM_TARBALL}" good)
        if(good)
            file(MAKE_DIRECTORY "${ODE_MT_CACHE_DIR}")
            if(NOT EXISTS "${cached}")
                file(COPY_FILE "${ODE_MT_UPSTREAM_TARBALL}" "${cached}")
            endif()
            set(${out} "${ODE_MT_UPSTREAM_TARBALL}" PARENT_SCOPE)
            return()
        endif()
        list(APPEND _tried "ODE_MT_UPSTREAM_TARBALL=${ODE_MT_UPSTREAM_TARBALL}: no such file")
    else()
        list(APPEND _tried "ODE_MT_UPSTREAM_TARBALL: not given")
    endif()

    _ode_mt_accept("${cached}" good)
    if(good)
        set(${out} "${cached}" PARENT_SCOPE)
        return()
    endif()
    list(APPEND _tried "${cached}: no such file")

    file(MAKE_DIRECTORY "${ODE_MT_CACHE_DIR}")
    set(fetched "${cached}.part")
    set(source "Debian source package `ode` (apt-get source)")
    message(STATUS "Fetching ODE ${ODE_MT_UPSTREAM} from the ${source}")
    execute_process(
        COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch-debian-source.sh" "${ODE_MT_DEBIAN_SUITE}"
                "${ODE_MT_UPSTREAM_ARCHIVE}" "${fetched}"
        OUTPUT_QUIET ERROR_VARIABLE error)
    _ode_mt_accept_fetched("${source}" "${fetched}" "${cached}" good)
    if(good)
        set(${out} "${cached}" PARENT_SCOPE)
        return()
    endif()
    string(STRIP "${error}" error)
    list(APPEND _tried "${source}: ${error}")

    message(STATUS "Fetching ODE ${ODE_MT_UPSTREAM} from ${ODE_MT_UPSTREAM_URL}")
    file(DOWNLOAD "${ODE_MT_UPSTREAM_URL}" "${fetched}" STATUS status TIMEOUT 300)
    list(GET status 0 code)
    list(GET status 1 reason)
    if(code EQUAL 0)
        _ode_mt_accept_fetched("${ODE_MT_UPSTREAM_URL}" "${fetched}" "${cached}" good)
        set(${out} "${cached}" PARENT_SCOPE)
        return()
    endif()
    file(REMOVE "${fetched}")
    list(APPEND _tried "${ODE_MT_UPSTREAM_URL}: ${reason}")

    list(JOIN _tried "\n  - " report)
    message(FATAL_ERROR "The sources of ODE ${ODE_MT_UPSTREAM} were not found. Tried:\n  - ${report}\n"
        "Give the archive with -DODE_MT_UPSTREAM_TARBALL=/path/to/${ODE_MT_UPSTREAM_ARCHIVE}")
endfunction()

# One hash over all unpacked files: shows an edited, missing or added file.
function(_ode_mt_fingerprint folder out)
    file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${folder}" "${folder}/*")
    list(SORT files)
    set(all "")
    foreach(file IN LISTS files)
        file(MD5 "${folder}/${file}" hash)
        string(APPEND all "${hash} ${file}\n")
    endforeach()
    string(SHA256 digest "${all}")
    set(${out} ${digest} PARENT_SCOPE)
endfunction()

# Unpacks the archive unless it is there already, unchanged. Sets `out` to the source folder. Builds that are configured at
# the same time wait for one another (file cmake.lock in ode/upstream/).
function(ode_mt_unpack_upstream out)
    set(folder "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/upstream")
    set(sources "${folder}/ode-${ODE_MT_UPSTREAM}")
    set(stamp "${sources}.fingerprint")
    set(${out} "${sources}" PARENT_SCOPE)
    file(LOCK "${folder}" DIRECTORY GUARD FUNCTION TIMEOUT 600)
    if(EXISTS "${stamp}")
        file(READ "${stamp}" expected)
        _ode_mt_fingerprint("${sources}" actual)
        if(actual STREQUAL expected)
            return()
        endif()
        message(WARNING "${sources} differs from the pinned archive; it is unpacked again. "
            "Upstream files are never edited in place: use a seam (ode/seams.cmake).")
    endif()
    _ode_mt_find_archive(archive)
    file(REMOVE_RECURSE "${stamp}" "${sources}")
    file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${folder}")
    _ode_mt_fingerprint("${sources}" fingerprint)
    file(WRITE "${stamp}" "${fingerprint}")
endfunction()
