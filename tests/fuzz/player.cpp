#include "player.h"

#include "fields.h"
#include "function.h"
#include "only_ours.h"
#include "protocol.h"
#include "stack_pattern.h"

#include <dlfcn.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace fuzz {

namespace {

// Calls that are drawn in all callbacks of one call, at most, and callbacks within callbacks.
constexpr int kMaxContacts = 32;

std::string hexOf(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return std::isnan(value) ? "nan" : text;
}

Call callOfNothing(const char *function, Arguments arguments = {}) {
    Call call;
    call.function = function;
    call.arguments = std::move(arguments);
    return call;
}

}  // namespace

Player *Player::s_player = nullptr;

Player::Player(const Options &options, Writer writer) : m_options(options), m_writer(std::move(writer)), m_trace(false) {
    s_player = this;
    shapeCallback = onShape;
    surface.parameters.mu = 1;
    if (options.jumps) {
        dSetDebugHandler(onDebug);
        dSetErrorHandler(onError);
    }
    if (options.messages) dSetMessageHandler(onMessage);
}

void Player::write(const std::string &text) {
    if (m_writer) m_writer(text + '\n');
}

void Player::tell(const char *what, const double *values, int count) {
    std::string text = std::string("    ") + what;
    m_trace.word(what);
    for (int i = 0; i < count; ++i) {
        m_trace.number(values[i]);
        if (m_options.tells) text += ' ' + hexOf(values[i]);
    }
    m_trace.endLine();
    if (m_options.tells) write(text);
}

void Player::adopt(ObjectKind kind, void *object, Reference &result) {
    if (object == nullptr) return;
    result = objects.add(kind, object, result.number);
    m_trace.know(object);
}

// --- what is drawn, or read -----------------------------------------------------------------------------

Reference Player::makeNow(const char *function, Arguments arguments) {
    Call call = callOfNothing(function, std::move(arguments));
    make(call);
    return call.result;
}

void Player::play(Draw &draw) {
    m_draw = &draw;
    makeScene(draw);
    while (!m_isOver && !draw.isOver() && m_calls < m_options.maxCalls) {
        if (draw.oneIn(24))
            playFrames(1 + draw.below(12), draw.oneIn(2));
        else
            drawAndMake(Where::between);
    }
}

void Player::drawAndMake(Where where) {
    const Function &function = m_draw->function(where);
    Call call;
    call.where = where;
    call.turn = m_turn[static_cast<std::size_t>(where)];
    call.function = function.name;
    if (m_draw->arguments(function, objects, call.arguments)) make(call);
}

void Player::play(const Script &script) {
    m_script = &script;
    for (m_next = 0; !m_isOver && m_next < script.size();) {
        Call call = script[m_next++];
        if (call.where == Where::between) make(call);
    }
}

void Player::finish() {
    m_draw = nullptr;
    m_script = nullptr;
    if (m_isOver) return write("# ends: something was left half way, or a sweep-and-prune space would sort NaNs");
    if (m_options.tells) write("  at the end");
    std::jmp_buf target;
    m_target = &target;
    if (setjmp(target) == 0) look(true);
}

void Player::fillStack() const {
    if (m_options.fillsStack != 0) fillStackBelow(m_options.fillsStack);
}

// --- calls ------------------------------------------------------------------------------------------------

void Player::make(Call &call) {
    if (m_isOver) return;
    const Function *const function = functionOf(call.function);
    if (function == nullptr || call.arguments.size() != function->parameters.size()) {
        write("# unknown: " + textOf(call));
        return;
    }
    // The name of what is made is known before it is.
    if (function->isMaker && call.result.number < 0) call.result = {function->makes, objects.named(function->makes)};
    if (call.where == Where::between) m_turn = {};
    write(textOf(call));
    ++m_calls;
    m_innermost = function;
    m_innermostPlace = call.where;
    m_trace.word(call.function);
    fillStack();
    if (call.where != Where::between) {
        function->call(*this, call.arguments, call.result);
        return;
    }
    std::jmp_buf target;
    m_target = &target;
    if (setjmp(target) == 0) {
        if (!function->call(*this, call.arguments, call.result)) write("# not made");
    } else {
        write("# left by a jump");
        m_trace.word("jump");
        m_depth = 0;
        m_isOver = m_isOver || m_innermost->leavesHalves || m_innermostPlace == Where::box;
    }
    m_trace.endLine();
}

// Calls of a script that belong to this callback; or some that are drawn.
void Player::callBack(Where where) {
    if (m_isAtOnce) return;
    const int turn = m_turn[static_cast<std::size_t>(where)]++;
    if (m_depth > 0) return;
    ++m_depth;
    if (m_script != nullptr) {
        for (std::size_t i = m_next; i < m_script->size() && (*m_script)[i].where != Where::between; ++i) {
            if ((*m_script)[i].where != where || (*m_script)[i].turn != turn) continue;
            Call call = (*m_script)[i];
            make(call);
        }
    } else if (m_draw != nullptr && !m_draw->isOver() && m_draw->oneIn(8)) {
        --m_turn[static_cast<std::size_t>(where)];
        for (unsigned left = 1 + m_draw->below(3); left > 0; --left) drawAndMake(where);
        ++m_turn[static_cast<std::size_t>(where)];
    }
    --m_depth;
}

// --- callbacks ---------------------------------------------------------------------------------------------

bool Player::hasSweepSpace() const {
    const std::vector<Reference> spaces = objects.living(ObjectKind::space);
    return std::any_of(spaces.begin(), spaces.end(), [this](const Reference &space) {
        return dSpaceGetClass(static_cast<dSpaceID>(objects.find(space))) == dSweepAndPruneSpaceClass;
    });
}

// Sweep-and-prune spaces sort bounds by their bits, and so by the sign of a NaN, which compilers are free to choose.
bool Player::sortsNaNs() const {
    const auto isNaN = [](const dReal *values, int count) { return std::any_of(values, values + count, [](dReal x) { return std::isnan(x); }); };
    if (!hasSweepSpace()) return false;
    const std::vector<Reference> geoms = objects.living(ObjectKind::geom);
    return std::any_of(geoms.begin(), geoms.end(), [&](const Reference &reference) {
        const auto geom = static_cast<dGeomID>(objects.find(reference));
        if (dGeomGetClass(geom) == dPlaneClass) return false;
        // The fourth column of a rotation is not set everywhere.
        const dReal *const rotation = dGeomGetRotation(geom);
        return isNaN(dGeomGetPosition(geom), 3) || isNaN(rotation, 3) || isNaN(rotation + 4, 3) || isNaN(rotation + 8, 3);
    });
}

void Player::collide(dSpaceID space) {
    if (sortsNaNs()) {
        m_isOver = true;
        return;
    }
    if (m_policy == Policy::serial)
        dSpaceCollide(space, this, near);
    else
        collideAtOnce([&] { dSpaceCollide(space, this, nearAtOnce); });
}

void Player::collide2(dGeomID a, dGeomID b) {
    if (sortsNaNs()) {
        m_isOver = true;
        return;
    }
    if (m_policy == Policy::serial)
        dSpaceCollide2(a, b, this, near);
    else
        collideAtOnce([&] { dSpaceCollide2(a, b, this, nearAtOnce); });
}

std::string Player::nameOf(dGeomID geom) const {
    const ObjectKind kind = dGeomIsSpace(geom) ? ObjectKind::space : ObjectKind::geom;
    return std::string(fuzz::nameOf(kind)) + std::to_string(objects.numberOf(kind, geom));
}

void Player::near(void *player, dGeomID a, dGeomID b) { static_cast<Player *>(player)->meet(a, b); }

void Player::meet(dGeomID a, dGeomID b) {
    m_trace.word("near");
    m_trace.object(a);
    m_trace.object(b);
    m_trace.endLine();
    if (m_options.tells) write("    near " + nameOf(a) + ' ' + nameOf(b));
    callBack(Where::near);
    if (dGeomIsSpace(a) || dGeomIsSpace(b))
        dSpaceCollide2(a, b, this, near);
    else
        makeContacts(a, b, [this](const double *values, int count) { tell("contact", values, count); });
}

// What a callback may do that others of its kind run beside (include/ode/ode_MT.h).
void Player::nearAtOnce(void *player, dGeomID a, dGeomID b) { static_cast<Player *>(player)->meetAtOnce(a, b); }

void Player::meetAtOnce(dGeomID a, dGeomID b) {
    std::string seen = "    near " + nameOf(a) + ' ' + nameOf(b);
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        note(seen);
        return dSpaceCollide2(a, b, this, nearAtOnce);
    }
    if (m_policy == Policy::concurrent && (objects.numberOf(ObjectKind::geom, a) + objects.numberOf(ObjectKind::geom, b)) % 4 == 0)
        for (const dBodyID body : {dGeomGetBody(a), dGeomGetBody(b)})
            if (body != nullptr) dBodyEnable(body);
    makeContacts(a, b, [&](const double *values, int count) {
        for (int i = 0; i < count; ++i) seen += ' ' + hexOf(values[i]);
    });
    note(std::move(seen));
}

void Player::note(std::string what) {
    const std::lock_guard<std::mutex> lock(m_atOnce);
    m_met.push_back(std::move(what));
}

void Player::collideAtOnce(const std::function<void()> &collide) {
    for (const Reference &world : objects.living(ObjectKind::world)) contactsOf(static_cast<dWorldID>(objects.find(world)));
    m_met.clear();
    m_isAtOnce = true;
    collide();
    m_isAtOnce = false;
    std::sort(m_met.begin(), m_met.end());
    for (const std::string &line : m_met) {
        m_trace.line(line);
        if (m_options.tells) write(line);
    }
}

// An assertion in such a callback ends the process: the callback may not be left by a jump, and which comes first is not certain.
void Player::setCallbackPolicy(const std::string &policy) {
    m_policy = policy == "concurrent" ? Policy::concurrent : policy == "independent" ? Policy::independent : Policy::serial;
    dSetDebugHandler(onDebug);
    dSetErrorHandler(onError);
    if (m_policy != Policy::serial) dSetMessageHandler(onMessage);
}

// The other library's messages go to standard error in another order while callbacks run at once.
void Player::changeSolver(dWorldID world) {
    using Getter = const char *(*)(dWorldID);
    using Setter = int (*)(dWorldID, const char *);
    const auto getter = reinterpret_cast<Getter>(dlsym(RTLD_DEFAULT, "dODE_MT_GetSolver"));
    const auto setter = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "dODE_MT_SetSolver"));
    if (getter == nullptr || setter == nullptr) return;
    setter(world, std::strcmp(getter(world), "fast") == 0 ? "exact" : "fast");
}

void Player::setMessages(bool on) {
    if (on || m_policy == Policy::serial) dSetMessageHandler(on ? onMessage : nullptr);
}

namespace {

// Asked for unimportant contacts of these, upstream gives places that it has not computed. Geoms within transforms count, too.
bool areConvexAndMesh(dGeomID a, dGeomID b) {
    const auto has = [&](int number) {
        return dGeomGetClass(a) == number || dGeomGetClass(b) == number || dGeomGetClass(a) == dGeomTransformClass ||
               dGeomGetClass(b) == dGeomTransformClass;
    };
    return has(dConvexClass) && has(dTriMeshClass);
}

}  // namespace

void Player::makeContacts(dGeomID a, dGeomID b, const TellContact &tellContact) {
    dContact contacts[kMaxContacts] = {};
    const int most = std::min(surface.most, kMaxContacts);
    const int flags = most | (areConvexAndMesh(a, b) ? 0 : surface.flags);
    fillStack();
    const int count = dCollide(a, b, flags, &contacts[0].geom, sizeof *contacts);
    const dBodyID bodies[] = {dGeomGetBody(a), dGeomGetBody(b)};
    dWorldID world = nullptr;
    for (const dBodyID body : bodies)
        if (body != nullptr) world = dBodyGetWorld(body);
    for (int i = 0; i < count; ++i) {
        const dContactGeom &geom = contacts[i].geom;
        const double values[] = {geom.pos[0],    geom.pos[1],    geom.pos[2], geom.normal[0],
                                 geom.normal[1], geom.normal[2], geom.depth,  static_cast<double>(geom.side1),
                                 static_cast<double>(geom.side2)};
        tellContact(values, 9);
    }
    const bool areApart = bodies[0] != nullptr && bodies[1] != nullptr && dBodyGetWorld(bodies[0]) != dBodyGetWorld(bodies[1]);
    if (world == nullptr || areApart || bodies[0] == bodies[1]) return;
    for (int i = 0; i < count; ++i) {
        contacts[i].surface = surface.parameters;
        contacts[i].fdir1[0] = 1;
        const dJointID joint = dJointCreateContact(world, contactsOf(world), &contacts[i]);
        dJointAttach(joint, bodies[0], bodies[1]);
    }
}

void Player::tellContacts(dGeomID a, dGeomID b, int most, bool unimportant) {
    dContactGeom contacts[kMaxContacts] = {};
    if (areConvexAndMesh(a, b)) unimportant = false;
    const int flags = std::min(most, kMaxContacts) | (unimportant ? static_cast<int>(CONTACTS_UNIMPORTANT) : 0);
    fillStack();
    const int count = dCollide(a, b, flags, contacts, sizeof *contacts);
    for (int i = 0; i < count; ++i) {
        const dContactGeom &geom = contacts[i];
        const double values[] = {geom.pos[0], geom.pos[1], geom.pos[2], geom.normal[0], geom.normal[1], geom.normal[2], geom.depth};
        tell("contact", values, 7);
    }
}

bool Player::makeContact(dWorldID world, dGeomID a, dGeomID b, dReal depth) {
    const dBodyID bodies[] = {dGeomGetBody(a), dGeomGetBody(b)};
    if (bodies[0] == bodies[1]) return false;
    for (const dBodyID body : bodies)
        if (body != nullptr && dBodyGetWorld(body) != world) return false;
    dContact contact{};
    contact.surface = surface.parameters;
    contact.fdir1[0] = 1;
    const dReal *const place = dGeomGetPosition(a);
    std::copy(place, place + 3, contact.geom.pos);
    contact.geom.normal[2] = 1;
    contact.geom.depth = depth;
    contact.geom.g1 = a;
    contact.geom.g2 = b;
    dJointAttach(dJointCreateContact(world, contactsOf(world), &contact), bodies[0], bodies[1]);
    return true;
}

namespace {

// Steps that were left by jumps have left their working memory, and the two libraries come to the limit at different ones.
bool isMemoryOver() {
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) > limit.rlim_cur / 2;
}

}  // namespace

void Player::step(dWorldID world, dReal size, bool quick) {
    const int done = (quick ? dWorldQuickStep : dWorldStep)(world, size);
    const double value = done;
    if (done == 0 && isMemoryOver()) {
        write(kMemoryIsOver);
        m_isOver = true;
        return;
    }
    tell("returns", &value, 1);
    look(false);
}

// The step does not come first where it might produce a NaN for a sweep-and-prune space to sort.
void Player::playFrame(dSpaceID space, dWorldID world, dReal size, bool quick, bool stepsFirst) {
    stepsFirst = stepsFirst && !hasSweepSpace();
    dWorldStepFunction *const stepper = quick ? dWorldQuickStep : dWorldStep;
    const auto collideAndStep = functionOfOurs<void, dSpaceID, void *, dNearCallback *, dWorldID, dReal, dWorldStepFunction *>(
        "dSpaceCollideAndWorldStep");
    const auto stepAndCollide =
        functionOfOurs<void, dSpaceID, void *, dNearCallback *, dWorldID, dReal, dWorldStepFunction *, dSpaceUpdateFunction *>(
            "dWorldStepAndSpaceCollide");
    const auto play = [&](dNearCallback *callback) {
        if (stepsFirst && stepAndCollide != nullptr) return stepAndCollide(space, this, callback, world, size, stepper, nullptr);
        if (collideAndStep != nullptr) return collideAndStep(space, this, callback, world, size, stepper);
        if (stepsFirst) stepper(world, size);
        dSpaceCollide(space, this, callback);
        if (!stepsFirst) stepper(world, size);
    };
    if (sortsNaNs())
        m_isOver = true;
    else if (m_policy == Policy::serial)
        play(near);
    else
        collideAtOnce([&] { play(nearAtOnce); });
    look(false);
}

// Two worlds in one call; on the other library by the calls that it stands for.
void Player::stepTogether(dWorldID first, dWorldID second, dReal size, bool quick) {
    const dWorldID worlds[] = {first, second};
    if (const auto together = functionOfOurs<int, const dWorldID *, int, const char *, dReal>("dODE_MT_StepWorlds"))
        together(worlds, 2, quick ? "quick" : "step", size);
    else {
        if (!(size > 0)) dDebug(d_ERR_UASSERT, "stepsize must be > 0 in dODE_MT_StepWorlds()");
        for (const dWorldID world : worlds) (quick ? dWorldQuickStep : dWorldStep)(world, size);
    }
    look(false);
}

void Player::moved(dBodyID body) {
    s_player->m_trace.word("moved");
    s_player->m_trace.object(body);
    s_player->m_trace.endLine();
    if (s_player->m_options.tells)
        s_player->write("    moved body" + std::to_string(s_player->objects.numberOf(ObjectKind::body, body)));
    s_player->callBack(Where::moved);
}

void Player::onShape(ShapeCallback which) {
    constexpr Where where[] = {Where::collider, Where::box, Where::triangle, Where::height};
    s_player->callBack(where[static_cast<int>(which)]);
}

void Player::handle(const char *kind, int number, const char *text, va_list arguments, bool mayJump) {
    char buffer[1000];
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    const std::string whole = buffer, told = whole.substr(0, whole.find(" ["));  // the place in the source is not compared
    if (m_isAtOnce) {
        if (!mayJump) return note(std::string("    ") + kind + ": " + told);
        const std::lock_guard<std::mutex> lock(m_atOnce);
        write("# an assertion has failed in callbacks that may run at once");
        _exit(3);
    }
    m_trace.line(std::string(kind) + ": " + told.substr(0, told.find(" (s=")), number);
    write(std::string("    ") + kind + ' ' + std::to_string(number) + ": " + told);
    if (mayJump && m_options.jumps && m_target != nullptr) std::longjmp(*m_target, 1);
    if (!mayJump) callBack(Where::message);
}

void Player::onDebug(int number, const char *text, va_list arguments) {
    s_player->handle("debug", number, text, arguments, true);
}

void Player::onError(int number, const char *text, va_list arguments) {
    s_player->handle("error", number, text, arguments, true);
}

void Player::onMessage(int number, const char *text, va_list arguments) {
    s_player->handle("message", number, text, arguments, false);
}

// --- state -------------------------------------------------------------------------------------------------

// A query of the boxes of geoms updates them, which a program without queries would not see.
void Player::look(bool atBoxes) {
    scenes::Inventory inventory = objects.inventory();
    if (!atBoxes) {
        inventory.geoms.clear();
        inventory.spaces.clear();
    }
    const scenes::Inventory all = objects.inventory();
    const exactness::Names names(all);
    std::string text;
    exactness::readState(inventory, names,
                         [&](exactness::Kind kind, std::size_t index, const char *field, const exactness::Reading &reading) {
                             m_trace.number(static_cast<double>(reading.words().size()));
                             for (const exactness::Word &word : reading.words()) {
                                 double value = 0;
                                 static_assert(sizeof value == sizeof word.bits, "");
                                 std::memcpy(&value, &word.bits, sizeof value);
                                 m_trace.number(word.kind == exactness::Word::Kind::Real ? value : static_cast<double>(word.bits));
                             }
                             if (!m_options.tells) return;
                             text = std::string("    ") + toString(kind) + std::to_string(index) + ' ' + field + ':';
                             for (const exactness::Word &word : reading.words()) text += ' ' + toString(word);
                             write(text);
                         });
    m_trace.endLine();
}

void Player::emptyContacts() {
    for (const auto &[world, group] : m_contacts) dJointGroupEmpty(group);
}

dJointGroupID Player::contactsOf(dWorldID world) {
    dJointGroupID &group = m_contacts[world];
    if (group == nullptr) group = dJointGroupCreate(0);
    return group;
}

dJointFeedback *Player::feedbackOf(dJointID joint) {
    std::unique_ptr<dJointFeedback> &feedback = m_feedback[joint];
    if (feedback == nullptr) feedback = std::make_unique<dJointFeedback>();
    return feedback.get();
}

}  // namespace fuzz
