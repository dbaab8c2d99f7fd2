#include "worlds/tree_mutation.h"

#include "driver/drawn_text.h"
#include "rule_world.h"

#include <algorithm>
#include <sstream>

namespace fuzz_worlds {

namespace {

using fuzz_driver::Random;

const std::vector<std::string> &attributeNames() {
    static const std::vector<std::string> names = {
        "name",           "type",     "version",         "relative_to", "attached_to",     "frame",
        "expressed_in",   "filename", "merge",           "degrees",     "rotation_format", "placement_frame",
        "canonical_link", "default",  "joint",           "wave",        "duration",        "count",
        "xmlns:odemt",    "odemt:x",  "placement_frame", "phase",       "start",           "least",
        "most",           "url"};
    return names;
}

const std::vector<std::string> &elementNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = {"include",
                                        "model",
                                        "joint",
                                        "plugin",
                                        "frame",
                                        "axis2",
                                        "visual",
                                        "sensor",
                                        "actor",
                                        "state",
                                        "joints",
                                        "phase",
                                        "repeat",
                                        "wave",
                                        "swing",
                                        "hold",
                                        "gain",
                                        "cycle",
                                        "seed",
                                        "use_parent_model_frame",
                                        "polyline",
                                        "ellipsoid",
                                        "experimental:params",
                                        "sdf",
                                        "world",
                                        "parent",
                                        "child",
                                        "pose",
                                        "uri"};
        for (const worlds::NamedRule &rule : worlds::elementRules())
            all.push_back(rule.path.substr(rule.path.rfind('/') + 1));
        return all;
    }();
    return names;
}

// Names of parts and attributes that occur in the tree.
std::string drawWordOf(const std::vector<XMLElement *> &elements, Random &random) {
    static const std::vector<std::string> reserved = {"world", "__model__", "__root__", "__world__",
                                                      "",      "m::a",      "::",       "nested::x"};
    if (random.oneIn(4)) return random.of(reserved);
    for (int tries = 0; tries < 20; ++tries)
        if (const char *name = random.of(elements)->Attribute("name")) return name;
    return "m";
}

std::vector<std::string> wordsOf(const std::string &text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

void setText(XMLElement &element, const std::string &text) {
    element.DeleteChildren();
    element.SetText(text.c_str());
}

// An element whose text is all that it holds, if there is one.
XMLElement *drawLeaf(const std::vector<XMLElement *> &elements, Random &random) {
    for (int tries = 0; tries < 30; ++tries)
        if (XMLElement *element = random.of(elements); !element->FirstChildElement() && element->GetText())
            return element;
    return nullptr;
}

void replaceNumber(XMLElement &leaf, Random &random) {
    std::vector<std::string> words = wordsOf(textOf(leaf));
    if (words.empty()) return;
    switch (random.below(4)) {
        case 0:
            words.insert(words.begin() + static_cast<std::ptrdiff_t>(random.below(words.size() + 1)),
                         fuzz_driver::drawNumber(random));
            break;
        case 1:
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(random.below(words.size())));
            break;
        default:
            words[random.below(words.size())] = fuzz_driver::drawNumber(random);
    }
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : " ") + word;
    setText(leaf, text);
}

void moveOrCopy(XMLDocument &xml, XMLElement &element, XMLElement &target, bool copies) {
    for (const tinyxml2::XMLNode *at = &target; at; at = at->Parent())
        if (at == &element && !copies) return;  // into itself
    if (&element == xml.RootElement() && !copies) return;
    target.InsertEndChild(copies ? element.DeepClone(&xml) : &element);
}

// The element inside ever more copies of its parent's kind: "model in model in model".
void nest(XMLDocument &xml, XMLElement &element, Random &random) {
    if (&element == xml.RootElement()) return;
    const std::size_t depth = 1 + random.below(random.oneIn(6) ? 400 : 8);
    XMLElement *inner = &element;
    for (std::size_t i = 0; i < depth; ++i) {
        auto *around = static_cast<XMLElement *>(inner->ShallowClone(&xml));
        inner->Parent()->InsertAfterChild(inner, around);
        around->InsertEndChild(inner);
    }
}

void addKnownElement(XMLElement &parent, Random &random) {
    const worlds::NamedRule &rule = random.of(worlds::elementRules());
    const std::string name = rule.path.substr(rule.path.rfind('/') + 1);
    XMLElement *child = parent.InsertNewChildElement(name.c_str());
    const std::string text = random.oneIn(3) ? fuzz_driver::drawText(random) : rule_world::sample(rule);
    if (!text.empty()) child->SetText(text.c_str());
}

void addOddNode(XMLDocument &xml, XMLElement &parent, Random &random) {
    switch (random.below(4)) {
        case 0:
            parent.InsertFirstChild(xml.NewComment(" - "));
            break;
        case 1:
            parent.InsertEndChild(xml.NewText(fuzz_driver::drawText(random).c_str()));
            break;
        case 2:
            parent.InsertEndChild(xml.NewUnknown("ENTITY x \"y\""));
            break;
        default:
            parent.InsertEndChild(xml.NewDeclaration("xml version=\"1.0\""));
    }
}

void swapTexts(XMLElement &one, XMLElement &other) {
    const std::string first = textOf(one), second = textOf(other);
    setText(one, second);
    setText(other, first);
}

void changeAttribute(XMLElement &element, const std::vector<XMLElement *> &all, Random &random) {
    std::vector<std::string> names;
    for (const tinyxml2::XMLAttribute *at = element.FirstAttribute(); at; at = at->Next())
        names.push_back(at->Name());
    const bool isNew = names.empty() || random.oneIn(3);
    const std::string name = isNew ? random.of(attributeNames()) : random.of(names);
    if (!isNew && random.oneIn(3)) return element.DeleteAttribute(name.c_str());
    const std::string value = random.oneIn(2) ? drawWordOf(all, random) : fuzz_driver::drawText(random);
    element.SetAttribute(name.c_str(), value.c_str());
}

// References to frames, links, joints and files.
void changeReference(const std::vector<XMLElement *> &all, Random &random,
                     const std::vector<std::string> &files) {
    static const std::vector<std::string> byText = {"parent", "child", "joints", "placement_frame", "name"};
    std::vector<XMLElement *> referring;
    for (XMLElement *element : all)
        if (const std::string name = element->Name();
            name == "uri" || std::find(byText.begin(), byText.end(), name) != byText.end())
            referring.push_back(element);
    if (!referring.empty() && random.oneIn(2)) {
        XMLElement &element = *random.of(referring);
        return setText(element,
                       element.Name() == std::string("uri") ? random.of(files) : drawWordOf(all, random));
    }
    XMLElement &element = *random.of(all);
    const std::string name = element.Name();
    const char *const attribute = name == "frame"  ? "attached_to"
                                  : name == "pose" ? "relative_to"
                                  : name == "xyz"  ? "expressed_in"
                                                   : "name";
    element.SetAttribute(attribute, drawWordOf(all, random).c_str());
}

}  // namespace

void mutateTree(XMLDocument &xml, Random &random, const std::vector<std::string> &files) {
    const std::vector<XMLElement *> all = elementsOf(xml);
    XMLElement &element = *random.of(all);
    XMLElement *leaf = drawLeaf(all, random);
    switch (random.below(18)) {
        case 0:
            if (&element != xml.RootElement()) element.Parent()->DeleteChild(&element);
            break;
        case 1:
            if (&element != xml.RootElement())
                element.Parent()->InsertAfterChild(&element, element.DeepClone(&xml));
            break;
        case 2:
        case 3:
            moveOrCopy(xml, element, *random.of(all), random.oneIn(2));
            break;
        case 4:
            element.SetName(random.of(elementNames()).c_str());
            break;
        case 5:
        case 6:
            changeAttribute(element, all, random);
            break;
        case 7:
            if (leaf) setText(*leaf, fuzz_driver::drawText(random));
            break;
        case 8:
        case 9:
        case 10:
        case 11:
            if (leaf) replaceNumber(*leaf, random);
            break;
        case 12:
            if (XMLElement *other = drawLeaf(all, random); leaf && other) swapTexts(*leaf, *other);
            break;
        case 13:
            addKnownElement(element, random);
            break;
        case 14:
            nest(xml, element, random);
            break;
        case 15:
            addOddNode(xml, element, random);
            break;
        default:
            changeReference(all, random, files);
    }
}

}  // namespace fuzz_worlds
