#include "worlds/xml_tree.h"

namespace fuzz_worlds {

namespace {

void collect(XMLElement &element, std::vector<XMLElement *> &all) {
    all.push_back(&element);
    for (XMLElement *child = element.FirstChildElement(); child; child = child->NextSiblingElement())
        collect(*child, all);
}

bool isTrue(const XMLElement *flag) {
    const std::string text = flag && flag->GetText() ? flag->GetText() : "";
    return text == "true" || text == "1" || text == "True" || text == "TRUE";
}

void collectInside(XMLElement &outer, const std::string &path, const worlds::ElementRule &rule,
                   bool isInStatic, std::vector<RuledElement> &all) {
    for (XMLElement *child = outer.FirstChildElement(); child; child = child->NextSiblingElement()) {
        all.push_back({child, path, &rule, isInStatic});
        collectInside(*child, path, rule, isInStatic, all);
    }
}

void collectRuled(XMLElement &parent, const std::string &context, bool isInStatic,
                  std::vector<RuledElement> &all) {
    for (XMLElement *child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
        const std::string path = context + "/" + child->Name();
        const worlds::ElementRule *rule = worlds::findElementRule(path);
        if (!rule || (rule->use != worlds::Use::Read && rule->use != worlds::Use::ReadBySelf)) continue;
        const bool isStatic = isInStatic || isTrue(child->FirstChildElement("static"));
        all.push_back({child, path, rule, isStatic});
        if (rule->use == worlds::Use::ReadBySelf)
            collectInside(*child, path, *rule, isStatic, all);
        else
            collectRuled(*child, worlds::elementContext(path), isStatic, all);
    }
}

// Which of the siblings with the same shown name it is.
int numberOf(const XMLElement &element) {
    int number = 0;
    const std::string name = shownName(element);
    for (const XMLElement *before = element.PreviousSiblingElement(); before;
         before = before->PreviousSiblingElement())
        if (shownName(*before) == name) ++number;
    return number;
}

}  // namespace

std::unique_ptr<XMLDocument> parseXml(const std::string &text) {
    auto xml = std::make_unique<XMLDocument>();
    if (xml->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || !xml->RootElement()) return nullptr;
    return xml;
}

std::string printXml(const XMLDocument &xml) {
    tinyxml2::XMLPrinter printer;
    xml.Print(&printer);
    return printer.CStr();
}

std::string textOf(const XMLElement &element) { return element.GetText() ? element.GetText() : ""; }

std::vector<XMLElement *> elementsOf(XMLDocument &xml) {
    std::vector<XMLElement *> all;
    collect(*xml.RootElement(), all);
    return all;
}

std::string shownName(const XMLElement &element) {
    const std::string type = element.Name();
    const char *name = type == "world" || type == "physics" ? nullptr : element.Attribute("name");
    return name ? type + "[" + name + "]" : type;
}

std::string pathOf(const XMLElement &element) {
    const tinyxml2::XMLNode *parent = element.Parent();
    const std::string outer = parent && parent->ToElement() ? pathOf(*parent->ToElement()) : "";
    const int number = numberOf(element);
    return outer + "/" + shownName(element) + (number > 0 ? "#" + std::to_string(number) : "");
}

XMLElement *findElement(XMLDocument &xml, const std::string &path) {
    for (XMLElement *element : elementsOf(xml))
        if (pathOf(*element) == path) return element;
    return nullptr;
}

std::vector<RuledElement> ruledElements(XMLDocument &xml) {
    std::vector<RuledElement> all;
    XMLElement &root = *xml.RootElement();
    if (std::string(root.Name()) != "sdf") return all;
    const bool isIncluded = root.FirstChildElement("world") == nullptr;
    collectRuled(root, isIncluded ? "world" : "/sdf", false, all);
    return all;
}

}  // namespace fuzz_worlds
