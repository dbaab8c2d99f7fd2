#include "worlds/world_case.h"

#include "support/temporary_folder.h"
#include "support/text_file.h"

#include <algorithm>
#include <sstream>

namespace fuzz_worlds {

namespace fs = std::filesystem;

namespace {

std::size_t countOf(const std::string &part, const std::string &text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

bool anyHolds(const WorldCase &world, const std::string &part) {
    return std::any_of(world.files.begin(), world.files.end(),
                       [&](const auto &file) { return file.second.find(part) != std::string::npos; });
}

}  // namespace

void writeCase(const WorldCase &world, const fs::path &folder) {
    for (const auto &[file, text] : world.files) support::writeTextFile(folder / file, text);
    std::ostringstream options;
    options << world.ignoreUnsupported << ' ' << world.staticMeetsStatic << ' ' << world.staticShapes << ' '
            << world.name << '\n';
    support::writeTextFile(folder / "options", options.str());
}

WorldCase readCase(const fs::path &folder) {
    WorldCase world;
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            world.files[fs::relative(entry.path(), folder).string()] = support::readWhatIsThere(entry.path());
    std::istringstream options(world.files["options"]);
    options >> world.ignoreUnsupported >> world.staticMeetsStatic >> world.staticShapes >> world.name;
    world.files.erase("options");
    return world;
}

bool isXml(const std::string &file) {
    for (const char *const ending : {".sdf", ".config", ".dae"})
        if (fs::path(file).extension() == ending) return true;
    return false;
}

std::size_t memoryBound(const WorldCase &world) {
    constexpr std::size_t kBase = 160u << 20, kElement = 100'000;
    std::size_t elements = 0, includes = 1;
    for (const auto &[file, text] : world.files) {
        if (!isXml(file)) continue;
        elements += countOf("<", text);
        includes += countOf("<include", text);
    }
    std::size_t bound = kBase + kElement * elements * includes;
    if (anyHolds(world, "quadtree")) bound += std::size_t{1} << 29;             // 4^10 cells
    if (anyHolds(world, "<heightmap")) bound += std::size_t{18} * 100'000'000;  // the most pixels
    if (anyHolds(world, "contact")) bound += std::size_t{1} << 29;              // 65,535 of a pair
    if (anyHolds(world, "<repeat")) bound += std::size_t{1} << 28;              // 1,000,000 phases
    return bound;
}

}  // namespace fuzz_worlds
