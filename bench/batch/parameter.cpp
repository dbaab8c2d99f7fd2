#include "batch/parameter.h"

#include "world_source.h"

#include <dlfcn.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace batch {

namespace {

using Json = nlohmann::ordered_json;

enum class Kind { Number, Whole, Switch, Solver };

struct Property {
    const char *name;
    Kind kind;
    double least, most;
    void (*set)(dWorldID world, double value);
};

// ODE_MT's own: the program also runs on Debian's library.
void setSolver(dWorldID world, const std::string &name) {
    using SetSolver = int(dWorldID, const char *);
    if (const auto set = reinterpret_cast<SetSolver *>(dlsym(RTLD_DEFAULT, "dODE_MT_SetSolver")))
        set(world, name.c_str());
    else if (name != "exact")
        throw std::invalid_argument("solver: this libode has no '" + name + "'");
}

constexpr double kHuge = 1e10;

const Property kProperties[] = {
    {"gravity", Kind::Number, -kHuge, kHuge,
     [](dWorldID world, double z) { dWorldSetGravity(world, 0, 0, static_cast<dReal>(z)); }},  // along z, m/s²
    {"erp", Kind::Number, 0, 1, [](dWorldID world, double erp) { dWorldSetERP(world, static_cast<dReal>(erp)); }},
    {"cfm", Kind::Number, 0, kHuge, [](dWorldID world, double cfm) { dWorldSetCFM(world, static_cast<dReal>(cfm)); }},
    {"iterations", Kind::Whole, 1, 100000,  // of dWorldQuickStep
     [](dWorldID world, double count) { dWorldSetQuickStepNumIterations(world, static_cast<int>(count)); }},
    {"sor_w", Kind::Number, 0, 2, [](dWorldID world, double w) { dWorldSetQuickStepW(world, static_cast<dReal>(w)); }},
    {"linear_damping", Kind::Number, 0, 1, [](dWorldID world, double scale) { dWorldSetLinearDamping(world, static_cast<dReal>(scale)); }},
    {"angular_damping", Kind::Number, 0, 1, [](dWorldID world, double scale) { dWorldSetAngularDamping(world, static_cast<dReal>(scale)); }},
    {"max_correcting_velocity", Kind::Number, 0, kHuge,  // m/s
     [](dWorldID world, double speed) { dWorldSetContactMaxCorrectingVel(world, static_cast<dReal>(speed)); }},
    {"surface_layer", Kind::Number, 0, kHuge, [](dWorldID world, double depth) { dWorldSetContactSurfaceLayer(world, static_cast<dReal>(depth)); }},
    {"auto_disable", Kind::Switch, 0, 1, [](dWorldID world, double isOn) { dWorldSetAutoDisableFlag(world, isOn != 0); }},
    {"solver", Kind::Solver, 0, 0, nullptr},
};

const Property *findProperty(const std::string &name) {
    const auto found = std::find_if(std::begin(kProperties), std::end(kProperties), [&](const Property &property) { return property.name == name; });
    return found != std::end(kProperties) ? &*found : nullptr;
}

bool isPath(const std::string &name) { return name.rfind("/sdf", 0) == 0; }

[[noreturn]] void failParameter(const std::string &name, const std::string &what) { fail("parameters." + name, what); }

std::string knownNames() {
    std::string names;
    for (const Property &property : kProperties) names += std::string(property.name) + ", ";
    return names + "/sdf/…/element, a name that stands as ${name} in the world";
}

std::string spelled(const Json &value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void checkValue(const Property &property, const Json &value) {
    const std::string name = property.name;
    switch (property.kind) {
        case Kind::Switch:
            if (!value.is_boolean()) failParameter(name, "'" + value.dump() + "' is not true or false");
            return;
        case Kind::Solver:
            if (value != "exact" && value != "fast") failParameter(name, "'" + spelled(value) + "' is unknown; known: exact, fast");
            return;
        case Kind::Whole:
            if (!value.is_number_integer()) failParameter(name, "'" + value.dump() + "' is not a whole number");
            break;
        case Kind::Number:
            if (!value.is_number()) failParameter(name, "'" + value.dump() + "' is not a number");
    }
    const double number = value.get<double>();
    if (!(number >= property.least && number <= property.most)) {
        const auto text = [](double limit) { return Json(limit).dump(); };
        failParameter(name, "'" + value.dump() + "' is not from " + text(property.least) + " to " + text(property.most));
    }
}

// One step of a path: "model[robot]", "link", "plugin".
struct Step {
    std::string element, name;  // no name: the first one
};

Step readStep(const std::string &text, const std::string &path) {
    const std::size_t bracket = text.find('[');
    if (bracket == std::string::npos) return {text, ""};
    if (text.back() != ']') failParameter(path, "a [ has no ]");
    return {text.substr(0, bracket), text.substr(bracket + 1, text.size() - bracket - 2)};
}

tinyxml2::XMLElement *findChild(tinyxml2::XMLNode *parent, const Step &step) {
    for (auto *child = parent->FirstChildElement(step.element.c_str()); child != nullptr; child = child->NextSiblingElement(step.element.c_str())) {
        const char *const name = child->Attribute("name");
        if (step.name.empty() || (name != nullptr && step.name == name)) return child;
    }
    return nullptr;
}

std::vector<std::string> splitPath(const std::string &path) {
    std::vector<std::string> parts;
    std::string part;
    bool isInBrackets = false;
    for (const char letter : path.substr(1)) {
        isInBrackets = letter == '[' || (isInBrackets && letter != ']');
        if (letter == '/' && !isInBrackets) {
            parts.push_back(part);
            part.clear();
        } else {
            part += letter;
        }
    }
    parts.push_back(part);
    return parts;
}

void changeElement(tinyxml2::XMLDocument &document, const std::string &file, const std::string &path, const std::string &text) {
    const std::size_t at = path.rfind('@');
    const std::string attribute = at == std::string::npos ? "" : path.substr(at + 1);
    tinyxml2::XMLNode *node = &document;
    std::string reached;
    for (const std::string &part : splitPath(path.substr(0, at))) {
        node = findChild(node, readStep(part, path));
        reached += "/" + part;
        if (node == nullptr) throw std::invalid_argument(file + ": there is no " + reached);
    }
    tinyxml2::XMLElement &element = *node->ToElement();
    if (attribute.empty()) {
        if (element.FirstChildElement() != nullptr) throw std::invalid_argument(file + ": " + path + " holds elements, not a value");
        element.SetText(text.c_str());
    } else {
        element.SetAttribute(attribute.c_str(), text.c_str());
    }
}

}  // namespace

void fail(const std::string &key, const std::string &what) { throw std::invalid_argument("plan: " + key + ": " + what); }

void insertValue(std::string &text, const std::string &name, const Json &value) {
    const std::string mark = "${" + name + "}", inserted = spelled(value);
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + inserted.size()))
        text.replace(at, mark.size(), inserted);
}

void checkParameter(const std::string &name, const Json &value, const std::string &world) {
    if (const Property *const property = findProperty(name)) return checkValue(*property, value);
    if (isPath(name)) {
        const std::string file = world.substr(0, world.find('$'));
        if (world.find('$') == std::string::npos && !bench::readWorldSpec(world).isSdf) failParameter(name, "'" + file + "' is no SDF world");
        return;
    }
    if (world.find("${" + name + "}") == std::string::npos) failParameter(name, "unknown in '" + world + "'; known: " + knownNames());
}

void setProperties(const scenes::Scene &scene, const Values &values) {
    for (const auto &[name, value] : values) {
        const Property *const property = findProperty(name);
        if (property == nullptr) continue;
        for (const dWorldID world : scene.inventory().worlds) {
            if (property->kind == Kind::Solver)
                setSolver(world, value.get<std::string>());
            else
                property->set(world, property->kind == Kind::Switch ? value.get<bool>() : value.get<double>());
        }
    }
}

bool changesElements(const Values &values) {
    return std::any_of(values.begin(), values.end(), [](const auto &value) { return isPath(value.first); });
}

std::string changeElements(const std::string &sdf, const std::string &file, const Values &values) {
    tinyxml2::XMLDocument document;
    if (document.Parse(sdf.data(), sdf.size()) != tinyxml2::XML_SUCCESS) return sdf;  // the loader says what is wrong
    for (const auto &[path, value] : values) {
        if (!isPath(path)) continue;
        std::string text = spelled(value);
        for (const auto &[name, other] : values) insertValue(text, name, other);
        if (text.find("${") != std::string::npos) failParameter(path, "'" + text + "' names a parameter that there is not");
        changeElement(document, file, path, text);
    }
    tinyxml2::XMLPrinter printer;
    document.Print(&printer);
    return printer.CStr();
}

}  // namespace batch
