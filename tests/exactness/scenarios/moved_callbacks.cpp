#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

constexpr int stackHeight = 5;

class Stacks : public ManyParts {
protected:
    explicit Stacks(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < stackHeight; ++i) {
                addBox(origin + Vector3{dReal(0.01) * part, 0, dReal(0.25) + dReal(0.5) * i}, {0.5, 0.5, 0.5},
                       1);
            }
        });
    }

    dBodyID stone(int stack, int level) const { return m_inventory.bodies[stack * stackHeight + level]; }
};

class EveryBody : public Stacks {
public:
    explicit EveryBody(Stepper stepper) : Stacks(stepper) {
        for (dBodyID body : m_inventory.bodies) watchMoved(body);
    }
};

// Only one island, half way, has a moved-callback: those before it may run in parallel.
class OneIsland : public Stacks {
public:
    explicit OneIsland(Stepper stepper) : Stacks(stepper) { watchMoved(stone(partCount / 2, 1)); }
};

// A callback adds forces to bodies of islands that were stepped before and that come later in this step,
// and reads what it can of them.
class Forces : public Stacks {
public:
    explicit Forces(Stepper stepper) : Stacks(stepper) { watchMoved(stone(partCount / 2, 2)); }

protected:
    void onMoved(dBodyID body) override {
        for (int stack : {1, partCount / 2, partCount - 2}) {
            dBodyAddForce(stone(stack, 4), 3, 1, 2);
            dBodyAddTorque(stone(stack, 3), 0, 0.2, 0.1);
            note("height in a moved-callback", dBodyGetPosition(stone(stack, 4))[2]);
            note("force in a moved-callback", dBodyGetForce(stone(stack, 4))[0]);
        }
        note("velocity of the moved body", dBodyGetLinearVel(body)[2]);
    }
};

// Callbacks switch callbacks of other bodies on and off.
class Switching : public Stacks {
public:
    explicit Switching(Stepper stepper) : Stacks(stepper) { watchMoved(stone(8, 0)); }

protected:
    void onMoved(dBodyID body) override {
        if (body != stone(8, 0)) return;
        const int other = frameNumber() % partCount;
        watchMoved(stone(other, 1));
        dBodySetMovedCallback(stone((other + 3) % partCount, 1), nullptr);
    }
};

// A callback joins stones of other stacks, or one to the world. Islands are stepped from the last stack to the first, so that
// some of the stacks have been stepped and the others come later in this step.
class Joining : public Stacks {
public:
    explicit Joining(Stepper stepper) : Stacks(stepper) {
        watchMoved(stone(partCount - 1, 2));
        watchMoved(stone(partCount / 2, 2));
    }

    void control() override {
        Stacks::control();
        while (m_inventory.joints.size() > 12) destroy(m_inventory.joints.front());
    }

protected:
    void onMoved(dBodyID) override {
        const int call = m_calls++;
        for (int i = 0; i < 3; ++i) {
            const int stack = (5 * call + 3 * i) % partCount;
            const dBodyID one = stone(stack, 1), other = stone((stack + 1 + call % 2) % partCount, 2);
            const dReal *place = dBodyGetPosition(one);
            addFeedback(addBall(one, i < 2 ? other : nullptr, {place[0], place[1], place[2]}));
        }
    }

private:
    int m_calls = 0;
};

// A callback in the first island attaches joints of other islands to stones of stacks that come later. When its island is
// stepped, such a joint finds bodies that are not numbered yet, which upstream takes for the second one of the island.
class Rejoining : public Stacks {
public:
    explicit Rejoining(Stepper stepper) : Stacks(stepper) {
        for (int stack = 0; stack < partCount; ++stack) {
            const dReal *place = dBodyGetPosition(stone(stack, 2));
            addHinge(stone(stack, 2), stone(stack, 3), {place[0], place[1], place[2]}, scenes::kAxisX);
            m_stackOf[stack] = stack;
        }
        watchMoved(stone(partCount - 1, 4));
        watchMoved(stone(partCount - 1, 0));
    }

protected:
    void onMoved(dBodyID) override {
        const int call = m_calls++, hinge = call % (partCount - 1);
        int &stack = m_stackOf[hinge];
        if (stack == 0) return;
        stack -= 1 + call % stack;
        dJointAttach(m_inventory.joints[hinge], stone(stack, 2), stone(stack, 3));
    }

private:
    int m_stackOf[partCount];
    int m_calls = 0;
};

// Geoms of other spaces are moved and resized, and collided with, in callbacks of step and collide.
class MovingGeoms : public Stacks {
public:
    explicit MovingGeoms(Stepper stepper) : Stacks(stepper) {
        m_other = addSpace(dHashSpaceCreate(nullptr));
        for (int i = 0; i < 6; ++i) {
            const dGeomID sensor = add(dCreateSphere(m_other, 1));
            dGeomSetPosition(sensor, 20 * i, 0, 1);
            m_sensors.push_back(sensor);
        }
        watchMoved(stone(3, 4));
        watchMoved(stone(12, 4));
    }

protected:
    // The other space is locked while it collides itself; nothing of it may move then.
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Stacks::onNearPair(o1, o2);
        const dGeomID stone = dGeomGetBody(o1) != nullptr ? o1 : o2;
        if (dGeomGetSpace(o1) == space()) moveSensor(dGeomGetPosition(stone));
    }

    void onMoved(dBodyID body) override {
        moveSensor(dBodyGetPosition(body));
        dGeomSphereSetRadius(m_sensors[1], 1 + 0.01 * frameNumber());
    }

private:
    void moveSensor(const dReal *place) {
        const dGeomID sensor = m_sensors[m_moves++ % m_sensors.size()];
        dGeomSetPosition(sensor, place[0], place[1], place[2] + 0.1);
    }

    dSpaceID m_other;
    std::vector<dGeomID> m_sensors;
    std::size_t m_moves = 0;
};

}  // namespace

void addMovedCallbacks(Catalogue &catalogue) {
    catalogue.push_back({"moved_callbacks/every_body", "every body reports that it moved", 60,
                         make<EveryBody>(), "the first island has a moved-callback"});
    catalogue.push_back(
        {"moved_callbacks/one_island", "one body half way reports that it moved", 60, make<OneIsland>()});
    catalogue.push_back({"moved_callbacks/forces", "a callback adds forces to earlier and later islands", 60,
                         make<Forces>()});
    catalogue.push_back({"moved_callbacks/switching", "callbacks switch other bodies' callbacks on and off",
                         60, make<Switching>()});
    catalogue.push_back({"moved_callbacks/joining", "a callback makes joints between stones of other islands", 60, make<Joining>(),
                         "the first island has a moved-callback"});
    catalogue.push_back({"moved_callbacks/rejoining", "a callback attaches joints of later islands to bodies of others", 60,
                         make<Rejoining>(), "the first island has a moved-callback"});
    catalogue.push_back({"moved_callbacks/moving_geoms", "callbacks move and resize geoms of another space",
                         60, make<MovingGeoms>()});
}

}  // namespace exactness
