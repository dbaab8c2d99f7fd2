#include "worlds/forbidden_change.h"

#include "worlds/xml_tree.h"

#include <algorithm>

namespace fuzz_worlds {

namespace {

using worlds::ElementRule;
using worlds::Type;
using worlds::Use;

const char *const kUnknown = "odemt_unknown";

bool isNumber(Type type) {
    return type == Type::Numbers || type == Type::Whole || type == Type::Limit || type == Type::Direction;
}

bool isBlank(const std::string &text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

// What can be done to an element by its rule.
std::vector<Forbidden> kindsFor(const RuledElement &ruled) {
    const ElementRule &rule = *ruled.rule;
    const bool isLeaf = ruled.element->FirstChildElement() == nullptr;
    const bool hasText = isLeaf && !isBlank(textOf(*ruled.element));
    if (rule.use == Use::ReadBySelf) {
        std::vector<Forbidden> kinds = {Forbidden::UnknownAttribute};
        if (!hasText) kinds.push_back(Forbidden::UnknownElement);
        if (!isLeaf) kinds.push_back(Forbidden::StrayText);
        return kinds;
    }
    std::vector<Forbidden> kinds = {Forbidden::UnknownAttribute};
    // Of SDF's own elements the first one counts.
    if (rule.often == worlds::Often::Once && ruled.path.find("/odemt:") != std::string::npos)
        kinds.push_back(Forbidden::Doubled);
    if (rule.type == Type::Group) {
        kinds.push_back(Forbidden::StrayText);
        if (!rule.needsOneChild) kinds.push_back(Forbidden::UnknownElement);  // there it is a second one
        return kinds;
    }
    kinds.push_back(Forbidden::ElementInValue);
    if (!hasText) return kinds;  // a pose without numbers is that of its frame
    if (rule.type != Type::Pose) kinds.push_back(Forbidden::Emptied);  // an empty pose is no change
    if (isNumber(rule.type) || rule.type == Type::Pose)
        kinds.insert(kinds.end(), {Forbidden::ExtraNumber, Forbidden::NotANumber, Forbidden::Unit});
    if (rule.type == Type::Pose || rule.count > 1) kinds.push_back(Forbidden::MissingNumber);
    if (rule.type == Type::Whole) kinds.push_back(Forbidden::Fraction);
    if (rule.type == Type::Choice || rule.type == Type::Flag) kinds.push_back(Forbidden::UnknownWord);
    return kinds;
}

// Controllers of what does not move are left aside.
bool isIncludedAsStatic(const WorldCase &world) {
    const auto xml = parseXml(world.world());
    if (!xml) return false;
    const std::vector<RuledElement> all = ruledElements(*xml);
    return std::any_of(all.begin(), all.end(), [](const RuledElement &ruled) {
        return ruled.path.find("include/static") != std::string::npos ||
               (ruled.isInStatic && ruled.path.find("/include") != std::string::npos);
    });
}

const RuledElement *findRuled(const std::vector<RuledElement> &all, const std::string &path) {
    for (const RuledElement &ruled : all)
        if (pathOf(*ruled.element) == path) return &ruled;
    return nullptr;
}

void setText(XMLElement &element, const std::string &text) {
    element.DeleteChildren();
    element.SetText(text.c_str());
}

std::string withoutFirstWord(const std::string &text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n"), end = text.find_first_of(" \t\r\n", begin);
    return end == std::string::npos ? "" : text.substr(end);
}

void change(XMLElement &element, Forbidden kind) {
    XMLDocument &xml = *element.GetDocument();
    const std::string text = textOf(element);
    switch (kind) {
        case Forbidden::UnknownElement:
            element.InsertNewChildElement(kUnknown);
            break;
        case Forbidden::UnknownAttribute:
            element.SetAttribute(kUnknown, "1");
            break;
        case Forbidden::Doubled:
            element.Parent()->InsertAfterChild(&element, element.DeepClone(&xml));
            break;
        case Forbidden::ExtraNumber:
            setText(element, text + " 1");
            break;
        case Forbidden::MissingNumber:
            setText(element, withoutFirstWord(text));
            break;
        case Forbidden::NotANumber:
            setText(element, "nan" + withoutFirstWord(text));
            break;
        case Forbidden::Unit:
            setText(element, text + "m");
            break;
        case Forbidden::Fraction:
            setText(element, text + ".5");
            break;
        case Forbidden::StrayText:
            element.InsertEndChild(xml.NewText("stray"));
            break;
        case Forbidden::UnknownWord:
            setText(element, text + kUnknown);
            break;
        case Forbidden::Emptied:
            setText(element, " ");
            break;
        case Forbidden::ElementInValue:
            element.InsertNewChildElement(kUnknown);
            break;
    }
}

}  // namespace

const char *nameOf(Forbidden kind) {
    constexpr const char *names[] = {"an unknown element in",
                                     "an unknown attribute of",
                                     "doubled",
                                     "a number more in",
                                     "a number less in",
                                     "not a number in",
                                     "a unit in",
                                     "a fraction in",
                                     "text beside elements in",
                                     "an unknown word in",
                                     "emptied",
                                     "an element in place of a value in"};
    return names[static_cast<int>(kind)];
}

std::string ForbiddenChange::text() const { return std::string(nameOf(kind)) + " " + path + " of " + file; }

std::optional<ForbiddenChange> drawForbidden(const WorldCase &world, fuzz_driver::Random &random) {
    std::vector<std::string> files;
    for (const auto &file : world.files)
        if (file.first.size() > 4 && file.first.compare(file.first.size() - 4, 4, ".sdf") == 0)
            files.push_back(file.first);
    const std::string &file = random.oneIn(3) ? random.of(files) : kWorldFile;
    const auto xml = parseXml(world.files.at(file));
    if (!xml) return std::nullopt;
    const std::vector<RuledElement> all = ruledElements(*xml);
    if (all.empty()) return std::nullopt;
    const RuledElement &ruled = random.of(all);
    if (ruled.rule->use == Use::ReadBySelf && (ruled.isInStatic || isIncludedAsStatic(world)))
        return std::nullopt;
    return ForbiddenChange{file, pathOf(*ruled.element), random.of(kindsFor(ruled))};
}

bool apply(const ForbiddenChange &wanted, WorldCase &world, std::string &name) {
    const auto found = world.files.find(wanted.file);
    const auto xml = found == world.files.end() ? nullptr : parseXml(found->second);
    if (!xml) return false;
    const std::vector<RuledElement> all = ruledElements(*xml);
    const RuledElement *ruled = findRuled(all, wanted.path);
    if (!ruled) return false;
    const std::vector<Forbidden> kinds = kindsFor(*ruled);
    if (std::find(kinds.begin(), kinds.end(), wanted.kind) == kinds.end()) return false;
    name = wanted.kind == Forbidden::UnknownElement ? kUnknown : shownName(*ruled->element);
    change(*ruled->element, wanted.kind);
    found->second = printXml(*xml);
    return true;
}

}  // namespace fuzz_worlds
