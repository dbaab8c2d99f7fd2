#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// A world without bodies, in which bodies are created and destroyed.
class EmptyWorld : public ScenarioScene {
public:
    explicit EmptyWorld(Stepper stepper) : ScenarioScene(stepper) { addGround(); }

    void control() override {
        if (frameNumber() == 10) addSphere({0, 0, 0.3}, 0.3, 1);
        if (frameNumber() == 30) destroy(m_inventory.bodies.front());
        if (frameNumber() == 35) add(dJointCreateBall(world(), nullptr));  // attached to nothing
    }
};

// Everything asleep, until one body wakes.
class AllDisabled : public ManyParts {
public:
    explicit AllDisabled(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                dBodyDisable(addBox(origin + Vector3{0, 0, dReal(0.3) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1));
        });
    }

    void control() override {
        if (frameNumber() == 20) dBodyEnable(m_inventory.bodies[5]);
        if (frameNumber() == 40) {
            for (dBodyID body : m_inventory.bodies) dBodyEnable(body);
        }
    }
};

// One island and nothing else.
class SingleIsland : public ScenarioScene {
public:
    explicit SingleIsland(Stepper stepper) : ScenarioScene(stepper) {
        addGround();
        for (int x = 0; x < 4; ++x) {
            for (int z = 0; z < 6; ++z)
                addBox({dReal(0.5) * x + dReal(0.2) * (z % 2), 0, dReal(0.25) + dReal(0.49) * z},
                       {0.48, 0.5, 0.5}, 1);
        }
        for (std::size_t i = 1; i < m_inventory.bodies.size(); i += 6) {
            const dReal *place = dBodyGetPosition(m_inventory.bodies[i]);
            addBall(m_inventory.bodies[i - 1], m_inventory.bodies[i], {place[0], place[1], place[2]});
        }
    }
};

// Joints to the world alone, joints that are switched off and on, joints without a row, joints without a
// body, and a null joint.
class OddJoints : public ManyParts {
public:
    explicit OddJoints(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int part, Vector3 origin) {
            const dBodyID first = addSphere(origin, 0.2, 1),
                          second = addSphere(origin + Vector3{1, 0, 0}, 0.2, 1);
            addFeedback(addBall(first, nullptr, origin + Vector3{0, 0, 1}));
            addFeedback(addHinge(nullptr, second, origin + Vector3{1, 0, 1}, scenes::kAxisX));
            const dJointID between =
                addUniversal(first, second, origin + Vector3{0.5, 0, 0}, scenes::kAxisX, scenes::kAxisY);
            if (part % 2 == 0) dJointDisable(between);
            addEulerMotor(first, second, scenes::kAxisX, scenes::kAxisZ);  // no row
            const dJointID nothing = add(dJointCreateNull(world(), nullptr));
            dJointAttach(nothing, first, second);
            add(dJointCreateSlider(world(), nullptr));  // attached to nothing
            m_between.push_back(between);
        });
    }

    void control() override {
        const dJointID joint = m_between[frameNumber() % m_between.size()];
        if (dJointIsEnabled(joint)) {
            dJointDisable(joint);
        } else {
            dJointEnable(joint);
        }
        if (frameNumber() == 30) dJointAttach(m_between[3], nullptr, nullptr);
        if (frameNumber() == 40) dJointAttach(m_between[3], m_inventory.bodies[6], m_inventory.bodies[9]);
    }

private:
    std::vector<dJointID> m_between;
};

}  // namespace

void addDegenerateWorlds(Catalogue &catalogue) {
    catalogue.push_back({"degenerate_worlds/empty", "no body at all, then one, then none", 50,
                         make<EmptyWorld>(), "there is never more than one island"});
    catalogue.push_back(
        {"degenerate_worlds/all_disabled", "all asleep, then one awake, then all", 60, make<AllDisabled>()});
    catalogue.push_back({"degenerate_worlds/single_island", "one island of 24 bodies", 60,
                         make<SingleIsland>(), "there is one island"});
    catalogue.push_back({"degenerate_worlds/odd_joints",
                         "joints to the world, disabled, without rows, without bodies", 60,
                         make<OddJoints>()});
}

}  // namespace exactness
