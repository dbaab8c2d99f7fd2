// Runs a scene and keeps what an onlooker sees of it. A scene of several worlds or spaces: the grid, the
// cells and the events are those of the first.
#pragma once

#include "record/cluster_overlay.h"
#include "scenes/scene.h"

namespace record {

class Recorder {
public:
    explicit Recorder(scenes::Scene &scene) : m_scene(scene) {}

    std::vector<Geom> geoms() const;
    void runFrame();
    Frame frame();  // as it is now; events are returned once

private:
    scenes::Scene &m_scene;
    ClusterOverlay m_overlay;
    std::vector<Event> m_events;
    long m_frames = 0;
};

}  // namespace record
