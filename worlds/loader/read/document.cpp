#include "loader/read/document.h"

#include "loader/read/element_check.h"
#include "loader/read/element_rules.h"
#include "loader/read/regular_file.h"
#include "loader/read/xml_text.h"
#include "support/text.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace worlds {

namespace {

constexpr std::size_t deepestInclude = 50;
constexpr std::size_t maxModels = 20000;            // a model of 60 elements takes about 20 kB
constexpr std::uintmax_t longestConfig = 1u << 20;  // bytes
constexpr int kPoseFrames = 6;  // the last version in which a pose names its frame in `frame`

void copy(const tinyxml2::XMLElement &source, Element &element, int version) {
    element.name = source.Name();
    element.text = wholeText(source);
    for (const tinyxml2::XMLAttribute *at = source.FirstAttribute(); at; at = at->Next()) {
        const bool isFrame =
            version <= kPoseFrames && element.name == "pose" && std::string(at->Name()) == "frame";
        element.attributes.emplace_back(isFrame ? "relative_to" : at->Name(), at->Value());
    }
    bool hasCData = false, hasPlain = false;
    for (const tinyxml2::XMLNode *node = source.FirstChild(); node; node = node->NextSibling()) {
        if (const tinyxml2::XMLElement *const inner = node->ToElement())
            copy(*inner, element.add(inner->Name()), version);
        if (const tinyxml2::XMLText *const text = node->ToText())
            (text->CData() ? hasCData : hasPlain) = true;
    }
    element.isCData = hasCData && !hasPlain;
}

// Parses a file's text to `root`, which is its <sdf> element. Returns false for an included one that is left out: of a version
// that is not supported.
bool parse(const std::string &text, const std::string &file, bool isIncluded, const Issues &issues, Element &root) {
    const auto broken = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Syntax, {file, ""}, what);
    };
    tinyxml2::XMLDocument xml;
    std::vector<std::string> faults;
    if (const std::string wrong = readXml(text, xml, &faults); !wrong.empty()) throw broken(wrong);
    for (const std::string &fault : faults) issues.warn({file, ""}, fault + "; read as Gazebo reads it");
    const tinyxml2::XMLElement &sdf = *xml.RootElement();
    if (std::string(sdf.Name()) != "sdf") throw broken("not SDF: the root element is not <sdf>");
    const Place place{file, "/sdf"};
    const char *const name = sdf.Attribute("version");
    if (!name) throw LoadError(LoadError::Kind::Syntax, place, "not SDF: <sdf> has no version");
    const std::optional<int> version = versionNamed(name);
    const std::string supported = versionName(oldestVersion) + " to " + versionName(newestVersion);
    if (!version && isIncluded) {
        issues.unsupported(place, "version " + support::quote(name) + ", none of " + supported);
        return false;
    }
    if (!version)
        throw LoadError(LoadError::Kind::Unsupported, place,
                        "version " + support::quote(name) + ": not supported; " + supported + " are");
    root.source = std::make_shared<SourceFile>(SourceFile{file, *version});
    copy(sdf, root, *version);
    if (!root.text.empty() && !root.isCData) root.fail("holds text: " + support::quote(root.text));
    return true;
}

// Returns the name, within a model's folder, of the file for the newest version of SDF that is supported: as
// model.config says. One without a version counts as the oldest.
std::string readModelConfig(const std::string &folder, const Place &place, const std::string &model) {
    const std::string config = folder + "/model.config";
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Resource, place,
                         "model " + support::quote(model) + ": " + config + ": " + what);
    };
    if (const std::string wrong = whyNotReadable(config, longestConfig); !wrong.empty()) throw fail(wrong);
    tinyxml2::XMLDocument xml;
    if (const std::string fault = readXml(readTextFile(config), xml); !fault.empty()) throw fail(fault);
    const tinyxml2::XMLElement &root = *xml.RootElement();
    if (std::string(root.Name()) != "model") throw fail("its root element is not <model>");
    std::string file;
    int newest = oldestVersion;
    for (const tinyxml2::XMLElement *sdf = root.FirstChildElement("sdf"); sdf;
         sdf = sdf->NextSiblingElement("sdf")) {
        const char *const name = sdf->Attribute("version");
        const std::optional<int> version = name ? versionNamed(name) : oldestVersion;
        if (!version || *version < newest) continue;
        newest = *version;
        file = wholeText(*sdf);
        if (file.empty()) throw fail("its <sdf> of version " + versionName(newest) + " names no file");
    }
    if (file.empty())
        throw fail("names no SDF file of a version from " + versionName(oldestVersion) + " to " +
                   versionName(newestVersion));
    return file;
}

// The file of a model that may be named by its folder.
std::string modelFile(const std::string &found, const Place &place, const std::string &model) {
    std::error_code none;  // what cannot be examined is no folder
    if (!fs::is_directory(found, none)) return found;
    return found + "/" + readModelConfig(found, place, model);
}

std::string canonicalName(const std::string &file, const Place &namedAt) {
    std::error_code error;
    const fs::path canonical = fs::canonical(file, error);
    if (error) throw LoadError(LoadError::Kind::Resource, namedAt, file + ": " + error.message());
    return canonical;
}

class Includes {
public:
    Includes(const std::string &worldFile, const Reading &reading) : m_reading(reading) {
        std::error_code none;  // the text may have come from no file
        const fs::path canonical = fs::canonical(worldFile, none);
        if (!none) m_worldFile = canonical;
    }

    // As OnInclude demands.
    std::list<Element> modelOf(Element &include) {
        const Element &uri = include.required("uri");
        const Place place = uri.place();
        const std::string found = m_reading.resources.find(uri.text, include.file().name);
        std::list<Element> included;
        if (found.empty()) {
            m_reading.issues.missing(place, "no model " + support::quote(uri.text) + ": " +
                                                m_reading.resources.whereSearched(uri.text, include.file().name));
            return included;
        }
        const std::string file = modelFile(found, place, uri.text);
        refuseCircles(include, file, place);
        if (++m_modelCount > maxModels)
            uri.fail("the world includes more than " + std::to_string(maxModels) + " models");

        Element root;
        if (!parse(textOf(file, place), file, true, m_reading.issues, root) || isLeftOut(root)) return included;
        included.splice(included.end(), root.children);
        included.front().source = root.source;
        override(included.front(), include);
        return included;
    }

private:
    // Each included file is known by its name here; those around it are those of the elements around.
    void refuseCircles(const Element &include, const std::string &file, const Place &place) {
        const std::string canonical = canonicalName(file, place);
        std::size_t depth = 0;
        for (const Element *at = &include; at; at = at->parent) {
            if (!at->source || !isFile(*at)) continue;
            ++depth;
            if (m_canonical[at->source->name] == canonical)
                throw LoadError(LoadError::Kind::Value, place, file + " includes itself");
        }
        if (canonical == m_worldFile)
            throw LoadError(LoadError::Kind::Value, place, file + " includes itself");
        if (depth > deepestInclude)
            throw LoadError(LoadError::Kind::Value, place,
                            "includes are nested more than " + std::to_string(deepestInclude) + " deep");
        m_canonical[file] = canonical;
    }

    static bool isFile(const Element &element) { return element.name == "model" || element.name == "sdf"; }

    const std::string &textOf(const std::string &file, const Place &place) {
        const auto known = m_texts.find(file);
        if (known != m_texts.end()) return known->second;
        if (const std::string wrong = whyNotReadable(file, longestTextFile); !wrong.empty())
            throw LoadError(LoadError::Kind::Resource, place, file + ": " + wrong);
        return m_texts[file] = readTextFile(file);
    }

    // True of a light and an actor, which move nothing, and of anything else but a model, if the user wants to do without.
    bool isLeftOut(const Element &root) const {
        const std::string kind = root.children.size() == 1 ? root.children.front().name : std::string();
        if (kind == "model" || kind == "light" || kind == "actor") return kind != "model";
        if (kind.empty())
            m_reading.issues.unsupported(root.place(), "an included file that does not hold one <model> and nothing else");
        else
            m_reading.issues.unsupported(root.children.front().place());
        return true;
    }

    // Gives the model what the <include> says of it. What is moved is still in the file of the <include>.
    static void override(Element &model, Element &include) {
        model.parent = include.parent;
        model.isMerged = include.parent->name == "model" && isTrue(include.attributeOrEmpty("merge"));
        if (const Element *const name = include.child("name")) {
            if (name->text.find("::") != std::string::npos) name->fail("a name may not hold '::'");
            model.setAttribute("name", name->text);
        }
        if (const Element *const frame = include.child("placement_frame")) {
            if (!include.child("pose")) frame->fail("needs a <pose> beside it");
            model.setAttribute("placement_frame", frame->text);
        }
        const auto source = std::make_shared<SourceFile>(include.file());
        for (const char *const kind : {"pose", "static"})
            if (include.child(kind))
                model.children.remove_if([&](const Element &child) { return child.name == kind; });
        for (auto at = include.children.begin(), next = at; at != include.children.end(); at = next) {
            next = std::next(at);
            if (at->name != "pose" && at->name != "static" && at->name != "plugin") continue;
            model.children.splice(model.children.end(), include.children, at);
            at->source = source;
        }
        for (Element &child : model.children) child.parent = &model;
    }

    const Reading &m_reading;
    std::string m_worldFile;                         // canonical; empty for a text of no file
    std::map<std::string, std::string> m_canonical;  // names of files
    std::map<std::string, std::string> m_texts;      // of included files
    std::size_t m_modelCount = 0;                    // that were included
};

}  // namespace

namespace {

// Makes a world around the one model of a file that holds no world, and a plane for it to stand on.
void putOnAPlane(Element &root) {
    if (root.child("world") || root.children.size() != 1 || root.children.front().name != "model") return;
    std::list<Element> model;
    model.swap(root.children);
    Element &world = root.add("world");
    world.isImplied = true;
    world.setAttribute("name", "default");
    model.front().parent = &world;
    world.children.splice(world.children.end(), model);
    const std::string name = "ground_plane";
    if (world.children.front().attributeOrEmpty("name") == name) return;
    Element &ground = world.add("model");
    ground.setAttribute("name", name);
    ground.add("static").text = "true";
    Element &link = ground.add("link");
    link.setAttribute("name", "link");
    Element &collision = link.add("collision");
    collision.setAttribute("name", "collision");
    collision.add("geometry").add("plane");
}

}  // namespace

std::shared_ptr<Element> readDocument(const std::string &text, const std::string &file,
                                      const Reading &reading) {
    const auto root = std::make_shared<Element>();
    parse(text, file, false, reading.issues, *root);
    putOnAPlane(*root);
    Includes includes(file, reading);
    checkElements(*root, reading.issues, [&](Element &include) { return includes.modelOf(include); });
    return root;
}

}  // namespace worlds
