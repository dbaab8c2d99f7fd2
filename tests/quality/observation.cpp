#include "observation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quality {

void use(const Stepping &stepping, scenes::Scene &scene) {
    for (const dWorldID world : scene.inventory().worlds) dWorldSetQuickStepNumIterations(world, stepping.iterations);
}

void PenetrationLog::contact(const dContact &contact) { m_depths.push_back(contact.geom.depth); }

double PenetrationLog::mean() const {
    return m_depths.empty() ? 0 : std::accumulate(m_depths.begin(), m_depths.end(), 0.0) / static_cast<double>(m_depths.size());
}

double PenetrationLog::quantile(double part) const { return quantileOf(m_depths, part); }

double quantileOf(std::vector<double> numbers, double part) {
    if (numbers.empty()) return 0;
    const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(numbers.size() - 1));
    std::nth_element(numbers.begin(), place, numbers.end());
    return *place;
}

double kineticEnergy(dBodyID body) {
    if (dBodyIsKinematic(body)) return 0;
    dMass mass;
    dBodyGetMass(body, &mass);
    const dReal *const v = dBodyGetLinearVel(body), *const w = dBodyGetAngularVel(body);
    dVector3 own;
    dBodyVectorFromWorld(body, w[0], w[1], w[2], own);
    double sum = mass.mass * dCalcVectorDot3(v, v) / 2;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += own[i] * mass.I[4 * i + j] * own[j] / 2;
    return sum;
}

double kineticEnergy(const std::vector<dBodyID> &bodies) {
    double sum = 0;
    for (const dBodyID body : bodies) sum += kineticEnergy(body);
    return sum;
}

double potentialEnergy(const std::vector<dBodyID> &bodies, double gravity) {
    double sum = 0;
    for (const dBodyID body : bodies) {
        dMass mass;
        dBodyGetMass(body, &mass);
        sum += mass.mass * gravity * dBodyGetPosition(body)[2];
    }
    return sum;
}

Places::Places(const std::vector<dBodyID> &bodies) {
    for (const dBodyID body : bodies) {
        Place place{body, {}};
        std::copy_n(dBodyGetPosition(body), 3, place.position);
        m_places.push_back(place);
    }
}

std::vector<double> Places::moves(int axes) const {
    std::vector<double> all;
    for (const Place &place : m_places) {
        double square = 0;
        for (int i = 0; i < axes; ++i) square += std::pow(dBodyGetPosition(place.body)[i] - place.position[i], 2);
        all.push_back(std::sqrt(square));
    }
    return all;
}

double Places::largestHorizontalMove() const { return quantileOf(moves(2), 1); }
double Places::largestMove() const { return quantileOf(moves(3), 1); }
double Places::medianMove() const { return quantileOf(moves(3), 0.5); }

int Places::countLower(double height) const {
    return static_cast<int>(std::count_if(m_places.begin(), m_places.end(), [height](const Place &place) {
        return dBodyGetPosition(place.body)[2] < place.position[2] - height;
    }));
}

void run(scenes::Scene &scene, int frames) {
    for (int i = 0; i < frames; ++i) scene.frame();
}

std::vector<Quantity> observeRest(scenes::Scene &scene, int settling, int watched) {
    run(scene, settling);
    const std::vector<dBodyID> &bodies = scene.inventory().bodies;
    const Places places(bodies);
    PenetrationLog depths(scene);
    std::vector<double> energies(bodies.size());
    for (int i = 0; i < watched; ++i) {
        scene.frame();
        for (std::size_t body = 0; body < bodies.size(); ++body) energies[body] += kineticEnergy(bodies[body]) / watched;
    }
    return {{"median drift", "m", places.medianMove(), 1e-4},
            {"mean depth", "m", depths.mean(), 1e-5},
            {"depth that one contact of 20 exceeds", "m", depths.quantile(0.95), 1e-4},
            {"median kinetic energy", "J", quantileOf(energies, 0.5), 1e-5}};
}

Gap gapOf(const std::vector<dJointID> &joints) {
    Gap gap{0, 0};
    int count = 0;
    for (const dJointID joint : joints) {
        dVector3 first, second;
        if (dJointGetType(joint) == dJointTypeBall) {
            dJointGetBallAnchor(joint, first);
            dJointGetBallAnchor2(joint, second);
        } else if (dJointGetType(joint) == dJointTypeHinge) {
            dJointGetHingeAnchor(joint, first);
            dJointGetHingeAnchor2(joint, second);
        } else {
            continue;
        }
        const double distance = std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
        gap.mean += distance;
        gap.largest = std::max(gap.largest, distance);
        ++count;
    }
    if (count > 0) gap.mean /= count;
    return gap;
}

}  // namespace quality
