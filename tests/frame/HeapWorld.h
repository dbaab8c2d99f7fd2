// Small boxes and balls in two layers on a plane, near enough to touch: some thousand pairs of geoms in one space, all of
// which move in every frame.
#pragma once

#include <ode/ode.h>

#include <atomic>
#include <vector>

// A function with the signature of dSimpleSpaceCreate.
inline dSpaceID createSweepSpace(dSpaceID parent) { return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XYZ); }

class HeapWorld {
public:
    static constexpr int kSide = 18;       // bodies along a side of a layer

    explicit HeapWorld(dSpaceID space);
    ~HeapWorld();
    HeapWorld(const HeapWorld &) = delete;
    HeapWorld &operator=(const HeapWorld &) = delete;

    void collide();  // contact joints for all that touch
    dWorldID world() const { return m_world; }
    void step();     // removes them

    // What the near-callback does with a pair; the usual thing if empty.
    using Callback = void (*)(HeapWorld &world, dGeomID o1, dGeomID o2);
    void setCallback(Callback callback) { m_callback = callback; }
    void makeContacts(dGeomID o1, dGeomID o2);

    std::vector<dReal> positions() const;
    int contacts() const { return m_contacts; }

private:
    void add(dReal x, dReal y, dReal z, bool ball);

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_group;
    std::vector<dBodyID> m_bodies;
    Callback m_callback = nullptr;
    std::atomic<int> m_contacts{0};  // since the beginning; callbacks may run at once
};
