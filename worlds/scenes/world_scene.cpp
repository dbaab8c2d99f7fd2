#include "scenes/world_scene.h"

namespace scenes {

namespace {

dSpaceID createSpace(SpaceKind kind) {
    switch (kind) {
        case SpaceKind::Simple:
            return dSimpleSpaceCreate(nullptr);
        case SpaceKind::SweepAndPrune:
            return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
        case SpaceKind::QuadTree: {
            const dVector3 center = {0, 0, 0},
                           extents = {256, 256, 256};  // m; geoms outside stay in the root
            const int depth = 6;                       // leaves of 8 m
            return dQuadTreeSpaceCreate(nullptr, center, extents, depth);
        }
        case SpaceKind::Hash:
            break;
    }
    return dHashSpaceCreate(nullptr);
}

}  // namespace

WorldScene::WorldScene(const SceneOptions &options, dReal stepSize)
    : Scene(stepSize),
      m_stepper(options.stepper),
      m_world(dWorldCreate()),
      m_space(createSpace(options.space)),
      m_contactGroup(dJointGroupCreate(0)) {
    dWorldSetGravity(m_world, 0, 0, REAL(-9.81));
    dWorldSetAutoDisableFlag(m_world, options.autoDisable ? 1 : 0);

    m_surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
    m_surface.mu = REAL(0.8);
    m_surface.soft_erp = REAL(0.2);
    m_surface.soft_cfm = REAL(1e-5);

    m_inventory.worlds.push_back(m_world);
    m_inventory.spaces.push_back(m_space);
}

void WorldScene::useBox3DDefaults() {
    dWorldSetGravity(m_world, 0, 0, -10);
    m_surface.mu = REAL(0.6);
}

WorldScene::~WorldScene() {
    dJointGroupDestroy(m_contactGroup);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

void WorldScene::collide() {
    m_contacts = 0;
    dSpaceCollide(m_space, this, &WorldScene::nearCallback);
}

void WorldScene::step() {
    if (m_stepper == Stepper::World)
        dWorldStep(m_world, m_stepSize);
    else
        dWorldQuickStep(m_world, m_stepSize);
}

void WorldScene::finish() {
    dJointGroupEmpty(m_contactGroup);
    m_time += m_stepSize;
}

void WorldScene::nearCallback(void *scene, dGeomID o1, dGeomID o2) {
    static_cast<WorldScene *>(scene)->meet(o1, o2);
}

void WorldScene::meet(dGeomID o1, dGeomID o2) {
    if (m_observer) m_observer->nearPair(o1, o2);
    if (dGeomIsSpace(o1) || dGeomIsSpace(o2)) {
        dSpaceCollide2(o1, o2, this, &WorldScene::nearCallback);
        return;
    }
    const dBodyID body1 = dGeomGetBody(o1), body2 = dGeomGetBody(o2);
    if (body1 && body2 && dAreConnectedExcluding(body1, body2, dJointTypeContact)) return;

    thread_local dContact contacts[kMaxContacts];
    const int count = dCollide(o1, o2, kMaxContacts, &contacts[0].geom, sizeof(dContact));
    if (count == 0) return;
    const dSurfaceParameters parameters = surface(o1, o2);
    for (int i = 0; i < count; ++i) {
        dContact &contact = contacts[i];
        contact.surface = parameters;
        if (m_observer) m_observer->contact(contact);
        dJointAttach(dJointCreateContact(m_world, m_contactGroup, &contact), body1, body2);
    }
    m_contacts += count;
}

}  // namespace scenes
