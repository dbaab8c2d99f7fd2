#include "additions.h"
#include "contact_probe.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <xmmintrin.h>

namespace exactness {

namespace {

// Heaps of mixed shapes beside posts, with near-callbacks that do more than ask for contacts.
class Liberties : public ManyParts {
protected:
    explicit Liberties(Stepper stepper, SpaceKind kind = SpaceKind::Hash) : ManyParts(stepper, kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            addStaticBox(origin + Vector3{0.3, 0.25, 0.6}, {0.2, 0.2, 1.2});
            for (int i = 0; i < 5; ++i) {
                const Vector3 place{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.45) * i};
                carry(createShape(space(), allShapes[(part + i) % 4]), origin + place);
            }
        });
    }

    static dBodyID bodyOf(dGeomID o1, dGeomID o2) {
        return dGeomGetBody(o1) != nullptr ? dGeomGetBody(o1) : dGeomGetBody(o2);
    }

    dGeomID someGeom(int number) const { return m_inventory.geoms[number % m_inventory.geoms.size()]; }
    dBodyID someBody(int number) const { return m_inventory.bodies[number % m_inventory.bodies.size()]; }

    int m_pairs = 0;  // of all frames
};

// Geoms are disabled and enabled: those of the pair, and others, of earlier or later pairs.
class Enabling : public Liberties {
public:
    Enabling(Stepper stepper, SpaceKind kind) : Liberties(stepper, kind) {}

    void control() override {
        if (frameNumber() % 3 != 0) return;
        for (dGeomID geom : m_inventory.geoms) dGeomEnable(geom);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const int pair = m_pairs++;
        if (pair % 11 == 0) dGeomDisable(o1);
        if (pair % 13 == 3) dGeomDisable(o2);
        if (pair % 5 == 2) dGeomDisable(someGeom(7 * pair));
        if (pair % 3 == 1) dGeomEnable(someGeom(5 * pair));
        Liberties::onNearPair(o1, o2);
        if (pair % 22 == 11) dGeomEnable(o1);
    }
};

// Whatever is done to geoms of a space that is not locked: moved, resized, filtered, marked, made, destroyed.
class OtherSpaces : public Liberties {
public:
    explicit OtherSpaces(Stepper stepper) : Liberties(stepper), m_other(addSpace(dHashSpaceCreate(nullptr))) {
        for (int i = 0; i < 40; ++i) addToOther();
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Liberties::onNearPair(o1, o2);
        if (dGeomGetSpace(o1) != space()) return;
        const int pair = m_pairs++;
        const dGeomID geom = m_marked[pair % m_marked.size()];
        const dReal *place = dBodyGetPosition(bodyOf(o1, o2));
        dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(pair)));
        if (pair % 3 == 0) dGeomSetPosition(geom, place[0], place[1], place[2]);
        if (pair % 5 == 0) dGeomBoxSetLengths(geom, 0.2 + 0.01 * (pair % 40), 0.4, 0.5);
        if (pair % 7 == 0) dGeomSetCategoryBits(geom, 1ul << pair % 3);
        if (pair % 11 == 0) dGeomSetCollideBits(geom, 6ul >> pair % 2);
        if (pair % 50 == 0) addToOther();
        if (pair % 50 == 25) destroyMarked(pair);
        if (pair % 20 == 10)
            note("mark", static_cast<double>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))));
        if (pair % 60 == 30) collideSpace(m_other);
    }

private:
    void addToOther() {
        m_marked.push_back(add(dCreateBox(m_other, 0.4, 0.4, 0.4)));
        dGeomSetCollideBits(m_marked.back(), ~0ul);
        dGeomSetPosition(m_marked.back(), 0.3 * m_marked.size(), 0, 0.5);
    }

    void destroyMarked(int number) {
        const auto place = m_marked.begin() + number % m_marked.size();
        destroy(*place);
        m_marked.erase(place);
    }

    dSpaceID m_other;
    std::vector<dGeomID> m_marked;
};

// Contacts that are taken away again at once or by a later callback, groups emptied half way, joints made and
// destroyed.
class Joints : public Liberties {
public:
    explicit Joints(Stepper stepper) : Liberties(stepper), m_early(dJointGroupCreate(0)) {}
    ~Joints() override { dJointGroupDestroy(m_early); }

    void finish() override {
        while (!m_loose.empty()) dropLoose();
        dJointGroupEmpty(m_early);
        Liberties::finish();
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const int pair = m_pairs++;
        Liberties::onNearPair(o1, o2);
        addContactTo(pair % 2 == 0 ? m_early : nullptr, o1, o2);
        if (pair % 3 == 2 && !m_loose.empty()) dropLoose();
        if (pair % 70 == 69) dJointGroupEmpty(m_early);
        if (pair % 40 == 7) pin(bodyOf(o1, o2));
        if (pair % 40 == 31 && !m_inventory.joints.empty()) destroy(m_inventory.joints.front());
    }

private:
    void addContactTo(dJointGroupID group, dGeomID o1, dGeomID o2) {
        dContact contact{};
        if (dCollide(o1, o2, 1, &contact.geom, sizeof(dContact)) == 0) return;
        contact.surface.mu = 0.3;
        const dJointID joint = dJointCreateContact(world(), group, &contact);
        dJointAttach(joint, dGeomGetBody(o1), dGeomGetBody(o2));
        if (group == nullptr) m_loose.push_back(joint);
    }

    void dropLoose() {
        dJointDestroy(m_loose.back());
        m_loose.pop_back();
    }

    void pin(dBodyID body) {
        const dReal *place = dBodyGetPosition(body);
        addFeedback(addBall(body, nullptr, {place[0], place[1], place[2] + 0.1}));
    }

    dJointGroupID m_early;
    std::vector<dJointID> m_loose;
};

// Functions of joints that move a body to and fro: far enough, and its position comes back as another one, and no space hears.
class Nudges : public Liberties {
public:
    explicit Nudges(Stepper stepper) : Liberties(stepper) {
        for (int i = 0; i < 12; ++i) {
            const dJointID joint = i % 3 == 0 ? dJointCreatePiston(world(), nullptr) : dJointCreatePU(world(), nullptr);
            m_joints.push_back(add(joint));
            dJointAttach(joint, someBody(7 * i), i % 2 == 0 ? someBody(7 * i + 1) : nullptr);
        }
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (m_pairs++ % 9 == 4) nudge(m_pairs);
        Liberties::onNearPair(o1, o2);
    }

private:
    void nudge(int number) {
        const dJointID joint = m_joints[number % m_joints.size()];
        const dReal far = number % 2 == 0 ? dReal(1e13) : dReal(1e9) * (number % 7);
        if (dJointGetType(joint) == dJointTypePiston)
            dJointSetPistonAnchorOffset(joint, 0, 0, 0.5, far, -far, far / 3);
        else if (number % 4 < 2)
            dJointSetPUAnchorDelta(joint, 0, 0, 0.5, far, 0, far / 7);
        else
            dJointSetPUAnchorOffset(joint, 0, 0, 0.5, far, 0, far / 7);
    }

    std::vector<dJointID> m_joints;
};

// Callbacks that compute their contacts in another mode of floating point, and put it back.
class Modes : public Liberties {
public:
    Modes(Stepper stepper, unsigned mode) : Liberties(stepper), m_mode(mode) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const unsigned own = _mm_getcsr();
        if (m_pairs++ % 4 == 1) _mm_setcsr(own | m_mode);
        Liberties::onNearPair(o1, o2);
        _mm_setcsr(own);
    }

private:
    const unsigned m_mode;
};

// Callbacks that query the joints of earlier callbacks of the frame.
class Queries : public Liberties {
public:
    explicit Queries(Stepper stepper) : Liberties(stepper) {
        for (int i = 0; i + 1 < 60; i += 10) addFixed(someBody(i), someBody(i + 1));
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const dBodyID b1 = dGeomGetBody(o1), b2 = dGeomGetBody(o2), other = someBody(3 * m_pairs++);
        if (b1 != nullptr && b2 != nullptr) {
            note("are connected", dAreConnected(b1, b2));
            note("but for contacts", dAreConnectedExcluding(b1, b2, dJointTypeContact));
            note("but for fixed joints", dAreConnectedExcluding(b1, b2, dJointTypeFixed));
        }
        lookAt(other);
        Liberties::onNearPair(o1, o2);
        lookAt(bodyOf(o1, o2));
        if (b1 != nullptr && b2 != nullptr) note("by", dConnectingJoint(b1, b2) != nullptr);
    }

private:
    void lookAt(dBodyID body) {
        const int joints = dBodyGetNumJoints(body);
        note("joints", joints);
        if (joints > 0) note("type of the first", dJointGetType(dBodyGetJoint(body, 0)));
    }
};

// Bodies are enabled, disabled, pushed, stopped, made kinematic, given other masses.
class Bodies : public Liberties {
public:
    explicit Bodies(Stepper stepper) : Liberties(stepper) { dWorldSetAutoDisableFlag(world(), 1); }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const int pair = m_pairs++;
        const dBodyID own = bodyOf(o1, o2), other = someBody(11 * pair);
        dBodyAddForce(own, 0.3 * (pair % 5), 0, 1);
        Liberties::onNearPair(o1, o2);
        if (pair % 4 == 0) dBodyAddRelTorque(other, 0, 0.1, 0.2);
        if (pair % 9 == 4) dBodyDisable(other);
        if (pair % 9 == 5) dBodyEnable(other);
        if (pair % 17 == 8) dBodySetLinearVel(own, 0, 0.2, 0.5);
        if (pair % 60 == 20) dBodySetKinematic(other);
        if (pair % 60 == 50) dBodySetDynamic(other);
        if (pair % 30 == 15) weigh(own, 1 + 0.1 * (pair % 7));
    }

private:
    static void weigh(dBodyID body, dReal mass) {
        dMass ball;
        dMassSetSphereTotal(&ball, mass, 0.2);
        dBodySetMass(body, &ball);
    }
};

// The pair again by dSpaceCollide2, the pair's geoms against the whole space, and the whole space once more
// while it is locked.
class Recursive : public Liberties {
public:
    Recursive(Stepper stepper, SpaceKind kind) : Liberties(stepper, kind) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (m_depth > 0) return;
        ++m_depth;
        const int pair = m_pairs++;
        if (pair % 3 == 0) collideTwo(o1, o2);
        if (pair % 3 == 1) collideTwo(o2, o1);
        if (pair % 20 == 5) collideTwo(o1, reinterpret_cast<dGeomID>(space()));
        if (pair % 20 == 15) collideTwo(reinterpret_cast<dGeomID>(space()), o2);
        if (pair % 100 == 50) collideSpace(space());
        if (pair % 100 == 75) switchGeom(someGeom(pair));
        --m_depth;
        Liberties::onNearPair(o1, o2);
    }

private:
    // And what the recursion sees then.
    void switchGeom(dGeomID geom) {
        dGeomDisable(geom);
        collideSpace(space());
        dGeomEnable(geom);
    }

    int m_depth = 0;
};

// dCollide in every way but the usual one: swapped, twice, for geoms of another pair, with other flags.
class OtherPairs : public Liberties {
public:
    explicit OtherPairs(Stepper stepper) : Liberties(stepper) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        probe(o2, o1, 3, sizeof(dContactGeom));
        if (m_before != nullptr) probe(m_before, o2, 2, sizeof(dContact));
        Liberties::onNearPair(o1, o2);
        probe(o1, o2, static_cast<int>(CONTACTS_UNIMPORTANT | 8u), 512);
        probe(o1, o2, 200, sizeof(dContact));
        m_before = o1;
    }

private:
    void probe(dGeomID o1, dGeomID o2, int flags, std::size_t skip) {
        m_probe.collide(o1, o2, flags, static_cast<int>(skip));
        m_probe.tell(m_observer);
    }

    ContactProbe m_probe;
    dGeomID m_before = nullptr;
};

// Callbacks that ask whether geoms touch, and nothing else: some colliders then leave the contact as they find it, and
// dCollide negates what the program had there.
class Touches : public Liberties {
public:
    explicit Touches(Stepper stepper) : Liberties(stepper) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        m_probe.collide(o1, o2, static_cast<int>(CONTACTS_UNIMPORTANT | 1u), sizeof(dContactGeom));
        m_probe.tell(m_observer);
    }

private:
    ContactProbe m_probe;
};

}  // namespace

void addCallbackLiberties(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 30, std::move(make)));
    };
    add("callback_liberties/enabling_in_simple", "geoms enabled and disabled in callbacks of a simple space",
        make<Enabling>(SpaceKind::Simple));
    add("callback_liberties/enabling_in_hash", "geoms enabled and disabled in callbacks of a hash space",
        make<Enabling>(SpaceKind::Hash));
    add("callback_liberties/enabling_in_sweep_and_prune", "the same in a sweep-and-prune space",
        make<Enabling>(SpaceKind::SweepAndPrune));
    add("callback_liberties/enabling_in_quad_tree", "the same in a quad-tree space",
        make<Enabling>(SpaceKind::QuadTree));
    add("callback_liberties/other_spaces", "callbacks change, make and destroy geoms of another space",
        make<OtherSpaces>());
    add("callback_liberties/joints", "contacts taken away again, groups emptied, joints made and destroyed",
        make<Joints>());
    add("callback_liberties/rounding", "callbacks that compute contacts rounded to zero", make<Modes>(_MM_ROUND_TOWARD_ZERO));
    add("callback_liberties/queries", "callbacks query joints that earlier callbacks made",
        make<Queries>());
    add("callback_liberties/bodies", "bodies enabled, stopped, pushed, made kinematic, given other masses",
        make<Bodies>());
    add("callback_liberties/recursive_in_simple", "callbacks collide the pair and the locked space again",
        make<Recursive>(SpaceKind::Simple));
    add("callback_liberties/recursive_in_hash", "the same in a hash space", make<Recursive>(SpaceKind::Hash));
    add("callback_liberties/recursive_in_quad_tree", "the same in a quad-tree space",
        make<Recursive>(SpaceKind::QuadTree));
    add("callback_liberties/other_pairs", "dCollide swapped, twice, and for geoms of another pair",
        make<OtherPairs>());
    add("callback_liberties/nudges", "functions of joints move bodies and move them back, which rounds their positions",
        make<Nudges>());
    add("callback_liberties/touches", "callbacks ask whether geoms touch, and get unwritten contacts",
        make<Touches>());
}

}  // namespace exactness
