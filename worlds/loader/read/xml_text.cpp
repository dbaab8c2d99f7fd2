#include "loader/read/xml_text.h"

#include "loader/load_error.h"
#include "support/text.h"

#include <expat.h>
#include <strings.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

namespace worlds {

namespace {

// tinyxml2 looks every attribute up among those before it.
constexpr std::size_t maxAttributes = 100, longestName = 1000;
// tinyxml2 itself ends at 100, its document and texts counted.
constexpr int deepest = 90;

// Stops at what the parser knows and tinyxml2 does not.
struct Limits {
    XML_Parser parser;
    std::string wrong;
    int depth = 0;

    void stop(const std::string &what) {
        wrong = what;
        XML_StopParser(parser, XML_FALSE);
    }
};

void onDeclaration(void *data, const char *version, const char *encoding, int) {
    Limits &limits = *static_cast<Limits *>(data);
    if (version && std::string(version) != "1.0")
        return limits.stop("XML of version " + support::quote(version) + ", not 1.0");
    if (encoding && ::strcasecmp(encoding, "UTF-8") != 0 && ::strcasecmp(encoding, "US-ASCII") != 0)
        limits.stop("XML in encoding " + support::quote(encoding) + ", neither UTF-8 nor US-ASCII");
}

void onDocumentType(void *data, const char *, const char *, const char *, int) {
    static_cast<Limits *>(data)->stop("XML with a document type");
}

void onElement(void *data, const char *name, const char **attributes) {
    Limits &limits = *static_cast<Limits *>(data);
    std::size_t count = 0, longest = std::strlen(name);
    for (; *attributes; attributes += 2, ++count) longest = std::max(longest, std::strlen(*attributes));
    if (count > maxAttributes)
        limits.stop("an element with " + std::to_string(count) + " attributes, more than " +
                    std::to_string(maxAttributes));
    if (longest > longestName)
        limits.stop("a name with " + std::to_string(longest) + " characters, more than " +
                    std::to_string(longestName));
    if (++limits.depth > deepest)
        limits.stop("elements in one another, more than " + std::to_string(deepest) + " deep");
}

void onElementEnd(void *data, const char *) { --static_cast<Limits *>(data)->depth; }

// Expat 2.9 deprecates the name that earlier ones have alone.
std::uint64_t currentLine(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
    return XML_GetCurrentLineNumber64(parser);
#else
    return XML_GetCurrentLineNumber(parser);
#endif
}

// The text begins behind `blankLines` others.
std::string whyNotWellFormed(const std::string &text, std::ptrdiff_t blankLines) {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate("UTF-8"),
                                                                         XML_ParserFree);
    if (!parser) throw std::bad_alloc();
    Limits limits{parser.get(), {}, 0};
    XML_SetUserData(parser.get(), &limits);
    XML_SetXmlDeclHandler(parser.get(), onDeclaration);
    XML_SetStartDoctypeDeclHandler(parser.get(), onDocumentType);
    XML_SetElementHandler(parser.get(), onElement, onElementEnd);
    constexpr std::size_t longestPart = 1u << 24;  // its length is an int to the parser
    for (std::size_t at = 0, length = 0;; at += length) {
        length = std::min(text.size() - at, longestPart);
        const bool isLast = at + length == text.size();
        if (XML_Parse(parser.get(), text.data() + at, static_cast<int>(length), isLast) != XML_STATUS_OK)
            break;
        if (isLast) return {};
    }
    const XML_Error error = XML_GetErrorCode(parser.get());
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    const std::string line =
        "line " + std::to_string(static_cast<std::uint64_t>(blankLines) + currentLine(parser.get())) + ": ";
    if (!limits.wrong.empty()) return line + limits.wrong + ": not supported";
    return "not well-formed XML, " + line + XML_ErrorString(error);
}

std::string lineAt(const std::string &text, std::size_t at) {
    return "line " + std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Where the declaration begins when nothing but blanks and comments stands before it; else 0.
std::size_t declarationIn(const std::string &text) {
    std::size_t at = text.find_first_not_of(" \t\r\n");
    while (at != std::string::npos && text.compare(at, 4, "<!--") == 0) {
        const std::size_t end = text.find("-->", at + 4);
        at = end == std::string::npos ? end : text.find_first_not_of(" \t\r\n", end + 3);
    }
    return at != std::string::npos && text.compare(at, 5, "<?xml") == 0 ? at : 0;
}

// Gazebo reads what stands before the declaration, and "--" within a comment, which are not well-formed. Lines stay what
// they are. `faults` is told of the first such comment.
std::string withoutHyphensInComments(std::string text, std::vector<std::string> &faults) {
    bool isKnown = false;
    for (std::size_t at = text.find("<!"); at != std::string::npos; at = text.find("<!", at)) {
        const bool isComment = text.compare(at, 4, "<!--") == 0,
                   isCData = text.compare(at, 9, "<![CDATA[") == 0;
        const std::size_t inside = at + (isComment ? 4 : 2);
        const std::size_t end = isComment || isCData ? text.find(isComment ? "-->" : "]]>", inside) : inside;
        if (end == std::string::npos) break;
        if (isComment && !isKnown && (text.find("--", inside) < end || (end > inside && text[end - 1] == '-'))) {
            isKnown = true;
            faults.push_back("not well-formed XML, " + lineAt(text, inside) + ": a comment holds '--'");
        }
        if (isComment) std::replace(text.begin() + inside, text.begin() + end, '-', ' ');
        at = end;
    }
    return text;
}

}  // namespace

std::string readXml(const std::string &text, tinyxml2::XMLDocument &xml, std::vector<std::string> *faults) {
    std::vector<std::string> found;
    std::string readable = withoutHyphensInComments(text, found);
    const std::size_t declaration = declarationIn(text);
    const auto linesBefore = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(declaration), '\n');
    if (declaration > 0) {
        readable.erase(0, declaration);
        found.push_back("not well-formed XML, " + lineAt(text, declaration) + ": the declaration <?xml is not at the very beginning");
    }
    const std::string wrong = whyNotWellFormed(readable, linesBefore);
    if (!wrong.empty()) return wrong;
    if (xml.Parse(readable.data(), readable.size()) != tinyxml2::XML_SUCCESS)
        return "not XML that can be read, line " + std::to_string(linesBefore + xml.ErrorLineNum()) + ": " +
               xml.ErrorName();
    if (faults) faults->insert(faults->end(), found.begin(), found.end());
    return {};
}

std::string wholeText(const tinyxml2::XMLElement &element) {
    std::string text;
    for (const tinyxml2::XMLNode *node = element.FirstChild(); node; node = node->NextSibling())
        text += node->ToText() ? node->Value() : " ";
    const std::size_t begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

}  // namespace worlds
