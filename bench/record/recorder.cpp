#include "record/recorder.h"

#include "record/geom_shape.h"

#include <algorithm>
#include <utility>

namespace record {

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

void Recorder::runFrame() {
    m_scene.frame();
    ++m_frames;
    const scenes::Inventory &inventory = m_scene.inventory();
    const std::vector<Event> events = m_overlay.events(inventory.worlds.front(), inventory.spaces.front());
    m_events.insert(m_events.end(), events.begin(), events.end());
}

Frame Recorder::frame() {
    const scenes::Inventory &inventory = m_scene.inventory();
    const dWorldID world = inventory.worlds.front();
    const dSpaceID space = inventory.spaces.front();
    Frame frame;
    frame.number = m_frames;
    frame.time = m_scene.time();
    frame.clusters = m_overlay.clusters(world, space);
    frame.grid = m_overlay.grid(world, space);
    frame.cells = m_overlay.cells(world, space);
    frame.events = std::exchange(m_events, {});
    for (dBodyID body : inventory.bodies) {
        frame.bodies.push_back(poseOf(body));
        frame.bodyClusters.push_back(m_overlay.of(body));
    }
    for (dGeomID geom : inventory.geoms) {
        frame.geoms.push_back(poseOf(geom));
        frame.memberships.push_back(m_overlay.of(geom));
    }
    return frame;
}

}  // namespace record
