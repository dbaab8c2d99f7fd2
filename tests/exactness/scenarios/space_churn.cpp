#include "additions.h"
#include "crowd.h"
#include "spaces.h"

#include <algorithm>

namespace exactness {

namespace {

// All members move, none, or a few, alternately: a broad phase that keeps its pairs must detect each change.
class Alternating : public Crowd {
public:
    Alternating(Stepper stepper, SpaceKind kind, int count) : Crowd(stepper, kind) {
        addGround();
        addMembers(count, 8, 1);
    }

    void control() override { alternate(); }
};

// A simple space that grows past the number of geoms up to which all are compared with all, and shrinks.
class Breathing : public Crowd {
public:
    explicit Breathing(Stepper stepper) : Crowd(stepper, SpaceKind::Simple) { addMembers(150, 7, 1); }

    void control() override {
        const bool grows = frameNumber() % 24 < 12;
        for (int i = 0; i < 45; ++i) {
            if (grows) {
                addMember(m_dice.within(7), m_dice.between(0.5, 1));
            } else {
                destroyOne();
            }
        }
        alternate();
    }

private:
    void destroyOne() {
        const dGeomID geom = m_inventory.geoms[m_dice.below(static_cast<int>(m_inventory.geoms.size()))];
        if (const dBodyID body = dGeomGetBody(geom)) {
            destroy(body);
        } else {
            destroy(geom);
        }
    }
};

// Geoms leave the space for another one and come back, are destroyed and made, moved in the same frame or
// not.
class InAndOut : public Crowd {
public:
    InAndOut(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind) {
        m_other = addSpace(createSpace(SpaceKind::Hash, nullptr));
        addGround();
        addMembers(600, 7, 1);
    }

    void control() override {
        if (frameNumber() % 4 == 3) return;
        const int last = static_cast<int>(m_inventory.geoms.size()) - 1;
        for (int i = 0; i < 25; ++i) changePlace(m_inventory.geoms[1 + m_dice.below(last)]);
        if (frameNumber() % 5 == 0) exchange();
    }

private:
    // Upstream requires that geoms that enter a space have moved since their boxes were last computed.
    void changePlace(dGeomID geom) {
        const dSpaceID from = dGeomGetSpace(geom), to = from == space() ? m_other : space();
        dSpaceRemove(from, geom);
        dSpaceAdd(m_dice.oneIn(3) ? from : to, geom);
        const dReal *place = dGeomGetPosition(geom);
        dGeomSetPosition(geom, place[0], place[1] + 0.01, place[2]);
    }

    void exchange() {
        destroy(m_inventory.geoms[1 + m_dice.below(500)]);
        destroy(m_inventory.bodies[m_dice.below(static_cast<int>(m_inventory.bodies.size()))]);
        addMembers(4, 7, 1);
    }

    dSpaceID m_other;
};

// Geoms without bodies jump, rotate, and change their size, between frames in which nothing
// happens.
class Teleports : public Crowd {
public:
    Teleports(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind) {
        addMembers(700, 8, 1);
        for (dBodyID body : m_inventory.bodies) dBodySetKinematic(body);
        for (int i = 0; i < 30; ++i) addFreeBody();
    }

    void control() override {
        if (frameNumber() % 3 == 0) return;
        for (int i = frameNumber() % 2 == 0 ? 8 : 300; i > 0; --i)
            jump(m_inventory.geoms[m_dice.below(static_cast<int>(m_inventory.geoms.size()))]);
    }

private:
    void addFreeBody() {
        const Vector3 place = m_dice.within(8);
        dBodySetLinearVel(addSphere(place, 0.3, 1), 1, 0.5, 0);
    }

    void jump(dGeomID geom) {
        const Vector3 place = m_dice.within(8);
        dGeomSetPosition(geom, place.x, place.y, place.z);
        if (dGeomGetClass(geom) != dSphereClass) return;
        dGeomSphereSetRadius(geom, m_dice.between(0.1, 0.6));
        dMatrix3 turn;
        dRFromAxisAndAngle(turn, 1, 2, place.x, place.y);
        dGeomSetRotation(geom, turn);
    }
};

}  // namespace

void addSpaceChurn(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, int steps, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, steps, std::move(make), callbacks));
    };
    constexpr auto shared = Scenario::Callbacks::shared;
    add("space_churn/simple", "700 geoms in a simple space: all move, none, or a few, alternately", 26,
        make<Alternating>(SpaceKind::Simple, 700), shared);
    add("space_churn/dense", "300 geoms in a simple space: all move, none, or a few, alternately", 26,
        make<Alternating>(SpaceKind::Simple, 300));
    add("space_churn/hash", "1200 geoms in a hash space: all move, none, or a few, alternately", 26,
        make<Alternating>(SpaceKind::Hash, 1200), shared);
    add("space_churn/sweep_and_prune", "500 geoms in a sweep-and-prune space, the same", 26,
        make<Alternating>(SpaceKind::SweepAndPrune, 500), shared);
    add("space_churn/quad_tree", "500 geoms in a quad-tree space, the same", 26,
        make<Alternating>(SpaceKind::QuadTree, 500));
    add("space_churn/big_quad_tree", "1200 geoms in a quad-tree space, the same", 26,
        make<Alternating>(SpaceKind::QuadTree, 1200), shared);
    add("space_churn/breathing", "a simple space of 150 to 690 geoms and back", 48, make<Breathing>());
    add("space_churn/in_and_out_of_hash", "geoms leave a hash space, return, are destroyed", 30,
        make<InAndOut>(SpaceKind::Hash), shared);
    add("space_churn/in_and_out_of_simple", "geoms leave a simple space, return, are destroyed", 30,
        make<InAndOut>(SpaceKind::Simple));
    add("space_churn/in_and_out_of_quad_tree", "geoms leave a quad-tree space, return, are destroyed", 30,
        make<InAndOut>(SpaceKind::QuadTree), shared);
    add("space_churn/in_and_out_of_sweep_and_prune", "geoms leave a sweep-and-prune space, return, are destroyed", 30,
        make<InAndOut>(SpaceKind::SweepAndPrune), shared);
    add("space_churn/teleports", "geoms jump, turn and change their size, between quiet frames", 24,
        make<Teleports>(SpaceKind::Hash));
    add("space_churn/teleports_in_simple", "geoms jump, turn and change their size in a simple space", 24,
        make<Teleports>(SpaceKind::Simple));
    add("space_churn/teleports_in_quad_tree", "geoms jump, turn and change their size in a quad-tree space", 24,
        make<Teleports>(SpaceKind::QuadTree));
}

}  // namespace exactness
