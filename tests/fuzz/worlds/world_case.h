// A world with all files that it names, and the options that it is loaded with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace fuzz_worlds {

const char *const kWorldFile = "world.sdf";

struct WorldCase {
    std::string name;                          // where it comes from: "create.sdf", "link/inertial/mass"
    std::map<std::string, std::string> files;  // by name within the folder of the case
    bool ignoreUnsupported = false, staticMeetsStatic = false;
    std::size_t staticShapes = 0;

    const std::string &world() const { return files.at(kWorldFile); }
};

void writeCase(const WorldCase &world, const std::filesystem::path &folder);

// Reads a case that writeCase has written. The options are those of a file "options" beside the world, if it is there.
WorldCase readCase(const std::filesystem::path &folder);

// Whether a file of the case is XML by its name.
bool isXml(const std::string &file);

// The most that loading the case may take, in bytes: 160 MB, and 100 kB for each element, which counts as
// often as there are <include>s; what the world asks for by numbers (cells of a quadtree, pixels, contacts of
// a pair, phases of a schedule) comes to that.
std::size_t memoryBound(const WorldCase &world);

}  // namespace fuzz_worlds
