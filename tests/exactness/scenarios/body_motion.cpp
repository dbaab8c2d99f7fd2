#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Chains of spinning bodies, each chain integrated in another way.
class BodyMotion : public ManyParts {
public:
    explicit BodyMotion(Stepper stepper) : ManyParts(stepper) {
        dWorldSetLinearDampingThreshold(world(), 0.5);
        dWorldSetAngularDampingThreshold(world(), 0.5);
        addGround();
        addParts([this](int part, Vector3 origin) {
            dBodyID before = nullptr;
            for (int i = 0; i < 6; ++i) {
                const Vector3 place = origin + Vector3{dReal(0.5) * i, 0, 1.5};
                const dBodyID body = addBox(place, {0.4, 0.2, 0.1}, 1);
                dBodySetAngularVel(body, 3.0 * i, 10 - 2 * i, 5);
                setMotion(body, part, i);
                if (i % 2 == 1) addBall(before, body, place + Vector3{-0.25, 0, 0});
                before = body;
            }
        });
    }

    void control() override {
        for (std::size_t i = 0; i < m_inventory.bodies.size(); i += 7) {
            const dBodyID body = m_inventory.bodies[i];
            dBodyAddForceAtRelPos(body, 0, 0, 3, 0.1, 0, 0);
            dBodyAddRelTorque(body, 0.05, 0, 0.02);
        }
        if (frameNumber() == 30) dBodySetFiniteRotationMode(m_inventory.bodies[0], 1);
    }

private:
    static void setMotion(dBodyID body, int part, int i) {
        switch (part % 8) {
            case 0:
                dBodySetFiniteRotationMode(body, 1);
                break;
            case 1:
                dBodySetFiniteRotationMode(body, 1);
                dBodySetFiniteRotationAxis(body, 0, 1, 0.1 * i);
                break;
            case 2:
                dBodySetGyroscopicMode(body, 0);
                break;
            case 3:
                dBodySetDamping(body, 0.02, 0.05);
                break;
            case 4:
                dBodySetMaxAngularSpeed(body, 4);
                break;
            case 5:
                dBodySetGravityMode(body, i % 2);
                break;
            case 6:
                dBodySetLinearDamping(body, 0.1);
                dBodySetLinearDampingThreshold(body, 0.01);
                dBodySetAngularDampingThreshold(body, 100);
                break;
            case 7:
                dBodySetFiniteRotationMode(body, 1);
                dBodySetDamping(body, 0, 0.1);
                dBodySetMaxAngularSpeed(body, 6);
                break;
        }
    }
};

}  // namespace

void addBodyMotion(Catalogue &catalogue) {
    catalogue.push_back({"body_motion",
                         "finite rotation, gyroscopic force, damping, speed limits, user forces", 80,
                         make<BodyMotion>()});
}

}  // namespace exactness
