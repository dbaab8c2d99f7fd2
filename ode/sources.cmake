# The upstream files of Debian's configuration (double or single precision, OPCODE, system libccd).
# Left out, because ode_mt/ implements their interfaces (see ode/seams.cmake): error.cpp, misc.cpp.
set(_core
    array box capsule collision_convex_trimesh collision_cylinder_box collision_cylinder_plane
    collision_cylinder_sphere collision_cylinder_trimesh collision_kernel collision_libccd
    collision_quadtreespace collision_sapspace collision_space collision_transform
    collision_trimesh_box collision_trimesh_ccylinder collision_trimesh_disabled
    collision_trimesh_internal collision_trimesh_opcode collision_trimesh_plane collision_trimesh_ray
    collision_trimesh_sphere collision_trimesh_trimesh collision_trimesh_trimesh_old collision_util
    convex cylinder default_threading export-dif fastdot fastldltfactor fastldltsolve fastlsolve
    fastltsolve fastvecscale heightfield lcp mass mat matrix memory objects obstack ode odeinit odemath
    odeou odetls plane quickstep ray resource_control rotation simple_cooperative sphere step
    threading_base threading_impl threading_pool_posix threading_pool_win timer util)
set(_joints
    amotor ball contact dball dhinge fixed hinge hinge2 joint lmotor null piston plane2d pr pu slider
    transmission universal)
set(_opcode
    OPC_AABBCollider OPC_AABBTree OPC_BaseModel OPC_Collider OPC_Common OPC_HybridModel OPC_LSSCollider
    OPC_MeshInterface OPC_Model OPC_OBBCollider Opcode OPC_OptimizedTree OPC_Picking OPC_PlanesCollider
    OPC_RayCollider OPC_SphereCollider OPC_TreeBuilders OPC_TreeCollider OPC_VolumeCollider)
set(_ice
    IceAABB IceContainer IceHPoint IceIndexedTriangle IceMatrix3x3 IceMatrix4x4 IceOBB IcePlane IcePoint
    IceRandom IceRay IceRevisitedRadix IceSegment IceTriangle IceUtils)
set(_ou atomic customization malloc threadlocalstorage)

function(_ode_mt_upstream_paths out folder)
    list(TRANSFORM ARGN PREPEND "${ODE_MT_UPSTREAM_DIR}/${folder}/")
    list(TRANSFORM ARGN APPEND ".cpp")
    set(${out} ${ARGN} PARENT_SCOPE)
endfunction()

_ode_mt_upstream_paths(_core ode/src ${_core})
_ode_mt_upstream_paths(_joints ode/src/joints ${_joints})
_ode_mt_upstream_paths(_opcode OPCODE ${_opcode})
_ode_mt_upstream_paths(_ice OPCODE/Ice ${_ice})
_ode_mt_upstream_paths(ODE_MT_UPSTREAM_OU ou/src/ou ${_ou})
set(ODE_MT_UPSTREAM_CORE ${_core})
set(ODE_MT_UPSTREAM_JOINTS ${_joints})
set(ODE_MT_UPSTREAM_SOURCES ${_core} ${_joints} ${_opcode} ${_ice} ${ODE_MT_UPSTREAM_OU})
