#include "worlds/spelling.h"

#include "worlds/xml_tree.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

namespace fuzz_worlds {

namespace {

using fuzz_driver::Random;
using worlds::ElementRule;
using worlds::Type;

using Rules = std::map<const XMLElement *, const ElementRule *>;

bool isNumeric(Type type) {
    return type == Type::Numbers || type == Type::Limit || type == Type::Direction || type == Type::Pose;
}

std::vector<std::string> wordsOf(const std::string &text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// The same number; a whole one stays written in digits alone.
std::string respellNumber(const std::string &word, bool isWhole, Random &random) {
    if (word.find_first_not_of("+-.0123456789eE") != std::string::npos) return word;  // inf
    const bool isSigned = word[0] == '-' || word[0] == '+';
    const std::string digits = isSigned ? word.substr(1) : word;
    const std::string sign = isSigned ? word.substr(0, 1) : "";
    const bool hasExponent = word.find_first_of("eE") != std::string::npos,
               hasPoint = word.find('.') != std::string::npos;
    switch (random.below(isWhole ? 2 : 5)) {
        case 0:
            return sign.empty() ? "+" + word : word;
        case 1:
            return sign + "00" + digits;
        case 2:
            return hasExponent ? word : hasPoint ? word + "000" : word + ".0";
        case 3:
            return hasExponent ? word : word + "e0";
        default:
            return hasExponent ? word : word + (hasPoint ? "0E+00" : ".E-0");
    }
}

std::string respellFlag(const std::string &word, Random &random) {
    static const std::vector<std::string> yes = {"true", "1", "True", "TRUE"},
                                          no = {"false", "0", "False", "FALSE"};
    if (std::count(yes.begin(), yes.end(), word)) return random.of(yes);
    return std::count(no.begin(), no.end(), word) ? random.of(no) : word;
}

std::string escaped(const std::string &text, char quote) {
    std::string plain;
    for (const char c : text) {
        if (c == '&')
            plain += "&amp;";
        else if (c == '<')
            plain += "&lt;";
        else if (c == '>')
            plain += "&gt;";
        else if (c == '\n' && quote)
            plain += "&#10;";
        else if (c == quote)
            plain += quote == '"' ? "&quot;" : "&apos;";
        else
            plain += c;
    }
    return plain;
}

// Writes a tree down. Whatever has no rule is written as it is.
class Speller {
public:
    Speller(const std::vector<Spelling> &ways, std::uint64_t seed, const Rules &rules)
        : m_ways(ways.begin(), ways.end()), m_random(seed), m_rules(rules) {}

    std::string document(const XMLDocument &xml) {
        std::string text = has(Spelling::Mark) ? "\xef\xbb\xbf" : "";
        if (!has(Spelling::Declaration)) text += "<?xml version=\"1.0\"?>" + lineEnd();
        if (has(Spelling::Comments)) text += "<!-- before -->" + lineEnd();
        text += element(*xml.RootElement(), 0);
        if (has(Spelling::Comments)) text += "<!-- behind -->";
        return text + lineEnd();
    }

private:
    bool has(Spelling way) const { return m_ways.count(way) > 0; }
    std::string lineEnd() const { return has(Spelling::LineEnds) ? "\r\n" : "\n"; }
    std::string indentation(int depth) {
        return has(Spelling::Indentation) ? "" : std::string(static_cast<std::size_t>(depth), '\t');
    }

    const ElementRule *ruleOf(const XMLElement &element) const {
        const auto found = m_rules.find(&element);
        return found == m_rules.end() || found->second->use != worlds::Use::Read ? nullptr : found->second;
    }

    std::string element(const XMLElement &element, int depth) {
        const ElementRule *rule = ruleOf(element);
        std::string text = "<" + std::string(element.Name()) + attributes(element);
        if (element.NoChildren()) return text + "/>";
        text += ">";
        const bool isGroup = rule && rule->type == Type::Group;
        for (const tinyxml2::XMLNode *child : children(element, isGroup)) {
            if (isGroup) text += lineEnd() + indentation(depth + 1);
            if (isGroup && has(Spelling::Comments) && m_random.oneIn(3))
                text += "<!-- here - \"stands\" <nothing/> -->";
            text += node(*child, rule, depth + 1);
        }
        if (isGroup) text += lineEnd() + indentation(depth);
        return text + "</" + element.Name() + ">";
    }

    // Elements that may occur once each may be in any order.
    std::vector<const tinyxml2::XMLNode *> children(const XMLElement &element, bool isGroup) {
        std::vector<const tinyxml2::XMLNode *> all;
        bool isAnyOrder = isGroup && has(Spelling::Order);
        for (const tinyxml2::XMLNode *child = element.FirstChild(); child; child = child->NextSibling()) {
            all.push_back(child);
            const XMLElement *inner = child->ToElement();
            const ElementRule *rule = inner ? ruleOf(*inner) : nullptr;
            isAnyOrder = isAnyOrder && rule && rule->often == worlds::Often::Once;
        }
        if (isAnyOrder) std::reverse(all.begin(), all.end());
        return all;
    }

    std::string attributes(const XMLElement &element) {
        std::vector<std::string> all;
        const char quote = has(Spelling::Attributes) ? '\'' : '"';
        for (const tinyxml2::XMLAttribute *at = element.FirstAttribute(); at; at = at->Next()) {
            const std::string blank = has(Spelling::Attributes) ? " \n" : " ",
                              equals = has(Spelling::Attributes) ? " = " : "=";
            all.push_back(blank + at->Name() + equals + quote + escaped(at->Value(), quote) + quote);
        }
        if (has(Spelling::Attributes)) std::reverse(all.begin(), all.end());
        std::string text;
        for (const std::string &attribute : all) text += attribute;
        return text;
    }

    std::string node(const tinyxml2::XMLNode &node, const ElementRule *rule, int depth) {
        if (const XMLElement *inner = node.ToElement()) return element(*inner, depth);
        if (const tinyxml2::XMLText *text = node.ToText()) return value(text->Value(), rule);
        return {};  // comments that were there
    }

    std::string value(const std::string &text, const ElementRule *rule) {
        if (!rule || rule->type == Type::Any || rule->type == Type::Group) return escaped(text, 0);
        std::vector<std::string> words = wordsOf(text);
        if (rule->type == Type::Text || words.empty()) return escaped(text, 0);  // blanks within a name count
        for (std::string &word : words) {
            if (has(Spelling::Numbers) && (isNumeric(rule->type) || rule->type == Type::Whole))
                word = respellNumber(word, rule->type == Type::Whole, m_random);
            if (has(Spelling::Flags) && rule->type == Type::Flag) word = respellFlag(word, m_random);
            if (has(Spelling::References)) word = referenced(word);
        }
        const std::string comment = has(Spelling::CommentsInText) ? "<!-- 1 -->" : "";
        std::string whole = comment + (has(Spelling::Blanks) ? " \n\t" : "");
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (i > 0)
                whole += (has(Spelling::Blanks) ? " \t\n " : " ") +
                         (m_random.oneIn(3) ? comment + (comment.empty() ? "" : " ") : "");
            whole += words[i];
        }
        whole += (has(Spelling::Blanks) ? "\n " : "") + comment;
        return has(Spelling::Cdata) && comment.empty() && !has(Spelling::References)
                   ? "<![CDATA[" + whole + "]]>"
                   : whole;
    }

    static std::string referenced(const std::string &word) {
        std::string text;
        for (const char c : word)
            text += "&#" + std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + ";";
        return text;
    }

    const std::set<Spelling> m_ways;
    Random m_random;
    const Rules &m_rules;
};

}  // namespace

const char *nameOf(Spelling spelling) {
    constexpr const char *names[kSpellings] = {
        "indentation", "comments", "comments in values",   "attributes", "numbers",     "flags",
        "blanks",      "CDATA",    "character references", "line ends",  "declaration", "byte order mark",
        "order"};
    return names[static_cast<int>(spelling)];
}

WorldCase respelled(const WorldCase &world, const std::vector<Spelling> &ways, std::uint64_t seed) {
    WorldCase other = world;
    for (auto &[file, text] : other.files) {
        if (file.size() < 4 || file.compare(file.size() - 4, 4, ".sdf") != 0) continue;
        const auto xml = parseXml(text);
        if (!xml) continue;
        Rules rules;
        if (const XMLElement &root = *xml->RootElement(); root.Name() == std::string("sdf"))
            rules[&root] = worlds::findElementRule("/sdf");
        for (const RuledElement &ruled : ruledElements(*xml)) rules[ruled.element] = ruled.rule;
        text = Speller(ways, seed, rules).document(*xml);
    }
    return other;
}

}  // namespace fuzz_worlds
