// Threads of the program's own step a world: a simulator that has a thread pool lends its threads instead of having ODE_MT start more.
// Prints the mean height of a field of pendulums, in metres.
#include <ode/ode.h>

#include <cstdio>
#include <thread>
#include <vector>

namespace {

constexpr int kThreads = 3, kPendulums = 200, kLinks = 4;

// The program's threads. Here they serve ODE until they are released; a real pool would lend them for a while.
class Pool {
public:
    Pool() : m_threading(dThreadingAllocateMultiThreadedImplementation()) {
        for (int i = 0; i < kThreads; ++i)
            m_threads.emplace_back([this] {
                dAllocateODEDataForThread(dAllocateMaskAll);
                dExternalThreadingServeMultiThreadedImplementation(m_threading, nullptr, nullptr);
                dCleanupODEAllDataForThread();
            });
    }
    ~Pool() {
        dThreadingImplementationShutdownProcessing(m_threading);
        for (std::thread &thread : m_threads) thread.join();
        dThreadingFreeImplementation(m_threading);
    }

    void lendTo(dWorldID world) {
        dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(m_threading), m_threading);
    }
    static void takeBackFrom(dWorldID world) { dWorldSetStepThreadingImplementation(world, nullptr, nullptr); }

private:
    const dThreadingImplementationID m_threading;
    std::vector<std::thread> m_threads;
};

// A chain of bars that swings from a point. Each one is an island.
std::vector<dBodyID> addPendulum(dWorldID world, double y) {
    std::vector<dBodyID> links;
    dMass mass;
    dMassSetBoxTotal(&mass, 0.5, 0.4, 0.05, 0.05);
    for (int i = 0; i < kLinks; ++i) {
        const dBodyID link = dBodyCreate(world);
        dBodySetMass(link, &mass);
        dBodySetPosition(link, 0.4 * i + 0.2, y, 3);
        const dJointID hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, link, links.empty() ? nullptr : links.back());
        dJointSetHingeAnchor(hinge, 0.4 * i, y, 3);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        links.push_back(link);
    }
    return links;
}

void swing() {
    Pool pool;  // outlives the world that it is lent to
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    std::vector<dBodyID> ends;
    for (int i = 0; i < kPendulums; ++i) ends.push_back(addPendulum(world, i).back());

    pool.lendTo(world);
    for (int step = 0; step < 100; ++step) dWorldStep(world, 0.01);
    Pool::takeBackFrom(world);

    double sum = 0;
    for (const dBodyID end : ends) sum += dBodyGetPosition(end)[2];
    std::printf("mean height of %d ends: %.6f m\n", kPendulums, sum / kPendulums);
    dWorldDestroy(world);
}

}  // namespace

int main() {
    dInitODE2(0);
    swing();  // all threads of the pool have left ODE when it is closed
    std::fprintf(stderr, "%u steps ran on several threads, %u at most\n", dODE_MT_GetParallelSteps(), dODE_MT_GetMaxWorkersUsed());
    dCloseODE();
}
