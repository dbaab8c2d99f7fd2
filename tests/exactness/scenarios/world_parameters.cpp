#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Stacks under parameters of the world that change while it runs, and step sizes that do.
class WorldParameters : public ManyParts {
public:
    explicit WorldParameters(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                addBox(origin + Vector3{dReal(0.05) * (i % 2), 0, dReal(0.2) + dReal(0.45) * i},
                       {0.5, dReal(0.4) + dReal(0.02) * part, 0.5}, 1 + i);
            }
        });
    }

    void control() override {
        const int phase = frameNumber() / 10;
        dWorldSetQuickStepNumIterations(world(), phase % 2 == 0 ? 1 : 30);
        dWorldSetQuickStepW(world(), phase % 3 == 0 ? 1.0 : 1.5);
        dWorldSetContactMaxCorrectingVel(world(), phase % 4 == 1 ? 0.1 : dInfinity);
        dWorldSetContactSurfaceLayer(world(), phase % 4 == 2 ? 0.01 : 0);
        dWorldSetERP(world(), 0.1 + 0.1 * phase);
        dWorldSetCFM(world(), phase % 2 == 0 ? 1e-8 : 1e-3);
        dWorldSetGravity(world(), 0.3 * phase, 0, -9.81);
        m_stepSize = phase % 3 == 2 ? 0.02 : stepLength;
    }

protected:
    void setSurface(dContact &contact) override {
        contact.surface.mode = dContactApprox1;  // the world's own ERP and CFM
        contact.surface.mu = 0.5;
    }
};

}  // namespace

void addWorldParameters(Catalogue &catalogue) {
    catalogue.push_back({"world_parameters",
                         "iterations, over-relaxation, ERP, CFM, surface layer, step size", 80,
                         make<WorldParameters>()});
}

}  // namespace exactness
