// Many worlds in many threads, as for learning: each thread steps worlds of its own, and no lock is needed. Prints where each of the
// balls of the worlds comes to rest, in metres, which does not depend on the number of threads.
#include <ode/ode.h>

#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

constexpr int kWorlds = 32;

// Rolls a ball along the ground against friction.
class Episode {
public:
    explicit Episode(double speed)
        : m_world(dWorldCreate()), m_space(dSimpleSpaceCreate(nullptr)), m_contacts(dJointGroupCreate(0)), m_ball(dBodyCreate(m_world)) {
        dWorldSetGravity(m_world, 0, 0, -9.81);
        dWorldSetAngularDamping(m_world, 0.02);
        dCreatePlane(m_space, 0, 0, 1, 0);
        dMass mass;
        dMassSetSphereTotal(&mass, 0.4, 0.1);
        dBodySetMass(m_ball, &mass);
        dBodySetPosition(m_ball, 0, 0, 0.1);
        dBodySetLinearVel(m_ball, speed, 0, 0);
        dGeomSetBody(dCreateSphere(m_space, 0.1), m_ball);
    }
    ~Episode() {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    Episode(const Episode &) = delete;
    Episode &operator=(const Episode &) = delete;

    double run() {
        for (int step = 0; step < 500; ++step) {
            dSpaceCollide(m_space, this, &Episode::collide);
            dWorldStep(m_world, 0.01);
            dJointGroupEmpty(m_contacts);
        }
        return dBodyGetPosition(m_ball)[0];
    }

private:
    static void collide(void *episode, dGeomID geom1, dGeomID geom2) { static_cast<Episode *>(episode)->touch(geom1, geom2); }

    void touch(dGeomID geom1, dGeomID geom2) {
        dContact contact = {};
        if (dCollide(geom1, geom2, 1, &contact.geom, sizeof(dContact)) == 0) return;
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = 0.5;
        dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), dGeomGetBody(geom1), dGeomGetBody(geom2));
    }

    const dWorldID m_world;
    const dSpaceID m_space;
    const dJointGroupID m_contacts;
    const dBodyID m_ball;
};

}  // namespace

int main() {
    dInitODE2(0);
    // Workers of ODE_MT are not needed here: the program's own threads keep all cores busy. dToggleODE_MT stays at 0.
    double distances[kWorlds];
    std::atomic<int> next{0};
    const auto work = [&] {
        dAllocateODEDataForThread(dAllocateMaskAll);
        for (int world = next++; world < kWorlds; world = next++) distances[world] = Episode(0.5 + 0.1 * world).run();
        dCleanupODEAllDataForThread();
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
    for (std::thread &thread : threads) thread.join();
    for (int world = 0; world < kWorlds; ++world) std::printf("%2d: %.6f m\n", world, distances[world]);
    dCloseODE();
}
