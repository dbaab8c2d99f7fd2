#include "additions.h"
#include "scenario_scene.h"

#include <cfenv>

#include <xmmintrin.h>

namespace exactness {

namespace {

// The caller rounds in another direction, or flushes denormals: the threads that step must do so too.
// Rounding upwards and downwards is excluded: there -(a - b) is not b - a, which compilers take for the same, so that two
// builds of the same source differ.
class FloatEnvironment : public ManyParts {
public:
    FloatEnvironment(Stepper stepper, bool flushes) : ManyParts(stepper), m_flushes(flushes) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                const dBodyID body =
                    addBox(origin + Vector3{0, dReal(0.01) * part, dReal(0.25) + dReal(0.5) * i},
                           {0.5, 0.5, 0.5}, 1);
                dBodySetAngularVel(body, 1e-310, 0.1, 4e-309);  // denormal
            }
        });
    }

    void step() override {
        std::fenv_t before;
        std::fegetenv(&before);
        if (m_flushes) {
            _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
            for (dBodyID body : m_inventory.bodies) dBodyAddForce(body, 1e-308, 0, 0);
        } else {
            std::fesetround(frameNumber() % 2 == 0 ? FE_TONEAREST : FE_TOWARDZERO);
        }
        ManyParts::step();
        note("direction of rounding after the step", std::fegetround());
        std::fesetenv(&before);
    }

private:
    bool m_flushes;
};

}  // namespace

void addFloatEnvironment(Catalogue &catalogue) {
    catalogue.push_back({"float_environment/rounding",
                         "the caller's direction of rounding changes from step to step", 60,
                         make<FloatEnvironment>(false)});
    catalogue.push_back({"float_environment/flush_to_zero", "the caller flushes denormals to zero", 60,
                         make<FloatEnvironment>(true)});
}

}  // namespace exactness
