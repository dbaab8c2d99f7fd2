# Run by `cmake --install`: the debug symbols of ODE_MT_LIBRARY, in ODE_MT_DEBUG_DIR/.build-id under the first two digits of its
# build ID.
execute_process(COMMAND "${ODE_MT_READELF}" --notes "${ODE_MT_LIBRARY}" OUTPUT_VARIABLE _notes COMMAND_ERROR_IS_FATAL ANY)
if(NOT _notes MATCHES "Build ID: ([0-9a-f][0-9a-f])([0-9a-f]+)")
    message(STATUS "No debug symbols: ${ODE_MT_LIBRARY} has no build ID")
    return()
endif()
set(_folder "${CMAKE_MATCH_1}")
set(_symbols "${ODE_MT_SCRATCH}/${CMAKE_MATCH_2}.debug")
execute_process(COMMAND "${ODE_MT_OBJCOPY}" --only-keep-debug --compress-debug-sections "${ODE_MT_LIBRARY}" "${_symbols}"
    COMMAND_ERROR_IS_FATAL ANY)
# What a debugger is not meant to run.
file(CHMOD "${_symbols}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
cmake_path(ABSOLUTE_PATH ODE_MT_DEBUG_DIR BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}")
file(INSTALL "${_symbols}" DESTINATION "${ODE_MT_DEBUG_DIR}/.build-id/${_folder}")
file(REMOVE "${_symbols}")
