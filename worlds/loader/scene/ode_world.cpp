#include "loader/scene/ode_world.h"

#include "loader/scene/ode_types.h"

namespace worlds {

namespace {

void setAutoDisable(dWorldID world, const AutoDisable &rest) {
    dWorldSetAutoDisableFlag(world, 1);
    dWorldSetAutoDisableLinearThreshold(world, toReal(rest.linearThreshold));
    dWorldSetAutoDisableAngularThreshold(world, toReal(rest.angularThreshold));
    dWorldSetAutoDisableTime(world, toReal(rest.idleTime));
    dWorldSetAutoDisableSteps(world, rest.idleSteps);
    dWorldSetAutoDisableAverageSamplesCount(world, static_cast<unsigned>(rest.averageSamples));
}

void setDamping(dWorldID world, const Damping &damping) {
    dWorldSetDamping(world, toReal(damping.linear), toReal(damping.angular));
    dWorldSetLinearDampingThreshold(world, toReal(damping.linearThreshold));
    dWorldSetAngularDampingThreshold(world, toReal(damping.angularThreshold));
}

void setMass(dBodyID body, const Mass &source) {
    const Matrix3 &inertia = source.inertia;
    dMass mass;
    dMassSetParameters(&mass, toReal(source.mass), 0, 0, 0, toReal(inertia(0, 0)), toReal(inertia(1, 1)),
                       toReal(inertia(2, 2)), toReal(inertia(0, 1)), toReal(inertia(0, 2)),
                       toReal(inertia(1, 2)));
    dBodySetMass(body, &mass);
}

}  // namespace

dWorldID createWorld(const Physics &physics) {
    const dWorldID world = dWorldCreate();
    const Vector3 &g = physics.gravity;
    dWorldSetGravity(world, toReal(g.x), toReal(g.y), toReal(g.z));
    dWorldSetCFM(world, toReal(physics.cfm));
    dWorldSetERP(world, toReal(physics.erp));
    dWorldSetQuickStepNumIterations(world, physics.iterations);
    dWorldSetQuickStepW(world, toReal(physics.sor));
    dWorldSetContactMaxCorrectingVel(world, toReal(physics.maxCorrectingSpeed));
    dWorldSetContactSurfaceLayer(world, toReal(physics.surfaceLayer));
    if (physics.autoDisable) setAutoDisable(world, *physics.autoDisable);
    if (physics.damping) setDamping(world, *physics.damping);
    return world;
}

dSpaceID createSpace(const Space &space) {
    switch (space.kind) {
        case scenes::SpaceKind::Simple:
            return dSimpleSpaceCreate(nullptr);
        case scenes::SpaceKind::Hash: {
            const dSpaceID hash = dHashSpaceCreate(nullptr);
            dHashSpaceSetLevels(hash, space.minLevel, space.maxLevel);
            return hash;
        }
        case scenes::SpaceKind::SweepAndPrune:
            return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
        case scenes::SpaceKind::QuadTree:
            break;
    }
    const dVector3 center = {toReal(space.center.x), toReal(space.center.y), toReal(space.center.z)};
    const dVector3 extents = {toReal(space.extents.x), toReal(space.extents.y),
                              toReal(space.extents.z)};
    return dQuadTreeSpaceCreate(nullptr, center, extents, space.depth);
}

dBodyID createBody(dWorldID world, const Link &link) {
    const dBodyID body = dBodyCreate(world);
    const Vector3 origin = link.pose.position + link.pose.rotation * link.mass.center;
    dBodySetPosition(body, toReal(origin.x), toReal(origin.y), toReal(origin.z));
    dBodySetQuaternion(body, OdeQuaternion(link.pose.rotation).value);
    setMass(body, link.mass);
    if (link.linearDamping) dBodySetLinearDamping(body, toReal(*link.linearDamping));
    if (link.angularDamping) dBodySetAngularDamping(body, toReal(*link.angularDamping));
    if (!link.gravity) dBodySetGravityMode(body, 0);
    if (!link.autoDisable) dBodySetAutoDisableFlag(body, 0);
    if (link.kinematic) dBodySetKinematic(body);
    return body;
}

}  // namespace worlds
