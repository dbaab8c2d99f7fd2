// A world for the tests of faults: geoms of most classes in a space of each kind, bodies in piles and in a
// chain, in several islands, and a frame that also changes things. The same calls give the same world.
#pragma once

#include <ode/ode.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace faults {

enum class SpaceKind { simple, hash, sweepAndPrune, quadTree };

class FaultWorld {
public:
    using Stepper = int (*)(dWorldID, dReal);

    // `towers`: of four spheres each, beside one geom of most classes. Towers that touch are one large island.
    FaultWorld(SpaceKind kind, Stepper stepper, int towers, bool towersTouch = false);
    FaultWorld(const FaultWorld &) = delete;
    FaultWorld &operator=(const FaultWorld &) = delete;
    ~FaultWorld();

    // One frame: changes, collision, step. Memory may be refused to any part of it. A part to which it was,
    // by std::bad_alloc or by the stepper's 0, is done again after `whenRefused` has been called, as a
    // program would do that has given memory back. Returns the number of parts that were.
    template <class WhenRefused>
    int frame(WhenRefused whenRefused) {
        int refusals = 0;
        for (int part = 0; part < kParts;) {
            if (attempt(part)) {
                ++part;
                continue;
            }
            ++refusals;
            whenRefused();
            takeBack(part);
        }
        return refusals;
    }
    int frame() {
        return frame([] {});
    }

    // Returns a hash of the state of the bodies, of the random sequence and of the callbacks of the last frame.
    std::uint64_t hash() const;
    // Adds a geom to the space and removes it: an assertion fails if the space was left locked.
    void useSpace();

private:
    static constexpr int kParts = 3;  // changes, collision, step

    bool attempt(int part);
    bool tryPart(int part);
    void takeBack(int part);
    dBodyID addBody(dGeomID geom, dReal x, dReal y, dReal z);
    void addTowers(int towers, dReal pitch);
    void addClasses();
    void addChain();
    void change();
    void step();
    static void nearCallback(void *world, dGeomID a, dGeomID b);
    void meet(dGeomID a, dGeomID b);

    const Stepper m_stepper;
    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contacts;
    std::vector<dBodyID> m_bodies;
    std::vector<dJointFeedback> m_feedbacks;
    dTriMeshDataID m_mesh;
    dHeightfieldDataID m_terrain;
    dGeomID m_guest;  // comes and goes
    int m_frames = 0;
    std::atomic<bool> m_isRefused{false};   // in a callback
    std::atomic<std::uint64_t> m_pairs{0};  // of the last collision, whatever their order
};

}  // namespace faults
