// What experiments observe of a scene.
#pragma once

#include "experiment.h"
#include "lab.h"

#include <string>
#include <vector>

namespace quality {

// Sets the iterations of all worlds of the scene.
void use(const Stepping &stepping, scenes::Scene &scene);

// Depths of contacts while it observes.
class PenetrationLog final : public scenes::Observer {
public:
    explicit PenetrationLog(scenes::Scene &scene) : m_scene(scene) { scene.observe(this); }
    ~PenetrationLog() override { m_scene.observe(nullptr); }
    void contact(const dContact &contact) override;

    double mean() const { return m_count == 0 ? 0 : m_sum / static_cast<double>(m_count); }  // m
    double largest() const { return m_largest; }

private:
    scenes::Scene &m_scene;
    double m_sum = 0, m_largest = 0;
    long m_count = 0;
};

double kineticEnergy(const std::vector<dBodyID> &bodies);                    // J
double potentialEnergy(const std::vector<dBodyID> &bodies, double gravity);  // J

// Positions to measure displacements from.
class Places {
public:
    explicit Places(const std::vector<dBodyID> &bodies);
    double largestHorizontalMove() const;  // m, since then
    double largestMove() const;

private:
    double largest(int axes) const;

    struct Place {
        dBodyID body;
        dVector3 position;
    };
    std::vector<Place> m_places;
};

// Runs the scene: `settling` frames unobserved, then `watched` ones, and measures what lies still: drift, depth of contacts, energy.
std::vector<Quantity> observeRest(scenes::Scene &scene, int settling, int watched);

void run(scenes::Scene &scene, int frames);

// Distance of the two anchors of ball joints and hinges: mean and largest, m.
struct Gap {
    double mean, largest;
};
Gap gapOf(const std::vector<dJointID> &joints);

}  // namespace quality
