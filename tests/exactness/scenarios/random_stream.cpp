#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// The numbers of iterations of QuickStep around which an island's random draws change: one set of draws
// for every eighth iteration after the first.
constexpr int iterationCounts[] = {1, 8, 9, 16, 17, 20, 50};

// Islands of many sizes, without a row, with one and with many, and a user who draws between frames.
class RandomStream : public ManyParts {
public:
    explicit RandomStream(Stepper stepper) : ManyParts(stepper) {
        dRandSetSeed(12345);
        addGround();
        addParts([this](int part, Vector3 origin) {
            addSphere(origin + Vector3{0, 3, 30}, 0.2, 1);  // falls freely: no row
            for (int i = 0; i < part % 7; ++i)
                addBox(origin + Vector3{0, 0, dReal(0.24) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
            const dBodyID pendulum = addSphere(origin + Vector3{3, 0, 2}, 0.2, 1);
            addBall(pendulum, nullptr, origin + Vector3{3, 0, 2.5});
            const dBodyID slide = addBox(origin + Vector3{6, 0, 1}, {0.3, 0.3, 0.3}, 1);
            addLinearMotor(slide);  // one row
        });
    }

    void control() override {
        constexpr int count = sizeof(iterationCounts) / sizeof(iterationCounts[0]);
        dWorldSetQuickStepNumIterations(world(), iterationCounts[frameNumber() % count]);
        if (frameNumber() % 3 == 0) note("drawn by the user", dRandInt(1000));
        if (frameNumber() % 5 == 0) note("real drawn by the user", dRandReal());
        if (frameNumber() == 41) dRandSetSeed(0xfedcba98);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        ManyParts::onNearPair(o1, o2);
        note("drawn in a near callback", dRandInt(7));
    }

private:
    void addLinearMotor(dBodyID body) {
        const dJointID motor = add(dJointCreateLMotor(world(), nullptr));
        dJointAttach(motor, body, nullptr);
        dJointSetLMotorNumAxes(motor, 1);
        dJointSetLMotorAxis(motor, 0, 0, 0, 0, 1);
        dJointSetLMotorParam(motor, dParamFMax, 20);
    }
};

// The user draws in moved-callbacks, so every island's numbers depend on what the user drew before.
class DrawsInMovedCallbacks : public RandomStream {
public:
    explicit DrawsInMovedCallbacks(Stepper stepper) : RandomStream(stepper) {
        const std::vector<dBodyID> &bodies = m_inventory.bodies;
        for (std::size_t i = bodies.size() / 2; i < bodies.size(); i += 5) watchMoved(bodies[i]);
    }

protected:
    void onMoved(dBodyID) override {
        if (frameNumber() % 2 == 0) note("drawn in a moved-callback", dRandInt(100));
        if (frameNumber() == 30) dRandSetSeed(777);
    }
};

}  // namespace

void addRandomStream(Catalogue &catalogue) {
    catalogue.push_back({"random_stream",
                         "1 to 50 iterations of QuickStep, islands of 0 to many rows, user draws", 84,
                         make<RandomStream>()});
    catalogue.push_back({"random_stream/moved_callbacks", "user draws in moved-callbacks of some bodies", 60,
                         make<DrawsInMovedCallbacks>(), "an island near the front has a moved-callback"});
}

}  // namespace exactness
