#include "loader/read/source_tree.h"

#include "loader/read/memory_file.h"
#include "loader/read/model_config.h"
#include "loader/read/regular_file.h"
#include "loader/read/source_check.h"
#include "loader/read/source_place.h"
#include "loader/read/xml_text.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace worlds {

namespace {

using tinyxml2::XMLElement;

constexpr std::size_t deepestInclude = 50;
constexpr std::size_t maxModels = 20000;  // libsdformat takes about 50 kB for each

// Every element is in a line of its own, so a line identifies the element.
std::string print(const tinyxml2::XMLDocument &xml) {
    tinyxml2::XMLPrinter printer;
    xml.Print(&printer);
    return printer.CStr();
}

bool isMerged(const XMLElement &include) {
    const char *merge = include.Attribute("merge");
    return merge && (std::string(merge) == "true" || std::string(merge) == "1");
}

std::string modelFile(const std::string &found, const Place &place, const std::string &uri) {
    std::error_code none;
    if (!fs::is_directory(found, none)) return found;
    return found + "/" + readModelConfig(found, place, uri);
}

std::string canonicalName(const std::string &file, const Place &namedAt) {
    std::error_code error;
    const fs::path canonical = fs::canonical(file, error);
    if (error) throw LoadError(LoadError::Kind::Resource, namedAt, file + ": " + error.message());
    return canonical;
}

}  // namespace

SourceTree::SourceTree(const std::string &text, const std::string &file, const ResourceFinder &resources)
    : m_resources(resources) {
    std::error_code none;  // the text may have come from no file
    const fs::path canonical = fs::canonical(file, none);
    if (!none) m_chain.push_back(canonical);
    readWorld(text, file);
}

SourceTree::~SourceTree() = default;

void SourceTree::readWorld(const std::string &text, const std::string &file) {
    tinyxml2::XMLDocument xml;
    XMLElement &root = parseSdf(text, file, xml);
    m_world.file = file;
    const OnInclude onInclude = [&](XMLElement &element, const Place &place) {
        return include(element, place, file, m_world.modelCount);
    };
    checkSource(root, {file, "/sdf"}, onInclude);
    m_world.text = print(xml);
}

const std::string &SourceTree::nameOf(const std::string &opened) const {
    const auto found = m_byName.find(opened);
    return found == m_byName.end() ? opened : found->second->file;
}

Place SourceTree::placeOf(const std::string &openedOrFile, int line) const {
    const auto found = m_byName.find(openedOrFile);
    const Source &source = found == m_byName.end() ? m_world : *found->second;
    const std::string path = pathOfLine(source.text, line);
    if (path.empty() || found == m_byName.end()) return {source.file, path};
    return {source.file, includedPath(path, source.outerPath, source.givenName)};
}

Place SourceTree::placeNamedIn(const std::string &message) const {
    const std::vector<std::string> names = namesIn(message);
    for (const std::string &name : names) {
        if (const std::string path = pathOfName(m_world.text, name); !path.empty())
            return {m_world.file, path};
        for (const auto &[canonical, source] : m_sources)
            if (const std::string path = pathOfName(source.text, name); !path.empty())
                return {source.file, includedPath(path, source.outerPath, source.givenName)};
    }
    return {m_world.file, "/sdf/world"};
}

// Makes <uri> name what libsdformat should open. Returns the model's name.
std::string SourceTree::include(XMLElement &element, const Place &place, const std::string &file,
                                std::size_t &modelCount) {
    XMLElement *uri = element.FirstChildElement("uri");
    const std::string wanted = uri ? wholeText(*uri) : std::string();
    const Place at{place.file, place.path + "/uri"};
    const std::string found = m_resources.find(wanted, file);
    if (found.empty()) throw LoadError(LoadError::Kind::Resource, at, "no model " + quote(wanted));

    const XMLElement *const name = element.FirstChildElement("name");
    const std::string givenName = name ? wholeText(*name) : std::string();
    if (givenName.find("::") != std::string::npos)
        throw LoadError(LoadError::Kind::Value, {place.file, place.path + "/name"}, "a name may not hold '::'");
    const std::string outer = place.path.substr(0, place.path.rfind("/include"));
    const Source &source = this->source(modelFile(found, at, wanted), at, outer, givenName);
    modelCount += source.modelCount;
    if (modelCount > maxModels)
        throw LoadError(LoadError::Kind::Value, at,
                        "the world includes more than " + std::to_string(maxModels) + " models");
    uri->SetText(source.opened.c_str());
    if (isMerged(element)) return {};
    return givenName.empty() ? source.modelName : givenName;
}

const SourceTree::Source &SourceTree::source(const std::string &file, const Place &includedAt,
                                             const std::string &outerPath, const std::string &givenName) {
    const std::string canonical = canonicalName(file, includedAt);
    if (std::find(m_chain.begin(), m_chain.end(), canonical) != m_chain.end())
        throw LoadError(LoadError::Kind::Value, includedAt, file + " includes itself");
    if (const auto known = m_sources.find(canonical); known != m_sources.end()) return known->second;
    if (m_chain.size() > deepestInclude)
        throw LoadError(LoadError::Kind::Value, includedAt,
                        "includes are nested more than " + std::to_string(deepestInclude) + " deep");
    const std::string wrong = whyNotReadable(file, longestTextFile);
    if (!wrong.empty()) throw LoadError(LoadError::Kind::Resource, includedAt, file + ": " + wrong);

    m_chain.push_back(canonical);
    Source source = readSource(file, outerPath, givenName);
    m_chain.pop_back();
    try {
        source.opened = m_memoryFiles.emplace_back(new MemoryFile(source.text))->name();
    } catch (const std::system_error &error) {  // too many distinct files are included
        throw LoadError(LoadError::Kind::Resource, includedAt, file + ": " + error.what());
    }
    const Source &kept = m_sources[canonical] = std::move(source);
    m_byName[kept.opened] = m_byName[kept.file] = &kept;
    return kept;
}

SourceTree::Source SourceTree::readSource(const std::string &file, const std::string &outerPath,
                                          const std::string &givenName) {
    tinyxml2::XMLDocument xml;
    XMLElement &root = parseSdf(readTextFile(file), file, xml);
    XMLElement *model = root.FirstChildElement("model");
    if (!model || root.FirstChildElement() != model || model->NextSiblingElement())
        throw LoadError(LoadError::Kind::Unsupported, {file, "/sdf"},
                        "an included file has to hold one <model> and nothing else");
    Source source;
    source.file = file;
    source.outerPath = outerPath;
    source.givenName = givenName;
    const char *ownName = model->Attribute("name");
    source.modelName = ownName ? ownName : "";
    source.modelCount = 1;
    const OnInclude onInclude = [&](XMLElement &element, const Place &place) {
        return include(element, place, file, source.modelCount);
    };
    checkIncludedModel(*model, {file, outerPath}, givenName, onInclude);
    source.text = print(xml);
    return source;
}

}  // namespace worlds
