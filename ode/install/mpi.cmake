# ode_mt_install_mpi(COMPONENT LIBDIR [EXCLUDE_FROM_ALL]): what islands that other processes solve need (docs/remote.md), where MPI was
# found: libode_mt_mpi.so in the folder of the library's own parts, and odemt_worker, which that finds from its own place. Nothing else of the
# tree is linked to MPI but odemt_batch_mpi.
#
# They are installed as they are, with the path of MPI's libraries alone in them; packages of the system (EXCLUDE_FROM_ALL) need none, as its loader
# knows it.
function(ode_mt_install_mpi component libdir)
    if(NOT TARGET ode_mt_mpi)
        return()
    endif()
    install(FILES $<TARGET_FILE:ode_mt_mpi> COMPONENT ${component} ${ARGN} DESTINATION "${libdir}/ode_mt")
    install(PROGRAMS $<TARGET_FILE:odemt_worker> COMPONENT ${component} ${ARGN} DESTINATION bin)
    if(ARGN)
        foreach(file "${libdir}/ode_mt/$<TARGET_FILE_NAME:ode_mt_mpi>" bin/odemt_worker)
            install(CODE "file(RPATH_REMOVE FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${file}\")" COMPONENT ${component} ${ARGN})
        endforeach()
    endif()
    ode_mt_strip_installed(${component} "${libdir}/ode_mt" ode_mt_mpi)
    ode_mt_strip_installed(${component} bin odemt_worker)
endfunction()
