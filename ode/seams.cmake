# Every place where the fork departs from upstream's sources, with the reason. No upstream file is
# edited; a seam changes what a file's compiler sees.
#
#   ode_mt_call_instead(FILES FUNCTION REPLACEMENT)  calls of FUNCTION in FILES go to REPLACEMENT, which
#                                                    ode_mt/ defines; upstream's own function stays
#   ode_mt_compile_after(FILE HEADER)                FILE sees ode/seams/HEADER first. Most of them give
#                                                    public functions defined in FILE other linker names,
#                                                    and ode_mt/api defines the public ones. Assembler
#                                                    labels keep __FUNCTION__, so upstream's messages stay
#                                                    the same
#   left out (ode/sources.cmake)                     ode_mt/ implements the interface of the whole file

function(ode_mt_call_instead files function replacement)
    foreach(file IN LISTS files)
        set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}" APPEND PROPERTY
            COMPILE_DEFINITIONS "${function}=${replacement}")
    endforeach()
endfunction()

function(ode_mt_compile_after file header)
    set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}" APPEND PROPERTY
        COMPILE_OPTIONS -include "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/seams/${header}"
                        -iquote "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../ode_mt")
endfunction()

# error.cpp is left out: messages of islands solved on other threads are kept back and delivered on the
# thread that called the step, in upstream's order (ode_mt/api/error.cpp).
#
# misc.cpp is left out: a step takes its random numbers as one atomic block, so the seed must be an
# atomic of ours (ode_mt/api/random.cpp, ode_mt/api/matrix_debug.cpp).

# Islands are found with fewer waits for memory (ode_mt/dynamics/dxStepPreparation.h).
ode_mt_call_instead("ode.cpp" dxReallocateWorldProcessContext dxPrepareStep)

# The islands are shared out by our frame instead of upstream's call queue, and stepped by stages of ours (docs/steppers.md).
# Upstream's steppers run only where a world has a threading implementation of the user's own.
ode_mt_call_instead("ode.cpp" dxProcessIslands dxStepIslands)

# An island on another thread must not touch collision spaces or call the user: the moved-notifications
# of its bodies are put off (ode_mt/dynamics/dxBodyIntegration.cpp).
ode_mt_call_instead("step.cpp;quickstep.cpp" dxStepBody dxIntegrateIslandBody)

# Two threads of the user may collide meshes at the same time: each thread has a cache of its own. The
# upstream name is a variable; this turns its declarations into those of a function that returns the
# calling thread's cache.
foreach(file collision_trimesh_box collision_trimesh_ccylinder collision_trimesh_opcode
             collision_trimesh_plane collision_trimesh_ray collision_trimesh_sphere
             collision_trimesh_trimesh collision_trimesh_trimesh_old collision_cylinder_trimesh
             collision_trimesh_internal collision_convex_trimesh odeinit)
    ode_mt_call_instead("${file}.cpp" g_ccTrimeshCollidersCache "(*dxThreadTrimeshCollidersCache())")
endforeach()

# Initialisation counters are plain globals upstream; ours may be called from any thread, and closing
# ends the worker threads (ode_mt/api/lifecycle.cpp).
ode_mt_compile_after("odeinit.cpp" odeinit.h)

# A world's threading implementation may be freed after these calls: its threads are given back first
# (ode_mt/api/world_threading.cpp).
ode_mt_compile_after("ode.cpp" ode.h)

# The table of colliders is filled lazily for the user's geom classes, without a lock
# (ode_mt/api/user_classes.cpp); spaces keep pairs from call to call and hear of changed filters
# (ode_mt/api/geom_filters.cpp).
ode_mt_compile_after("collision_kernel.cpp" collision_kernel.h)

# A mesh that gets other data is marked as changed, but its space is not told (ode_mt/api/meshes.cpp).
ode_mt_compile_after("collision_trimesh_internal.cpp" collision_trimesh.h)

# Contacts computed ahead of callbacks hear of changes to the data of height fields (ode_mt/api/height_fields.cpp).
ode_mt_compile_after("heightfield.cpp" heightfield.h)
# They hear of data of meshes that is destroyed (ode_mt/api/meshes.cpp).
ode_mt_compile_after("collision_trimesh_opcode.cpp" collision_trimesh_opcode.h)
# They also hear of bodies that functions of joints move to and fro (ode_mt/api/joint_offsets.cpp).
ode_mt_compile_after("joints/piston.cpp" joint_offsets.h)
ode_mt_compile_after("joints/pu.cpp" joint_offsets.h)

# libccd asks convex geoms for their furthest point, dozens of times a pair (ode_mt/collision/dxConvexSupport.h). It may search
# without end (ode_mt/collision/dxCcdSearch.h).
ode_mt_compile_after("collision_libccd.cpp" collision_libccd.h)

# The sign of a zero depth follows from the order of the arguments in fmax(0.0, x). g++ takes the order to be free and changes
# it; Debian's binary has it as it is written. Elsewhere upstream calls neither fmax nor fmin (docs/same-bits.md).
set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/collision_libccd.cpp" APPEND PROPERTY
    COMPILE_OPTIONS -fno-builtin-fmax)

# Spaces of all kinds are ours: they find pairs incrementally, and report them in upstream's order
# (ode_mt/collision/dxOrderedSpace.h).
foreach(file collision_space collision_quadtreespace collision_sapspace)
    ode_mt_compile_after("${file}.cpp" collision_space.h)
endforeach()


# The triangular solves of upstream's LCP solver with vectors: same bits, less time (docs/solve.md).
ode_mt_compile_after("lcp.cpp" lcp.h)

# Upstream's own solver is left with what is not finite (ode_mt/dynamics/lcp/dxDantzig.cpp). There the sign of a NaN may
# decide whether it reports an error. Of two NaNs that are added one is kept, and vectors would keep another one than
# Debian's binary, which has none in these loops (docs/exactness.md). Problems without limits, which it solves, too, take as
# long as before.
set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/lcp.cpp" APPEND PROPERTY
    COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-tree-loop-vectorize>)
