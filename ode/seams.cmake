# Every place where the fork departs from upstream's sources, with the reason. No upstream file is
# edited; a seam changes what a file's compiler sees.
#
#   ode_mt_rename(FILE FUNCTION...)                  public functions dThing, defined in FILE, are dxUpstreamThing
#                                                    for the linker, and ode_mt/api defines the public ones, in
#                                                    the file named after the public header that declares them.
#                                                    __FUNCTION__ stays, and with it the text of messages
#   ode_mt_call_instead(FILES FUNCTION REPLACEMENT)  calls of FUNCTION in FILES go to REPLACEMENT, which
#                                                    ode_mt/ defines; upstream's own function stays
#   ode_mt_compile_after(FILE HEADER)                FILE sees ode/seams/HEADER, or HEADER at its path, first
#   left out (ode/sources.cmake)                     ode_mt/ implements the interface of the whole file
#   set_property(... COMPILE_OPTIONS ...)            an option of the compiler for one file

set(ODE_MT_RENAMED "")  # declarations of dxUpstreamThing for ode_mt/ (seams/upstream.h.in)
function(ode_mt_rename file)
    foreach(function IN LISTS ARGN)
        string(REGEX REPLACE "^d" "dxUpstream" renamed ${function})
        set(header "${CMAKE_CURRENT_BINARY_DIR}/seams/${function}.h")
        file(CONFIGURE OUTPUT "${header}" CONTENT "#pragma redefine_extname ${function} ${renamed}\n")
        set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}" APPEND PROPERTY
            COMPILE_OPTIONS -include "${header}")
        string(APPEND ODE_MT_RENAMED "decltype(${function}) ${renamed};\n")
    endforeach()
    set(ODE_MT_RENAMED "${ODE_MT_RENAMED}" PARENT_SCOPE)
endfunction()

function(ode_mt_call_instead files function replacement)
    foreach(file IN LISTS files)
        set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}" APPEND PROPERTY
            COMPILE_DEFINITIONS "${function}=${replacement}")
    endforeach()
endfunction()

function(ode_mt_compile_after file header)
    cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/seams")
    set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/${file}" APPEND PROPERTY
        COMPILE_OPTIONS -include "${header}"
                        -iquote "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../ode_mt")
endfunction()

# error.cpp is left out: messages of islands solved on other threads are kept back and delivered on the
# thread that called the step, in upstream's order (ode_mt/api/error.cpp).
#
# misc.cpp is left out: a step takes its random numbers as one atomic block, so the seed must be an
# atomic of ours (ode_mt/api/misc.cpp).

# Islands are found with fewer waits for memory (ode_mt/dynamics/step/islands/dxIslandSearch.h).
ode_mt_call_instead("ode.cpp" dxReallocateWorldProcessContext dxPrepareStepIslands)

# The islands are distributed by our strategies instead of upstream's call queue (ode_mt/dynamics/step/dxStep.h), and stepped by stages of
# ours (docs/step.md).
# Upstream's steppers run only where a world has a threading implementation of the user's own, and for islands whose joints the
# user changes during the step.
ode_mt_call_instead("ode.cpp" dxProcessIslands dxStepIslands)

# Our steppers move a body by dxIntegrateIslandBody, which defers notifications on workers. Where upstream's steppers run, it marks
# moved-callbacks as code of the user's, for which a second thread's first step does not wait for ever
# (ode_mt/dynamics/step/islands/dxBodyMotion.cpp, ode_mt/dynamics/step/random/dxSingleStepper.h).
ode_mt_call_instead("step.cpp;quickstep.cpp" dxStepBody dxIntegrateIslandBody)

# An island that upstream's QuickStep steps may have its own part of the random sequence (ode_mt/dynamics/step/random/dxIslandDraws.h).
ode_mt_call_instead("quickstep.cpp" dRandInt dxDrawForIsland)

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
# ends the worker threads.
ode_mt_rename(odeinit.cpp dInitODE dInitODE2 dAllocateODEDataForThread dCleanupODEAllDataForThread dCloseODE)

# A program asks for our extension as for upstream's: dCheckConfiguration("ODE_EXT_mt").
ode_mt_rename(ode.cpp dCheckConfiguration)

# A world's threading implementation may be freed after these calls: its threads are given back first.
ode_mt_rename(ode.cpp dWorldDestroy dWorldSetStepThreadingImplementation)

# Where callbacks run on several threads, contact joints are put into their lists later (ode_mt/collision/callbacks/dxConcurrentCallbacks.h);
# groups of joints are emptied without taking memory (ode_mt/dynamics/step/dxJointRemoval.h).
ode_mt_rename(ode.cpp dJointCreateContact dJointAttach dJointGroupEmpty)

# The table of colliders is filled lazily for the user's geom classes, without a lock (ode_mt/collision/narrowphase/dxColliderTable.h).
ode_mt_rename(collision_kernel.cpp dCollide dCreateGeomClass dSetColliderOverride)

# Two boxes are collided with vectors: same bits, less time (docs/collision.md).
ode_mt_rename(box.cpp dBoxBox)
ode_mt_call_instead("collision_kernel.cpp" dCollideBoxBox dxCollideBoxBox)

# Spaces keep pairs from call to call, and are notified of changed filters and switches.
ode_mt_rename(collision_kernel.cpp dGeomSetBody dGeomSetCategoryBits dGeomSetCollideBits dGeomEnable dGeomDisable)

# A mesh that gets other data is marked as changed, but its space is not told.
ode_mt_rename(collision_trimesh_internal.cpp dGeomTriMeshSetData)

# The narrow-phase prefetch is notified of changes to the data of height fields.
ode_mt_rename(heightfield.cpp
    dGeomHeightfieldDataCreate dGeomHeightfieldDataBuildCallback dGeomHeightfieldDataBuildByte
    dGeomHeightfieldDataBuildShort dGeomHeightfieldDataBuildSingle dGeomHeightfieldDataBuildDouble
    dGeomHeightfieldDataSetBounds dGeomHeightfieldDataDestroy)
# It is notified of data of meshes that is destroyed.
ode_mt_rename(collision_trimesh_opcode.cpp dGeomTriMeshDataDestroy)
# It is also notified of bodies that functions of joints move to and fro.
ode_mt_rename(joints/piston.cpp dJointSetPistonAnchorOffset)
ode_mt_rename(joints/pu.cpp dJointSetPUAnchorDelta dJointSetPUAnchorOffset)

# libccd asks convex geoms for their furthest point, dozens of times a pair, and its iteration may never end
# (ode_mt/collision/narrowphase/dxCcdQuery.h).
ode_mt_compile_after("collision_libccd.cpp" collision_libccd.h)

# The sign of a zero depth follows from the order of the arguments in fmax(0.0, x). g++ takes the order to be free and may change
# it; Debian 12's binary has it as it is written, and that of a release whose compiler changed it has a seam of its own. Elsewhere upstream calls
# neither fmax nor fmin (docs/exactness.md).
set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/collision_libccd.cpp" APPEND PROPERTY
    COMPILE_OPTIONS -fno-builtin-fmax)

# Spaces of all kinds are ours: they find pairs incrementally, and report them in upstream's order
# (ode_mt/collision/spaces/dxOrderedSpace.h).
ode_mt_rename(collision_space.cpp dSimpleSpaceCreate dHashSpaceCreate dHashSpaceSetLevels dHashSpaceGetLevels dSpaceCollide)
ode_mt_rename(collision_quadtreespace.cpp dQuadTreeSpaceCreate)
ode_mt_rename(collision_sapspace.cpp dSweepAndPruneSpaceCreate)

# The triangular solves of upstream's LCP solver with vectors: same bits, less time (docs/exact.md).
ode_mt_compile_after("lcp.cpp" lcp.h)

# Upstream's own solver is left with what is not finite, and with the other cases of docs/exact.md
# (ode_mt/dynamics/world_step/exact/dxDantzig.cpp). There the sign of a NaN may decide whether it reports an error. Of two NaNs
# that are added one is kept, and vectors would keep another one than Debian's binary, which has none in these loops
# (docs/exactness.md). Problems without limits, which it solves, too, take as long as before.
set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/lcp.cpp" APPEND PROPERTY
    COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-tree-loop-vectorize>)

# Those that this release alone needs, and the files that implement them.
set(ODE_MT_RELEASE_SOURCES "")
include("${ODE_MT_RELEASE_DIR}/seams.cmake" OPTIONAL)
list(TRANSFORM ODE_MT_RELEASE_SOURCES PREPEND "${ODE_MT_RELEASE_DIR}/")
set(ODE_MT_RELEASE_SOURCES "${ODE_MT_RELEASE_SOURCES}" CACHE INTERNAL "Files of the release's own seams")

configure_file(seams/upstream.h.in seams/upstream.h @ONLY)
