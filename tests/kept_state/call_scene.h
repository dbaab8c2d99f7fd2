// The scene in which the call test calls every exported function: geoms of every class in a space, in a space
// within it, in another space and in none, bodies under all of them, a joint of every type, two worlds.
// Everything that a library may keep from call to call is there after two frames.
#pragma once

#include "call_trace.h"

#include <csetjmp>
#include <functional>
#include <string>
#include <vector>

namespace kept_state {

enum class SpaceKind { simple, hash, sweepAndPrune, quadTree };
constexpr SpaceKind allSpaceKinds[] = {SpaceKind::simple, SpaceKind::hash, SpaceKind::sweepAndPrune,
                                       SpaceKind::quadTree};
const char *nameOf(SpaceKind kind);
dSpaceID createSpace(SpaceKind kind, dSpaceID parent);

// Where the geoms live that a call is made for.
enum class Place { root, nested, other, nowhere };
constexpr Place allPlaces[] = {Place::root, Place::nested, Place::other, Place::nowhere};
const char *nameOf(Place place);

// Geoms of every class in one place.
struct GeomSet {
    dSpaceID space = nullptr;
    dGeomID sphere, box, capsule, cylinder, convex, mesh;           // with bodies
    dGeomID slab, plane, ray, heights, terrain, transform, custom, tested;  // without
    dGeomID wrapped;                                                // the transform's own
    std::vector<dGeomID> all;                                       // but the wrapped one
};

class CallScene {
public:
    CallScene(SpaceKind kind, Place place, int turn, bool keepsText);
    CallScene(const CallScene &) = delete;
    CallScene &operator=(const CallScene &) = delete;
    void destroy();
    void destroyRoot();  // the root space, and all in it

    // --- frames ---------------------------------------------------------------------------------------
    void collide();
    void step();
    void frame();
    bool stepsExactly = false;  // by dWorldStep; false: dWorldQuickStep
    void askBoxes();   // of all geoms
    void tellState();  // at the end of a case: boxes and the order of geoms too

    // Is done once: in the next near-callback of the root space between two geoms, or in the next
    // moved-callback.
    std::function<void()> inNearCallback, inMovedCallback;
    // Calls it. False: the debug or error handler was called, which jumps back to here.
    bool attempt(const std::function<void()> &call);

    // --- objects for recipes ---------------------------------------------------------------------------
    GeomSet &set() { return m_sets[static_cast<int>(place)]; }
    GeomSet &setAt(Place where) { return m_sets[static_cast<int>(where)]; }
    dGeomID any();        // a geom of the place, alternately
    dGeomID placeable();  // one that may be moved, alternately
    dGeomID carried();    // one with a body, alternately
    dBodyID body() { return dGeomGetBody(carried()); }
    dBodyID filler(int number) const { return fillers[number % fillers.size()]; }
    dGeomID takeGeom();           // that the caller destroys or keeps from the scene
    dBodyID takeBody();           // whose geoms stay
    dGeomID adopt(dGeomID geom);  // made by a recipe: is known and recorded from now on
    dBodyID adopt(dBodyID body);
    dJointID adopt(dJointID joint);
    void drop(dGeomID geom);
    void drop(dJointID joint);
    dGeomID created() const { return m_created; }  // the last one adopted

    template <class T>
    void tell(const T &value) {
        trace.line("value", static_cast<double>(value));
    }
    void tell(const void *object);
    void tell(const dReal *values, int count);

    const SpaceKind kind;
    const Place place;
    const int turn;
    CallTrace trace;
    dWorldID world, second;
    dJointGroupID contacts;
    std::vector<dBodyID> fillers;  // of the first world, in towers
    std::vector<dJointID> joints;  // by dJointType, dJointTypeNone is null
    std::vector<dBodyID> bodies;   // all

    static CallScene *living;
    static std::jmp_buf *faultTarget;  // of the innermost attempt()

private:
    static void nearCallback(void *scene, dGeomID o1, dGeomID o2);
    static void movedCallback(dBodyID body);
    void nearPair(dGeomID o1, dGeomID o2);
    void fill(GeomSet &set, int number);
    dGeomID put(GeomSet &set, dGeomID geom, int number, bool withBody);
    void addTowers();
    void addJoints();
    void tellBodies();

    GeomSet m_sets[4];
    std::vector<dSpaceID> m_spaces;
    std::vector<dJointID> m_made;
    dGeomID m_created = nullptr;
    int m_pairs = 0;
};

}  // namespace kept_state
