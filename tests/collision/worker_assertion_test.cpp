// An assertion that fails while workers compute bounding boxes is reported once, on the thread that collides the space.
//
// Geoms with an offset that are attached to another body while they are dirty have none any more, which upstream's computePosr
// asserts.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <ode/ode_MT.h>

#include <atomic>
#include <thread>
#include <vector>

namespace {

std::thread::id g_caller;
std::atomic<int> g_calls, g_callsElsewhere;

[[noreturn]] void leave(int, const char *, va_list) {
    ++g_calls;
    if (std::this_thread::get_id() != g_caller) ++g_callsElsewhere;
    throw g_calls.load();
}

void doNothing(void *, dGeomID, dGeomID) {}

class WorkerAssertion : public testing::Test {
protected:
    static constexpr int kGeoms = 3000;  // enough that boxes are computed in parallel

    WorkerAssertion() {
        dInitODE2(0);
        dToggleODE_MT(3);
        dODE_MT_SetAlgorithm("lcp");
        g_caller = std::this_thread::get_id();
        g_calls = g_callsElsewhere = 0;
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        for (int i = 0; i < kGeoms; ++i) {
            bodies.push_back(dBodyCreate(world));
            dBodySetPosition(bodies[i], i % 60 * 2, i / 60 * 2, 0);
            geoms.push_back(dCreateSphere(space, dReal(0.5)));
            dGeomSetBody(geoms[i], bodies[i]);
            dGeomSetOffsetPosition(geoms[i], dReal(0.1), 0, 0);
        }
        dSetDebugHandler(leave);
    }
    ~WorkerAssertion() override {
        dSetDebugHandler(nullptr);
        dODE_MT_SetAlgorithm("auto");
        dToggleODE_MT(0);
    }

    void stepAndCollide() {
        dWorldQuickStep(world, dReal(0.01));
        dSpaceCollide(space, nullptr, doNothing);
    }

    dWorldID world;
    dSpaceID space;
    std::vector<dBodyID> bodies;
    std::vector<dGeomID> geoms;
};

TEST_F(WorkerAssertion, IsReportedOnceOnTheCallingThread) {
    for (int i = 0; i < 3; ++i) stepAndCollide();
    dWorldQuickStep(world, dReal(0.01));
    for (int i = 0; i < kGeoms; ++i) dGeomSetBody(geoms[i], bodies[(i + 1) % kGeoms]);
    EXPECT_THROW(dSpaceCollide(space, nullptr, doNothing), int);
    EXPECT_EQ(g_calls, 1);
    EXPECT_EQ(g_callsElsewhere, 0);
}

}  // namespace
