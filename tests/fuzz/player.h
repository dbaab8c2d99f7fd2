// Plays a script: calls ODE's functions, is its callbacks and handlers, and tells a trace what it sees.
#pragma once

#include "call.h"
#include "draw.h"
#include "objects.h"

#include "call_trace.h"

#include <array>
#include <csetjmp>
#include <cstdint>
#include <string>

namespace fuzz {

// How contacts are made, until a script says otherwise.
struct Surface {
    dSurfaceParameters parameters{};
    int most = 4;  // contacts of a pair
    int flags = 0;  // of dCollide, above the number
};

class Player {
public:
    // Text is written as it comes, so that a crash leaves it: each call, and what was seen if `tells`.
    using Writer = std::function<void(const std::string &)>;
    struct Options {
        bool jumps = false;     // the debug and error handlers jump out of the call, and the script goes on
        bool messages = false;  // there is a message handler
        bool tells = false;
        int mostCalls = 2000;
    };

    Player(const Options &options, Writer writer);
    Player(const Player &) = delete;
    Player &operator=(const Player &) = delete;

    // Calls are drawn from bytes, or are those of a script. Each is written before it is made.
    void play(Draw &draw);
    void play(const Script &script);
    void finish();  // looks at everything once more

    std::uint64_t hash() const { return m_trace.hash(); }
    int calls() const { return m_calls; }

    // --- for the functions ---------------------------------------------------------------------------
    Objects objects;
    Surface surface;
    kept_state::CallTrace &trace() { return m_trace; }
    void *find(const Argument &argument) const { return objects.find(argument.reference); }
    // A new object; known to the trace.
    void adopt(ObjectKind kind, void *object, Reference &result);
    void tell(const char *what, const double *values, int count);
    void look(bool atBoxes);  // at the state of all objects; asking for boxes changes what upstream does later
    void collide(dSpaceID space);
    void collide2(dGeomID a, dGeomID b);
    void step(dWorldID world, dReal size, bool quick);
    void emptyContacts();
    dJointGroupID contactsOf(dWorldID world);
    dJointFeedback *feedbackOf(dJointID joint);

    static void moved(dBodyID body);

private:
    static void near(void *player, dGeomID a, dGeomID b);
    void meet(dGeomID a, dGeomID b);
    void makeContacts(dGeomID a, dGeomID b);
    void callBack(Where where);
    bool attempt(const Function &function, Call &call);
    void make(Call &call);
    void drawAndMake(Where where);
    void handle(const char *kind, int number, const char *text, va_list arguments, bool mayJump);
    static void onDebug(int number, const char *text, va_list arguments);
    static void onError(int number, const char *text, va_list arguments);
    static void onMessage(int number, const char *text, va_list arguments);
    void write(const std::string &text);

    const Options m_options;
    const Writer m_writer;
    kept_state::CallTrace m_trace;
    Draw *m_draw = nullptr;            // NULL: a script is played
    const Script *m_script = nullptr;
    std::size_t m_next = 0;            // of the script, behind the call in progress
    std::array<int, 4> m_turn{};       // callbacks of the call in progress, by place
    int m_depth = 0;                   // of callbacks
    int m_calls = 0;
    const Function *m_innermost = nullptr;  // that was called last
    bool m_isOver = false;
    std::jmp_buf *m_target = nullptr;  // of the call between frames
    std::map<dWorldID, dJointGroupID> m_contacts;
    std::map<dJointID, std::unique_ptr<dJointFeedback>> m_feedback;
    static Player *s_player;
};

}  // namespace fuzz
