#include "loader/read/model_config.h"

#include "loader/read/element_rules.h"
#include "loader/read/regular_file.h"
#include "loader/read/xml_text.h"

#include <tinyxml2.h>

#include <algorithm>

namespace worlds {

namespace {

constexpr std::uintmax_t longestConfig = 1u << 20;  // bytes

}  // namespace

std::string readModelConfig(const std::string &folder, const Place &place, const std::string &model) {
    const std::string config = folder + "/model.config";
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Resource, place, "model " + quote(model) + ": " + config + ": " + what);
    };
    const std::string wrong = whyNotReadable(config, longestConfig);
    if (!wrong.empty()) throw fail(wrong);
    tinyxml2::XMLDocument xml;
    if (const std::string fault = readXml(readTextFile(config), xml); !fault.empty()) throw fail(fault);
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
        file = wholeText(*sdf);
        if (file.empty()) throw fail("its <sdf version=\"" + std::string(version) + "\"> names no file");
    }
    if (file.empty()) throw fail("names no SDF file of a version from " + known.front() + " to " + known.back());
    return file;
}

}  // namespace worlds
