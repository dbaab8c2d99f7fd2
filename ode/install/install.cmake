# Installs what Debian's libode8 and libode-dev install, and a CMake package. Everything in the installed
# tree finds its neighbours from its own place, so that the tree may be moved.
#
# Components: runtime (the shared library), development, debug (its debug symbols), tools, mpi (if MPI was found). `cmake --install` installs all
# of them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# --- what a program linked to libode.a needs besides, as linker options ---------------------------
set(_static_needs ${CCD_LDFLAGS} ${HWY_LDFLAGS} ${CMAKE_THREAD_LIBS_INIT} -ldl -lstdc++ -lm)
list(REMOVE_DUPLICATES _static_needs)
list(TRANSFORM CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES PREPEND "-L" OUTPUT_VARIABLE _found_anyway)
list(REMOVE_ITEM _static_needs ${_found_anyway})
list(JOIN _static_needs " " ODE_MT_STATIC_NEEDS_LINE)

# --- the files ------------------------------------------------------------------------------------
get_target_property(ODE_MT_LIBRARY_VERSION ode VERSION)
get_target_property(ODE_MT_SOVERSION ode SOVERSION)

# Sets `out` to the way from the folder `from` to the folder `to`, both in `prefix` unless they are whole paths.
function(_ode_mt_way out prefix from to)
    foreach(path from to)
        cmake_path(ABSOLUTE_PATH ${path} BASE_DIRECTORY "${prefix}" NORMALIZE)
    endforeach()
    file(RELATIVE_PATH way "${from}" "${to}")
    string(REGEX REPLACE "/$" "" way "${way}")
    set(${out} "${way}" PARENT_SCOPE)
endfunction()

# Writes into `out` what compilers are told about a tree that is installed in PREFIX, with LIBDIR, INCLUDEDIR and BINDIR in it.
function(ode_mt_generate_development_files out prefix libdir includedir bindir)
    set(CMAKE_INSTALL_PREFIX "${prefix}")
    set(CMAKE_INSTALL_LIBDIR "${libdir}")
    set(CMAKE_INSTALL_INCLUDEDIR "${includedir}")
    _ode_mt_way(ODE_MT_LIBDIR "${prefix}" . "${libdir}")
    _ode_mt_way(ODE_MT_INCLUDEDIR "${prefix}" . "${includedir}")
    _ode_mt_way(ODE_MT_PKGCONFIG_TO_PREFIX "${prefix}" "${libdir}/pkgconfig" .)
    _ode_mt_way(ODE_MT_BINDIR_TO_PREFIX "${prefix}" "${bindir}" .)
    set(here "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
    configure_file("${here}/ode.pc.in" "${out}/ode.pc" @ONLY)
    configure_file("${here}/ode-config.in" "${out}/ode-config" @ONLY)
    configure_package_config_file("${here}/ode-config.cmake.in" "${out}/ode-config.cmake" INSTALL_PREFIX "${prefix}"
        INSTALL_DESTINATION "${libdir}/cmake/ode" PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
    write_basic_package_version_file("${out}/ode-config-version.cmake" VERSION ${ODE_MT_UPSTREAM} COMPATIBILITY SameMinorVersion)
endfunction()

set(_generated "${PROJECT_BINARY_DIR}/install")
ode_mt_generate_development_files("${_generated}" "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_LIBDIR}" "${CMAKE_INSTALL_INCLUDEDIR}"
    "${CMAKE_INSTALL_BINDIR}")

install(TARGETS ode COMPONENT runtime
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" NAMELINK_COMPONENT development)
install(TARGETS ode_static COMPONENT development ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_BINARY_DIR}/include/ode" COMPONENT development
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")
install(FILES "${_generated}/ode.pc" COMPONENT development DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
install(FILES "${_generated}/ode-config.cmake" "${_generated}/ode-config-version.cmake"
        COMPONENT development DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/ode")
install(PROGRAMS "${_generated}/ode-config" COMPONENT development DESTINATION "${CMAKE_INSTALL_BINDIR}")
# Both of upstream's licences ask that their text goes with the library.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${ODE_MT_UPSTREAM_DIR}/LICENSE-BSD.TXT"
              "${ODE_MT_UPSTREAM_DIR}/LICENSE.TXT"
        COMPONENT runtime DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# --- debug symbols apart --------------------------------------------------------------------------
# They are most of what the compiler writes. Those of the shared library are installed where debuggers look for them by its build
# ID; programs and the static library go without.

# ode_mt_strip_installed(COMPONENT FOLDER TARGET...): after they are installed in that folder of the tree.
function(ode_mt_strip_installed component folder)
    if(NOT CMAKE_OBJCOPY)
        return()
    endif()
    set(exclude "")
    if(component IN_LIST ODE_MT_DEBIAN_COMPONENTS)
        set(exclude EXCLUDE_FROM_ALL)
    endif()
    if(NOT IS_ABSOLUTE "${folder}")
        string(PREPEND folder "\${CMAKE_INSTALL_PREFIX}/")
    endif()
    foreach(target IN LISTS ARGN)
        get_target_property(kind ${target} TYPE)
        set(option --strip-unneeded)
        if(kind STREQUAL "STATIC_LIBRARY")
            set(option --strip-debug)
        endif()
        install(CODE "execute_process(COMMAND \"${CMAKE_OBJCOPY}\" ${option}
            \"\$ENV{DESTDIR}${folder}/$<TARGET_FILE_NAME:${target}>\" COMMAND_ERROR_IS_FATAL ANY)"
            COMPONENT ${component} ${exclude})
    endforeach()
endfunction()

# ode_mt_install_debug_symbols(COMPONENT LIBDIR [EXCLUDE_FROM_ALL])
function(ode_mt_install_debug_symbols component libdir)
    if(NOT CMAKE_OBJCOPY)
        return()
    endif()
    install(CODE "
        set(ODE_MT_OBJCOPY \"${CMAKE_OBJCOPY}\")
        set(ODE_MT_READELF \"${CMAKE_READELF}\")
        set(ODE_MT_LIBRARY \"$<TARGET_FILE:ode>\")
        set(ODE_MT_SCRATCH \"${PROJECT_BINARY_DIR}/install\")
        set(ODE_MT_DEBUG_DIR \"${libdir}/debug\")"
        COMPONENT ${component} ${ARGN})
    install(SCRIPT "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/debug_symbols.cmake" COMPONENT ${component} ${ARGN})
endfunction()
ode_mt_strip_installed(runtime "${CMAKE_INSTALL_LIBDIR}" ode)
ode_mt_strip_installed(development "${CMAKE_INSTALL_LIBDIR}" ode_static)
ode_mt_install_debug_symbols(debug "${CMAKE_INSTALL_LIBDIR}")
include(${CMAKE_CURRENT_LIST_DIR}/mpi.cmake)
ode_mt_install_mpi(mpi "${CMAKE_INSTALL_LIBDIR}")

# --- uninstall ------------------------------------------------------------------------------------
if(PROJECT_IS_TOP_LEVEL)
    add_custom_target(uninstall VERBATIM COMMENT "Removing what was installed last"
        COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" -P "${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake")
endif()
