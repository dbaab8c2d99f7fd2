#include "additions.h"
#include "scenario_scene.h"

#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <limits>

namespace exactness {

namespace {

std::jmp_buf beforeTheFault;

// A scene whose debug handler jumps out of whatever ODE was doing. Nothing is done after that.
class Fault : public ManyParts {
public:
    ~Fault() override {
        dSetDebugHandler(nullptr);
        dSetErrorHandler(nullptr);
    }

    void collide() override {
        if (!m_faulted) guarded([this] { ManyParts::collide(); });
    }

    void step() override {
        if (!m_faulted) guarded([this] { ManyParts::step(); });
    }

protected:
    explicit Fault(Stepper stepper) : ManyParts(stepper) {
        dSetDebugHandler(&handle);
        dSetErrorHandler(&handle);
        addGround();
    }

private:
    template <class Stage>
    void guarded(const Stage &stage) {
        if (setjmp(beforeTheFault) == 0) {
            stage();
        } else {
            m_faulted = true;
        }
    }

    static void handle(int number, const char *format, va_list arguments) {
        char text[300];
        std::vsnprintf(text, sizeof(text), format, arguments);
        static_cast<Fault &>(living()).note(text, number);
        std::longjmp(beforeTheFault, 1);
    }

    bool m_faulted = false;
};

class FaultOfStacks : public Fault {
protected:
    explicit FaultOfStacks(Stepper stepper) : Fault(stepper) {
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                addBox(origin + Vector3{0, dReal(0.01) * part, dReal(0.25) + dReal(0.5) * i}, {0.5, 0.5, 0.5},
                       1);
            }
        });
    }
};

// A body half way in the order of islands gets a force that is not a number.
class NotANumber : public FaultOfStacks {
public:
    explicit NotANumber(Stepper stepper) : FaultOfStacks(stepper) {}

    void control() override {
        if (frameNumber() != 20) return;
        const dReal nan = std::numeric_limits<dReal>::quiet_NaN();
        dBodyAddTorque(m_inventory.bodies[m_inventory.bodies.size() / 2], nan, 0, 0);
    }
};

// A near callback steps the world, whose geoms may not move while the space is locked.
class StepInNearCallback : public FaultOfStacks {
public:
    explicit StepInNearCallback(Stepper stepper) : FaultOfStacks(stepper) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Fault::onNearPair(o1, o2);
        if (frameNumber() == 20) ManyParts::step();
    }
};

// A near callback destroys a geom of the space that is locked.
class DestroyInNearCallback : public FaultOfStacks {
public:
    explicit DestroyInNearCallback(Stepper stepper) : FaultOfStacks(stepper) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Fault::onNearPair(o1, o2);
        if (frameNumber() == 20) dGeomDestroy(dGeomGetBody(o1) != nullptr ? o1 : o2);
    }
};

// A near callback throws and leaves the space locked; from then on the space cannot be changed.
class ThrowInNearCallback : public FaultOfStacks {
public:
    explicit ThrowInNearCallback(Stepper stepper) : FaultOfStacks(stepper) {}

    void collide() override {
        try {
            Fault::collide();
        } catch (int pair) {
            note("thrown out of a near callback", pair);
        }
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Fault::onNearPair(o1, o2);
        if (frameNumber() == 20 && ++m_pairs == 7) throw m_pairs;
    }

private:
    int m_pairs = 0;
};

// Chains swing, until two bodies half way in the order of islands are joined twice more: without softness the
// matrix is singular, and forces are no numbers.
class Singular : public Fault {
public:
    explicit Singular(Stepper stepper) : Fault(stepper) {
        dWorldSetCFM(world(), 0);
        addParts([this](int, Vector3 origin) {
            dBodyID before = nullptr;
            for (int link = 0; link < 6; ++link) {
                const Vector3 place = origin + Vector3{dReal(0.4) * link, 0, 5};
                const dBodyID body = addSphere(place, 0.1, 1);
                addBall(body, before, place + Vector3{-0.2, 0, 0});
                before = body;
            }
        });
    }

    void control() override {
        if (frameNumber() != 12) return;
        const std::size_t half = m_inventory.bodies.size() / 2;
        for (int i = 0; i < 2; ++i) addFixed(m_inventory.bodies[half], m_inventory.bodies[half + 1]);
    }
};

}  // namespace

void addFaults(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        Scenario scenario{name, meaning, 24, std::move(make)};
        scenario.leavesRuins = true;
        catalogue.push_back(scenario);
    };
    add("faults/not_a_number", "a torque of NaN; the debug handler jumps out of the step",
        make<NotANumber>());
    add("faults/step_in_near_callback", "a step in a near callback, with the space locked",
        make<StepInNearCallback>());
    add("faults/destroy_in_near_callback", "a geom of the locked space destroyed",
        make<DestroyInNearCallback>());
    add("faults/singular", "a singular matrix without softness; the debug handler jumps out of the step",
        make<Singular>());
    catalogue.back().steppers = {Stepper::World};  // QuickStep has no matrix
    add("faults/throw_in_near_callback", "an exception leaves the space locked", make<ThrowInNearCallback>());
}

}  // namespace exactness
