#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Pendulums and sliding boxes that report forces: joints of one island, of several islands that share one
// struct, contact joints, and joints that have no row in this step, whose struct stays as it was.
class Feedback : public ManyParts {
public:
    explicit Feedback(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i) addPendulum(part, origin + Vector3{dReal(0.9) * i, 0, 1.4});
            for (int i = 0; i < 3; ++i) {
                const dBodyID box = addBox(origin + Vector3{dReal(0.5) * i, 3, 0.24}, {0.5, 0.5, 0.5}, 1);
                dBodySetLinearVel(box, 2 - i, 0, 0);
            }
        });
    }

    void step() override {
        ManyParts::step();
        if (frameNumber() % 8 == 0) noteContactFeedback();
    }

protected:
    void onContact(dJointID joint) override { addContactFeedback(joint); }

private:
    void addPendulum(int part, Vector3 pivot) {
        const dBodyID upper = addCapsule(pivot + Vector3{0.3, 0, 0}, scenes::kAxisX, 0.05, 0.4, 1);
        const dBodyID lower = addCapsule(pivot + Vector3{0.8, 0, 0}, scenes::kAxisX, 0.05, 0.3, 1);
        const dJointID top = addHinge(upper, nullptr, pivot, scenes::kAxisY);
        const dJointID middle = addBall(upper, lower, pivot + Vector3{0.55, 0, 0});
        addFeedback(middle);
        if (part % 4 == 0) {
            shareFeedback(top);
        } else {
            addFeedback(top);
        }
        // An angular motor without force and stops has no rows.
        const dJointID idle = addEulerMotor(upper, lower, scenes::kAxisZ, scenes::kAxisX);
        addFeedback(idle)->f1[0] = 42;
    }

    void shareFeedback(dJointID joint) {
        if (m_shared == nullptr) m_shared = addFeedback(joint);
        dJointSetFeedback(joint, m_shared);
    }

    dJointFeedback *m_shared = nullptr;
};

// Pendulums in islands of their own. The structures of the first ones, whose islands come last, overlap: each begins one number
// behind the one before it.
class OverlappingFeedback : public ManyParts {
public:
    explicit OverlappingFeedback(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 6; ++i) addPendulum(origin + Vector3{0, dReal(0.5) * i, 1});
        });
    }

    void step() override {
        ManyParts::step();
        for (const dReal number : m_numbers) note("number", static_cast<double>(number));
    }

private:
    static constexpr std::size_t kOverlapping = 10;

    void addPendulum(Vector3 pivot) {
        const dBodyID upper = addCapsule(pivot + Vector3{0.3, 0, 0}, scenes::kAxisX, 0.05, 0.4, 1);
        const dBodyID lower = addCapsule(pivot + Vector3{0.8, 0, 0}, scenes::kAxisX, 0.05, 0.3, 1);
        const dJointID top = addHinge(upper, nullptr, pivot, scenes::kAxisY);
        addBall(upper, lower, pivot + Vector3{0.55, 0, 0});
        if (m_pendulums++ < kOverlapping)
            dJointSetFeedback(top, reinterpret_cast<dJointFeedback *>(&m_numbers[m_pendulums - 1]));
    }

    dReal m_numbers[kOverlapping + sizeof(dJointFeedback) / sizeof(dReal)] = {};
    std::size_t m_pendulums = 0;
};

}  // namespace

void addJointFeedback(Catalogue &catalogue) {
    catalogue.push_back({"joint_feedback", "feedback of joints and contacts, one struct for several islands",
                         80, make<Feedback>()});
    catalogue.push_back({"joint_feedback/overlapping", "feedback structs of several islands that overlap", 40,
                         make<OverlappingFeedback>()});
}

}  // namespace exactness
