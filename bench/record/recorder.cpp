#include "record/recorder.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "loader/scene/sdf_scene.h"
#include "record/geom_shape.h"

namespace record {

namespace {

using Islands = std::unordered_map<dBodyID, int>;

// Bodies that a scene does not list are passed through, too.
void visit(dBodyID first, int island, Islands &islands) {
    std::vector<dBodyID> open = {first};
    islands.emplace(first, island);
    while (!open.empty()) {
        const dBodyID body = open.back();
        open.pop_back();
        for (int i = 0; i < dBodyGetNumJoints(body); ++i) {
            const dJointID joint = dBodyGetJoint(body, i);
            if (!dJointIsEnabled(joint)) continue;
            for (const int side : {0, 1}) {
                const dBodyID other = dJointGetBody(joint, side);
                if (other && dBodyIsEnabled(other) && islands.emplace(other, island).second) open.push_back(other);
            }
        }
    }
}

}  // namespace

std::vector<int> islandsOf(const std::vector<dBodyID> &bodies) {
    Islands islands;
    int count = 0;
    std::vector<int> found;
    for (const dBodyID body : bodies) {
        if (dBodyIsEnabled(body) && islands.count(body) == 0) visit(body, count++, islands);
        const auto island = islands.find(body);
        found.push_back(island == islands.end() ? kNoIsland : island->second);
    }
    return found;
}

Recorder::Recorder(scenes::Scene &scene, const RecorderSettings &settings) : m_scene(scene) {
    if (settings.clusters) m_overlay.emplace();
    if (settings.contacts) m_contacts.emplace();
    if (settings.workers) m_workers.emplace();
}

std::vector<Geom> Recorder::geoms() const {
    const std::vector<dBodyID> &bodies = m_scene.inventory().bodies;
    std::vector<Geom> geoms;
    for (dGeomID geom : m_scene.inventory().geoms) {
        const auto body = std::find(bodies.begin(), bodies.end(), dGeomGetBody(geom));
        geoms.push_back(
            {shapeOf(geom), body == bodies.end() ? Geom::kStatic : static_cast<int>(body - bodies.begin())});
    }
    return geoms;
}

// The scenes of the catalogue have no names.
std::vector<std::string> Recorder::bodyNames() const {
    const auto *const world = dynamic_cast<const worlds::SdfScene *>(&m_scene);
    return world != nullptr ? world->bodyNames() : std::vector<std::string>();
}

// As Scene::frame, with looks at what finish() empties.
void Recorder::runFrame() {
    m_scene.control();
    if (m_contacts) m_contacts->clear();
    m_scene.collide();
    m_scene.step();
    m_islands = islandsOf(m_scene.inventory().bodies);
    if (m_workers) m_stepped = m_workers->of(m_scene.inventory().bodies);
    m_scene.finish();
    ++m_frames;
    if (!m_overlay) return;
    const scenes::Inventory &inventory = m_scene.inventory();
    const std::vector<Event> events = m_overlay->events(inventory.worlds.front(), inventory.spaces.front());
    m_events.insert(m_events.end(), events.begin(), events.end());
}

void Recorder::addClusters(Frame &frame) const {
    const scenes::Inventory &inventory = m_scene.inventory();
    const dWorldID world = inventory.worlds.front();
    const dSpaceID space = inventory.spaces.front();
    frame.clusters = m_overlay->clusters(world, space);
    frame.grid = m_overlay->grid(world, space);
    frame.cells = m_overlay->cells(world, space);
    for (std::size_t i = 0; i < inventory.bodies.size(); ++i) frame.bodyClusters[i] = m_overlay->of(inventory.bodies[i]);
    for (std::size_t i = 0; i < inventory.geoms.size(); ++i) frame.memberships[i] = m_overlay->of(inventory.geoms[i]);
}

void Recorder::addBodies(Frame &frame) const {
    for (dBodyID body : m_scene.inventory().bodies) {
        frame.bodies.push_back(poseOf(body));
        frame.velocities.push_back(velocityOf(body));
        frame.awake.push_back(dBodyIsEnabled(body) != 0);
    }
    frame.islands = m_islands;
    frame.islands.resize(frame.bodies.size(), kNoIsland);  // finish() may have made bodies
    if (!m_workers) return;
    frame.workers = m_stepped;
    frame.workers.resize(frame.bodies.size(), -1);
}

Frame Recorder::frame() {
    const scenes::Inventory &inventory = m_scene.inventory();
    Frame frame;
    frame.number = m_frames;
    frame.time = m_scene.time();
    frame.events = std::exchange(m_events, {});
    addBodies(frame);
    for (dGeomID geom : inventory.geoms) frame.geoms.push_back(poseOf(geom));
    frame.bodyClusters.resize(inventory.bodies.size());
    frame.memberships.resize(inventory.geoms.size());
    if (m_overlay) addClusters(frame);
    if (m_contacts) frame.contacts = m_contacts->contacts(inventory.geoms);
    return frame;
}

}  // namespace record
