#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

constexpr int stackHeight = 5;

class Stacks : public ManyParts {
protected:
    explicit Stacks(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < stackHeight; ++i)
                addStone(origin + Vector3{dReal(0.02) * i, 0, dReal(0.25) + dReal(0.5) * i});
        });
    }

    dBodyID addStone(Vector3 place) { return addBox(place, {0.5, 0.5, 0.5}, 1); }
};

// Bodies, geoms, joints and spaces are created and destroyed between frames.
class BetweenFrames : public Stacks {
public:
    explicit BetweenFrames(Stepper stepper) : Stacks(stepper) {}

    void control() override {
        const int frame = frameNumber();
        const std::size_t which = (7u * frame) % m_inventory.bodies.size();
        if (frame % 3 == 0) destroy(m_inventory.bodies[which]);
        if (frame % 2 == 0) addStone({dReal(20) * (frame % 4), dReal(20) * (frame / 4 % 4), dReal(3.2)});
        if (frame % 5 == 0) joinSome(which);
        if (frame % 10 == 9) destroy(m_inventory.joints.front());
        if (frame % 6 == 1) growGeom(which);
    }

private:
    void joinSome(std::size_t which) {
        const dBodyID first = m_inventory.bodies[which / 2], second = m_inventory.bodies[which / 2 + 1];
        const dReal *place = dBodyGetPosition(first);
        addFeedback(addBall(first, second, {place[0], place[1], place[2]}));
    }

    void growGeom(std::size_t which) {
        const dGeomID geom = dBodyGetFirstGeom(m_inventory.bodies[which % m_inventory.bodies.size()]);
        dVector3 sides;
        dGeomBoxGetLengths(geom, sides);
        dGeomBoxSetLengths(geom, sides[0] * 1.05, sides[1], sides[2] * 0.97);
    }
};

// Near callbacks make bodies without geoms, joints to the world and user forces, and break joints.
class InNearCallbacks : public Stacks {
public:
    explicit InNearCallbacks(Stepper stepper) : Stacks(stepper) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Stacks::onNearPair(o1, o2);
        const dBodyID body = dGeomGetBody(o1) != nullptr ? dGeomGetBody(o1) : dGeomGetBody(o2);
        const int pair = m_pairs++;
        if (pair % 40 == 3) weigh(body);
        if (pair % 60 == 5 && !m_inventory.joints.empty()) destroy(m_inventory.joints.front());
        if (pair % 17 == 0) dBodyAddForce(body, 4, 0, 2);
        if (pair % 90 == 11) dBodyDisable(body);
        if (pair % 25 == 0) note("joints of a body in a near callback", dBodyGetNumJoints(body));
    }

private:
    // Hangs a body without a geom on the stone.
    void weigh(dBodyID stone) {
        const dReal *place = dBodyGetPosition(stone);
        const Vector3 anchor{place[0], place[1], place[2]};
        addFeedback(addBall(stone, addBody(anchor + Vector3{0.3, 0, 0}, world()), anchor));
    }

    int m_pairs = 0;
};

// Moved-callbacks change what comes later: forces, velocities, new bodies, joints switched off.
class InMovedCallbacks : public Stacks {
public:
    explicit InMovedCallbacks(Stepper stepper) : Stacks(stepper) {
        for (std::size_t i = 0; i < m_inventory.bodies.size(); i += 3) watchMoved(m_inventory.bodies[i]);
        for (std::size_t i = 0; i + 1 < m_inventory.bodies.size(); i += stackHeight) {
            const dReal *place = dBodyGetPosition(m_inventory.bodies[i]);
            addHinge(m_inventory.bodies[i], m_inventory.bodies[i + 1], {place[0], place[1], place[2]},
                     scenes::kAxisX);
        }
    }

protected:
    void onMoved(dBodyID body) override {
        const int call = m_calls++;
        if (call % 50 == 7) addBody({5, 5, 5}, world());
        if (call % 31 == 3) dJointDisable(m_inventory.joints[call % m_inventory.joints.size()]);
        if (call % 31 == 20) dJointEnable(m_inventory.joints[call % m_inventory.joints.size()]);
        if (call % 11 == 0) dBodySetAngularVel(body, 0, 0, 1);
        if (call % 13 == 0)
            dBodySetPosition(body, dBodyGetPosition(body)[0] + 0.01, dBodyGetPosition(body)[1], 2);
    }

private:
    int m_calls = 0;
};

}  // namespace

void addCreation(Catalogue &catalogue) {
    catalogue.push_back({"creation/between_frames", "bodies, geoms and joints are created and destroyed between frames", 80,
                         make<BetweenFrames>()});
    catalogue.push_back({"creation/in_near_callbacks", "near callbacks make and destroy bodies and joints",
                         60, make<InNearCallbacks>()});
    catalogue.push_back({"creation/in_moved_callbacks", "moved-callbacks make bodies and switch joints", 60,
                         make<InMovedCallbacks>(), "the first island has a moved-callback"});
}

}  // namespace exactness
