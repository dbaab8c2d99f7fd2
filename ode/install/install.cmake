# Installs what Debian's libode8 and libode-dev install, and a CMake package. Everything in the installed
# tree finds its neighbours from its own place, so that the tree may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# --- what a program linked to libode.a needs besides, as linker options ---------------------------
set(_static_needs ${CCD_LDFLAGS} ${HWY_LDFLAGS})
find_package(OpenMP COMPONENTS CXX)
foreach(library IN LISTS OpenMP_CXX_LIB_NAMES)
    # By name where every compiler finds its own, else by path.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR library STREQUAL "pthread")
        list(APPEND _static_needs "-l${library}")
    else()
        list(APPEND _static_needs "${OpenMP_${library}_LIBRARY}")
    endif()
endforeach()
list(APPEND _static_needs ${CMAKE_THREAD_LIBS_INIT} -ldl -lstdc++ -lm)
list(REMOVE_DUPLICATES _static_needs)
list(TRANSFORM CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES PREPEND "-L" OUTPUT_VARIABLE _found_anyway)
list(REMOVE_ITEM _static_needs ${_found_anyway})
list(JOIN _static_needs " " ODE_MT_STATIC_NEEDS_LINE)

# --- the files ------------------------------------------------------------------------------------
# Sets `out` to the way from the folder `from` to the folder `to` of the installed tree.
function(_ode_mt_way out from to)
    file(RELATIVE_PATH way "${from}" "${to}")
    string(REGEX REPLACE "/$" "" way "${way}")
    set(${out} "${way}" PARENT_SCOPE)
endfunction()

set(_pkgconfig "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
set(_package "${CMAKE_INSTALL_LIBDIR}/cmake/ode")
_ode_mt_way(ODE_MT_LIBDIR "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_LIBDIR}")
_ode_mt_way(ODE_MT_INCLUDEDIR "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
_ode_mt_way(ODE_MT_PKGCONFIG_TO_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
_ode_mt_way(ODE_MT_BINDIR_TO_PREFIX "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_PREFIX}")
get_target_property(ODE_MT_LIBRARY_VERSION ode VERSION)
get_target_property(ODE_MT_SOVERSION ode SOVERSION)

set(_generated "${CMAKE_BINARY_DIR}/install")
configure_file("${CMAKE_CURRENT_LIST_DIR}/ode.pc.in" "${_generated}/ode.pc" @ONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/ode-config.in" "${_generated}/ode-config" @ONLY)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ode-config.cmake.in" "${_generated}/ode-config.cmake"
    INSTALL_DESTINATION "${_package}" PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file("${_generated}/ode-config-version.cmake"
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)

install(TARGETS ode COMPONENT runtime
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" NAMELINK_COMPONENT development)
install(TARGETS ode_static COMPONENT development ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${CMAKE_BINARY_DIR}/include/ode" COMPONENT development
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")
install(FILES "${_generated}/ode.pc" COMPONENT development DESTINATION "${_pkgconfig}")
install(FILES "${_generated}/ode-config.cmake" "${_generated}/ode-config-version.cmake"
        COMPONENT development DESTINATION "${_package}")
install(PROGRAMS "${_generated}/ode-config" COMPONENT development DESTINATION "${CMAKE_INSTALL_BINDIR}")
# Both of upstream's licences ask that their text goes with the library.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${ODE_MT_UPSTREAM_DIR}/LICENSE-BSD.TXT"
              "${ODE_MT_UPSTREAM_DIR}/LICENSE.TXT"
        COMPONENT runtime DESTINATION "${CMAKE_INSTALL_DOCDIR}")
