// Records a scene frame by frame, with its islands.
#pragma once

#include <ode/ode.h>

#include <optional>
#include <vector>

#include "record/cluster_overlay.h"
#include "record/contact_log.h"
#include "scenes/scene.h"

namespace record {

constexpr int kNoIsland = -1;  // of a body that sleeps

// The island of each body, which awake bodies and enabled joints form, contacts among them. Islands are numbered from 0 in the order of their
// first bodies. Requires that contact joints still exist: between a scene's step() and finish().
std::vector<int> islandsOf(const std::vector<dBodyID> &bodies);

struct RecorderSettings {
    bool clusters = true;   // requires ODE_MT
    bool contacts = false;  // with their forces
    bool workers = false;   // requires ODE_MT
};

// Runs a scene and keeps what an onlooker sees of it. Of a scene of several worlds or spaces it keeps the grid, the cells and the
// events of the first.
class Recorder {
public:
    Recorder(scenes::Scene &scene, const RecorderSettings &settings);

    std::vector<Geom> geoms() const;
    std::vector<std::string> bodyNames() const;
    void runFrame();
    Frame frame();  // as it is now; events are returned once

private:
    void addClusters(Frame &frame) const;
    void addBodies(Frame &frame) const;

    scenes::Scene &m_scene;
    std::optional<ClusterOverlay> m_overlay;
    std::optional<ContactLog> m_contacts;
    std::optional<BodyWorkers> m_workers;
    std::vector<int> m_islands, m_stepped;  // in the last step: which island, by which worker
    std::vector<Event> m_events;
    long m_frames = 0;
};

}  // namespace record
