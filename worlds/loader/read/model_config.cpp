#include "loader/read/model_config.h"

#include "loader/read/element_rules.h"
#include "loader/read/regular_file.h"

#include <tinyxml2.h>

#include <algorithm>

namespace worlds {

namespace {

constexpr std::uintmax_t longestConfig = 1u << 20;  // bytes

std::string wordOf(const tinyxml2::XMLElement &element) {
    const std::string text = element.GetText() ? element.GetText() : "";
    const std::size_t begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

}  // namespace

std::string readModelConfig(const std::string &folder, const Place &place, const std::string &model) {
    const std::string config = folder + "/model.config";
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Resource, place, "model " + quote(model) + ": " + config + ": " + what);
    };
    const std::string wrong = whyNotReadable(config, longestConfig);
    if (!wrong.empty()) throw fail(wrong);
    tinyxml2::XMLDocument xml;
    if (xml.LoadFile(config.c_str()) != tinyxml2::XML_SUCCESS)
        throw fail("not well-formed XML, line " + std::to_string(xml.ErrorLineNum()) + ": " + xml.ErrorName());
    const tinyxml2::XMLElement *root = xml.RootElement();
    if (!root || std::string(root->Name()) != "model") throw fail("its root element is not <model>");

    const std::vector<std::string> &known = sdfVersions();  // the oldest first
    std::string file;
    auto newest = known.begin();
    for (const tinyxml2::XMLElement *sdf = root->FirstChildElement("sdf"); sdf; sdf = sdf->NextSiblingElement("sdf")) {
        const char *version = sdf->Attribute("version");
        const auto found = version ? std::find(newest, known.end(), version) : known.end();
        if (found == known.end()) continue;
        newest = found;
        file = wordOf(*sdf);
        if (file.empty()) throw fail("its <sdf version=\"" + std::string(version) + "\"> names no file");
    }
    if (file.empty()) throw fail("names no SDF file of a version from " + known.front() + " to " + known.back());
    return file;
}

}  // namespace worlds
