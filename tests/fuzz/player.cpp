#include "player.h"

#include "fields.h"
#include "function.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace fuzz {

namespace {

// Calls that are drawn in all callbacks of one call, at most, and callbacks within callbacks.
constexpr int kMostContacts = 32;

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

Argument argumentOf(double number) {
    Argument argument;
    argument.numbers.push_back(number);
    return argument;
}

Argument argumentOf(const Reference &reference) {
    Argument argument;
    argument.kind = Argument::Kind::reference;
    argument.reference = reference;
    return argument;
}

}  // namespace

Player *Player::s_player = nullptr;

Player::Player(const Options &options, Writer writer) : m_options(options), m_writer(std::move(writer)), m_trace(false) {
    s_player = this;
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

void Player::play(Draw &draw) {
    m_draw = &draw;
    const auto call = [this](Call made) {
        make(made);
        return made.result;
    };
    const Reference world = call(callOfNothing("dWorldCreate"));
    call(callOfNothing("dWorldSetGravity", {argumentOf(world), argumentOf(0), argumentOf(0), argumentOf(-9.75)}));
    Reference null;
    null.kind = ObjectKind::space;
    static const char *const kinds[] = {"dSimpleSpaceCreate", "dHashSpaceCreate", "dSweepAndPruneSpaceCreate", "dQuadTreeSpaceCreate"};
    Arguments arguments;
    const Function *const maker = functionOf(kinds[draw.spaceKind()]);
    draw.arguments(*maker, objects, arguments);
    arguments[0] = argumentOf(null);
    const Reference space = call(callOfNothing(maker->name.c_str(), arguments));
    if (!draw.oneIn(4))
        call(callOfNothing("dCreatePlane", {argumentOf(space), argumentOf(0), argumentOf(0), argumentOf(1), argumentOf(0)}));
    static const char *const shapes[] = {"dCreateSphere", "dCreateBox", "dCreateCapsule", "dCreateCylinder", "dCreateConvex", "dCreateGeom"};
    for (unsigned i = 0; i < draw.bodies() && !m_isOver && !draw.isOver(); ++i) {
        const Reference body = call(callOfNothing("dBodyCreate", {argumentOf(world)}));
        const Function *const shape = functionOf(shapes[draw.below(6)]);
        draw.arguments(*shape, objects, arguments);
        arguments[0] = argumentOf(space);
        const Reference geom = call(callOfNothing(shape->name.c_str(), arguments));
        if (geom.number < 0 || body.number < 0) continue;
        call(callOfNothing("dGeomSetBody", {argumentOf(geom), argumentOf(body)}));
        draw.arguments(*functionOf("dBodySetPosition"), objects, arguments);
        arguments[0] = argumentOf(body);
        call(callOfNothing("dBodySetPosition", arguments));
    }
    while (!m_isOver && !draw.isOver() && m_calls < m_options.mostCalls) drawAndMake(Where::between);
}

void Player::drawAndMake(Where where) {
    const Function &function = m_draw->function(where);
    Call call;
    call.where = where;
    call.turn = m_turn[static_cast<int>(where)];
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
    if (m_isOver) return write("# ends: an object was left half made or half destroyed");
    if (m_options.tells) write("  at the end");
    std::jmp_buf target;
    m_target = &target;
    if (setjmp(target) == 0) look(true);
}

// --- calls ------------------------------------------------------------------------------------------------

void Player::make(Call &call) {
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
    m_trace.word(call.function);
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
        m_isOver = m_innermost->leavesHalves;
    }
    m_trace.endLine();
}

// Calls of a script that belong to this callback; or some that are drawn.
void Player::callBack(Where where) {
    const int turn = m_turn[static_cast<int>(where)]++;
    if (m_depth > 0) return;
    ++m_depth;
    if (m_script != nullptr) {
        for (std::size_t i = m_next; i < m_script->size() && (*m_script)[i].where != Where::between; ++i) {
            if ((*m_script)[i].where != where || (*m_script)[i].turn != turn) continue;
            Call call = (*m_script)[i];
            make(call);
        }
    } else if (m_draw != nullptr && !m_draw->isOver() && m_draw->oneIn(8)) {
        --m_turn[static_cast<int>(where)];
        for (unsigned left = 1 + m_draw->below(3); left > 0; --left) drawAndMake(where);
        ++m_turn[static_cast<int>(where)];
    }
    --m_depth;
}

// --- callbacks ---------------------------------------------------------------------------------------------

void Player::collide(dSpaceID space) { dSpaceCollide(space, this, near); }
void Player::collide2(dGeomID a, dGeomID b) { dSpaceCollide2(a, b, this, near); }

void Player::near(void *player, dGeomID a, dGeomID b) { static_cast<Player *>(player)->meet(a, b); }

void Player::meet(dGeomID a, dGeomID b) {
    m_trace.word("near");
    m_trace.object(a);
    m_trace.object(b);
    m_trace.endLine();
    if (m_options.tells) {
        const auto name = [this](dGeomID geom) {
            const ObjectKind kind = dGeomIsSpace(geom) ? ObjectKind::space : ObjectKind::geom;
            return std::string(nameOf(kind)) + std::to_string(objects.numberOf(kind, geom));
        };
        write("    near " + name(a) + ' ' + name(b));
    }
    callBack(Where::near);
    if (dGeomIsSpace(a) || dGeomIsSpace(b))
        dSpaceCollide2(a, b, this, near);
    else
        makeContacts(a, b);
}

void Player::makeContacts(dGeomID a, dGeomID b) {
    dContact contacts[kMostContacts] = {};
    const int most = std::min(surface.most, kMostContacts);
    const int count = dCollide(a, b, most | surface.flags, &contacts[0].geom, sizeof *contacts);
    const dBodyID bodies[] = {dGeomGetBody(a), dGeomGetBody(b)};
    dWorldID world = nullptr;
    for (const dBodyID body : bodies)
        if (body != nullptr) world = dBodyGetWorld(body);
    for (int i = 0; i < count; ++i) {
        const dContactGeom &geom = contacts[i].geom;
        const double values[] = {geom.pos[0],    geom.pos[1],    geom.pos[2], geom.normal[0],
                                 geom.normal[1], geom.normal[2], geom.depth,  static_cast<double>(geom.side1),
                                 static_cast<double>(geom.side2)};
        tell("contact", values, 9);
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

void Player::step(dWorldID world, dReal size, bool quick) {
    const int done = (quick ? dWorldQuickStep : dWorldStep)(world, size);
    const double value = done;
    tell("returns", &value, 1);
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

void Player::handle(const char *kind, int number, const char *text, va_list arguments, bool mayJump) {
    char buffer[1000];
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    const std::string whole = buffer, told = whole.substr(0, whole.find(" ["));  // the place in the source is not compared
    m_trace.line(std::string(kind) + ": " + told, number);
    write(std::string("    ") + kind + ' ' + std::to_string(number) + ": " + told);
    if (mayJump && m_target != nullptr) std::longjmp(*m_target, 1);
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

// Asking for the boxes of geoms brings these up to date, which a program that does not ask would not see.
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
