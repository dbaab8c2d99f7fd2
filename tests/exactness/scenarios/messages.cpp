#include "additions.h"
#include "scenario_scene.h"

#include <csetjmp>
#include <cstdarg>
#include <cstdio>

namespace exactness {

namespace {

struct LeftTheStep {};  // thrown by a handler

enum class Handler { None, Notes, Looks, JumpsOut, Throws };

std::jmp_buf beforeTheStep;

// Walls in which upstream's LCP solver gives up now and then and says so, among chains in which it does not.
class Messages : public ManyParts {
public:
    Messages(Stepper stepper, Handler handler) : ManyParts(stepper), m_handler(handler) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            if (part % 4 == 2) {
                addWall(origin);
            } else {
                addChain(origin);
            }
        });
        if (handler != Handler::None) dSetMessageHandler(&handle);
    }

    ~Messages() override { dSetMessageHandler(nullptr); }

    void step() override {
        if (m_left) return;
        // Upstream's step is C++ that the jump leaves without destructors; nothing here has one.
        if (setjmp(beforeTheStep) != 0) {
            leave("a handler jumped out of the step");
            return;
        }
        try {
            ManyParts::step();
        } catch (const LeftTheStep &) {
            leave("a handler threw out of the step");
        }
    }

private:
    void addWall(Vector3 origin) {
        for (int x = 0; x < 3; ++x) {
            for (int z = 0; z < 4; ++z) {
                const Vector3 place{dReal(0.5) * x + dReal(0.25) * (z % 2), 0, dReal(0.25) + dReal(0.5) * z};
                addBox(origin + place, {0.5, 0.5, 0.5}, 1);
            }
        }
    }

    void addChain(Vector3 origin) {
        dBodyID before = nullptr;
        for (int link = 0; link < 10; ++link) {
            const Vector3 place = origin + Vector3{dReal(0.5) * link, 0, 8};
            const dBodyID body = addSphere(place, 0.2, 1);
            addBall(body, before, place + Vector3{-0.25, 0, 0});
            before = body;
        }
    }

    // After that upstream's world cannot step again: its working memory is still lent out.
    void leave(const char *how) {
        m_left = true;
        note(how);
    }

    static void handle(int number, const char *format, va_list arguments) {
        char text[200];
        std::vsnprintf(text, sizeof(text), format, arguments);
        static_cast<Messages &>(living()).onMessage(number, text);
    }

    void onMessage(int number, const char *text) {
        note(text, number);
        if (m_handler == Handler::Looks) look();
        if (frameNumber() < framesBeforeLeaving) return;
        if (m_handler == Handler::JumpsOut) std::longjmp(beforeTheStep, 1);
        if (m_handler == Handler::Throws) throw LeftTheStep();
    }

    // A handler sees the world as far as upstream has stepped it: islands that come later have not moved.
    void look() {
        for (dBodyID body : m_inventory.bodies) {
            note("height in a handler", dBodyGetPosition(body)[2]);
            note("speed in a handler", dBodyGetLinearVel(body)[2]);
        }
        note("random seed in a handler", static_cast<double>(dRandGetSeed()));
    }

    static constexpr int framesBeforeLeaving = 12;

    Handler m_handler;
    bool m_left = false;
};

}  // namespace

void addMessages(Catalogue &catalogue) {
    const std::vector<Stepper> worldOnly{Stepper::World};  // QuickStep has no such message
    const auto add = [&](const char *name, const char *meaning, Handler handler) {
        const bool leavesStep = handler == Handler::JumpsOut || handler == Handler::Throws;
        catalogue.push_back({name, meaning, 30, make<Messages>(handler), "", worldOnly, leavesStep});
    };
    add("messages/printed", "messages of the LCP solver on standard error", Handler::None);
    add("messages/handled", "messages to a handler of the user", Handler::Notes);
    add("messages/looked_at", "a handler that reads all bodies", Handler::Looks);
    add("messages/jumped_out", "a handler that leaves the step with longjmp", Handler::JumpsOut);
    add("messages/thrown_out", "a handler that leaves the step with an exception", Handler::Throws);
}

}  // namespace exactness
