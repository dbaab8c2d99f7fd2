# ode_mt_install_tools(COMPONENT LIBDIR [EXCLUDE_FROM_ALL]): the programs and the worlds. Programs find worlds and ODE_MT's library from
# their own place, so that the tree may be moved.
#
# A path of libraries in the build folder is replaced as it is installed: a path relative to the program beside it would be in the
# programs of the build folder, too. Packages of the system (EXCLUDE_FROM_ALL) need none, as its loader knows the folder.
include(GNUInstallDirs)

function(ode_mt_install_tools component libdir)
    set(tools odemt_batch odemt_bench odemt_bench_child odemt_check odemt_info odemt_record odemt_report odemt_scale odemt_scale_child odemt_top)
    set(tools_without_library odemt_bench_child odemt_check odemt_top)  # of their own: they find it in another way, or start what does
    foreach(tool IN LISTS tools)
        set(file "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/${tool}")
        set(change "file(RPATH_REMOVE FILE \"${file}\")")
        set(path "$ORIGIN/../${libdir}")
        string(LENGTH "${PROJECT_BINARY_DIR}/lib" room)
        string(LENGTH "${path}" length)
        if(NOT ARGN AND length LESS_EQUAL room AND NOT IS_ABSOLUTE "${libdir}" AND NOT tool IN_LIST tools_without_library)
            set(change "file(RPATH_SET FILE \"${file}\" NEW_RPATH \"\\${path}\")")
        endif()
        install(PROGRAMS $<TARGET_FILE:${tool}> COMPONENT ${component} ${ARGN} DESTINATION bin)
        install(CODE "${change}" COMPONENT ${component} ${ARGN})
    endforeach()
    ode_mt_strip_installed(${component} bin ${tools})
    set_property(GLOBAL PROPERTY ODE_MT_TOOLS ${tools} odemt_observer)  # for packages and tests
    # What odemt_check loads into programs, beside the library that it compares them on (check/check_options.cpp).
    install(FILES $<TARGET_FILE:odemt_observer> DESTINATION "${libdir}/ode_mt" COMPONENT ${component} ${ARGN})
    ode_mt_strip_installed(${component} "${libdir}/ode_mt" odemt_observer)
    set(worlds "${PROJECT_SOURCE_DIR}/worlds")
    file(GLOB files CONFIGURE_DEPENDS "${worlds}/*.sdf")
    install(FILES "${worlds}/README.md" ${files} DESTINATION share/ode_mt/worlds COMPONENT ${component} ${ARGN})
    install(DIRECTORY "${worlds}/models" DESTINATION share/ode_mt/worlds COMPONENT ${component} ${ARGN})
endfunction()

# The one tool that needs MPI, beside odemt_batch, which starts it. No Debian package has it.
if(TARGET odemt_batch_mpi)
    set(_file "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/odemt_batch_mpi")
    install(PROGRAMS $<TARGET_FILE:odemt_batch_mpi> COMPONENT mpi DESTINATION bin)
    install(CODE "file(RPATH_SET FILE \"${_file}\" NEW_RPATH \"\\$ORIGIN/../${CMAKE_INSTALL_LIBDIR}\")" COMPONENT mpi)
    ode_mt_strip_installed(mpi bin odemt_batch_mpi)
endif()
