// dxClusterBroadphase leaves checks out, finds the pairs of brute force all the same, and rebuilds nothing because one
// member goes and another comes.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "CrossoverPasses.h"
#include "OdeSession.h"
#include "collision/pairs/dxMembers.h"
#include "clusters/dxClusterBroadphase.h"

namespace {

using Slot = dxMembers::Slot;
using Pairs = std::vector<std::pair<Slot, Slot>>;

// Cubes that travel in a box of 40 m, some with bodies, and a floor.
class TunedClusters : public testing::TestWithParam<const char *> {
protected:
    struct Mover {
        std::array<dReal, 3> centre{}, velocity{};
        dReal half = 0;
    };

    TunedClusters() { dODE_MT_SetHeuristics("default"); }
    ~TunedClusters() override {
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members[slot].geom != nullptr) dGeomDestroy(members[slot].geom);
        dWorldDestroy(world);
        dODE_MT_SetHeuristics("default");
    }

    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(random); }

    Slot add(bool isDynamic, dReal speed) {
        const dGeomID geom = dCreateSphere(nullptr, 1);
        if (isDynamic) dGeomSetBody(geom, dBodyCreate(world));
        const Slot slot = members.add(geom);
        movers.resize(members.end());
        Mover &mover = movers[slot];
        mover.half = uniform(dReal(0.1), dReal(0.4));
        for (int axis = 0; axis < 3; ++axis) {
            mover.centre[axis] = uniform(-20, 20);
            mover.velocity[axis] = isDynamic ? uniform(-speed, speed) : 0;
        }
        place(slot);
        return slot;
    }
    void addFloor() {
        const Slot slot = members.add(dCreatePlane(nullptr, 0, 0, 1, 0));
        movers.resize(members.end());
        movers[slot] = Mover();
        const dReal aabb[6] = {-dInfinity, dInfinity, -dInfinity, dInfinity, -dInfinity, -15};
        members.setBounds(slot, dxBounds(aabb));
    }
    void place(Slot slot) {
        members.markChanged(slot);
        dReal aabb[6];
        for (int axis = 0; axis < 3; ++axis) {
            aabb[2 * axis] = movers[slot].centre[axis] - movers[slot].half;
            aabb[2 * axis + 1] = movers[slot].centre[axis] + movers[slot].half;
        }
        members.setBounds(slot, dxBounds(aabb));
    }
    void remove(Slot slot) {
        if (const dBodyID body = dGeomGetBody(members[slot].geom)) dBodyDestroy(body);
        dGeomDestroy(members[slot].geom);
        members.remove(slot);
    }
    void moveAll() {
        for (Slot slot = 0; slot < members.end(); ++slot) {
            Mover &mover = movers[slot];
            if (members[slot].geom == nullptr || mover.half == 0 || mover.velocity[0] == 0) continue;
            for (int axis = 0; axis < 3; ++axis) {
                mover.centre[axis] += mover.velocity[axis];
                if (std::abs(mover.centre[axis]) > 20) mover.velocity[axis] = -mover.velocity[axis];
            }
            place(slot);
        }
    }
    Slot randomMover() {
        Slot slot;
        do slot = random() % members.end();
        while (members[slot].geom == nullptr || movers[slot].half == 0);
        return slot;
    }
    // What a program may do at any time.
    void meddle() {
        const Slot slot = randomMover();
        switch (random() % 5) {
            case 0:
                for (dReal &x : movers[slot].centre) x = uniform(-20, 20);
                return place(slot);
            case 1:
                movers[slot].half = uniform(dReal(0.1), 2);
                return place(slot);
            case 2:
                remove(slot);
                return;
            case 3:
                add(random() % 2 == 0, dReal(0.05));
                return;
            default:
                dGeomSetBody(members[slot].geom, dGeomGetBody(members[slot].geom) ? nullptr : dBodyCreate(world));
                return members.markChanged(slot);
        }
    }

    Pairs found(dxClusterBroadphase &tuned) {
        std::vector<dxBroadphase::Match> matches;
        tuned.findOverlaps(members, dxTaskRunner::alone(), matches);
        Pairs pairs;
        for (const dxBroadphase::Match &match : matches) pairs.emplace_back(std::minmax(match.a, match.b));
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
    Pairs bruteForce() const {
        Pairs pairs;
        for (Slot a = 0; a < members.end(); ++a)
            for (Slot b = a + 1; b < members.end(); ++b)
                if (members[a].geom != nullptr && members[b].geom != nullptr &&
                    (members.isChanged(a) || members.isChanged(b)) && members[a].bounds.overlaps(members[b].bounds))
                    pairs.emplace_back(a, b);
        return pairs;
    }

    std::mt19937 random{7};
    OdeSession session;
    dWorldID world = dWorldCreate();
    dxMembers members;
    std::vector<Mover> movers;  // by slot
};

TEST_P(TunedClusters, FindThePairsOfBruteForceThoughChecksAreLeftOut) {
    unsigned checks = 0, searches = 0;
    std::size_t pairs = 0;
    for (const int count : {6, 12, 40})
        for (const dReal speed : {dReal(0.01), dReal(0.1), dReal(1)}) {
            dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
            for (Slot slot = 0; slot < members.end(); ++slot)
                if (members[slot].geom != nullptr) remove(slot);
            members.forgetChanges();
            addFloor();
            for (int i = 0; i < count; ++i) add(i % 3 != 0, speed);
            for (int frame = 0; frame < 800; ++frame) {
                const Pairs all = found(tuned);
                ASSERT_EQ(all, bruteForce()) << count << " cubes, speed " << speed << ", frame " << frame;
                pairs += all.size();
                members.forgetChanges();
                moveAll();
                if (random() % 40 == 0) meddle();
            }
            checks += tuned.checks();
            searches += tuned.searches();
        }
    EXPECT_GT(pairs, 1000u);
    EXPECT_LT(checks, searches - searches / 4) << "hardly any check is skipped";
}

// Both come half of the way, which is what the proof allows for, and a third stretches the grid.
TEST_P(TunedClusters, NoneIsMissedThatMeetsHeadOn) {
    dODE_MT_SetHeuristics("crossover,declustering");
    const Slot left = add(true, 1), right = add(true, 1), far = add(true, 1), wall = add(false, 0);
    unsigned checks = 0, searches = 0;
    for (int trial = 0; trial < 60; ++trial) {
        dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
        const dReal speed = uniform(dReal(0.02), dReal(0.3));
        for (const Slot slot : {left, right, far, wall}) movers[slot] = {{0, 0, 0}, {0, 0, 0}, dReal(0.4)};
        movers[left].centre[0] = uniform(-20, -10);
        movers[right].centre[0] = uniform(10, 20);
        movers[far].centre[1] = uniform(50, 80);
        movers[wall].centre[0] = uniform(-5, 5);
        movers[left].velocity[0] = speed;
        movers[right].velocity[0] = -speed;
        for (const Slot slot : {left, right, far, wall}) place(slot);
        for (int frame = 0; movers[left].centre[0] < movers[right].centre[0]; ++frame) {
            ASSERT_EQ(found(tuned), bruteForce()) << "trial " << trial << ", frame " << frame;
            members.forgetChanges();
            moveAll();
        }
        members.forgetChanges();
        checks += tuned.checks();
        searches += tuned.searches();
    }
    EXPECT_LT(checks, searches / 2);
}

// Two that approach slowly: were travel counted more than once, a check would come after some five frames.
TEST_P(TunedClusters, AGapLastsAsLongAsTravelLeavesAnyOfIt) {
    dODE_MT_SetHeuristics("crossover,declustering");
    dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
    const Slot left = add(true, 1), right = add(true, 1);
    movers[left] = {{-10, 0, 0}, {dReal(0.05), 0, 0}, dReal(0.4)};
    movers[right] = {{10, 0, 0}, {dReal(-0.05), 0, 0}, dReal(0.4)};
    for (const Slot slot : {left, right}) place(slot);
    unsigned longest = 0, since = 0, before = 0;  // searches without a check
    for (int frame = 0; frame < 150; ++frame) {
        found(tuned);
        members.forgetChanges();
        moveAll();
        since = tuned.checks() == before ? since + 1 : 0;
        before = tuned.checks();
        longest = std::max(longest, since);
    }
    EXPECT_GT(longest, 20u);
}

TEST_P(TunedClusters, WithoutTheCheckFrequencyEverySearchChecks) {
    dODE_MT_SetHeuristics("cells,centre");
    dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
    for (int i = 0; i < 10; ++i) add(true, dReal(0.01));
    for (int frame = 0; frame < 50; ++frame) {
        found(tuned);
        members.forgetChanges();
        moveAll();
    }
    EXPECT_EQ(tuned.checks(), 50u);
}

TEST_P(TunedClusters, WhatComesGoesOrJumpsIsCheckedAtOnce) {
    dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
    for (int i = 0; i < 8; ++i) add(true, dReal(0.001));
    const auto checkedAtOnce = [&](const char *what) {
        const unsigned before = tuned.checks();
        found(tuned);
        members.forgetChanges();
        EXPECT_EQ(tuned.checks(), before + 1) << what;
    };
    const auto letRest = [&] {
        unsigned before;
        do {
            before = tuned.checks();
            for (int frame = 0; frame < 40; ++frame) {
                movers[0].centre[0] += dReal(1e-9);
                place(0);
                found(tuned);
                members.forgetChanges();
            }
        } while (tuned.checks() > before + 2);  // the cell size still climbs
    };
    letRest();
    add(true, 0);
    checkedAtOnce("a member came");
    letRest();
    remove(1);
    checkedAtOnce("a member went");
    letRest();
    movers[2].centre[0] += 40;
    place(2);
    checkedAtOnce("a member jumped");
    letRest();
    dJointAttach(dJointCreateBall(world, nullptr), dGeomGetBody(members[3].geom), dGeomGetBody(members[4].geom));
    place(0);
    checkedAtOnce("a joint was made");
}

// The scene counts members that enter or leave cells: a rebuilt grid or list would count all members.
TEST_P(TunedClusters, OneThatGoesAndOneThatComesMoveNobodyElse) {
    dODE_MT_SetHeuristics("crossover,declustering");
    dxClusterBroadphase tuned(dxMakeCrossoverPass(GetParam()));
    addFloor();
    for (int i = 0; i < 300; ++i) add(i % 3 != 0, 0);
    found(tuned);
    members.forgetChanges();
    const unsigned before = tuned.clusters().scene().changes();
    for (unsigned frame = 0; frame < 100; ++frame) {
        remove(randomMover());
        add(frame % 2 == 0, 0);
        found(tuned);
        members.forgetChanges();
        // The bound is for all frames so far: changes may be processed some frames later.
        ASSERT_LE(tuned.clusters().scene().changes() - before, 2 * (frame + 1)) << "frame " << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Passes, TunedClusters, testing::ValuesIn(kPasses), nameOfPass);

}  // namespace
