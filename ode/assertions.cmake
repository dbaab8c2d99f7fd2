# Lines of upstream's assertions that ode_mt/ raises in upstream's place: people search for such messages, which end in file and line. They are
# looked up in the sources of the release that is built, for seams/assertions.h.

set(ODE_MT_ASSERTIONS "")

# CONSTANT is the line of FILE that has TEXT, the only one.
function(ode_mt_find_assertion constant file text)
    set(path "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    file(READ "${path}" source)
    string(FIND "${source}" "${text}" place)
    string(FIND "${source}" "${text}" last REVERSE)
    if(place EQUAL -1 OR NOT place EQUAL last)
        message(FATAL_ERROR "ODE ${ODE_MT_UPSTREAM}: ${file} has \"${text}\" not once")
    endif()
    string(SUBSTRING "${source}" 0 ${place} before)
    string(REGEX MATCHALL "\n" ends "${before}")
    list(LENGTH ends lines)
    math(EXPR line "${lines} + 1")
    set(ODE_MT_ASSERTIONS "${ODE_MT_ASSERTIONS}constexpr unsigned ${constant} = ${line};\n" PARENT_SCOPE)
endfunction()

ode_mt_find_assertion(kHashSpaceRangeLine collision_space.cpp "aabbBound >= dMinIntExact")
ode_mt_find_assertion(kQuadTreeOrderXLine collision_quadtreespace.cpp "(MinX <= MaxX)")
ode_mt_find_assertion(kQuadTreeOrderZLine collision_quadtreespace.cpp "(MinZ <= MaxZ)")
ode_mt_find_assertion(kSapFirstBoxLine collision_sapspace.cpp "(g1->gflags & GEOM_AABB_BAD)==0")
ode_mt_find_assertion(kSapSecondBoxLine collision_sapspace.cpp "(g2->gflags & GEOM_AABB_BAD)==0")

configure_file(seams/assertions.h.in seams/assertions.h @ONLY)
