// The plan of a group's constraints: each joint is in one place, packs that may be solved at once share no moving body, bodies with many edges
// have an overflow; small groups are solved upwards or downwards. And its phases on threads: each chunk once a sweep, phases one after the other.
//
// Covers dxPackOrder.cpp.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <set>
#include <vector>

#include "config.h"
#include "objects.h"
#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "own_threads.h"
#include "random_world.h"
#include "threading/pool/dxPhaseRunner.h"
#include "world_group.h"

namespace {

using Manifold = dxConstraintPlan::Manifold;

std::vector<Manifold> lanesOf(const dxConstraintPlan &plan) {
    std::vector<Manifold> manifolds;
    plan.forLaneManifolds([&](const Manifold &manifold) { manifolds.push_back(manifold); });
    return manifolds;
}

std::vector<Manifold> rowsOf(const dxConstraintPlan &plan) {
    std::vector<Manifold> manifolds;
    plan.forRowManifolds([&](const Manifold &manifold) { manifolds.push_back(manifold); });
    return manifolds;
}

class Group : public WorldGroup {
public:
    using WorldGroup::WorldGroup;

    bool moves(int body) const { return body >= 0 && island().bodies[body]->invMass > 0; }
    int bodyOf(unsigned joint, int side) const {
        const dxBody *const body = island().joints[joint]->node[side].body;
        return body != nullptr ? body->tag : dxConstraintPlan::kNoBody;
    }
};

dJointID touch(dWorldID world, dBodyID first, dBodyID second) {
    dContact contact = {};
    contact.geom.normal[2] = 1;
    const dJointID joint = dJointCreateContact(world, nullptr, &contact);
    dJointAttach(joint, first, second);
    return joint;
}

// side x side bodies, each of which touches its neighbours.
std::vector<dBodyID> touchInGrid(dWorldID world, int side) {
    std::vector<dBodyID> bodies;
    for (int i = 0; i < side * side; ++i) bodies.push_back(dBodyCreate(world));
    for (int i = 0; i < side * side; ++i) {
        if (i % side != 0) touch(world, bodies[static_cast<std::size_t>(i)], bodies[static_cast<std::size_t>(i - 1)]);
        if (i >= side) touch(world, bodies[static_cast<std::size_t>(i)], bodies[static_cast<std::size_t>(i - side)]);
    }
    return bodies;
}

class ConstraintPlan : public testing::Test {
protected:
    ConstraintPlan() { dInitODE2(0); }
    ~ConstraintPlan() override { dCloseODE(); }

    // By pack: the manifolds in its lanes. Fails where two share a lane, or a joint is in two places or none.
    static std::vector<std::vector<const Manifold *>> packsOf(const dxConstraintPlan &plan, const Group &group,
                                                                                std::size_t packs) {
        std::vector<unsigned> times(group.island().jointCount, 0);
        std::vector<std::vector<const Manifold *>> all(packs);
        std::set<std::pair<unsigned, unsigned>> lanes;
        plan.forLaneManifolds([&](const Manifold &manifold) {
            EXPECT_LT(manifold.pack, packs);
            EXPECT_TRUE(lanes.insert({manifold.pack, manifold.lane}).second);
            EXPECT_LE(manifold.contactCount, dxContactPack::kMaxContacts);
            all.at(manifold.pack).push_back(&manifold);
            for (unsigned i = 0; i < manifold.contactCount; ++i) {
                ++times.at(manifold.firstJoint + i);
                EXPECT_EQ(group.bodyOf(manifold.firstJoint + i, 0), manifold.body[0]);
                EXPECT_EQ(group.bodyOf(manifold.firstJoint + i, 1), manifold.body[1]);
            }
        });
        for (const dxConstraintPlan::RowJoint &other : plan.rowJoints()) ++times.at(other.joint);
        plan.forLaneJoints([&](const dxConstraintPlan::LaneJoint &own, unsigned, unsigned) {
            ++times.at(own.joint);
            for (int side = 0; side < 2; ++side) EXPECT_EQ(group.bodyOf(own.joint, side), own.body[side]);
        });
        for (const Manifold &manifold : rowsOf(plan))
            for (unsigned i = 0; i < manifold.contactCount; ++i)
                EXPECT_EQ(plan.rowJoints()[manifold.firstRowJoint() + i].joint, manifold.firstJoint + i);
        EXPECT_EQ(std::count(times.begin(), times.end(), 1u), static_cast<std::ptrdiff_t>(times.size()));
        return all;
    }

    static std::vector<int> movingBodiesOf(const std::vector<const Manifold *> &pack, const Group &group) {
        std::set<int> bodies;
        for (const Manifold *manifold : pack)
            for (const int body : manifold->body)
                if (group.moves(body)) EXPECT_TRUE(bodies.insert(body).second) << "two lanes share a body";
        return {bodies.begin(), bodies.end()};
    }

    // Chunks of a phase share no moving body; packs and joints of a chunk do if it is alone in its phase.
    static void expectNoneShared(const dxConstraintPlan &plan, const Group &group) {
        const auto packs = packsOf(plan, group, plan.packs().size());
        std::vector<unsigned> timesOfPack(packs.size(), 0), timesOfOther(plan.rowJoints().size(), 0);
        std::vector<unsigned> timesOfJointPack(plan.jointPacks().size(), 0);
        for (const dxConstraintPlan::Phase &phase : plan.phases()) {
            const bool isAlone = phase.endChunk - phase.firstChunk == 1;
            std::set<int> used;
            for (unsigned c = phase.firstChunk; c < phase.endChunk; ++c) {
                const dxConstraintPlan::Chunk &chunk = plan.chunks()[c];
                std::set<int> own;
                const auto take = [&](const std::vector<int> &bodies) {
                    for (const int body : bodies)
                        if (group.moves(body)) EXPECT_TRUE(own.insert(body).second || isAlone) << "they may be solved at once, and share a body";
                };
                for (unsigned p = chunk.firstPack; p < chunk.endPack; ++p) {
                    ++timesOfPack.at(p);
                    take(movingBodiesOf(packs[p], group));
                }
                for (unsigned p = chunk.firstJointPack; p < chunk.endJointPack; ++p) {
                    ++timesOfJointPack.at(p);
                    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
                        const dxConstraintPlan::LaneJoint &joint = plan.laneJoints()[p * dxLanes::kCount + lane];
                        if (!joint.isEmpty()) take({joint.body[0], joint.body[1]});
                    }
                }
                for (unsigned o = chunk.firstRowJoint; o < chunk.endRowJoint; ++o) {
                    const unsigned other = plan.rowJointsInOrder()[o];
                    ++timesOfOther.at(other);
                    take({group.bodyOf(plan.rowJoints()[other].joint, 0), group.bodyOf(plan.rowJoints()[other].joint, 1)});
                }
                for (const int body : own) EXPECT_TRUE(used.insert(body).second) << "two chunks at once share a body";
            }
        }
        for (const unsigned times : timesOfPack) EXPECT_EQ(times, 1u);
        for (const unsigned times : timesOfOther) EXPECT_EQ(times, 1u);
        for (const unsigned times : timesOfJointPack) EXPECT_EQ(times, 1u);
    }
};

TEST_F(ConstraintPlan, ColorsRandomWorlds) {
    for (const RandomWorld::Shape shape : {RandomWorld::Shape{5, 12}, {80, 240}, {300, 200}, {500, 4000}}) {
        RandomWorld world(shape, 2);
        const Group group(world.world());
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        expectNoneShared(plan, group);
        // They have joints of all types: few contacts beside them are rows, all in one phase.
        const bool areRows = group.island().jointCount <= 1000;
        EXPECT_EQ(plan.packs().empty(), areRows);
        EXPECT_EQ(plan.phases().size() == 1, areRows);
    }
}

// A grid of bodies in which each touches four others is filled with few colours, eight to a pack.
TEST_F(ConstraintPlan, FillsPacks) {
    constexpr int kSide = 30;
    const dWorldID world = dWorldCreate();
    touchInGrid(world, kSide);
    const Group group(world);
    dxStepArena arena;
    dxConstraintPlan plan;
    plan.make(group.island(), arena);
    expectNoneShared(plan, group);
    EXPECT_LE(plan.phases().size(), 7u);
    EXPECT_LE(plan.packs().size(), lanesOf(plan).size() / 8 + plan.phases().size());
    dWorldDestroy(world);
}

// Joints of a grid fill packs, those with many rows beside one another. They are rows where packs would be nearly empty, and beside contacts in a
// small group.
TEST_F(ConstraintPlan, FillsPacksOfJoints) {
    struct Case {
        int side;
        bool hasContact, areRows;
    };
    for (const auto &[side, hasContact, areRows] : {Case{3, false, true}, {20, false, false}, {20, true, true}, {30, true, false}}) {
        const dWorldID world = dWorldCreate();
        std::vector<dBodyID> bodies;
        const auto connect = [&](int i, int other) {
            const dJointID joint = i % 2 == 0 ? dJointCreateBall(world, nullptr) : dJointCreateHinge(world, nullptr);
            dJointAttach(joint, bodies[static_cast<std::size_t>(i)], bodies[static_cast<std::size_t>(other)]);
        };
        for (int i = 0; i < side * side; ++i) {
            bodies.push_back(dBodyCreate(world));
            if (i % side != 0) connect(i, i - 1);
            if (i >= side) connect(i, i - side);
        }
        dJointAttach(dJointCreateTransmission(world, nullptr), bodies[0], bodies[1]);
        if (hasContact) touch(world, bodies[0], nullptr);
        const Group group(world);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        expectNoneShared(plan, group);
        const std::size_t joints = group.island().jointCount;
        if (areRows) {
            EXPECT_EQ(plan.rowJoints().size(), joints);
            EXPECT_TRUE(plan.jointPacks().empty());
        } else {
            EXPECT_EQ(plan.rowJoints().size(), hasContact ? 2u : 1u) << "the transmission and the contact";
            EXPECT_LE(plan.jointPacks().size(), joints / dxLanes::kCount + plan.phases().size());
            EXPECT_LT(plan.packedRows(), 5 * plan.jointPacks().size()) << "balls and hinges are mixed";
        }
        dWorldDestroy(world);
    }
}

// A smaller one that stands on the ground is solved from there up, or down to it, as drawn from where its first body is.
TEST_F(ConstraintPlan, SolvesSmallGroupsUpOrDown) {
    constexpr int kSide = 20;
    const dWorldID world = dWorldCreate();
    const std::vector<dBodyID> bodies = touchInGrid(world, kSide);
    for (int i = 0; i < kSide; ++i) touch(world, bodies[static_cast<std::size_t>(i)], nullptr);
    const Group group(world);
    const auto heightOf = [&](int tag) { return (kSide * kSide - 1 - tag) / kSide; };  // the last body is the first of the world
    unsigned up = 0, down = 0;
    for (int place = 0; place < 20; ++place) {
        dBodySetPosition(group.island().bodies[0], 0.1 * place, 0, 0);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        expectNoneShared(plan, group);
        EXPECT_LE(plan.packs().size(), lanesOf(plan).size() / 8 + kSide);
        unsigned lowest[kSide], highest[kSide] = {};  // packs of contacts with what is below
        std::fill_n(lowest, kSide, ~0u);
        for (const Manifold &manifold : lanesOf(plan)) {
            const int height = heightOf(manifold.body[0]);
            if (manifold.body[1] >= 0 && heightOf(manifold.body[1]) == height) continue;
            lowest[height] = std::min(lowest[height], manifold.pack);
            highest[height] = std::max(highest[height], manifold.pack);
        }
        const bool isUp = lowest[0] < lowest[kSide - 1];
        for (int height = 1; height < kSide; ++height)
            EXPECT_LT(isUp ? highest[height - 1] : highest[height], isUp ? lowest[height] + 8 : lowest[height - 1] + 8) << height;
        ++(isUp ? up : down);
    }
    EXPECT_GE(std::min(up, down), 3u);
    dWorldDestroy(world);
}

// A column is a chain in which each contact waits for the one before it.
TEST_F(ConstraintPlan, KeepsColumnsInOrder) {
    constexpr std::size_t kColumns = 8, kHeight = 10;
    const dWorldID world = dWorldCreate();
    std::vector<dBodyID> bodies;
    for (std::size_t i = 0; i < kColumns * kHeight; ++i) bodies.push_back(dBodyCreate(world));
    for (std::size_t i = 0; i < kColumns * kHeight; ++i) touch(world, bodies[i], i % kHeight == 0 ? nullptr : bodies[i - 1]);
    const Group group(world);
    dxStepArena arena;
    dxConstraintPlan plan;
    plan.make(group.island(), arena);
    expectNoneShared(plan, group);
    ASSERT_EQ(lanesOf(plan).size(), kColumns * kHeight);
    EXPECT_EQ(plan.packs().size(), kHeight);  // eight columns are eight lanes, whichever way they go
    std::vector<unsigned> packOf(bodies.size());
    for (const Manifold &manifold : lanesOf(plan)) packOf.at(static_cast<std::size_t>(manifold.body[0])) = manifold.pack;
    for (std::size_t column = 0; column < kColumns; ++column) {
        const unsigned first = packOf[column * kHeight];
        for (std::size_t i = 0; i < kHeight; ++i)
            EXPECT_EQ(packOf[column * kHeight + i], first == 0 ? i : kHeight - 1 - i) << column;
    }
    dWorldDestroy(world);
}

// More edges on a body than there are colours: the rest is solved as rows, one by one. A body that does not move has no colours.
TEST_F(ConstraintPlan, SolvesTheRestOfAHubAsRows) {
    constexpr int kPairs = 1000, kTouching = 200, kColors = 63;
    for (const bool moves : {true, false}) {
        const dWorldID world = dWorldCreate();
        const dBodyID hub = dBodyCreate(world);
        if (!moves) dBodySetKinematic(hub);
        for (int i = 0; i < kPairs; ++i) touch(world, dBodyCreate(world), dBodyCreate(world));
        for (int i = 0; i < kTouching; ++i) touch(world, dBodyCreate(world), hub);
        const Group group(world);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        expectNoneShared(plan, group);
        EXPECT_EQ(rowsOf(plan).size(), moves ? kTouching - kColors : 0u);
        EXPECT_EQ(plan.rowJoints().size(), moves ? kTouching - kColors : 0u);
        EXPECT_EQ(plan.phases().size(), moves ? kColors + 1u : 1u);
        dWorldDestroy(world);
    }
}

// Vectors that would be nearly empty are not worth it.
TEST_F(ConstraintPlan, SolvesContactsAsRowsWhereLanesWouldBeEmpty) {
    for (const unsigned pairs : {1u, 2u, 4u, 5u, 8u}) {
        const dWorldID world = dWorldCreate();
        for (unsigned i = 0; i < pairs; ++i) touch(world, dBodyCreate(world), dBodyCreate(world));
        const Group group(world);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        expectNoneShared(plan, group);
        EXPECT_EQ(lanesOf(plan).size(), pairs > 4 ? pairs : 0);
        EXPECT_EQ(rowsOf(plan).size(), pairs > 4 ? 0 : pairs);
        dWorldDestroy(world);
    }
}

// Contacts between two bodies are a manifold; the ninth begins another one.
TEST_F(ConstraintPlan, PutsContactsOfTwoBodiesTogether) {
    for (const int pairs : {1, 8}) {
        const dWorldID world = dWorldCreate();
        for (int pair = 0; pair < pairs; ++pair) {
            const dBodyID first = dBodyCreate(world), second = dBodyCreate(world);
            for (int i = 0; i < 9; ++i) touch(world, first, second);
            for (int i = 0; i < 3; ++i) touch(world, first, nullptr);
        }
        const Group group(world);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        EXPECT_EQ(lanesOf(plan).empty(), pairs == 1);
        EXPECT_EQ(rowsOf(plan).empty(), pairs != 1);
        std::vector<unsigned> counts, expected;
        for (const Manifold &manifold : lanesOf(plan)) counts.push_back(manifold.contactCount);
        for (const Manifold &manifold : rowsOf(plan)) counts.push_back(manifold.contactCount);
        for (int pair = 0; pair < pairs; ++pair) expected.insert(expected.end(), {1, 3, 8});
        std::sort(counts.begin(), counts.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(counts, expected);
        dWorldDestroy(world);
    }
}

// One thread's rows are in the order of the group.
TEST_F(ConstraintPlan, OrdersRows) {
    for (const bool hasBall : {false, true}) {
        const dWorldID world = dWorldCreate();
        std::vector<dBodyID> row(4);
        for (dBodyID &body : row) body = dBodyCreate(world);
        for (std::size_t i = 1; i < row.size(); ++i) touch(world, row[i - 1], row[i]);
        if (hasBall) dJointAttach(dJointCreateBall(world, nullptr), row[0], nullptr);
        const Group group(world);
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group.island(), arena);
        EXPECT_EQ(plan.hasContactsOnly(), !hasBall);
        const std::vector<unsigned> order(plan.rowJointsInOrder().begin(), plan.rowJointsInOrder().end());
        EXPECT_EQ(order, hasBall ? std::vector<unsigned>({0, 1, 2, 3}) : std::vector<unsigned>({0, 1, 2}));
        dWorldDestroy(world);
    }
}

// Islands that follow one another in a group are told apart by what connects their bodies.
TEST_F(ConstraintPlan, FindsIslands) {
    const dWorldID world = dWorldCreate();
    std::vector<dBodyID> bodies;
    for (int i = 0; i < 8; ++i) bodies.push_back(dBodyCreate(world));  // tags from the last one on
    const auto body = [&](int tag) { return bodies[static_cast<std::size_t>(7 - tag)]; };
    touch(world, body(0), body(2));
    touch(world, body(1), body(2));
    touch(world, body(3), nullptr);
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, body(5), body(7));
    touch(world, body(6), body(7));
    const Group group(world);
    dxStepArena arena;
    dxConstraintPlan plan;
    plan.make(group.island(), arena);
    std::vector<std::pair<unsigned, unsigned>> islands;
    for (const dxConstraintPlan::Island &island : plan.islands()) islands.emplace_back(island.firstBody, island.endBody);
    EXPECT_EQ(islands, (std::vector<std::pair<unsigned, unsigned>>{{0, 3}, {3, 4}, {4, 5}, {5, 8}}));
    for (const dxConstraintPlan::RowJoint &other : plan.rowJoints()) {
        const dxBody *const first = plan.jointOf(other)->node[0].body;
        const dxConstraintPlan::Island &island = plan.islands()[plan.islandOf(other)];
        EXPECT_LE(island.firstBody, static_cast<unsigned>(first->tag));
        EXPECT_GT(island.endBody, static_cast<unsigned>(first->tag));
    }
    dWorldDestroy(world);
}

// Solvers take the plan's phases of chunks: each chunk once a sweep, and none before all of the phase before it, whatever threads take part.
TEST_F(ConstraintPlan, IsSweptOnceASweepByAnyNumberOfThreads) {
    RandomWorld world({500, 4000}, 2);
    const Group group(world.world());
    dxStepArena arena;
    dxConstraintPlan plan;
    plan.make(group.island(), arena);
    constexpr unsigned kSweeps = 7;
    for (const unsigned workers : {1u, 2u, 5u}) {
        dxPhaseRunner phases;
        phases.reserve(workers);
        OwnThreads threads(workers);
        std::vector<std::atomic<unsigned>> times(plan.chunks().size());
        std::atomic<unsigned> inWork{0};
        std::atomic<bool> isInOrder{true};
        phases.run(dxParallelStage::PgsSweep, threads, [&] {
            for (unsigned sweep = 0; sweep < kSweeps; ++sweep)
                for (const dxConstraintPlan::Phase &phase : plan.phases()) {
                    if (inWork.load() != 0) isInOrder = false;
                    phases.forChunks(phase.endChunk - phase.firstChunk, [&](unsigned i, unsigned) {
                        ++inWork;
                        if (times[phase.firstChunk + i].fetch_add(1) != sweep) isInOrder = false;
                        --inWork;
                    });
                }
        });
        EXPECT_TRUE(isInOrder);
        for (const std::atomic<unsigned> &chunk : times) EXPECT_EQ(chunk.load(), kSweeps);
    }
}

}  // namespace
