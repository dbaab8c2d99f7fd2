# Debian packages. They have the layout of Debian's own (docs/packages.md has the table), whatever folders this build installs into,
# so each has rules of installation of its own: components that only CPack installs, named after the packages.
set(_here "${CMAKE_CURRENT_LIST_DIR}")
set(_out "${PROJECT_BINARY_DIR}/debian")
set(_lib "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
set(_single "")
set(_single_flavour "")
if(ODE_MT_PRECISION STREQUAL "single")
    set(_single sp)
    set(_single_flavour -sp)
endif()
set(_library "libode8${_single}-mt")
set(_development "libode${_single_flavour}-mt-dev")
set(_tools libode-mt-tools)
set(_documentation libode-mt-doc)
set(_mpi libode-mt-mpi)
# CPack clears a folder that it would name after a component ...-dbgsym.
set(_debug "${_library}-debug")
set(ODE_MT_DEBIAN_COMPONENTS ${_library} ${_debug} ${_development})
if(TARGET odemt_bench AND NOT _single)
    list(APPEND ODE_MT_DEBIAN_COMPONENTS ${_tools} ${_documentation})
endif()
# Its programs are started by the mpirun of the MPI that they are linked to.
if(TARGET ode_mt_mpi AND MPIEXEC_EXECUTABLE AND NOT _single)
    file(REAL_PATH "${MPIEXEC_EXECUTABLE}" _mpirun)
    execute_process(COMMAND "${ODE_MT_DPKG}" --search "${_mpirun}" OUTPUT_VARIABLE _mpi_launcher ERROR_QUIET)
    string(REGEX MATCH "^[^:, ]+" _mpi_launcher "${_mpi_launcher}")
    if(_mpi_launcher)
        list(APPEND ODE_MT_DEBIAN_COMPONENTS ${_mpi})
    else()
        message(STATUS "No package ${_mpi}: ${_mpirun} is not of a Debian package")
    endif()
endif()

# ode_mt_describe(COMPONENT FIELD VALUE...): CPack's names of fields, and values without semicolons. DESCRIPTION begins with a line of
# its own.
function(ode_mt_describe package)
    string(TOUPPER "${package}" upper)
    string(REGEX REPLACE "-debug$" "-dbgsym" name "${package}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}" PARENT_SCOPE)
    while(ARGN)
        list(POP_FRONT ARGN field value)
        if(field STREQUAL "DESCRIPTION")
            set(CPACK_COMPONENT_${upper}_DESCRIPTION "${value}" PARENT_SCOPE)
        else()
            set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${value}" PARENT_SCOPE)
        endif()
    endwhile()
endfunction()

# Writes docs/changelog.md in Debian's format: a heading is "## VERSION, YEAR-MONTH-DAY", and points follow.
function(ode_mt_write_debian_changelog file)
    file(STRINGS "${PROJECT_SOURCE_DIR}/docs/changelog.md" lines)
    set(text "")
    set(end "")
    foreach(line IN LISTS lines)
        if(line MATCHES "^## ([^,]*), (.*)$")
            set(version "${ODE_MT_UPSTREAM}+mt${CMAKE_MATCH_1}")
            execute_process(COMMAND date --utc --rfc-email "--date=${CMAKE_MATCH_2}" OUTPUT_VARIABLE date
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
            string(APPEND text "${end}ode-mt (${version}) unstable; urgency=medium\n\n")
            set(end "\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n\n")
        elseif(end AND line MATCHES "^[* ] ")
            string(APPEND text "  ${line}\n")
        endif()
    endforeach()
    file(CONFIGURE OUTPUT "${file}" CONTENT "${text}${end}" @ONLY)
endfunction()

# --- what every package has -----------------------------------------------------------------------
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE ode-mt)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE https://www.ode.org)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_ODE_MT_SYMBOLS "${PROJECT_BINARY_DIR}/lib/libode.so.8")

file(READ "${PROJECT_SOURCE_DIR}/LICENSE" ODE_MT_LICENCE)
file(READ "${ODE_MT_UPSTREAM_DIR}/LICENSE-BSD.TXT" ODE_MT_UPSTREAM_LICENCE)
foreach(text ODE_MT_LICENCE ODE_MT_UPSTREAM_LICENCE)
    string(REPLACE "\r" "" ${text} "${${text}}")
    string(STRIP "${${text}}" ${text})
    string(REGEX REPLACE "\n[ \t]*\n" "\n.\n" ${text} "${${text}}")
    string(REPLACE "\n" "\n " ${text} " ${${text}}")
endforeach()
configure_file("${_here}/copyright.in" "${_out}/copyright" @ONLY)

find_program(ODE_MT_GZIP gzip REQUIRED)
ode_mt_write_debian_changelog("${_out}/changelog")
execute_process(COMMAND "${ODE_MT_GZIP}" -9nf "${_out}/changelog" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB _pages CONFIGURE_DEPENDS "${_here}/*.1")
foreach(page IN LISTS _pages)
    cmake_path(GET page FILENAME name)
    execute_process(COMMAND "${ODE_MT_GZIP}" -9nc "${page}" OUTPUT_FILE "${_out}/${name}.gz" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/changelog.md" ${_pages})
foreach(package IN LISTS ODE_MT_DEBIAN_COMPONENTS)
    string(REGEX REPLACE "-debug$" "-dbgsym" name "${package}")
    install(FILES "${_out}/copyright" "${_out}/changelog.gz" DESTINATION "share/doc/${name}"
            COMPONENT ${package} EXCLUDE_FROM_ALL)
endforeach()

install(FILES "${_here}/runtime.lintian-overrides" DESTINATION share/lintian/overrides RENAME "${_library}"
        COMPONENT ${_library} EXCLUDE_FROM_ALL)

# --- the library and its debug symbols ------------------------------------------------------------
install(TARGETS ode COMPONENT ${_library} EXCLUDE_FROM_ALL LIBRARY DESTINATION "${_lib}" NAMELINK_SKIP)
ode_mt_strip_installed(${_library} "${_lib}" ode)
ode_mt_install_debug_symbols(${_debug} lib EXCLUDE_FROM_ALL)
file(WRITE "${_out}/triggers" "activate-noawait ldconfig\n")
file(WRITE "${_out}/shlibs" "libode 8 ${_library} (>= ${CPACK_PACKAGE_VERSION})\n")
string(TOUPPER "${_library}" _upper)
set(CPACK_DEBIAN_${_upper}_PACKAGE_CONTROL_EXTRA "${_out}/triggers" "${_out}/shlibs" "${_out}/symbols")
set(CPACK_ODE_MT_SYMBOLS_FILE "${_out}/symbols")
set(CPACK_ODE_MT_SYMBOLS_HEADER "${PROJECT_SOURCE_DIR}/include/ode/ode_MT.h")
if(_single)
    # The same file name with another ABI: never beside Debian's, never in its place.
    set(CPACK_ODE_MT_SYMBOLS_UPSTREAM "${_library} ${CPACK_PACKAGE_VERSION}")
    ode_mt_describe(${_library} SECTION libs SHLIBDEPS ON SUGGESTS libgomp1
        CONFLICTS "${ODE_MT_DEBIAN_PACKAGE}" DESCRIPTION "Open Dynamics Engine on every core - runtime library (single precision)
This is the Open Dynamics Engine ${ODE_MT_UPSTREAM} with parallel stepping, for programs
that are compiled with single precision (dSINGLE). It cannot be installed
beside ${ODE_MT_DEBIAN_PACKAGE}, which has the same file name and double precision.")
else()
    set(CPACK_ODE_MT_SYMBOLS_UPSTREAM "${ODE_MT_DEBIAN_PACKAGE} 2:${ODE_MT_UPSTREAM}")
    # Where Debian's package has another name, it provides libode8, too.
    set(_theirs ${ODE_MT_DEBIAN_PACKAGE} libode8)
    list(REMOVE_DUPLICATES _theirs)
    list(TRANSFORM _theirs APPEND " (= ${ODE_MT_DEBIAN_VERSION})" OUTPUT_VARIABLE _provided)
    list(JOIN _theirs ", " _theirs)
    list(JOIN _provided ", " _provided)
    ode_mt_describe(${_library} SECTION libs SHLIBDEPS ON SUGGESTS "libgomp1, ${_mpi}"
        PROVIDES "${_provided}" CONFLICTS "${_theirs}" REPLACES "${_theirs}"
        DESCRIPTION "Open Dynamics Engine on every core - runtime library
This is the Open Dynamics Engine ${ODE_MT_UPSTREAM} with parallel stepping. It takes the
place of ${ODE_MT_DEBIAN_PACKAGE}: programs run unchanged and compute the same results, bit for
bit. ODE_MT_THREADS=auto in the environment makes them use all cores where that
is faster.")
endif()
set(CPACK_ODE_MT_SYMBOLS_OURS "${_library} ${CPACK_PACKAGE_VERSION}")
ode_mt_describe(${_debug} SECTION debug DEPENDS "${_library} (= ${CPACK_PACKAGE_VERSION})"
    DESCRIPTION "debug symbols for ${_library}
Debuggers and profilers find them by the library's build ID.")

# --- headers, static library, what tells compilers about them --------------------------------------
ode_mt_generate_development_files("${_out}" /usr "${_lib}" include bin)
install(TARGETS ode COMPONENT ${_development} EXCLUDE_FROM_ALL LIBRARY DESTINATION "${_lib}" NAMELINK_ONLY)
install(TARGETS ode_static COMPONENT ${_development} EXCLUDE_FROM_ALL ARCHIVE DESTINATION "${_lib}")
ode_mt_strip_installed(${_development} "${_lib}" ode_static)
install(DIRECTORY "${PROJECT_BINARY_DIR}/include/ode" COMPONENT ${_development} EXCLUDE_FROM_ALL
        DESTINATION include FILES_MATCHING PATTERN "*.h")
install(FILES "${_out}/ode.pc" COMPONENT ${_development} EXCLUDE_FROM_ALL DESTINATION "${_lib}/pkgconfig")
install(FILES "${_out}/ode-config.cmake" "${_out}/ode-config-version.cmake"
        COMPONENT ${_development} EXCLUDE_FROM_ALL DESTINATION "${_lib}/cmake/ode")
install(PROGRAMS "${_out}/ode-config" COMPONENT ${_development} EXCLUDE_FROM_ALL DESTINATION bin)
install(FILES "${_out}/ode-config.1.gz" COMPONENT ${_development} EXCLUDE_FROM_ALL DESTINATION share/man/man1)
set(_others "libode-dev, libode-mt-dev, libode-sp-mt-dev, libode-sp-dev")
string(REPLACE "${_development}, " "" _others "${_others}")
ode_mt_describe(${_development} SECTION libdevel DEPENDS "${_library} (= ${CPACK_PACKAGE_VERSION})"
    SUGGESTS "libccd-dev, libhwy-dev, ${_documentation}" CONFLICTS "${_others}"
    DESCRIPTION "Open Dynamics Engine on every core - development files
Headers, static library, and files for pkg-config and CMake. They take the
place of libode-dev: what ${ODE_MT_DEBIAN_PACKAGE} offers is declared as there, and ode_MT.h
declares what ODE_MT adds.
A program that is linked to the static library also needs libccd-dev and
libhwy-dev.")
if(_single)
    string(TOUPPER "${_development}" _upper)
    string(REPLACE "development files\n" "development files (single precision)\n"
        CPACK_COMPONENT_${_upper}_DESCRIPTION "${CPACK_COMPONENT_${_upper}_DESCRIPTION}")
else()
    ode_mt_describe(${_development} REPLACES libode-dev
        PROVIDES "libode-dev (= ${ODE_MT_DEBIAN_VERSION}), libode8-dev")
endif()

# --- islands that other processes solve -----------------------------------------------------------
if(_mpi IN_LIST ODE_MT_DEBIAN_COMPONENTS)
    ode_mt_install_mpi(${_mpi} "${_lib}" EXCLUDE_FROM_ALL)
    install(FILES "${_out}/odemt_worker.1.gz" COMPONENT ${_mpi} EXCLUDE_FROM_ALL DESTINATION share/man/man1)
    ode_mt_describe(${_mpi} SECTION science SHLIBDEPS ON DEPENDS "${_library} (= ${CPACK_PACKAGE_VERSION}), ${_mpi_launcher}"
        SUGGESTS "${_documentation}"
        DESCRIPTION "Open Dynamics Engine on every core - workers on other machines
With ODE_MT_WORKERS=mpi in the environment of a program, dWorldStep has islands
solved by processes odemt_worker, also on other machines, with the same results:
mpirun -np 1 program : -np 15 odemt_worker. All machines need this package in the
same version.")
endif()

# --- programs, worlds, documentation ---------------------------------------------------------------
if(_tools IN_LIST ODE_MT_DEBIAN_COMPONENTS)
    ode_mt_install_tools(${_tools} "${_lib}" EXCLUDE_FROM_ALL)
    get_property(_programs GLOBAL PROPERTY ODE_MT_TOOLS)
    list(REMOVE_ITEM _programs odemt_observer)  # a library
    foreach(tool IN LISTS _programs)
        install(FILES "${_out}/${tool}.1.gz" COMPONENT ${_tools} EXCLUDE_FROM_ALL DESTINATION share/man/man1)
    endforeach()
    ode_mt_describe(${_tools} SECTION science SHLIBDEPS ON DEPENDS "${_library} (= ${CPACK_PACKAGE_VERSION})"
        SUGGESTS "${_documentation}, ${_mpi}"
        DESCRIPTION "Open Dynamics Engine on every core - bench, recorder, viewer, worlds
odemt_bench measures the speed of libode.so.8 in SDF worlds and procedural
scenes, odemt_record records what moves in them, odemt_report shows results and
recordings as a page for a browser, and odemt_info shows which libode.so.8
programs get and how it is set up. odemt_check runs a program on libode8 and on
ODE_MT, and says whether it computes the same. odemt_top shows on a terminal how
the frames of a running program go. odemt_batch runs thousands of worlds into one
table. odemt_scale predicts how fast a world is on many machines. The worlds of
the bench are included.")
    foreach(folder docs examples)
        install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" COMPONENT ${_documentation} EXCLUDE_FROM_ALL
                DESTINATION "share/doc/${_documentation}" PATTERN "docs/figures/data" EXCLUDE)
    endforeach()
    install(FILES "${PROJECT_SOURCE_DIR}/README.md" COMPONENT ${_documentation} EXCLUDE_FROM_ALL
            DESTINATION "share/doc/${_documentation}")
    ode_mt_describe(${_documentation} SECTION doc ARCHITECTURE all
        DESCRIPTION "Open Dynamics Engine on every core - documentation and examples
How to use the library, how it works, what was measured, and short programs in
C, C++ and Python.")
endif()
