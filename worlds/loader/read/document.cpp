#include "loader/read/document.h"

#include "loader/read/element_check.h"
#include "loader/read/element_path.h"

#include <tinyxml2.h>
#include <sdf/Console.hh>
#include <sdf/Exception.hh>
#include <sdf/parser.hh>
#include <sdf/SDFImpl.hh>
#include <sdf/World.hh>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace worlds {

namespace {

std::string line(const std::string &text, int number) {
    std::istringstream stream(text);
    std::string found;
    for (int i = 0; i < number; ++i)
        if (!std::getline(stream, found)) return {};
    const std::size_t begin = found.find_first_not_of(" \t");
    return begin == std::string::npos ? std::string() : found.substr(begin);
}

// libsdformat reports an element that it cannot read by position alone: the line shows what is wrong.
LoadError toLoadError(const sdf::Error &error, const std::string &text, const std::string &file) {
    Place place{file, shortPath(error.XmlPath().value_or(""))};
    const std::string source = error.FilePath().value_or("<data-string>");
    const bool inWorldFile = source == "<data-string>";
    if (!inWorldFile) place.file = source;
    std::string message = error.Message();
    message.erase(message.find_last_not_of(" \n") + 1);
    if (const int number = error.LineNumber().value_or(0); number > 0) {
        message += " (line " + std::to_string(number);
        if (inWorldFile) message += ": " + line(text, number);
        message += ")";
    }
    return LoadError(LoadError::Kind::Syntax, place, message);
}

void checkXml(const std::string &text, const std::string &file) {
    tinyxml2::XMLDocument xml;
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Syntax, {file, ""}, what);
    };
    if (xml.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
        throw fail("not well-formed XML, line " + std::to_string(xml.ErrorLineNum()) + ": " +
                   xml.ErrorName());
    const tinyxml2::XMLElement *root = xml.FirstChildElement("sdf");
    if (!root) throw fail("not SDF: the root element is not <sdf>");
    if (!root->Attribute("version")) throw fail("not SDF: <sdf> has no version");
}

bool isUnknownAttribute(const sdf::Error &error) {
    return error.Code() == sdf::ErrorCode::ATTRIBUTE_INCORRECT_TYPE;
}

sdf::ParserConfig parserConfig(const std::string &file, const ResourceFinder &resources) {
    sdf::ParserConfig config;
    config.SetFindCallback([&resources, file](const std::string &uri) { return resources.find(uri, file); });
    config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
    config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);  // named by checkElements
    config.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
    return config;
}

sdf::SDFPtr parse(const std::string &text, const std::string &file, const sdf::ParserConfig &config,
                  const Issues &issues) {
    sdf::SDFPtr document(new sdf::SDF());
    sdf::init(document);
    sdf::Errors errors;
    const bool readable = sdf::readString(text, config, document->Root(), errors);
    for (const sdf::Error &error : errors) {
        const LoadError asOurs = toLoadError(error, text, file);
        if (!isUnknownAttribute(error)) throw asOurs;
        if (readable) issues.unsupported(asOurs.place(), "an attribute here");
    }
    if (!readable) throw LoadError(LoadError::Kind::Syntax, {file, ""}, "libsdformat cannot read it");
    return document;
}

}  // namespace

Document::Document(const std::string &text, const std::string &file, const ResourceFinder &resources,
                   const Issues &issues) {
    sdf::Console::Instance()->SetQuiet(true);  // every error is thrown
    checkXml(text, file);
    try {
        const sdf::ParserConfig config = parserConfig(file, resources);
        const sdf::SDFPtr document = parse(text, file, config, issues);
        checkElements(document->Root(), file, issues);
        const sdf::Errors errors = m_root.Load(document, config);
        if (!errors.empty()) throw toLoadError(errors.front(), text, file);
    } catch (const sdf::Exception &error) {  // no std::exception
        throw LoadError(LoadError::Kind::Syntax, {file, ""}, error.GetErrorStr());
    }
    if (m_root.WorldCount() != 1)
        throw LoadError(LoadError::Kind::Unsupported, {file, "/sdf"}, "more than one <world>");
}

std::string readTextFile(const std::string &file) {
    std::error_code none;  // the stream below tells what is wrong
    if (std::filesystem::is_directory(file, none))
        throw LoadError(LoadError::Kind::File, {file, ""}, "is a folder");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream && stream.peek() == std::ifstream::traits_type::eof())
        throw LoadError(LoadError::Kind::File, {file, ""}, "is empty");
    if (!stream || !(text << stream.rdbuf()))
        throw LoadError(LoadError::Kind::File, {file, ""}, std::strerror(errno));
    return text.str();
}

}  // namespace worlds
