// Plays a script: calls ODE's functions, implements its callbacks and handlers, and records a trace.
#pragma once

#include "call.h"
#include "draw.h"
#include "objects.h"
#include "shapes.h"

#include "call_trace.h"

#include <array>
#include <csetjmp>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace fuzz {

// How contacts are made, until a script says otherwise.
struct Surface {
    dSurfaceParameters parameters{};
    int most = 4;  // contacts of a pair
    int flags = 0;  // of dCollide, above the number
};

class Player {
public:
    // Text is written as it comes, so that a crash leaves it: each call, and the results if `tells`.
    using Writer = std::function<void(const std::string &)>;
    struct Options {
        bool jumps = false;     // the debug and error handlers jump out of the call, and the script continues
        bool messages = false;  // there is a message handler
        bool tells = false;
        std::uint8_t fillsStack = 0;  // with this byte, before each call (stack_pattern.h); 0: not
        int maxCalls = 2000;
    };

    Player(const Options &options, Writer writer);
    Player(const Player &) = delete;
    Player &operator=(const Player &) = delete;

    // Calls are drawn from bytes, or are those of a script. Each is written before it is made.
    void play(Draw &draw);
    void play(const Script &script);
    void finish();  // records the state of all objects once more

    std::uint64_t hash() const { return m_trace.hash(); }
    int calls() const { return m_calls; }
    bool jumps() const { return m_options.jumps; }  // out of assertions

    // --- for the functions ---------------------------------------------------------------------------
    Objects objects;
    Surface surface;
    Shapes shapes;
    kept_state::CallTrace &trace() { return m_trace; }
    void *find(const Argument &argument) const { return objects.find(argument.reference); }
    // A new object; known to the trace.
    void adopt(ObjectKind kind, void *object, Reference &result);
    void tell(const char *what, const double *values, int count);
    void look(bool atBoxes);  // at the state of all objects; asking for boxes changes what upstream does later
    void collide(dSpaceID space);
    void collide2(dGeomID a, dGeomID b);
    void step(dWorldID world, dReal size, bool quick);
    // A call of ODE_MT's for both.
    void stepTogether(dWorldID first, dWorldID second, dReal size, bool quick);
    void playFrame(dSpaceID space, dWorldID world, dReal size, bool quick, bool stepsFirst);
    void emptyContacts();
    void tellContacts(dGeomID a, dGeomID b, int most, bool unimportant);
    bool makeContact(dWorldID world, dGeomID a, dGeomID b, dReal depth);  // as the program pleases
    dJointGroupID contactsOf(dWorldID world);
    // "serial", "concurrent" or "independent": what near-callbacks do from now on.
    void setCallbackPolicy(const std::string &policy);
    void changeSolver(dWorldID world);  // to the other one of ODE_MT's
    bool isInCallback() const { return m_depth > 0 || m_innermostPlace != Where::between; }  // and so perhaps in a step
    void setMessages(bool on);  // whether there is a message handler
    dJointFeedback *feedbackOf(dJointID joint);

    static void moved(dBodyID body);

private:
    static void near(void *player, dGeomID a, dGeomID b);
    void meet(dGeomID a, dGeomID b);
    using TellContact = std::function<void(const double *values, int count)>;
    void makeContacts(dGeomID a, dGeomID b, const TellContact &tellContact);
    std::string nameOf(dGeomID geom) const;

    // Near-callbacks of which several may run at once: they draw no calls, and their order is not compared.
    static void nearAtOnce(void *player, dGeomID a, dGeomID b);
    void meetAtOnce(dGeomID a, dGeomID b);
    void collideAtOnce(const std::function<void()> &collide);
    void note(std::string what);

    bool hasSweepSpace() const;
    bool sortsNaNs() const;

    void makeScene(Draw &draw);
    void makeBodies(Draw &draw, const Reference &world, const Reference &space);
    void makeHeap(Draw &draw, const Reference &world, const Reference &space);
    void makeTerrain(Draw &draw, const Reference &space);
    void setFilters(Draw &draw);
    void makeJoints(Draw &draw, const Reference &world);
    void playFrames(unsigned count, bool quick);
    Reference makeNow(const char *function, Arguments arguments);
    void callBack(Where where);
    void make(Call &call);
    void drawAndMake(Where where);
    static void onShape(ShapeCallback which);
    void handle(const char *kind, int number, const char *text, va_list arguments, bool mayJump);
    static void onDebug(int number, const char *text, va_list arguments);
    static void onError(int number, const char *text, va_list arguments);
    static void onMessage(int number, const char *text, va_list arguments);
    void write(const std::string &text);
    void fillStack() const;

    const Options m_options;
    const Writer m_writer;
    kept_state::CallTrace m_trace;
    Draw *m_draw = nullptr;            // NULL: a script is played
    const Script *m_script = nullptr;
    std::size_t m_next = 0;            // of the script, behind the call in progress
    std::array<int, places> m_turn{};  // callbacks of the call in progress, by place
    int m_depth = 0;                   // of callbacks
    int m_calls = 0;
    const Function *m_innermost = nullptr;  // that was called last
    Where m_innermostPlace = Where::between;
    bool m_isOver = false;
    enum class Policy { serial, concurrent, independent } m_policy = Policy::serial;
    bool m_isAtOnce = false;           // such callbacks are running
    std::mutex m_atOnce;
    std::vector<std::string> m_met;    // by them
    std::jmp_buf *m_target = nullptr;  // of the call between frames
    std::map<dWorldID, dJointGroupID> m_contacts;
    std::map<dJointID, std::unique_ptr<dJointFeedback>> m_feedback;
    static Player *s_player;
};

}  // namespace fuzz
