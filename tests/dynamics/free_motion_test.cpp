// The free motion of bodies is that of upstream's formulas, to rounding: masses, gravity, forces, and the torque of bodies that
// turn about no principal axis.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dynamics/quick_step/fast/dxFreeMotion.h"
#include "dynamics/step/islands/dxBodyForces.h"
#include "random_world.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

std::vector<dxBody *> bodiesOf(dWorldID world) {
    std::vector<dxBody *> bodies;
    for (dObject *body = world->firstbody; body != nullptr; body = body->next) bodies.push_back(static_cast<dxBody *>(body));
    return bodies;
}

// What dxFindFreeMotion finds for all bodies of a world.
struct FreeMotionOf {
    explicit FreeMotionOf(dWorldID world) : bodies(bodiesOf(world)), masses(bodies.size()), velocities(bodies.size()) {
        dxIslandStep step{world, kStepSize, {}, nullptr};
        step.island.bodies = const_cast<dxBody *const *>(bodies.data());
        step.island.bodyCount = static_cast<unsigned>(bodies.size());
        dxFindFreeMotion(step, masses.data(), velocities.data());
    }

    const std::vector<dxBody *> bodies;
    std::vector<dxIslandBody> masses;
    std::vector<dxSpatialMotion> velocities;
};

// v + h inv(M) f, by the functions that the exact steppers use. Leaves gravity and torque in the accumulators.
std::vector<double> expectedMotion(const dWorldID world, dxBody &body) {
    dxAddGravity(body, world->gravity);
    dxAddGyroscopicTorque(body, kStepSize);
    dMatrix3 inverse;
    dxFindInvInertia(body, inverse);
    std::vector<double> motion(6);
    for (std::size_t i = 0; i < 3; ++i) {
        motion[i] = body.lvel[i] + kStepSize * body.invMass * body.facc[i];
        motion[3 + i] = body.avel[i];
        for (std::size_t k = 0; k < 3; ++k) motion[3 + i] += kStepSize * inverse[4 * i + k] * body.tacc[k];
    }
    return motion;
}

TEST(FreeMotion, IsThatOfTheExactSteppers) {
    dInitODE2(0);
    unsigned turning = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        RandomWorld world({40, 0}, seed);
        world.push();
        for (dxBody *const body : bodiesOf(world.world())) dBodySetAngularVel(body, 3 * body->avel[0] + 20, -7, 11);
        const FreeMotionOf found(world.world());
        for (std::size_t i = 0; i < found.bodies.size(); ++i) {
            dxBody &body = *found.bodies[i];
            turning += (body.flags & dxBodyGyroscopic) != 0 && body.invMass > 0;
            const std::vector<double> expected = expectedMotion(world.world(), body);
            EXPECT_EQ(found.masses[i].invMass, body.invMass);
            for (std::size_t k = 0; k < 6; ++k)
                EXPECT_NEAR(found.velocities[i].columns[k], expected[k], 1e-9 * (1 + std::abs(expected[k])));
        }
    }
    EXPECT_GT(turning, 100u);
    dCloseODE();
}

// The accumulators are the exact stepper's, should it step the group after all.
TEST(FreeMotion, LeavesTheBodiesAlone) {
    dInitODE2(0);
    RandomWorld world({40, 0}, 3), same({40, 0}, 3);
    world.push();
    same.push();
    const FreeMotionOf found(world.world());
    EXPECT_EQ(world.state(), same.state());
    dCloseODE();
}

}  // namespace
