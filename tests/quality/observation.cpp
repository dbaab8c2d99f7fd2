#include "observation.h"

#include <algorithm>
#include <cmath>

namespace quality {

void use(const Stepping &stepping, scenes::Scene &scene) {
    for (const dWorldID world : scene.inventory().worlds) dWorldSetQuickStepNumIterations(world, stepping.iterations);
}

void PenetrationLog::contact(const dContact &contact) {
    m_sum += contact.geom.depth;
    m_largest = std::max(m_largest, double(contact.geom.depth));
    ++m_count;
}

double kineticEnergy(const std::vector<dBodyID> &bodies) {
    double sum = 0;
    for (const dBodyID body : bodies) {
        if (dBodyIsKinematic(body)) continue;
        dMass mass;
        dBodyGetMass(body, &mass);
        const dReal *const v = dBodyGetLinearVel(body), *const w = dBodyGetAngularVel(body);
        dVector3 own;
        dBodyVectorFromWorld(body, w[0], w[1], w[2], own);
        sum += mass.mass * dCalcVectorDot3(v, v) / 2;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) sum += own[i] * mass.I[4 * i + j] * own[j] / 2;
    }
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

double Places::largest(int axes) const {
    double largest = 0;
    for (const Place &place : m_places) {
        double square = 0;
        for (int i = 0; i < axes; ++i) square += std::pow(dBodyGetPosition(place.body)[i] - place.position[i], 2);
        largest = std::max(largest, std::sqrt(square));
    }
    return largest;
}

double Places::largestHorizontalMove() const { return largest(2); }
double Places::largestMove() const { return largest(3); }

void run(scenes::Scene &scene, int frames) {
    for (int i = 0; i < frames; ++i) scene.frame();
}

std::vector<Quantity> observeRest(scenes::Scene &scene, int settling, int watched) {
    run(scene, settling);
    const std::vector<dBodyID> &bodies = scene.inventory().bodies;
    const Places places(bodies);
    PenetrationLog depths(scene);
    double energy = 0;
    for (int i = 0; i < watched; ++i) {
        scene.frame();
        energy += kineticEnergy(bodies) / watched;
    }
    const double count = static_cast<double>(bodies.size());
    return {{"drift", "m", places.largestMove(), 1e-3},
            {"mean depth", "m", depths.mean(), 1e-5},
            {"largest depth", "m", depths.largest(), 2e-4},
            {"kinetic energy a body", "J", energy / count, 1e-5}};
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
