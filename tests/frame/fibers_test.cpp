// Programs that switch between stacks of their own (fibers, coroutines) in callbacks: calls that several fibers of one thread have in
// progress do not end in the reverse order of their beginnings.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <ucontext.h>

#include <memory>
#include <vector>

#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

constexpr int kFibers = 3, kFrames = 12;

class Fibers {
public:
    explicit Fibers(int pairsBetween) : m_pairsBetween(pairsBetween) {
        s_running = this;
        for (int i = 0; i < kFibers; ++i) {
            Fiber &fiber = m_fibers[i];
            fiber.world = std::make_unique<HeapWorld>(i % 2 == 0 ? dHashSpaceCreate(nullptr) : dSimpleSpaceCreate(nullptr));
            fiber.world->setCallback([](HeapWorld &world, dGeomID o1, dGeomID o2) { s_running->meet(world, o1, o2); });
            getcontext(&fiber.context);
            fiber.context.uc_stack.ss_sp = fiber.stack.data();
            fiber.context.uc_stack.ss_size = fiber.stack.size();
            fiber.context.uc_link = &m_main;
            makecontext(&fiber.context, [] { s_running->live(); }, 0);
        }
    }

    // Runs all fibers alternately until all have ended.
    std::vector<dReal> positions() {
        while (switchFrom(m_main)) {
        }
        std::vector<dReal> all;
        for (const Fiber &fiber : m_fibers)
            for (const dReal number : fiber.world->positions()) all.push_back(number);
        return all;
    }

private:
    struct Fiber {
        ucontext_t context;
        std::vector<char> stack = std::vector<char>(1 << 20);
        std::unique_ptr<HeapWorld> world;
        bool isDone = false;
    };

    void live() {
        Fiber &self = m_fibers[m_current];
        for (int i = 0; i < kFrames + m_current; ++i) {
            self.world->collide();
            self.world->step();
        }
        self.isDone = true;
    }

    void meet(HeapWorld &world, dGeomID o1, dGeomID o2) {
        if (++m_pairs % m_pairsBetween == 0) switchFrom(m_fibers[m_current].context);
        world.makeContacts(o1, o2);
        if (m_pairs % (m_pairsBetween + 3) == 0) switchFrom(m_fibers[m_current].context);
    }

    // To the next fiber that is not done; false: there is none other.
    bool switchFrom(ucontext_t &context) {
        const int self = m_current;
        for (int i = 1; i <= kFibers; ++i) {
            const int next = (self + i) % kFibers;
            if (m_fibers[next].isDone || &m_fibers[next].context == &context) continue;
            m_current = next;
            swapcontext(&context, &m_fibers[next].context);
            return true;
        }
        return false;
    }

    static Fibers *s_running;

    const int m_pairsBetween;
    ucontext_t m_main{};
    Fiber m_fibers[kFibers];
    int m_current = 0, m_pairs = 0;
};
Fibers *Fibers::s_running = nullptr;

class FibersTest : public testing::TestWithParam<int> {};

TEST_P(FibersTest, SwitchInNearCallbacks) {
    if (kAddressSanitizer || kThreadSanitizer) GTEST_SKIP() << "sanitizers do not follow such switches";
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(0, "serial");
        dRandSetSeed(0);
        const std::vector<dReal> serial = Fibers(GetParam()).positions();
        for (const char *const algorithm : {"auto", "lcp"}) {
            OdeSession::use(3, algorithm);
            dRandSetSeed(0);
            if (Fibers(GetParam()).positions() != serial) return false;
        }
        return true;
    }));
}

INSTANTIATE_TEST_SUITE_P(PairsBetween, FibersTest, testing::Values(1, 7, 50, 400));

}  // namespace
