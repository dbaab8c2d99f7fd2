// Friction with a known answer.
#include "observation.h"

#include <algorithm>
#include <cmath>

namespace quality {

namespace {

constexpr double kGravity = 9.81;  // m/s^2

// A box on a slope, with friction 0.5; how far it is from its first place after `frames`, m.
double slide(const Stepping &stepping, dReal angle, const std::function<void(dSurfaceParameters &)> &change, int frames) {
    Lab lab(stepping.stepper);
    use(stepping, lab);
    lab.surfaceOfAll().mu = REAL(0.5);
    change(lab.surfaceOfAll());
    lab.addSlope(angle);
    constexpr dReal kHalf = REAL(0.25);  // m
    const dBodyID box = lab.addBox({-kHalf * std::sin(angle), 0, kHalf * std::cos(angle)}, {2 * kHalf, 2 * kHalf, 2 * kHalf}, 25);
    tilt(box, -angle);
    const Places places({box});
    run(lab, frames);
    return places.largestMove();
}

const dReal kFrictionAngle = std::atan(REAL(0.5)), kDegree = static_cast<dReal>(M_PI / 180);

std::vector<Quantity> slopeBelow(const Stepping &stepping) {
    return {{"distance", "m", slide(stepping, kFrictionAngle - kDegree, [](dSurfaceParameters &) {}, 500), 1e-3}};
}

std::vector<Quantity> slopeAbove(const Stepping &stepping) {
    constexpr int kFrames = 200;
    const double angle = kFrictionAngle + kDegree, seconds = kFrames * 0.01;
    const double right = kGravity * (std::sin(angle) - 0.5 * std::cos(angle)) * seconds * seconds / 2;
    return {{"error of the distance", "m", std::fabs(slide(stepping, angle, [](dSurfaceParameters &) {}, kFrames) - right), 5e-3}};
}

std::vector<Quantity> steepWithoutSliding(const Stepping &stepping) {
    const auto infinite = [](dSurfaceParameters &surface) {
        surface.mode &= ~dContactApprox1;
        surface.mu = dInfinity;
    };
    return {{"distance", "m", slide(stepping, 35 * kDegree, infinite, 300), 1e-3}};
}

// Pushed by less and by more than four contacts of 20 N each can hold.
std::vector<Quantity> pushed(const Stepping &stepping) {
    const auto distance = [&](dReal force, int frames) {
        Lab lab(stepping.stepper);
        use(stepping, lab);
        lab.surfaceOfAll().mode &= ~dContactApprox1;
        lab.surfaceOfAll().mu = 20;
        lab.addGround();
        const dBodyID box = lab.addBox({0, 0, REAL(0.1)}, {REAL(0.6), REAL(0.6), REAL(0.2)}, 30);
        const Places places({box});
        lab.setController([box, force](int) { dBodyAddForce(box, force, 0, 0); });
        run(lab, frames);
        return places.largestHorizontalMove();
    };
    constexpr double kSeconds = 1;
    return {{"distance below the limit", "m", distance(75, 300), 1e-3},
            {"error above the limit", "m", std::fabs(distance(110, 100) - (110 - 80) / 30.0 * kSeconds * kSeconds / 2), 2e-2}};
}

// A box that a kinematic slab carries: how much slower than the slab it still is.
std::vector<Quantity> carried(const Stepping &stepping) {
    Lab lab(stepping.stepper);
    use(stepping, lab);
    const dBodyID slab = lab.addKinematicBox({0, 0, REAL(-0.1)}, {10, 3, REAL(0.2)});
    const std::vector<dBodyID> tower = addTower(lab, {0, 0, REAL(0.2)}, 3, REAL(0.4), 20);
    lab.setController([slab](int frame) { dBodySetLinearVel(slab, std::min(REAL(1.0), REAL(0.02) * static_cast<dReal>(frame)), 0, 0); });
    run(lab, 200);
    double slip = 0;
    for (const dBodyID box : tower) slip = std::max(slip, std::fabs(dBodyGetLinearVel(box)[0] - 1.0));
    return {{"slip", "m/s", slip, 1e-3}, {"distance behind", "m", dBodyGetPosition(slab)[0] - dBodyGetPosition(tower.back())[0], 5e-3}};
}

// A ball that rolls until rolling friction stops it.
std::vector<Quantity> rolling(const Stepping &stepping) {
    Lab lab(stepping.stepper);
    use(stepping, lab);
    lab.surfaceOfAll().mode |= dContactRolling;
    lab.surfaceOfAll().rho = REAL(0.01);
    lab.addGround();
    constexpr dReal kRadius = REAL(0.2);
    const dBodyID ball = lab.addSphere({0, 0, kRadius}, kRadius, 5);
    dBodySetLinearVel(ball, 2, 0, 0);
    dBodySetAngularVel(ball, 0, 2 / kRadius, 0);
    run(lab, 600);
    return {{"distance", "m", dBodyGetPosition(ball)[0], 5e-3, Quantity::Kind::reference},
            {"speed in the end", "m/s", std::fabs(dBodyGetLinearVel(ball)[0]), 1e-4}};
}

}  // namespace

std::vector<Experiment> slidingExperiments() {
    return {{"slope_below", "a box on a slope one degree below the friction angle", slopeBelow},
            {"slope_above", "the same one degree above", slopeAbove},
            {"steep", "a box on a slope of 35 degrees that cannot slide", steepWithoutSliding},
            {"pushed", "a box with fixed limits of friction is pushed", pushed},
            {"carried", "boxes on a slab that starts to move", carried},
            {"rolling", "a ball with rolling friction rolls until it stops", rolling}};
}

}  // namespace quality
