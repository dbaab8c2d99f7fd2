#include "additions.h"
#include "crowd.h"

#include <algorithm>

namespace exactness {

namespace {

// Heaps of boxes all alike in a square, so many that their pairs are not found by a sweep of all.
class Heaps : public ScenarioScene {
public:
    explicit Heaps(Stepper stepper) : ScenarioScene(stepper, SpaceKind::SweepAndPrune) {
        addGround();
        m_contactLimit = 2;
        for (int i = 0; i < kHeaps * kBoxes; ++i) {
            const int heap = i / kBoxes, layer = i % kBoxes;
            const Vector3 corner{dReal(heap % kSide) - kSide / 2, dReal(heap / kSide) - kSide / 2, 0};
            addBox(corner + Vector3{dReal(0.02) * layer, 0, dReal(0.2) + dReal(0.38) * layer}, {0.4, 0.4, 0.4}, 1);
        }
    }

private:
    static constexpr int kSide = 20, kHeaps = kSide * kSide, kBoxes = 3;
};

// Boxes on a grid around zero whose bounds are the same numbers, along the sweep's axis -0 and 0 among them: where they
// are in the order depends on earlier calls. Some jump to another place of the grid and back.
class EqualBounds : public Crowd {
public:
    EqualBounds(Stepper stepper, int side) : Crowd(stepper, SpaceKind::SweepAndPrune, 31), m_side(side) {
        for (int i = 0; i < side * side * side; ++i) {
            const dGeomID box = add(dCreateBox(space(), 0.5, 0.5, 0.5));
            dGeomSetCollideBits(box, ~0ul);
            keepFromContacts(box);
            put(box, i);
        }
        addMembers(60, side * 0.25, 0.4);
    }

    void control() override {
        if (frameNumber() % 4 == 0) return;
        const int boxes = m_side * m_side * m_side;
        for (int i = frameNumber() % 4 == 1 ? boxes / 2 : 9; i > 0; --i)
            put(m_inventory.geoms[m_dice.below(boxes)], m_dice.below(boxes));
    }

private:
    // The corners of every second layer are at zero, of either sign.
    void put(dGeomID box, int place) {
        const int x = place % m_side - m_side / 2, y = place / m_side % m_side - m_side / 2,
                  z = place / m_side / m_side - m_side / 2;
        dGeomSetPosition(box, 0.5 * x + 0.25, 0.5 * y, 0.5 * z);
    }

    int m_side;
};

// The members are so far out that single precision cannot distinguish them: boxes that do not touch are pairs all the same.
class FarOut : public Crowd {
public:
    explicit FarOut(Stepper stepper) : Crowd(stepper, SpaceKind::SweepAndPrune, 32) {
        for (int i = 0; i < 1300; ++i) {
            const dReal distance = i % 2 == 0 ? dReal(3e6) : dReal(-3e6);
            addMember(Vector3{distance, 0, 0} + m_dice.within(9), 1);
        }
    }

    void control() override { alternate(); }
};

// A space that grows past the number of geoms up to which all are swept, and shrinks.
class Breathing : public Crowd {
public:
    explicit Breathing(Stepper stepper) : Crowd(stepper, SpaceKind::SweepAndPrune, 33) {
        addGround();
        addMembers(420, 9, 1);
    }

    void control() override {
        const bool grows = frameNumber() % 20 < 10;
        for (int i = 0; i < 80; ++i) {
            if (grows) {
                addMember(m_dice.within(9), m_dice.between(0.5, 1));
            } else {
                destroy(m_inventory.geoms[1 + m_dice.below(static_cast<int>(m_inventory.geoms.size()) - 1)]);
            }
        }
        alternate();
    }
};

// Geoms are taken out and put back, moved or not, and switched off and on between frames and in callbacks, among
// infinite planes and balls.
class Switched : public Crowd {
public:
    Switched(Stepper stepper, int count) : Crowd(stepper, SpaceKind::SweepAndPrune, 34) {
        addMembers(count / 2, 7, 1);
        for (int i = 0; i < 4; ++i) {
            addGiant(dCreatePlane(space(), 0.1 * i, 0.2, 1, -7));
            addGiant(dCreateSphere(space(), dInfinity));
        }
        addMembers(count / 2, 7, 1);
    }

    void control() override {
        alternate();
        if (frameNumber() % 5 == 0) return;
        for (int i = 0; i < 20; ++i) {
            const dGeomID geom = some();
            dSpaceRemove(space(), geom);
            dSpaceAdd(space(), geom);
            if (i % 3 == 0) nudge(geom);
        }
        for (int i = 0; i < 12; ++i) {
            dGeomDisable(some());
            dGeomEnable(some());
        }
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Crowd::onNearPair(o1, o2);
        if (++m_pairs % 400 == 0) dGeomDisable(some());
        if (m_pairs % 400 == 200) dGeomEnable(some());
    }

private:
    dGeomID some() { return m_inventory.geoms[m_dice.below(static_cast<int>(m_inventory.geoms.size()))]; }

    void addGiant(dGeomID geom) {
        add(geom);
        dGeomSetCollideBits(geom, ~0ul);
        keepFromContacts(geom);
    }

    int m_pairs = 0;
};

// What need not be an order of axes: one of them twice, one of them thrice.
class AnyAxes : public Crowd {
public:
    explicit AnyAxes(Stepper stepper) : Crowd(stepper, SpaceKind::Hash, 35) {
        for (const int axes : {0, 1 | 1 << 2 | 2 << 4, 2 | 2 << 2 | 2 << 4, dSAP_AXES_ZXY | 1 << 6}) {
            const dSpaceID odd = addSpace(dSweepAndPruneSpaceCreate(nullptr, axes));
            for (int i = 0; i < 150; ++i) {
                const dGeomID geom = addMember(m_dice.within(20), 1);
                dSpaceRemove(space(), geom);
                dSpaceAdd(odd, geom);
            }
        }
    }

    void control() override { alternate(); }
};

// A space full of geoms, some of them moving, is asked by rays and boxes that are in no space.
class Asked : public Crowd {
public:
    explicit Asked(Stepper stepper) : Crowd(stepper, SpaceKind::SweepAndPrune, 36) {
        addMembers(1300, 9, 1);
        for (int i = 0; i < 40; ++i) m_rays.push_back(add(dCreateRay(nullptr, 12)));
        m_box = add(dCreateBox(nullptr, 3, 3, 3));
    }

    void control() override { alternate(); }

    void collide() override {
        Crowd::collide();
        const dGeomID all = reinterpret_cast<dGeomID>(space());
        for (const dGeomID ray : m_rays) {
            const Vector3 from = m_dice.within(9), along = m_dice.within(1);
            dGeomRaySet(ray, from.x, from.y, from.z, along.x, along.y, along.z);
            collideTwo(ray, all);
        }
        const Vector3 place = m_dice.within(7);
        dGeomSetPosition(m_box, place.x, place.y, place.z);
        collideTwo(all, m_box);
    }

private:
    std::vector<dGeomID> m_rays;
    dGeomID m_box;
};

// Every second geom is of a class whose boxes end before they begin, where others begin: which of the two is found depends on their
// order, and that on who else comes and goes.
class Inverted : public Crowd {
public:
    explicit Inverted(Stepper stepper) : Crowd(stepper, SpaceKind::SweepAndPrune, 37) {
        const dGeomClass description = {0, [](int) -> dColliderFn * { return nullptr; }, &bound, nullptr, nullptr};
        const int inverted = dCreateGeomClass(&description);
        for (int i = 0; i < 120; ++i) {
            const dGeomID geom = add(i % 2 == 0 ? dCreateGeom(inverted) : dCreateBox(nullptr, 1, 30, 30));
            keepFromContacts(geom);
            put(geom);
            dSpaceAdd(space(), geom);
        }
        addMembers(60, 4, 0.4);
    }

    void control() override {
        if (frameNumber() % 3 == 0) return;
        for (int i = 0; i < 4; ++i) {
            const dGeomID geom = m_inventory.geoms[m_dice.below(120)];
            dSpaceRemove(space(), geom);
            if (frameNumber() % 3 == 1) put(geom);
            dSpaceAdd(space(), geom);
        }
    }

private:
    static void bound(dGeomID geom, dReal box[6]) {
        const dReal *const place = dGeomGetPosition(geom);
        const dReal bounds[6] = {place[0] + dReal(0.5), place[0] - dReal(0.5), -15, 15, -15, 15};
        std::copy(bounds, bounds + 6, box);
    }

    void put(dGeomID geom) { dGeomSetPosition(geom, m_dice.below(24) - 12, 0, 0); }
};

// So few geoms, and so far apart, that the space is swept anew while they move: all of them, none, or a few, each for some frames, and then some
// come and go. Many have equal bounds, whose order depends on earlier calls. Rays query the space between calls, and in callbacks.
class Restless : public Crowd {
public:
    explicit Restless(Stepper stepper) : Crowd(stepper, SpaceKind::SweepAndPrune, 38) {
        for (int i = 0; i < kBoxes; ++i) {
            const dGeomID box = add(dCreateBox(space(), 0.5, 0.5, 0.5));
            dGeomSetCollideBits(box, ~0ul);
            keepFromContacts(box);
            put(box);
        }
        addMembers(40, 8, 0.4);
        for (int i = 0; i < 12; ++i) m_rays.push_back(add(dCreateRay(nullptr, 12)));
    }

    void control() override {
        const int phase = frameNumber() % 24;
        const int moving = phase < 8 ? kBoxes : phase < 14 ? 0 : 2;
        moveEvery(moving == kBoxes ? 1 : 0);
        for (int i = 0; i < moving; ++i) put(some());
        for (int i = 20; i < phase; ++i) {
            const dGeomID geom = some();
            dSpaceRemove(space(), geom);
            if (i == 21) put(geom);
            dSpaceAdd(space(), geom);
            dGeomDisable(some());
            dGeomEnable(some());
        }
    }

    void collide() override {
        Crowd::collide();
        if (frameNumber() % 3 == 0) query(12);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Crowd::onNearPair(o1, o2);
        if (m_isWithin || ++m_pairs % 60 != 0) return;
        m_isWithin = true;
        query(m_pairs % 120 == 0 ? 12 : 2);
        m_isWithin = false;
    }

private:
    static constexpr int kBoxes = 160;

    dGeomID some() { return m_inventory.geoms[m_dice.below(kBoxes)]; }

    void put(dGeomID box) {
        dGeomSetPosition(box, 0.5 * m_dice.below(32) - 8, 0.5 * m_dice.below(32) - 8, 0.5 * m_dice.below(32) - 8);
    }

    void query(int rays) {
        for (int i = 0; i < rays; ++i) {
            const Vector3 from = m_dice.within(8), along = m_dice.within(1);
            dGeomRaySet(m_rays[i], from.x, from.y, from.z, along.x, along.y, along.z);
            collideTwo(m_rays[i], reinterpret_cast<dGeomID>(space()));
        }
    }

    std::vector<dGeomID> m_rays;
    int m_pairs = 0;
    bool m_isWithin = false;
};

}  // namespace

void addSweepSpaces(Catalogue &catalogue) {
    constexpr auto shared = Scenario::Callbacks::shared, reentrant = Scenario::Callbacks::reentrant;
    const auto add = [&](const char *name, const char *meaning, int steps, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, steps, std::move(make), callbacks));
    };
    Scenario heaps{"sweep_spaces/heaps", "400 heaps of boxes in a sweep-and-prune space", 30, make<Heaps>()};
    heaps.callbacks = shared;
    catalogue.push_back(heaps);
    add("sweep_spaces/equal_bounds", "1000 boxes with equal bounds, around zero", 24, make<EqualBounds>(10), reentrant);
    add("sweep_spaces/many_equal_bounds", "1700 boxes with equal bounds, around zero", 24, make<EqualBounds>(12),
        reentrant);
    add("sweep_spaces/far_out", "1300 geoms 3000 km from zero, where bounds are rounded together", 24,
        make<FarOut>(), reentrant);
    add("sweep_spaces/breathing", "a sweep-and-prune space of 420 to 1200 geoms and back", 40, make<Breathing>());
    add("sweep_spaces/switched", "500 geoms and infinite ones, added and removed, enabled and disabled", 30, make<Switched>(500));
    add("sweep_spaces/many_switched", "1400 geoms and infinite ones, added and removed, enabled and disabled", 30,
        make<Switched>(1400));
    add("sweep_spaces/any_axes", "spaces whose axes are not all three", 24, make<AnyAxes>(), reentrant);
    add("sweep_spaces/inverted", "boxes that end before they begin, and others that begin there, added and removed", 30, make<Inverted>());
    add("sweep_spaces/restless", "200 geoms that all move, rest, or move by few, for some frames each, with queries in callbacks", 60,
        make<Restless>());
    add("sweep_spaces/asked", "rays and boxes query 1300 geoms in a sweep-and-prune space", 20, make<Asked>());
}

}  // namespace exactness
