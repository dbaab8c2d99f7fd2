// What one word behind --worlds says: NAME[:N][,MODIFIER...].
#pragma once

#include "loader/load_world.h"

#include <string>
#include <vector>

namespace bench {

struct WorldSpec {
    std::string name;                    // of an SDF world or scene, or a file
    std::string size;                    // the part after the colon; empty if there is none
    std::vector<std::string> modifiers;  // the parts after the commas
    bool isSdf = false;                  // else a scene
};

// Opens no file. Throws std::invalid_argument for what says nothing or the same twice.
WorldSpec readWorldSpec(const std::string &world);

// "static_meets_static", the modifiers of an SDF world.
extern const char *const kStaticMeetsStatic;

// How to load an SDF world. Throws std::invalid_argument for a size or modifier that makes no sense.
worlds::LoadOptions loadOptions(const WorldSpec &spec);

}  // namespace bench
