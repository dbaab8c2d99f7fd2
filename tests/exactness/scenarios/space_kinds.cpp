// Spaces of every kind and with every parameter.
//
// Covers api/collision_space.cpp.
#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <algorithm>

namespace exactness {

namespace {

// A heap of five shapes for every part, in a space that is made for the part.
class Heaps : public ManyParts {
protected:
    using ManyParts::ManyParts;

    void addHeap(int part, Vector3 corner, dSpaceID where) {
        for (int i = 0; i < 5; ++i) {
            const Vector3 place{dReal(0.07) * i, dReal(0.05) * (i % 2), dReal(0.3) + dReal(0.5) * i};
            m_pieces.push_back(carry(createShape(where, allShapes[(part + i) % 4]), corner + place));
        }
    }

    std::vector<dBodyID> m_pieces;
};

// A sweep-and-prune space for every order of the axes, each with its own ground, whose box is infinite.
class AxisOrders : public Heaps {
public:
    explicit AxisOrders(Stepper stepper) : Heaps(stepper) {
        constexpr int orders[] = {dSAP_AXES_XYZ, dSAP_AXES_XZY, dSAP_AXES_YXZ,
                                  dSAP_AXES_YZX, dSAP_AXES_ZXY, dSAP_AXES_ZYX};
        for (int order : orders) {
            m_spaces.push_back(addSpace(dSweepAndPruneSpaceCreate(nullptr, order)));
            add(dCreatePlane(m_spaces.back(), 0, 0, 1, 0));
            add(dCreatePlane(m_spaces.back(), 0.6, 0, 0.8, -60));
        }
        addParts([this](int part, Vector3 origin) { addHeap(part, origin, m_spaces[part % 6]); }, 24);
    }

    // Equal lowest corners: only the history of the sort distinguishes them.
    void control() override {
        if (frameNumber() % 10 != 5) return;
        for (std::size_t i = 0; i + 1 < m_pieces.size(); i += 10) {
            const dReal *place = dBodyGetPosition(m_pieces[i]);
            dBodySetPosition(m_pieces[i], place[0], place[1], 3);
            dBodySetPosition(m_pieces[i + 1], place[0], place[1], 3.3);
        }
    }

private:
    std::vector<dSpaceID> m_spaces;
};

// Quad trees of every depth, which their geoms cross and leave.
class QuadTrees : public Heaps {
public:
    explicit QuadTrees(Stepper stepper) : Heaps(stepper) {
        for (int depth = 1; depth <= 6; ++depth) {
            const dVector3 centre = {dReal(5) * depth, 10, 0}, extents = {dReal(8) * depth, 20, 10};
            m_trees.push_back(addSpace(dQuadTreeSpaceCreate(nullptr, centre, extents, depth)));
            add(dCreatePlane(m_trees.back(), 0, 0, 1, 0));
        }
        addParts([this](int part, Vector3 origin) { addHeap(part, origin, m_trees[part % 6]); }, 18);
        for (std::size_t i = 0; i < m_pieces.size(); ++i)
            dBodySetLinearVel(m_pieces[i], 6.0 * (i / 5 % 3) - 6, 5.0 * (i / 5 % 5) - 10, 0);
    }

    void control() override {
        if (frameNumber() % 12 != 0) return;
        for (dBodyID body : m_pieces) {
            const dReal *velocity = dBodyGetLinearVel(body);
            dBodySetLinearVel(body, -2 * velocity[0], -velocity[1], -1);
        }
    }

private:
    std::vector<dSpaceID> m_trees;
};

// A hash space whose levels change between frames, in steps so small and so large that everything lies in
// cells, and nothing.
class ChangedLevels : public Heaps {
public:
    explicit ChangedLevels(Stepper stepper) : Heaps(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            addHeap(part, origin + Vector3{-30, -30, 0}, space());
            addStaticBox(origin + Vector3{-30, -29, 0.5}, {dReal(1 << part % 6), 0.2, 1});
        });
    }

    void control() override {
        constexpr struct {
            int lowest, highest;
        } levels[] = {{-3, 10}, {-1, 1}, {0, 0}, {3, 3}, {-20, -10}, {8, 20}, {-6, -1}, {-2, 0}};
        const auto &now = levels[frameNumber() / 3 % 8];
        if (frameNumber() % 3 == 0) dHashSpaceSetLevels(space(), now.lowest, now.highest);
        int lowest, highest;
        dHashSpaceGetLevels(space(), &lowest, &highest);
        note("levels", 100 * lowest + highest);
    }
};

// Eight spaces of all kinds that are never in one another, and are collided with one another, with a
// sublevel each, and with geoms that are in no space. The sublevels change between frames.
class Sublevels : public Heaps {
public:
    explicit Sublevels(Stepper stepper) : Heaps(stepper) {
        addGround();
        for (int i = 0; i < 8; ++i) {
            m_spaces.push_back(addSpace(createSpace(allSpaceKinds[i % 4], nullptr)));
            m_inner.push_back(addSpace(createSpace(allSpaceKinds[i / 2], m_spaces.back())));
        }
        addParts([this](int part, Vector3 origin) {
            addHeap(part, origin, m_spaces[part % 8]);
            addHeap(part + 1, origin + Vector3{0.3, 0.1, 0.1}, m_spaces[(part + 3) % 8]);
            addHeap(part + 2, origin + Vector3{-0.3, 0, 0.2}, m_inner[part % 8]);
        });
        addStrays();
    }

    void control() override {
        for (std::size_t i = 0; i < m_spaces.size(); ++i)
            dSpaceSetSublevel(m_spaces[i], static_cast<int>(i + frameNumber() / 2) % 3);
    }

    void collide() override {
        m_contacts = 0;
        for (dSpaceID each : m_spaces) collideSpace(each);
        for (std::size_t i = 0; i < m_spaces.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const bool swapped = (i + j + frameNumber()) % 2 == 0;
                collideTwo(asGeom(m_spaces[swapped ? j : i]), asGeom(m_spaces[swapped ? i : j]));
            }
            meetStrays(m_spaces[i], i % 2 == 0);
        }
    }

private:
    static dGeomID asGeom(dSpaceID each) { return reinterpret_cast<dGeomID>(each); }

    void addStrays() {
        m_strays.push_back(add(dCreatePlane(nullptr, 0, 0, 1, 0)));
        for (int i = 0; i < 6; ++i) {
            const dGeomID pole = add(dCreateCapsule(nullptr, 0.2, 3));
            dGeomSetPosition(pole, 20 * (i % 4) + 0.2, 20 * (i / 4) + 0.1, 0.3);
            m_strays.push_back(pole);
        }
    }

    void meetStrays(dSpaceID each, bool swapped) {
        for (dGeomID stray : m_strays) {
            if (swapped) {
                collideTwo(stray, asGeom(each));
            } else {
                collideTwo(asGeom(each), stray);
            }
        }
    }

    std::vector<dSpaceID> m_spaces, m_inner;
    std::vector<dGeomID> m_strays;
};

// Spaces within the root space are created and destroyed; some destroy their geoms, others do not.
class Cleanup : public Heaps {
public:
    explicit Cleanup(Stepper stepper) : Heaps(stepper) {
        dSpaceSetManualCleanup(space(), 1);
        addGround();
        addParts([this](int part, Vector3 origin) {
            m_spaces.push_back(makeSpace(part));
            addHeap(part, origin, m_spaces.back());
            add(dCreateBox(m_spaces.back(), 0.5, 0.5, 0.5));  // dies with the space, or not
            dGeomSetPosition(m_inventory.geoms.back(), origin.x + 0.4, origin.y + 0.1, 0.2);
        });
    }

    void control() override {
        if (frameNumber() % 3 != 0) return;
        const std::size_t which = frameNumber() / 3 % m_spaces.size();
        note("manual cleanup", dSpaceGetManualCleanup(m_spaces[which]));
        if (frameNumber() % 2 == 0) {
            dSpaceClean(m_spaces[which]);
            moveGeoms(m_spaces[which], space());
        } else {
            leaveGeoms(which);
        }
    }

private:
    dSpaceID makeSpace(int number) {
        // Upstream's quad tree does not forget geoms that outlive it.
        const dSpaceID made = addSpace(createSpace(allSpaceKinds[number % 3], space()));
        dSpaceSetManualCleanup(made, 1);
        dSpaceSetCleanup(made, number % 2);
        return made;
    }

    // Upstream requires that geoms that enter a space have moved since their boxes were last computed.
    static void enter(dSpaceID to, dGeomID geom) {
        dSpaceAdd(to, geom);
        const dReal *place = dGeomGetPosition(geom);
        dGeomSetPosition(geom, place[0], place[1], place[2]);
    }

    static void moveGeoms(dSpaceID from, dSpaceID to) {
        while (dSpaceGetNumGeoms(from) > 2) {
            const dGeomID geom = dSpaceGetGeom(from, 1);
            dSpaceRemove(from, geom);
            enter(to, geom);
        }
    }

    // The space goes, its geoms stay; a new one takes its place.
    void leaveGeoms(std::size_t which) {
        const dSpaceID old = m_spaces[which];
        std::vector<dGeomID> left;
        for (int i = 0; i < dSpaceGetNumGeoms(old); ++i) left.push_back(dSpaceGetGeom(old, i));
        dSpaceSetCleanup(old, 0);
        m_inventory.spaces.erase(std::find(m_inventory.spaces.begin(), m_inventory.spaces.end(), old));
        dSpaceDestroy(old);
        m_spaces[which] = makeSpace(frameNumber());
        for (dGeomID geom : left) {
            note("in the space that took them", dSpaceQuery(m_spaces[which], geom));
            enter(m_spaces[which], geom);
        }
    }

    std::vector<dSpaceID> m_spaces;
};

}  // namespace

void addSpaceKinds(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, int steps, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, steps, std::move(make)));
    };
    add("space_kinds/axis_orders", "sweep-and-prune spaces of all six orders of axes", 40,
        make<AxisOrders>());
    add("space_kinds/quad_trees", "quad trees one to six deep, crossed and left", 50, make<QuadTrees>());
    add("space_kinds/changed_levels", "a hash space whose levels change between frames", 40,
        make<ChangedLevels>());
    add("space_kinds/sublevels", "spaces of all kinds against one another and against geoms, with sublevels",
        30, make<Sublevels>());
    add("space_kinds/cleanup", "nested spaces destroyed with their geoms and without", 60, make<Cleanup>());
}

}  // namespace exactness
