# Tests of ctest from a GoogleTest program: one process for each suite, not for each case, as most cases take a millisecond and a process takes ten.
#
#   odemt_add_suites(PROGRAM PREFIX name. [FILTER gtest_filter] [ALONE regex] PROPERTIES property value ...)
#
# A suite S is the test name.S. FILTER is empty or -PATTERNS, as --gtest_filter has it: it leaves out suites and cases. Each case of a suite whose
# name matches ALONE is a test with a process of its own, name.S.case: cases that take long by themselves, and those that need a process in which
# nothing has happened yet.
# Suites are read from the program when ctest starts, again after the program was built or its filter has changed.
function(odemt_add_suites program)
    cmake_parse_arguments(PARSE_ARGV 1 suites "" "PREFIX;FILTER;ALONE" "PROPERTIES")
    set(_script "${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake")
    set(_properties "")
    foreach(_word IN LISTS suites_PROPERTIES)
        string(APPEND _properties " [==[${_word}]==]")
    endforeach()
    file(GENERATE OUTPUT "${_script}" CONTENT
"set(script [==[${_script}]==])
set(program [==[$<TARGET_FILE:${program}>]==])
set(prefix [==[${suites_PREFIX}]==])
set(filter [==[${suites_FILTER}]==])
set(alone [==[${suites_ALONE}]==])
set(properties ${_properties})
include([==[${PROJECT_SOURCE_DIR}/tests/discover_suites.cmake]==])
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${_script}")
endfunction()
