// What moves: bounces, dominoes, wheels.
#include "judged_scenes.h"
#include "observation.h"

#include <algorithm>
#include <cmath>

namespace quality {

namespace {

// A ball falls by 2 m and bounces with 0.8 of its speed.
std::vector<Quantity> bounce(const Stepping &stepping) {
    Lab lab(stepping.stepper, REAL(0.002));
    use(stepping, lab);
    lab.surfaceOfAll().mode |= dContactBounce;
    lab.surfaceOfAll().bounce = REAL(0.8);
    lab.surfaceOfAll().bounce_vel = REAL(0.1);
    lab.addGround();
    constexpr double kRadius = 0.2, kFall = 2;
    const dBodyID ball = lab.addSphere({0, 0, kRadius + kFall}, kRadius, 5);
    run(lab, 400);  // 0.64 s to the ground
    double highest = 0;
    for (int i = 0; i < 400; ++i) {
        lab.frame();
        highest = std::max(highest, dBodyGetPosition(ball)[2] - kRadius);
    }
    return {{"height", "m", highest, 1e-3, Quantity::Kind::reference}};
}

// The first is pushed; when the last one falls, and how many stay.
std::vector<Quantity> dominoes(const Stepping &stepping) {
    Lab lab(stepping.stepper, REAL(0.005));
    use(stepping, lab);
    lab.surfaceOfAll().mu = REAL(0.5);
    lab.addGround();
    constexpr dReal kHeight = REAL(0.5);
    std::vector<dBodyID> stones;
    for (int i = 0; i < 12; ++i)
        stones.push_back(lab.addBox({REAL(0.25) * static_cast<dReal>(i), 0, kHeight / 2}, {REAL(0.08), REAL(0.25), kHeight}, 5));
    dBodySetAngularVel(stones[0], 0, 4, 0);
    dBodySetLinearVel(stones[0], 1, 0, 0);
    double seconds = 0;
    for (int i = 0; i < 600; ++i) {
        lab.frame();
        if (seconds == 0 && dBodyGetPosition(stones.back())[2] < 0.8 * kHeight / 2) seconds = lab.time();
    }
    const auto standing = std::count_if(stones.begin(), stones.end(),
                                        [&](dBodyID stone) { return dBodyGetPosition(stone)[2] > 0.95 * kHeight / 2; });
    return {{"standing", "", static_cast<double>(standing), 0}, {"time until the last one falls", "s", seconds, 0.05, Quantity::Kind::reference}};
}

// Drives for three seconds on free ground.
std::vector<Quantity> rover(const Stepping &stepping) {
    const std::unique_ptr<scenes::Scene> scene = makeJudgedScene("rover:1", stepping.stepper);
    use(stepping, *scene);
    PenetrationLog depths(*scene);
    run(*scene, 125);
    const dReal *const at = dBodyGetPosition(scene->inventory().bodies.front());
    return {{"x", "m", at[0], 2e-2, Quantity::Kind::reference},
            {"y", "m", at[1], 2e-2, Quantity::Kind::reference},
            {"mean depth", "m", depths.mean(), 1e-5},
            {"largest gap", "m", gapOf(scene->inventory().joints).largest, 1e-5}};
}

// Two rows of balls collide head-on without friction: momentum stays, and what remains of the energy.
std::vector<Quantity> collision(const Stepping &stepping) {
    Lab lab(stepping.stepper, REAL(0.005));
    use(stepping, lab);
    dWorldSetGravity(lab.world(), 0, 0, 0);
    lab.surfaceOfAll().mu = 0;
    constexpr dReal kRadius = REAL(0.2);
    for (int i = 0; i < 10; ++i) {
        const dReal x = (static_cast<dReal>(i) - REAL(4.5)) * REAL(0.401) + (i < 5 ? REAL(-0.5) : REAL(0.5));
        dBodySetLinearVel(lab.addSphere({x, 0, 0}, kRadius, 5), i < 5 ? 2 : -1, 0, 0);
    }
    PenetrationLog depths(lab);
    run(lab, 400);
    double momentum = 0;
    for (const dBodyID ball : lab.inventory().bodies) momentum += 5 * dBodyGetLinearVel(ball)[0] - 5 * 0.5;
    return {{"error of the momentum", "kg m/s", std::fabs(momentum), 1e-9},
            {"kinetic energy", "J", kineticEnergy(lab.inventory().bodies), 1, Quantity::Kind::reference},
            {"largest depth", "m", depths.quantile(1), 5e-4}};
}

}  // namespace

std::vector<Experiment> movingExperiments() {
    return {{"bounce", "a ball bounces", bounce},
            {"dominoes", "twelve dominoes", dominoes},
            {"rover", "a rover drives two seconds", rover},
            {"collision", "two rows of balls collide", collision}};
}

}  // namespace quality
