#include "worlds/message_rule.h"

#include "driver/message_text.h"

#include <algorithm>
#include <regex>

namespace fuzz_worlds {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxMessage = 5000;  // bytes, names of files included

bool startsWith(const std::string &text, const std::string &begin) {
    return text.compare(0, begin.size(), begin) == 0;
}

std::string wrongText(const std::string &message) {
    if (const std::string wrong = fuzz_driver::whatIsNoPlainLine(message); !wrong.empty()) return wrong;
    if (const std::string name = fuzz_driver::innerNameIn(message); !name.empty())
        return "names the inside: " + name;
    if (message.size() > kMaxMessage) return "has " + std::to_string(message.size()) + " bytes";
    return {};
}

// A message may refer to the whole file only if there is no element to name: text that is no XML, or of an unsupported kind, is reported
// by its line.
bool mayHaveNoPath(const Loading &loading) {
    static const std::regex byLine("^(not well-formed XML, )?line [0-9]+: ");
    const std::string reason = loading.message.substr(std::min(loading.message.size(), loading.placeFile.size() + 2));
    return loading.errorKind == "File" ||
           (loading.errorKind == "Syntax" && (reason.find("not SDF") != std::string::npos || std::regex_search(reason, byLine)));
}

std::string wrongPlace(const Loading &loading, const WorldCase &world, const fs::path &folder) {
    const fs::path file = fs::path(loading.placeFile).lexically_relative(folder).lexically_normal();
    const auto found = world.files.find(file.string());
    if (found == world.files.end()) return "names " + loading.placeFile + ", which is no file of the world";
    if (loading.placePath.empty()) return mayHaveNoPath(loading) ? "" : "names no element";
    if (!startsWith(loading.placePath, "/sdf")) return "has a path that does not begin at /sdf";
    const std::string type = lastOf(loading.placePath).substr(0, lastOf(loading.placePath).find('['));
    if (found->second.find("<" + type) == std::string::npos)
        return "names an element <" + type + "> that is not in the file";
    return {};
}

}  // namespace

std::string lastOf(const std::string &path) {
    // A name may hold slashes: it begins at the first bracket behind a slash.
    std::size_t begin = 0;
    bool isName = false;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path[i] == '[') isName = true;
        if (path[i] == ']') isName = false;
        if (path[i] == '/' && !isName) begin = i + 1;
    }
    return path.substr(begin);
}

std::string whatIsWrongWithMessages(const Loading &loading, const WorldCase &world, const fs::path &folder) {
    for (const std::string &warning : loading.warnings)
        if (const std::string wrong = wrongText(warning); !wrong.empty())
            return "a warning " + wrong + ": " + fuzz_driver::shown(warning);
    if (loading.result != Loading::Result::Refused) return {};
    std::string wrong = wrongText(loading.message);
    if (wrong.empty() && !startsWith(loading.message, folder.string()))
        wrong = "does not begin with the name of a file";
    if (wrong.empty()) wrong = wrongPlace(loading, world, folder);
    return wrong.empty() ? "" : "a message " + wrong + ": " + fuzz_driver::shown(loading.message);
}

}  // namespace fuzz_worlds
