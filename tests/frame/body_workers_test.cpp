// dODE_MT_NoteBodyWorkers and dODE_MT_GetBodyWorker: who has stepped a body in the last step, and that asking for it changes no bit.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <set>

#include "ChainWorld.h"
#include "OdeSession.h"

namespace {

constexpr unsigned kChains = 30, kLinks = 4;

class BodyWorkers : public testing::TestWithParam<dWorldStepFunction *> {
protected:
    void SetUp() override { dODE_MT_NoteBodyWorkers(1); }
    void TearDown() override { dODE_MT_NoteBodyWorkers(0); }

    std::set<int> workers() const {
        std::set<int> found;
        for (const dBodyID body : m_world.bodies()) found.insert(dODE_MT_GetBodyWorker(body));
        return found;
    }

    const OdeSession m_session{2, "lcp"};
    ChainWorld m_world{kChains, kLinks, GetParam()};
};

TEST_P(BodyWorkers, BodiesOfAnIslandHaveOne) {
    std::set<int> found;
    for (int i = 0; i < 50; ++i) {
        m_world.step();
        for (std::size_t body = 0; body < m_world.bodies().size(); ++body)
            EXPECT_EQ(dODE_MT_GetBodyWorker(m_world.bodies()[body]), dODE_MT_GetBodyWorker(m_world.bodies()[body - body % kLinks]));
        for (const int worker : workers()) found.insert(worker);
    }
    EXPECT_EQ(found.count(0), 1u);
    found.erase(0);
    found.erase(1);  // there where it was scheduled in time
    EXPECT_TRUE(found.empty());
}

TEST_P(BodyWorkers, AllAreTheCallersWhereStepsAreSerial) {
    OdeSession::use(0, "serial");
    m_world.step();
    EXPECT_EQ(workers(), std::set<int>{0});
}

TEST_P(BodyWorkers, WhoeverWasNotSteppedHasNone) {
    EXPECT_EQ(workers(), std::set<int>{-1});  // before the first step
    m_world.step();
    dBodyDisable(m_world.bodies()[0]);
    for (unsigned link = 1; link < kLinks; ++link) dBodyDisable(m_world.bodies()[link]);
    m_world.step();
    EXPECT_EQ(dODE_MT_GetBodyWorker(m_world.bodies()[0]), -1);
    EXPECT_GE(dODE_MT_GetBodyWorker(m_world.bodies()[kLinks]), 0);
    const dBodyID born = dBodyCreate(m_world.world());
    EXPECT_EQ(dODE_MT_GetBodyWorker(born), -1);
}

TEST_P(BodyWorkers, NobodyHasOneWhereNothingIsNoted) {
    m_world.step();
    dODE_MT_NoteBodyWorkers(0);
    m_world.step();
    EXPECT_EQ(workers(), std::set<int>{-1});
}

TEST_P(BodyWorkers, NoBitChanges) {
    ChainWorld other(kChains, kLinks, GetParam());
    dRandSetSeed(9);
    m_world.step(20);
    dODE_MT_NoteBodyWorkers(0);
    dRandSetSeed(9);
    other.step(20);
    EXPECT_EQ(m_world.state(), other.state());
}

INSTANTIATE_TEST_SUITE_P(Steppers, BodyWorkers, testing::Values(&dWorldStep, &dWorldQuickStep));

}  // namespace
