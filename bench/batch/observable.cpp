#include "batch/observable.h"

#include "loader/scene/sdf_scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace batch {

namespace {

using Reading = std::function<double()>;

double sum(const std::vector<dBodyID> &bodies, double (*ofBody)(dBodyID)) {
    double all = 0;
    for (const dBodyID body : bodies) all += ofBody(body);
    return all;
}

// ½ m v² + ½ ω · I ω, with the inertia in the body's own axes.
double kineticEnergy(dBodyID body) {
    dMass mass;
    dBodyGetMass(body, &mass);
    dVector3 spin;
    const dReal *const w = dBodyGetAngularVel(body), *const v = dBodyGetLinearVel(body);
    dBodyVectorFromWorld(body, w[0], w[1], w[2], spin);
    double energy = 0;
    for (int i = 0; i < 3; ++i) {
        energy += 0.5 * mass.mass * v[i] * v[i];
        for (int j = 0; j < 3; ++j) energy += 0.5 * spin[i] * mass.I[4 * i + j] * spin[j];
    }
    return energy;
}

double potentialEnergy(dBodyID body) {
    dMass mass;
    dBodyGetMass(body, &mass);
    dVector3 gravity;
    dWorldGetGravity(dBodyGetWorld(body), gravity);
    const dReal *const position = dBodyGetPosition(body);
    return dBodyGetGravityMode(body) != 0 ? -mass.mass * (gravity[0] * position[0] + gravity[1] * position[1] + gravity[2] * position[2]) : 0;
}

double awake(dBodyID body) { return dBodyIsEnabled(body) != 0; }

using OfWorld = double (*)(const scenes::Scene &);
const std::map<std::string, OfWorld> kOfWorld = {
    {"contacts", [](const scenes::Scene &scene) { return static_cast<double>(scene.contactCount()); }},
    {"awake", [](const scenes::Scene &scene) { return sum(scene.inventory().bodies, awake); }},
    {"kinetic_energy", [](const scenes::Scene &scene) { return sum(scene.inventory().bodies, kineticEnergy); }},
    {"potential_energy", [](const scenes::Scene &scene) { return sum(scene.inventory().bodies, potentialEnergy); }},
    {"energy",
     [](const scenes::Scene &scene) { return sum(scene.inventory().bodies, kineticEnergy) + sum(scene.inventory().bodies, potentialEnergy); }},
};

using OfBody = const dReal *(*)(dBodyID);
const std::map<std::string, OfBody> kVectors = {
    {"position", dBodyGetPosition}, {"velocity", dBodyGetLinearVel}, {"angular_velocity", dBodyGetAngularVel}};

const std::vector<std::string> kOfJoint = {"angle", "rate", "extension"};

std::string known() {
    return "known: contacts, awake, energy, kinetic_energy, potential_energy, reading[N], BODY.position.x, BODY.velocity.x, "
           "BODY.angular_velocity.x, BODY.height, BODY.speed, JOINT.angle, JOINT.rate, JOINT.extension, each behind max, min or mean or alone";
}

// "base.position.x" is the body "base" and "position", axis 0.
struct Words {
    std::string owner, quantity;
    int axis = -1;
};

std::optional<Words> split(const std::string &what) {
    Words words;
    std::string rest = what;
    const std::size_t last = rest.rfind('.');
    if (last == std::string::npos) return std::nullopt;
    std::string end = rest.substr(last + 1);
    rest.resize(last);
    if (end.size() == 1 && end[0] >= 'x' && end[0] <= 'z') {
        words.axis = end[0] - 'x';
        const std::size_t before = rest.rfind('.');
        if (before == std::string::npos) return std::nullopt;
        end = rest.substr(before + 1);
        rest.resize(before);
    }
    words.owner = rest;
    words.quantity = end;
    const bool isVector = kVectors.count(end) != 0;
    const bool isNumber = end == "height" || end == "speed" || std::count(kOfJoint.begin(), kOfJoint.end(), end) != 0;
    if (rest.empty() || isVector != (words.axis >= 0) || (!isVector && !isNumber)) return std::nullopt;
    return words;
}

// The N of "body[N]".
std::optional<std::size_t> indexIn(const std::string &text, const std::string &list) {
    if (text.rfind(list + "[", 0) != 0 || text.back() != ']') return std::nullopt;
    const char *const begin = text.data() + list.size() + 1, *const end = text.data() + text.size() - 1;
    std::size_t index = 0;
    const auto [stopped, error] = std::from_chars(begin, end, index);
    return error == std::errc() && stopped == end ? std::optional(index) : std::nullopt;
}

template <class Object>
Object find(const std::vector<Object> &objects, const std::vector<std::string> *names, const std::string &name, const std::string &list) {
    if (const auto index = indexIn(name, list)) {
        if (*index < objects.size()) return objects[*index];
        throw ObservableError("there is no " + name + ": the world has " + std::to_string(objects.size()));
    }
    if (names != nullptr) {
        const auto found = std::find(names->begin(), names->end(), name);
        if (found != names->end()) return objects[static_cast<std::size_t>(found - names->begin())];
    }
    throw ObservableError("there is no " + list + " '" + name + "'");
}

Reading ofBody(const Words &words, dBodyID body) {
    if (words.quantity == "height") return [body] { return static_cast<double>(dBodyGetPosition(body)[2]); };
    if (words.quantity == "speed")
        return [body] {
            const dReal *const v = dBodyGetLinearVel(body);
            return std::sqrt(static_cast<double>(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        };
    return [vector = kVectors.at(words.quantity), axis = words.axis, body] { return static_cast<double>(vector(body)[axis]); };
}

Reading ofJoint(const Words &words, dJointID joint) {
    const bool isSlider = words.quantity == "extension";
    if (dJointGetType(joint) != (isSlider ? dJointTypeSlider : dJointTypeHinge))
        throw ObservableError("'" + words.owner + "' is no " + (isSlider ? "slider" : "hinge"));
    auto *const read = isSlider ? dJointGetSliderPosition : words.quantity == "angle" ? dJointGetHingeAngle : dJointGetHingeAngleRate;
    return [read, joint] { return static_cast<double>(read(joint)); };
}

}  // namespace

Observable readObservable(const std::string &name, const std::string &expression) {
    Observable observable{name, Observable::Over::End, expression};
    const std::pair<const char *, Observable::Over> words[] = {
        {"max ", Observable::Over::Max}, {"min ", Observable::Over::Min}, {"mean ", Observable::Over::Mean}};
    for (const auto &[word, over] : words)
        if (expression.rfind(word, 0) == 0) observable = {name, over, expression.substr(std::string(word).size())};
    if (kOfWorld.count(observable.what) == 0 && !indexIn(observable.what, "reading") && !split(observable.what))
        throw ObservableError("'" + expression + "' is unknown; " + known());
    return observable;
}

Reading findReading(const Observable &observable, const scenes::Scene &scene) {
    const auto world = kOfWorld.find(observable.what);
    if (world != kOfWorld.end()) return [&scene, read = world->second] { return read(scene); };
    const scenes::Inventory &inventory = scene.inventory();
    if (const auto index = indexIn(observable.what, "reading")) {
        if (*index < inventory.readings.size()) return [&inventory, index = *index] { return static_cast<double>(inventory.readings[index]); };
        throw ObservableError("there is no " + observable.what + ": the world has " + std::to_string(inventory.readings.size()));
    }
    const Words words = *split(observable.what);
    const auto *const sdf = dynamic_cast<const worlds::SdfScene *>(&scene);
    const bool isJoint = std::count(kOfJoint.begin(), kOfJoint.end(), words.quantity) != 0;
    if (isJoint) return ofJoint(words, find(inventory.joints, sdf != nullptr ? &sdf->jointNames() : nullptr, words.owner, "joint"));
    return ofBody(words, find(inventory.bodies, sdf != nullptr ? &sdf->bodyNames() : nullptr, words.owner, "body"));
}

}  // namespace batch
