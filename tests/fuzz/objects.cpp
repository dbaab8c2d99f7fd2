#include "objects.h"

#include <algorithm>

namespace fuzz {

Reference Objects::add(ObjectKind kind, void *object, int number) {
    std::vector<void *> &objects = m_objects[static_cast<int>(kind)];
    if (number < 0) number = static_cast<int>(objects.size());
    if (number >= static_cast<int>(objects.size())) objects.resize(static_cast<std::size_t>(number) + 1, nullptr);
    objects[static_cast<std::size_t>(number)] = object;
    return {kind, number};
}

void *Objects::find(const Reference &reference) const {
    const std::vector<void *> &objects = m_objects[static_cast<int>(reference.kind)];
    const auto number = static_cast<std::size_t>(reference.number);
    return reference.number >= 0 && number < objects.size() ? objects[number] : nullptr;
}

int Objects::numberOf(ObjectKind kind, const void *object) const {
    const std::vector<void *> &objects = m_objects[static_cast<int>(kind)];
    const auto found = std::find(objects.begin(), objects.end(), object);
    return object == nullptr || found == objects.end() ? -1 : static_cast<int>(found - objects.begin());
}

std::vector<Reference> Objects::living(ObjectKind kind) const {
    std::vector<Reference> all;
    const std::vector<void *> &objects = m_objects[static_cast<int>(kind)];
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i] != nullptr) all.push_back({kind, static_cast<int>(i)});
    return all;
}

int Objects::countLiving(ObjectKind kind) const {
    const std::vector<void *> &objects = m_objects[static_cast<int>(kind)];
    return static_cast<int>(objects.size() - static_cast<std::size_t>(std::count(objects.begin(), objects.end(), nullptr)));
}

void Objects::forget(ObjectKind kind, const void *object) {
    const int number = numberOf(kind, object);
    if (number >= 0) m_objects[static_cast<int>(kind)][static_cast<std::size_t>(number)] = nullptr;
    if (kind == ObjectKind::joint)
        m_homes.erase(std::remove_if(m_homes.begin(), m_homes.end(), [&](const JointHome &home) { return home.joint == object; }),
                      m_homes.end());
}

void Objects::forgetGeom(dGeomID geom) {
    if (dGeomIsSpace(geom))
        forgetSpace(reinterpret_cast<dSpaceID>(geom));
    else
        forget(ObjectKind::geom, geom);
}

// Upstream cannot list the geoms of a quad tree: all that are known are asked for their space.
void Objects::forgetSpace(dSpaceID space) {
    forget(ObjectKind::space, space);
    if (dSpaceGetCleanup(space) == 0) return;
    for (const Reference &reference : living(ObjectKind::geom)) {
        const auto geom = static_cast<dGeomID>(find(reference));
        if (geom != nullptr && dGeomGetSpace(geom) == space) forget(ObjectKind::geom, geom);
    }
    for (const Reference &reference : living(ObjectKind::space)) {
        const auto inner = static_cast<dSpaceID>(find(reference));
        if (inner != nullptr && dGeomGetSpace(reinterpret_cast<dGeomID>(inner)) == space) forgetSpace(inner);
    }
}

void Objects::forgetWorld(dWorldID world) {
    forget(ObjectKind::world, world);
    for (const Reference &reference : living(ObjectKind::body))
        if (dBodyGetWorld(static_cast<dBodyID>(find(reference))) == world) forget(ObjectKind::body, find(reference));
    for (const Reference &reference : living(ObjectKind::joint))
        if (worldOf(static_cast<dJointID>(find(reference))) == world) forget(ObjectKind::joint, find(reference));
}

void Objects::forgetGroup(dJointGroupID group, bool isDestroyed) {
    for (const Reference &reference : living(ObjectKind::joint)) {
        void *const joint = find(reference);
        if (std::any_of(m_homes.begin(), m_homes.end(), [&](const JointHome &home) { return home.joint == joint && home.group == group; }))
            forget(ObjectKind::joint, joint);
    }
    if (isDestroyed) forget(ObjectKind::group, group);
}

void Objects::putJoint(dJointID joint, dWorldID world, dJointGroupID group) { m_homes.push_back({joint, world, group}); }

dWorldID Objects::worldOf(dJointID joint) const {
    for (const JointHome &home : m_homes)
        if (home.joint == joint) return home.world;
    return nullptr;
}

bool Objects::isInGroup(dJointID joint) const {
    for (const JointHome &home : m_homes)
        if (home.joint == joint) return home.group != nullptr;
    return false;
}

namespace {

const void *dataOf(dGeomID geom) {
    if (dGeomGetClass(geom) == dTriMeshClass) return dGeomTriMeshGetTriMeshDataID(geom);
    return dGeomGetClass(geom) == dHeightfieldClass ? dGeomHeightfieldGetHeightfieldData(geom) : nullptr;
}

}  // namespace

bool Objects::isInUse(const void *data) const {
    if (m_pinned.count(data) != 0) return true;
    for (const Reference &reference : living(ObjectKind::geom))
        if (dataOf(static_cast<dGeomID>(find(reference))) == data) return true;
    return false;
}

void Objects::pinData(dGeomID geom) {
    if (const void *const data = dataOf(geom)) m_pinned.insert(data);
}

scenes::Inventory Objects::inventory() const {
    scenes::Inventory inventory;
    const auto list = [this](ObjectKind kind, auto &handles) {
        for (const Reference &reference : living(kind))
            handles.push_back(static_cast<typename std::decay_t<decltype(handles)>::value_type>(find(reference)));
    };
    list(ObjectKind::world, inventory.worlds);
    list(ObjectKind::space, inventory.spaces);
    list(ObjectKind::body, inventory.bodies);
    list(ObjectKind::joint, inventory.joints);
    list(ObjectKind::geom, inventory.geoms);
    return inventory;
}

}  // namespace fuzz
