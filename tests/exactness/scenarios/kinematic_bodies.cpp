#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

constexpr dReal beltSpeed = 1.2;  // m/s

void makeKinematic(dBodyID body) {
    dBodySetKinematic(body);
    dBodySetAutoDisableFlag(body, 0);
}

// Boxes on kinematic belts that move, and pendulums that hang from rotating kinematic bodies.
class Belts : public ManyParts {
public:
    explicit Belts(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int part, Vector3 origin) {
            const dBodyID belt = addBox(origin, {6, 2, 0.2}, 1);
            makeKinematic(belt);
            dBodySetLinearVel(belt, part % 2 == 0 ? beltSpeed : -beltSpeed, 0, 0);
            m_belts.push_back(belt);
            for (int i = 0; i < 5; ++i)
                addBox(origin + Vector3{dReal(0.6) * i - 1, 0, 0.3}, {0.4, 0.4, 0.4}, 1);
            addTurningPendulum(part, origin + Vector3{0, 5, 2});
        });
    }

    void control() override {
        for (dBodyID belt : m_belts) {
            if (frameNumber() % 30 == 0) dBodySetLinearVel(belt, -dBodyGetLinearVel(belt)[0], 0, 0);
        }
        if (frameNumber() == 40) dBodySetDynamic(m_belts[0]);
    }

private:
    void addTurningPendulum(int part, Vector3 place) {
        const dBodyID hub = addBox(place, {0.4, 0.4, 0.4}, 1),
                      arm = addBox(place + Vector3{0.7, 0, 0}, {0.6, 0.1, 0.1}, 1);
        makeKinematic(hub);
        dBodySetAngularVel(hub, 0, 2, 0.5 * part);
        addFeedback(addBall(hub, arm, place + Vector3{0.4, 0, 0}));
    }

    std::vector<dBodyID> m_belts;
};

// One kinematic body under many stacks, as the bed of a truck, driven over a bump.
class Hub : public ScenarioScene {
public:
    explicit Hub(Stepper stepper) : ScenarioScene(stepper) {
        m_bed = addBox({0, 0, 0}, {12, 6, 0.2}, 1);
        makeKinematic(m_bed);
        for (int x = 0; x < 6; ++x) {
            for (int y = 0; y < 3; ++y) {
                for (int z = 0; z < 2; ++z) {
                    addBox({dReal(1.5) * x - 4, dReal(1.5) * y - 2, dReal(0.35) + dReal(0.5) * z},
                           {0.5, 0.5, 0.5}, 1);
                }
            }
        }
    }

    void control() override {
        const bool bump = frameNumber() % 20 < 3;
        dBodySetLinearVel(m_bed, 0.5, 0, bump ? 0.8 : -0.14);
    }

private:
    dBodyID m_bed;
};

}  // namespace

void addKinematicBodies(Catalogue &catalogue) {
    catalogue.push_back({"kinematic_bodies/belts", "moving belts and turning hubs", 80, make<Belts>()});
    catalogue.push_back({"kinematic_bodies/hub", "one kinematic body under many stacks", 40, make<Hub>(),
                         "a kinematic body that touches all others joins them in one island"});
}

}  // namespace exactness
