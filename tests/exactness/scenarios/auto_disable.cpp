#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Stacks that come to rest and fall asleep, each by another rule, and are woken by balls thrown at some,
// by the user and by a joint.
class AutoDisable : public ManyParts {
public:
    explicit AutoDisable(Stepper stepper) : ManyParts(stepper) {
        dWorldSetAutoDisableFlag(world(), 1);
        dWorldSetAutoDisableLinearThreshold(world(), 0.08);
        dWorldSetAutoDisableAngularThreshold(world(), 0.08);
        dWorldSetAutoDisableSteps(world(), 6);
        dWorldSetAutoDisableTime(world(), 0);
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 6; ++i) {
                const dBodyID body =
                    addBox(origin + Vector3{0, 0, dReal(0.25) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
                setRule(body, part);
                m_stacks.push_back(body);
            }
        });
    }

    void control() override {
        if (frameNumber() == 50) throwBalls();
        if (frameNumber() == 70) dBodyEnable(m_stacks[6]);
        if (frameNumber() == 80) dBodyDisable(m_stacks[13]);
        if (frameNumber() == 90) joinStacks();
    }

private:
    static void setRule(dBodyID body, int part) {
        switch (part % 6) {
            case 0:
                break;
            case 1:
                dBodySetAutoDisableAverageSamplesCount(body, 5);
                break;
            case 2:
                dBodySetAutoDisableAverageSamplesCount(body, 1);
                break;
            case 3:
                dBodySetAutoDisableSteps(body, 0);
                dBodySetAutoDisableTime(body, 0.11);
                break;
            case 4:
                dBodySetAutoDisableFlag(body, 0);
                break;
            case 5:
                dBodySetAutoDisableAverageSamplesCount(body, 12);
                dBodySetAutoDisableLinearThreshold(body, 0.3);
                dBodySetAutoDisableAngularThreshold(body, 0.3);
                break;
        }
    }

    void throwBalls() {
        for (std::size_t i = 0; i < m_stacks.size(); i += 18) {
            const dReal *top = dBodyGetPosition(m_stacks[i + 5]);
            const dBodyID ball = addSphere({top[0] - 1, top[1], top[2] + 0.1}, 0.2, 0.5);
            dBodySetLinearVel(ball, 6, 0.4, 0);
        }
    }

    void joinStacks() { addBall(m_stacks[11], m_stacks[17], {10, 0, 2}); }

    std::vector<dBodyID> m_stacks;
};

}  // namespace

void addAutoDisable(Catalogue &catalogue) {
    catalogue.push_back({"auto_disable", "stacks fall asleep by steps, time and averages, and are woken", 120,
                         make<AutoDisable>()});
}

}  // namespace exactness
