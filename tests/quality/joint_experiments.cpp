// Joints under load: pendulums, chains, motors, stops.
#include "judged_scenes.h"
#include "observation.h"

#include <algorithm>
#include <cmath>

namespace quality {

namespace {

// Falls from level; the energy that is then missing or too much, as a part of that of the fall.
std::vector<Quantity> pendulum(const Stepping &stepping, bool isHinge) {
    Lab lab(stepping.stepper, REAL(0.002));
    use(stepping, lab);
    std::vector<dBodyID> links;
    for (int i = 0; i < 2; ++i) {
        const dReal x = static_cast<dReal>(i);
        links.push_back(lab.addBox({x + REAL(0.5), 0, 3}, {1, REAL(0.1), REAL(0.1)}, 5));
        const dBodyID previous = i == 0 ? nullptr : links[0];
        if (isHinge)
            lab.addHinge(links.back(), previous, {x, 0, 3}, scenes::kAxisY);
        else
            lab.addBall(links.back(), previous, {x, 0, 3});
    }
    const double before = potentialEnergy(links, 9.81), fall = 2 * 5 * 9.81;  // J, to one metre below
    run(lab, 1500);
    const Gap gap = gapOf(lab.inventory().joints);
    const double after = potentialEnergy(links, 9.81) + kineticEnergy(links);
    return {{"error of the energy", "of the fall", std::fabs(after - before) / fall, 2e-3}, {"largest gap", "m", gap.largest, 1e-5}};
}

std::vector<Quantity> ballPendulum(const Stepping &stepping) { return pendulum(stepping, false); }
std::vector<Quantity> hingePendulum(const Stepping &stepping) { return pendulum(stepping, true); }

// Hangs straight down with a load of fifty links.
std::vector<Quantity> loadedChain(const Stepping &stepping) {
    constexpr int kLinks = 20;
    constexpr dReal kLength = REAL(0.2);  // m
    Lab lab(stepping.stepper, REAL(0.005));
    use(stepping, lab);
    dBodyID previous = nullptr;
    for (int i = 0; i < kLinks; ++i) {
        const dReal top = 5 - kLength * static_cast<dReal>(i);
        const dBodyID link = lab.addCapsule({0, 0, top - kLength / 2}, scenes::kAxisZ, REAL(0.02), kLength / 2, 1);
        lab.addBall(link, previous, {0, 0, top});
        previous = link;
    }
    const dReal bottom = 5 - kLength * kLinks;
    const dBodyID load = lab.addSphere({0, 0, bottom - REAL(0.2)}, REAL(0.2), 50);
    lab.addBall(load, previous, {0, 0, bottom});
    double stretch = 0;
    run(lab, 300);
    const int watched = 200;
    for (int i = 0; i < watched; ++i) {
        lab.frame();
        stretch += (bottom - REAL(0.2) - dBodyGetPosition(load)[2]) / watched;
    }
    return {{"stretch", "m", std::fabs(stretch), 1e-4}, {"kinetic energy", "J", kineticEnergy(lab.inventory().bodies), 1e-3}};
}

// A motor lifts an arm against a stop and holds it there.
std::vector<Quantity> stop(const Stepping &stepping) {
    Lab lab(stepping.stepper);
    use(stepping, lab);
    const dBodyID arm = lab.addBox({REAL(0.5), 0, 2}, {1, REAL(0.1), REAL(0.1)}, 5);
    const dBodyID load = lab.addBox({1, 0, 2}, {REAL(0.2), REAL(0.2), REAL(0.2)}, 10);
    lab.addFixed(load, arm);
    const dJointID motor = lab.addHinge(arm, nullptr, {0, 0, 2}, scenes::kAxisY);
    dJointSetHingeParam(motor, dParamLoStop, REAL(-0.5));
    dJointSetHingeParam(motor, dParamHiStop, REAL(0.5));
    dJointSetHingeParam(motor, dParamVel, -1);  // upwards
    dJointSetHingeParam(motor, dParamFMax, 300);
    run(lab, 200);
    double beyond = 0, speed = 0;
    for (int i = 0; i < 100; ++i) {
        lab.frame();
        beyond = std::max(beyond, std::fabs(std::fabs(dJointGetHingeAngle(motor)) - 0.5));
        speed = std::max(speed, std::fabs(double(dJointGetHingeAngleRate(motor))));
    }
    return {{"angle from the stop", "rad", beyond, 1e-4}, {"speed", "rad/s", speed, 1e-3}};
}

// Five arms in a row, each driven by a motor at rest: how much they sag.
std::vector<Quantity> motors(const Stepping &stepping) {
    Lab lab(stepping.stepper);
    use(stepping, lab);
    dBodyID previous = nullptr;
    for (int i = 0; i < 5; ++i) {
        const dReal x = REAL(0.4) * static_cast<dReal>(i);
        const dBodyID arm = lab.addBox({x + REAL(0.2), 0, 2}, {REAL(0.4), REAL(0.1), REAL(0.1)}, 3);
        dJointSetHingeParam(lab.addHinge(arm, previous, {x, 0, 2}, scenes::kAxisY), dParamFMax, 1000);
        previous = arm;
    }
    const Places places(lab.inventory().bodies);
    run(lab, 40);
    return {{"sag", "m", places.largestMove(), 1e-3}};
}

std::vector<Quantity> gaps(const Stepping &stepping, const std::string &name, int frames) {
    const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(name, stepping.stepper);
    use(stepping, *scene);
    double mean = 0, largest = 0;
    for (int i = 0; i < frames; ++i) {
        scene->frame();
        const Gap gap = gapOf(scene->inventory().joints);
        mean += gap.mean / frames;
        largest = std::max(largest, gap.largest);
    }
    return {{"mean gap", "m", mean, 1e-5}, {"largest gap", "m", largest, 1e-3}};
}

std::vector<Quantity> ragdolls(const Stepping &stepping) { return gaps(stepping, "ragdolls:4", 300); }
std::vector<Quantity> bridge(const Stepping &stepping) { return gaps(stepping, "bridge", 400); }
std::vector<Quantity> grid(const Stepping &stepping) { return gaps(stepping, "joint_grid:40", 100); }
std::vector<Quantity> net(const Stepping &stepping) { return gaps(stepping, "net", 200); }
std::vector<Quantity> swingingChain(const Stepping &stepping) { return gaps(stepping, "chain:20", 300); }

}  // namespace

std::vector<Experiment> jointExperiments() {
    return {{"pendulum_ball", "two links on ball joints, falling from level", ballPendulum},
            {"pendulum_hinge", "the same on hinges", hingePendulum},
            {"loaded_chain", "20 links under a load of 50 kg", loadedChain},
            {"stop", "a motor holds a load at its stop", stop},
            {"motors", "five arms in a row, each held by a motor", motors},
            {"ragdolls", "four ragdolls that fall", ragdolls},
            {"bridge", "planks on hinges with boxes on them", bridge},
            {"joint_grid", "40 by 40 balls on ball joints, hanging by the top row", grid},
            {"net", "900 plates on balls and hinges, falling to the ground", net},
            {"swinging_chain", "20 capsules on ball joints, falling from level", swingingChain}};
}

}  // namespace quality
