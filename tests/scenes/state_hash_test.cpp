#include "scenes/state_hash.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

class StateHash : public testing::Test {
protected:
    static void SetUpTestSuite() { dInitODE2(0); }
    static void TearDownTestSuite() { dCloseODE(); }

    StateHash() { inventory.bodies = {body, dBodyCreate(world)}; }
    ~StateHash() override { dWorldDestroy(world); }

    std::uint64_t hash() const { return scenes::stateHash(inventory); }

    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    scenes::Inventory inventory;
};

}  // namespace

TEST_F(StateHash, EveryFieldCounts) {
    std::vector<std::uint64_t> hashes = {hash()};
    const auto expectNew = [&](const char *field) {
        for (std::uint64_t old : hashes) EXPECT_NE(hash(), old) << field;
        hashes.push_back(hash());
    };
    dBodySetPosition(body, 0, 0, REAL(1e-7));
    expectNew("position");
    const dQuaternion turned = {0, 1, 0, 0};
    dBodySetQuaternion(body, turned);
    expectNew("quaternion");
    dBodySetLinearVel(body, 0, REAL(1e-7), 0);
    expectNew("linear velocity");
    dBodySetAngularVel(body, REAL(1e-7), 0, 0);
    expectNew("angular velocity");
    dBodyDisable(body);
    expectNew("enabled");
    inventory.readings = {1, 2};
    expectNew("readings");
    inventory.readings = {2, 1};
    expectNew("order of readings");
}

TEST_F(StateHash, BothZerosDiffer) {
    const std::uint64_t before = hash();
    dBodySetLinearVel(body, REAL(-0.0), 0, 0);
    EXPECT_NE(hash(), before);
}

TEST_F(StateHash, TheOrderOfBodiesCounts) {
    dBodySetPosition(body, 1, 2, 3);
    const std::uint64_t before = hash();
    std::swap(inventory.bodies[0], inventory.bodies[1]);
    EXPECT_NE(hash(), before);
}

TEST_F(StateHash, EveryNaNIsTheSame) {
    const dReal nan = std::numeric_limits<dReal>::quiet_NaN();
    dBodySetLinearVel(body, nan, 0, 0);
    const std::uint64_t positive = hash();
    dBodySetLinearVel(body, -nan, 0, 0);
    EXPECT_EQ(hash(), positive);
}
