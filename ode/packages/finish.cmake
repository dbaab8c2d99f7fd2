# Run by CPack before it makes the packages.
cmake_minimum_required(VERSION 3.25)

# What was staged for packages is not installed, so that there is nothing to uninstall.
file(GLOB _lists "${CPACK_ODE_MT_BUILD}/install_manifest*.txt")
foreach(_list IN LISTS _lists)
    file(READ "${_list}" _files)
    if(_files MATCHES "_CPack_Packages")
        file(REMOVE "${_list}")
    endif()
endforeach()

# The symbols file of the library. A program that calls ODE's functions alone is given
# a dependency on libode8, which Debian's library satisfies as well; one that calls ours, on our package.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
    return()
endif()
file(STRINGS "${CPACK_ODE_MT_SYMBOLS_HEADER}" _declared REGEX "ODE_API.*\\(")
list(TRANSFORM _declared REPLACE ".*[ *](d[A-Za-z_0-9]+)\\(.*" "\\1")
string(REPLACE " " ";" _upstream "${CPACK_ODE_MT_SYMBOLS_UPSTREAM}")
string(REPLACE " " ";" _ours "${CPACK_ODE_MT_SYMBOLS_OURS}")
list(GET _upstream 0 _package)
list(GET _upstream 1 _upstream_version)
list(GET _ours 0 _our_package)
list(GET _ours 1 _our_version)

execute_process(COMMAND nm --dynamic --defined-only --format=posix "${CPACK_ODE_MT_SYMBOLS}"
    OUTPUT_VARIABLE _names COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" _names "${_names}")
set(_text "libode.so.8 ${_package} #MINVER#\n| ${_our_package} #MINVER#\n")
foreach(_line IN LISTS _names)
    string(REGEX REPLACE "[ @].*" "" _name "${_line}")
    if(_name IN_LIST _declared)
        string(APPEND _text " ${_name}@Base ${_our_version} 1\n")
    else()
        string(APPEND _text " ${_name}@Base ${_upstream_version}\n")
    endif()
endforeach()
file(WRITE "${CPACK_ODE_MT_SYMBOLS_FILE}" "${_text}")
