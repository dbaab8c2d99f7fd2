# The names of source files that compilers write into assertion texts and debug information. Neither holds the folder that
# the library was built in: two builds in two folders give the same bytes (tests/reproducible).
#
#   ode_file_names              INTERFACE: for every target whose code goes into the library
#   ode_mt_name_upstream_files  for upstream's files: assertions name files as Debian's binary does
#
# Where prefixes overlap, the one given last is taken. Debug information names files as seen from the repository's root:
# a debugger that is started there finds them.

# A compiler cache may hand the compiler names as seen from the build folder (ccache: base_dir).
function(_ode_mt_prefix_maps out kind folder name)
    file(RELATIVE_PATH relative "${PROJECT_BINARY_DIR}" "${folder}")
    set(options "-f${kind}-prefix-map=${folder}/=${name}")
    string(REGEX REPLACE "/$" "" relative "${relative}")
    if(relative)
        list(APPEND options "-f${kind}-prefix-map=${relative}/=${name}")
    endif()
    set(${out} ${${out}} ${options} PARENT_SCOPE)
endfunction()

set(_debug_maps "")
set(_macro_maps "")
set(_folders "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}")
# In this order, one of two that lie in or beside one another never takes the other's names ("ode", "ode/build", "ode-build").
list(SORT _folders)
foreach(folder IN LISTS _folders)
    list(APPEND _debug_maps "-fdebug-prefix-map=${folder}=.")  # the folder that the compiler runs in
    _ode_mt_prefix_maps(_debug_maps debug "${folder}" "./")
    _ode_mt_prefix_maps(_macro_maps macro "${folder}" "")
endforeach()
# Headers of upstream's that ode_mt/ includes assert, too.
_ode_mt_prefix_maps(_macro_maps macro "${ODE_MT_UPSTREAM_DIR}/ode/src" "")

add_library(ode_file_names INTERFACE)
target_compile_options(ode_file_names INTERFACE ${_debug_maps} ${_macro_maps})
if(ODE_MT_LTO)
    # Code that is optimised as a whole is compiled when the library is linked. The line tables of what goes into libode.a are
    # the assembler's own.
    target_compile_options(ode_file_names INTERFACE "-Wa,--debug-prefix-map=${PROJECT_BINARY_DIR}=.")
    target_link_options(ode_file_names INTERFACE ${_debug_maps})
endif()

# Debian's compiler ran in each folder of sources, so a file of another folder is named by the way there.
function(ode_mt_name_upstream_files folder way_up)
    set(maps "")
    _ode_mt_prefix_maps(maps macro "${ODE_MT_UPSTREAM_DIR}" "${way_up}")
    _ode_mt_prefix_maps(maps macro "${ODE_MT_UPSTREAM_DIR}/${folder}" "")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS ${maps})
endfunction()
ode_mt_name_upstream_files(ode/src "../../" ${ODE_MT_UPSTREAM_CORE})
ode_mt_name_upstream_files(ode/src/joints "../../../" ${ODE_MT_UPSTREAM_JOINTS})
ode_mt_name_upstream_files(ou/src/ou "../../../" ${ODE_MT_UPSTREAM_OU})
