#include "rule_world.h"

#include "support/text.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace rule_world {

namespace {

using tinyxml2::XMLElement;
using worlds::ElementRule;
using worlds::NamedRule;
using worlds::Type;

bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

// "link/pose" as /sdf/world/model/link/pose.
std::vector<std::string> chainOf(const std::string &path) {
    static const std::map<std::string, std::string> around = {{"", ""},
                                                              {"world", "sdf/"},
                                                              {"model", "sdf/world/"},
                                                              {"link", "sdf/world/model/"},
                                                              {"joint", "sdf/world/model/"},
                                                              {"collision", "sdf/world/model/link/"}};
    const std::string first = path.substr(0, path.find('/'));
    return support::split(around.at(first) + (first.empty() ? path.substr(1) : path), '/');
}

std::string jointType(const std::string &path) {
    if (contains(path, "suspension")) return "revolute2";
    if (contains(path, "axis2")) return "universal";
    if (path == "joint/axis/limit/lower" || path == "joint/axis/limit/upper") return "prismatic";
    return path == "joint/physics/ode/erp" ? "ball" : "revolute";
}

void setAttributes(XMLElement &element, const NamedRule &rule) {
    const std::string &path = rule.path;
    const std::string name = element.Name();
    static const std::map<std::string, std::string> names = {
        {"world", "w"}, {"model", "m"}, {"link", "l"}, {"collision", "c"}, {"frame", "f"}, {"joint", "j"}};
    if (names.count(name)) element.SetAttribute("name", names.at(name).c_str());
    if (name == "sdf") element.SetAttribute("version", worlds::versionName(std::min(rule.rule.until, 9)).c_str());
    if (name == "physics" && contains(path, "world/")) element.SetAttribute("type", "ode");
    if (name == "joint") element.SetAttribute("type", jointType(path).c_str());
    if (name == "odemt:space") element.SetAttribute("type", contains(path, "level") ? "hash" : "quadtree");
}

XMLElement &add(XMLElement &parent, const std::string &name, const std::string &text = {}) {
    XMLElement *child = parent.InsertNewChildElement(name.c_str());
    if (!text.empty()) child->SetText(text.c_str());
    return *child;
}

XMLElement &addNamed(XMLElement &parent, const std::string &type, const std::string &name) {
    XMLElement &child = add(parent, type);
    child.SetAttribute("name", name.c_str());
    return child;
}

// What the innermost element, or one around it, needs besides the chain.
void complete(XMLElement &element, const std::string &next, const std::string &path) {
    const std::string name = element.Name();
    const auto missing = [&](const std::string &child) {
        return child != next && !element.FirstChildElement(child.c_str());
    };
    if (name == "model") {
        if (missing("link")) addNamed(element, "link", "l");
        if (next == "joint" || path == "model/joint") {
            addNamed(element, "link", "a");
            addNamed(element, "link", "b");
        }
        if (contains(path, "plane") || contains(path, "heightmap")) add(element, "static", "true");
    }
    if (name == "joint") {
        if (missing("parent")) add(element, "parent", "a");
        if (missing("child")) add(element, "child", "b");
        const bool hasTwo = contains(path, "axis2") || contains(path, "suspension");
        if (missing("axis") && jointType(path) != "ball") add(add(element, "axis"), "xyz", "0 0 1");
        if (missing("axis2") && hasTwo) add(add(element, "axis2"), "xyz", "0 1 0");
    }
    if (name == "axis2" && next != "xyz") add(element, "xyz", "0 1 0");
    if (name == "collision" && missing("geometry"))
        add(add(add(element, "geometry"), "sphere"), "radius", "1");
    if (name == "geometry" && next.empty()) add(add(element, "sphere"), "radius", "1");
    if (name == "include" && next == "placement_frame") add(element, "pose", "0 0 0 0 0 0");
    if (name == "include" && missing("uri")) add(element, "uri", "part.sdf");
    if (name == "mesh" && missing("uri")) add(element, "uri", "cube.obj");
    if (name == "heightmap" && missing("uri")) add(element, "uri", "flat.pgm");
    if (name == "box" && missing("size")) add(element, "size", "1 1 1");
    if (name == "sphere" || name == "cylinder" || name == "capsule") {
        if (missing("radius")) add(element, "radius", "1");
        if (name != "sphere" && missing("length")) add(element, "length", "1");
    }
}

std::string numbers(const ElementRule &rule) {
    const double number = std::clamp(1.0, rule.least, rule.most);
    std::ostringstream text;
    for (int i = 0; i < rule.count; ++i) text << (i ? " " : "") << number;
    return text.str();
}

}  // namespace

RuleWorld::RuleWorld(const NamedRule &rule) {
    const std::vector<std::string> chain = chainOf(rule.path);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        XMLElement *inner = xml.NewElement(chain[i].c_str());
        if (element)
            element->InsertEndChild(inner);
        else
            xml.InsertEndChild(inner);
        element = inner;
        setAttributes(*element, rule);
        complete(*element, i + 1 < chain.size() ? chain[i + 1] : "", rule.path);
        const char *name = element->Attribute("name");
        path += "/" + chain[i] + (name && chain[i] != "world" ? "[" + std::string(name) + "]" : "");
    }
    const std::string text = sample(rule);
    if (!text.empty()) element->SetText(text.c_str());
    if (rule.path == "/sdf") addNamed(*element, "world", "w");
}

std::string RuleWorld::text() const {
    tinyxml2::XMLPrinter printer;
    xml.Print(&printer);
    return printer.CStr();
}

void RuleWorld::addCompany() {
    XMLElement &world = *xml.RootElement()->FirstChildElement("world");
    XMLElement &floor = addNamed(world, "model", "floor");
    add(floor, "static", "true");
    add(add(addNamed(addNamed(floor, "link", "l"), "collision", "c"), "geometry"), "plane");
    XMLElement &ball = addNamed(addNamed(world, "model", "ball"), "link", "l");
    add(ball, "pose", "0.3 0.2 0.95 0 0 0");
    add(add(add(addNamed(ball, "collision", "c"), "geometry"), "sphere"), "radius", "1");
}

bool RuleWorld::moveModelTo(const std::string &modelFile) {
    XMLElement *world = xml.RootElement()->FirstChildElement("world");
    XMLElement *model = world ? world->FirstChildElement("model") : nullptr;
    if (!model) return false;
    tinyxml2::XMLDocument included;
    XMLElement *root = included.NewElement("sdf");
    root->SetAttribute("version", xml.RootElement()->Attribute("version"));
    included.InsertEndChild(root);
    root->InsertEndChild(model->DeepClone(&included));
    included.SaveFile(modelFile.c_str());
    world->DeleteChild(model);
    element = nullptr;
    add(add(*world, "include"), "uri", modelFile);
    return true;
}

std::string sample(const NamedRule &named) {
    static const std::map<std::string, std::string> texts = {{"joint/parent", "a"},
                                                             {"joint/child", "b"},
                                                             {"collision/geometry/mesh/uri", "cube.obj"},
                                                             {"collision/geometry/heightmap/uri", "flat.pgm"},
                                                             {"joint/axis2/xyz", "0 1 0"},
                                                             {"link/inertial/inertia/ixy", "0"},
                                                             {"link/inertial/inertia/ixz", "0"},
                                                             {"link/inertial/inertia/iyz", "0"},
                                                             {"world/gravity", "0 0 -9.8"},
                                                             {"joint/axis/limit/effort", "5"}};
    if (const auto found = texts.find(named.path); found != texts.end()) return found->second;
    const std::string last = named.path.substr(named.path.rfind('/') + 1);
    const ElementRule &rule = named.rule;
    switch (rule.type) {
        case Type::Text:
            return last == "uri" ? "part.sdf" : last == "placement_frame" ? "l" : "n";
        case Type::Choice:
            return rule.choices.front();
        case Type::Flag:
            return "true";
        case Type::Pose:
            return "0 0 0 0 0 0";
        case Type::Direction:
            return "0 0 1";
        case Type::Whole:
        case Type::Mask:
        case Type::Limit:
        case Type::Numbers:
            return numbers(rule);
        default:
            return {};
    }
}

void writeFiles(const std::string &folder) {
    std::ofstream(folder + "/cube.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::ofstream(folder + "/flat.pgm", std::ios::binary) << "P5\n2 2\n255\n" << std::string(4, '\x80');
    std::ofstream(folder + "/part.sdf") << "<sdf version=\"1.9\"><model name=\"part\"><link name=\"l\"/>"
                                           "</model></sdf>";
}

}  // namespace rule_world
