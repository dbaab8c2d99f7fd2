# Packages (docs/packages.md), made by CPack in a build folder:
#
#   cpack -G DEB   Debian packages that take the place of Debian's libode8 and libode-dev; the target debian_packages builds what they hold
#                  before
#   cpack -G TXZ   an archive of what `cmake --install` installs, to be unpacked in any folder
if(NOT EXISTS "${PROJECT_SOURCE_DIR}/docs/changelog.md")
    return()  # a part of the repository, as for tests/mutation
endif()
set(CPACK_PACKAGE_NAME ode_mt)
set(CPACK_PACKAGE_VENDOR "the ODE_MT developers")
set(ODE_MT_MAINTAINER "ODE_MT developers <ode-mt@users.invalid>" CACHE STRING "Name and address of who makes the packages")
set(CPACK_PACKAGE_CONTACT "${ODE_MT_MAINTAINER}")
set(CPACK_PACKAGE_VERSION "${ODE_MT_UPSTREAM}+mt${ODE_MT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_FILE_NAME "ode_mt-${CPACK_PACKAGE_VERSION}-${ODE_MT_PRECISION}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_THREADS 0)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
set(CPACK_ODE_MT_BUILD "${PROJECT_BINARY_DIR}")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/finish.cmake")

find_program(ODE_MT_DPKG dpkg DOC "Debian's dpkg; without it no Debian packages")
if(ODE_MT_DPKG AND CMAKE_LIBRARY_ARCHITECTURE)
    include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
endif()
# Archives hold what is installed without naming components, so the one list is that of the Debian packages.
set(CPACK_COMPONENTS_ALL ${ODE_MT_DEBIAN_COMPONENTS})
include(CPack)

if(ODE_MT_DPKG AND CMAKE_LIBRARY_ARCHITECTURE)
    get_property(ode_mt_tools GLOBAL PROPERTY ODE_MT_TOOLS)
    add_custom_target(debian_packages COMMAND ${CMAKE_CPACK_COMMAND} -G DEB WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" VERBATIM)
    add_dependencies(debian_packages ode ode_static ${ode_mt_tools})
    foreach(target ode_mt_mpi odemt_worker)
        if(TARGET ${target})
            add_dependencies(debian_packages ${target})
        endif()
    endforeach()
endif()
