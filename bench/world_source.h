// The values of --worlds, and the scenes that they stand for.
//
//   create             one of the SDF worlds of worlds/
//   create:620         the same with 620 static shapes: its obstacles are repeated around it
//   create,static_meets_static   the same with pairs of static shapes reported by ODE's space
//   path/to/file.sdf   any SDF world; may have a number and the modifier, too
//   stacks:100,quick   a procedural scene; "soccer" alone is the SDF world, "soccer:4" the scene
//   pile:1000..8000    one scene for each size, doubled from 1000 to 8000 at most
//   thesis             all the worlds that the thesis measures
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "loader/load_world.h"
#include "scenes/scene.h"

namespace bench {

// A range of sizes as one word behind --worlds: "pile:1000..8000,sap".
//
// Returns one world for each size from the first to at most the last, each twice the one before; a world without
// such a range is itself. So is one whose range makes no sense: as a size it is complained of by name.
std::vector<std::string> expandSizes(const std::string &world);

// What one word behind --worlds says: NAME[:N][,MODIFIER...].
struct WorldSpec {
    std::string name;                    // of an SDF world or scene, or a file
    std::string size;                    // the part after the colon; empty if there is none
    std::vector<std::string> modifiers;  // the parts after the commas
    bool isSdf = false;                  // else a scene
};

// Opens no file. Throws std::invalid_argument for what says nothing or the same twice.
WorldSpec readWorldSpec(const std::string &world);

// How to load an SDF world. Throws std::invalid_argument for a size or modifier that makes no sense.
worlds::LoadOptions loadOptions(const WorldSpec &spec);

// "rover,pile:4000,quick,create" is three worlds: a modifier belongs to the world before it. "thesis" is
// eight.
std::vector<std::string> splitWorlds(const std::string &list);

// Throws std::invalid_argument that names what is wrong and what exists; opens no file.
void checkWorld(const std::string &world);

// What happens to elements of an SDF world that are not supported.
struct Unsupported {
    bool isLeftOut = false;
    std::string option = "--ignore-unsupported";  // by which the user leaves them out, for messages; empty: by none
};

// Throws what checkWorld throws and what the loader throws. `warnings`: what the loader left out, or reads in another way
// than it is written.
std::unique_ptr<scenes::Scene> openWorld(const std::string &world, const Unsupported &unsupported,
                                         std::vector<std::string> &warnings);

std::string listWorlds();  // for --list

}  // namespace bench
