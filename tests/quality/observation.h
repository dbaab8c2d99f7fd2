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

    double mean() const;  // m
    double quantile(double part) const;

private:
    scenes::Scene &m_scene;
    std::vector<double> m_depths;
};

// The smallest number that is no less than `part` (0 to 1) of all; 0: there are none.
double quantileOf(std::vector<double> numbers, double part);

double kineticEnergy(dBodyID body);  // J
double kineticEnergy(const std::vector<dBodyID> &bodies);
double potentialEnergy(const std::vector<dBodyID> &bodies, double gravity);  // J

// Positions to measure displacements from.
class Places {
public:
    explicit Places(const std::vector<dBodyID> &bodies);
    double largestHorizontalMove() const;  // m, since then
    double largestMove() const;
    double medianMove() const;
    // Bodies that are lower by more than `height` (m).
    int countLower(double height) const;

private:
    std::vector<double> moves(int axes) const;

    struct Place {
        dBodyID body;
        dVector3 position;
    };
    std::vector<Place> m_places;
};

// Runs the scene: `settling` frames unobserved, then `watched` ones, and measures what lies still: drift, depth of contacts, energy.
// Medians, since single bodies of a heap still tumble when most have come to rest: with another rounding, others do.
std::vector<Quantity> observeRest(scenes::Scene &scene, int settling, int watched);

void run(scenes::Scene &scene, int frames);

// Distance of the two anchors of ball joints and hinges: mean and largest, m.
struct Gap {
    double mean, largest;
};
Gap gapOf(const std::vector<dJointID> &joints);

}  // namespace quality
