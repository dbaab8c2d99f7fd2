#include "draw.h"

#include "played_as.h"

#include <cmath>
#include <limits>

namespace fuzz {

namespace {

// Functions that may be called in a place, each as often as its weight.
std::vector<const Function *> weighted(Where where) {
    std::vector<const Function *> list;
    for (const Function &function : functions()) {
        for (int i = 0; i < function.weights[static_cast<std::size_t>(where)]; ++i) list.push_back(&function);
    }
    return list;
}

bool hasPose(dGeomID geom) { return !dGeomIsSpace(geom) && dGeomGetClass(geom) != dPlaneClass; }

}  // namespace

Draw::Draw(const std::uint8_t *bytes, std::size_t count) : m_bytes(bytes), m_count(count) {
    constexpr Mode modes[] = {Mode::ordinary, Mode::ordinary, Mode::ordinary, Mode::ordinary,
                              Mode::tiny,     Mode::huge,     Mode::zero,     Mode::broken};
    m_mode = modes[byte() % 8];
    const unsigned size = byte();
    m_isHeap = playedAs.isFast ? size % 2 != 0 : size >= 244;
    if (playedAs.isFast)
        m_bodies = m_isHeap ? 8 + size % 64 : 2 + size % 12;
    else
        m_bodies = size < 160 ? 2 + size % 12 : size < 236 ? size % 80 : m_isHeap ? 64 + size % 12 * 4 : 100 + size % 16 * 10;
    m_spaceKind = byte() % 4;
    if (byte() % 4 != 0) chooseFocus();
}

// What seldom comes, comes often in some scripts, and so together with all that is kept (Groce et al., "Swarm testing", ISSTA
// 2012). Functions that are adjacent in the table are related.
void Draw::chooseFocus() {
    constexpr int kRuns = 2;
    constexpr std::size_t kLength = 5;
    const std::vector<Function> &all = functions();
    for (int run = 0; run < kRuns; ++run) {
        const std::size_t first = below(static_cast<unsigned>(all.size()));
        for (std::size_t i = 0; i < kLength; ++i) {
            const Function &function = all[(first + i) % all.size()];
            for (std::size_t place = 0; place < places; ++place)
                if (function.weights[place] != 0) m_focus[place].push_back(&function);
        }
    }
}

std::uint8_t Draw::byte() { return m_at < m_count ? m_bytes[m_at++] : 0; }

unsigned Draw::below(unsigned limit) {
    if (limit <= 1) return 0;
    const unsigned low = byte();
    return (limit <= 256 ? low : low | static_cast<unsigned>(byte()) << 8) % limit;
}

const Function &Draw::function(Where where) {
    static const std::vector<std::vector<const Function *>> lists = [] {
        std::vector<std::vector<const Function *>> made;
        for (int place = 0; place < places; ++place) made.push_back(weighted(static_cast<Where>(place)));
        return made;
    }();
    const std::vector<const Function *> &focus = m_focus[static_cast<std::size_t>(where)];
    const std::vector<const Function *> &list = !focus.empty() && oneIn(3) ? focus : lists[static_cast<std::size_t>(where)];
    return *list[below(static_cast<unsigned>(list.size()))];
}

// Some calls are refused by upstream all the same.
bool Draw::arguments(const Function &function, const Objects &objects, Arguments &arguments) {
    if (!draw(function, objects, arguments)) return false;
    return !function.adjust || oneIn(64) || function.adjust(objects, arguments);
}

bool Draw::draw(const Function &function, const Objects &objects, Arguments &arguments) {
    arguments.clear();
    for (const Parameter &parameter : function.parameters) {
        Argument argument;
        switch (parameter.kind) {
            case Parameter::Kind::object:
            case Parameter::Kind::nullableObject:
                if (!object(parameter, objects, argument)) return false;
                break;
            case Parameter::Kind::number:
                argument.numbers.push_back(number(parameter.meaning));
                break;
            case Parameter::Kind::word:
                argument.kind = Argument::Kind::word;
                argument.word = parameter.words[below(static_cast<unsigned>(parameter.words.size()))];
                break;
            case Parameter::Kind::numbers:
                argument.kind = Argument::Kind::numbers;
                if (parameter.isPose)
                    pose(parameter, argument);
                else
                    for (int i = 0; i < parameter.length; ++i) argument.numbers.push_back(number(parameter.meaning));
                break;
        }
        arguments.push_back(std::move(argument));
    }
    return true;
}

bool Draw::object(const Parameter &parameter, const Objects &objects, Argument &argument) {
    argument.kind = Argument::Kind::reference;
    argument.reference.kind = parameter.object;
    if (parameter.kind == Parameter::Kind::nullableObject && oneIn(parameter.object == ObjectKind::group ? 2 : 6)) return true;
    std::vector<Reference> living = objects.living(parameter.object);
    if (parameter.object == ObjectKind::geom && parameter.type == kAnyType && oneIn(8)) living = objects.living(ObjectKind::space);
    const auto fits = [&](const Reference &reference) {
        void *const found = objects.find(reference);
        if (parameter.object == ObjectKind::geom && parameter.type == kWithPose) return hasPose(static_cast<dGeomID>(found));
        if (parameter.object == ObjectKind::geom && parameter.type == kOnBody) return dGeomGetBody(static_cast<dGeomID>(found)) != nullptr;
        if (parameter.object == ObjectKind::space && parameter.type >= 0)
            return dSpaceGetClass(static_cast<dSpaceID>(found)) == parameter.type;
        if (parameter.object == ObjectKind::geom && parameter.type >= 0)
            return dGeomGetClass(static_cast<dGeomID>(found)) == parameter.type;
        if (parameter.object != ObjectKind::joint || parameter.type < 0) return true;
        const auto joint = static_cast<dJointID>(found);
        // Upstream's functions of most types dereference the bodies without a check.
        return dJointGetType(joint) == parameter.type && dJointGetBody(joint, 0) != nullptr;
    };
    if (living.empty()) return parameter.kind == Parameter::Kind::nullableObject;
    const auto first = below(static_cast<unsigned>(living.size()));
    for (std::size_t i = 0; i < living.size(); ++i) {
        const Reference &reference = living[(first + i) % living.size()];
        if (!fits(reference)) continue;
        argument.reference = reference;
        return true;
    }
    return false;
}

// Mostly rotations.
void Draw::pose(const Parameter &parameter, Argument &argument) {
    double q[4];
    for (double &value : q) value = 2 * number(Meaning::fraction) - 1;
    if (!oneIn(16)) {
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (length > 0 && std::isfinite(length))
            for (double &value : q) value /= length;
    }
    if (parameter.length == 4) {
        argument.numbers.assign(q, q + 4);
        return;
    }
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    argument.numbers = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),     0,
                        2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),     0,
                        2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y), 0};
}

double Draw::number(Meaning meaning) {
    switch (meaning) {
        case Meaning::count:
            return oneIn(10) ? static_cast<int>(below(512)) - 128 : static_cast<int>(below(12));
        case Meaning::level:
            return oneIn(6) ? static_cast<int>(below(64)) - 32 : static_cast<int>(below(8)) - 4;
        case Meaning::flag:
            return below(2);
        case Meaning::choice:
            return below(8);
        case Meaning::parameter:
            return below(16) + 256 * (oneIn(3) ? below(4) : 0);
        case Meaning::bits:
            return oneIn(3) ? below(65536) : below(8);
        default:
            return m_mode != Mode::ordinary && oneIn(6) ? unusual() : ordinary(meaning);
    }
}

// Sixteenths and hundredths: positions and sizes coincide exactly, and nearly.
double Draw::ordinary(Meaning meaning) {
    const unsigned coarse = below(32);
    const double fine = oneIn(2) ? 0 : below(256) / 2560.0;
    switch (meaning) {
        case Meaning::size:
            return 0.125 + coarse / 32.0 + fine;
        case Meaning::time:
            return 0.001 + coarse / 1000.0 + fine / 10;
        case Meaning::place:
            return (static_cast<int>(coarse) - 12) / 8.0 + fine;
        case Meaning::speed:
            return (static_cast<int>(coarse) - 16) / 2.0 + fine;
        case Meaning::fraction:
            return coarse / 32.0 + fine / 10;
        case Meaning::angle:
            return (static_cast<int>(coarse) - 16) / 5.0 + fine;
        case Meaning::coordinate:
            return (static_cast<int>(coarse) - 16) / 16.0 + fine;
        default:
            return (static_cast<int>(coarse) - 8) / 4.0 + fine;
    }
}

double Draw::unusual() {
    const double sign = oneIn(2) ? -1 : 1;
    using Limits = std::numeric_limits<double>;
    switch (m_mode) {
        case Mode::tiny: {
            constexpr double values[] = {1e-5, 1e-10, 1e-20, 1e-100, 1e-160, Limits::min(), Limits::denorm_min(), 1e-310};
            return sign * values[below(8)];
        }
        case Mode::huge: {
            constexpr double values[] = {1e3, 1e5, 1e8, 1e12, 1e20, 1e40, 1e100, 1e155};
            return sign * values[below(8)];
        }
        case Mode::zero:
            return sign * 0.0;
        default: {
            constexpr double values[] = {Limits::quiet_NaN(), Limits::infinity(), Limits::max(), 1e200, 0, 1, Limits::quiet_NaN(), 1e308};
            return sign * values[below(8)];
        }
    }
}

}  // namespace fuzz
