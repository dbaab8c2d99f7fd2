// The benchmark worlds by name.
#pragma once

#include <string>
#include <vector>

namespace worlds {

// The folder of the SDF files: $ODE_MT_WORLDS if set, else share/ode_mt/worlds of the tree that this program is installed
// in, else the source folder.
std::string worldFolder();

// The folder of the models that come with the worlds, whatever ODE_MT_WORLDS is: Gazebo's sun and ground plane among them.
std::string commonModelFolder();

// "create", "pioneer3at", … in alphabetical order.
std::vector<std::string> availableWorlds();

// The folder and what it holds: "/worlds holds create epuck", "/worlds is not a folder".
std::string worldsInFolder();

// The file of a world given by name ("create") or by file name ("my/world.sdf"). Throws
// std::invalid_argument, naming the worlds that exist.
std::string findWorld(const std::string &nameOrFile);

}  // namespace worlds
