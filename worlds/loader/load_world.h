// Finds SDF worlds, and turns them into scenes. ../README.md lists the elements that are supported.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "loader/load_error.h"
#include "loader/scene/sdf_scene.h"

namespace worlds {

struct LoadOptions {
    // false: an element that is not supported is a LoadError. true: it is left out, and named in
    // `warnings`.
    bool ignoreUnsupported = false;
    // What the user writes for `ignoreUnsupported`, for messages: "--ignore-unsupported". Empty: there is no way.
    std::string ignoringOption;
    // Each once: what was left out, and what is read in another way than it is written. Not owned.
    std::vector<std::string> *warnings = nullptr;

    // false: by their category and collide bits, static shapes never collide with one another: ODE's space does
    // not report such pairs. true: it does, and the near callback drops them, which moves nothing
    // otherwise but takes the time that a program without such bits takes.
    bool staticMeetsStatic = false;

    // Number of static shapes that the world should have; the obstacles of the file are repeated around it until
    // it does (description/repeat_obstacles.h). 0: as many as the file has.
    std::size_t staticShapes = 0;

    // Folders in which model:// URIs and relative file names are searched, besides the folder of the file that
    // names them, its subfolder models/, the folders in kModelFolderVariables (read/resource_finder.h) and, last, the
    // models that come with the worlds.
    std::vector<std::string> modelFolders;
};

// Throws LoadError. dInitODE2 is the caller's job.
std::unique_ptr<SdfScene> loadWorld(const std::string &file, const LoadOptions &options = {});

// The same for a world in memory; `name` replaces the file in messages and for relative names.
std::unique_ptr<SdfScene> loadWorldText(const std::string &sdf, const std::string &name,
                                        const LoadOptions &options = {});

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
