// Turns an SDF world into a scene. ../README.md lists the elements that are supported.
#pragma once

#include "loader/load_error.h"
#include "loader/scene/sdf_scene.h"

#include <memory>
#include <string>
#include <vector>

namespace worlds {

struct LoadOptions {
    // false: an element that is not supported is a LoadError. true: it is left out, and named in
    // `warnings`.
    bool ignoreUnsupported = false;
    std::vector<std::string> *warnings = nullptr;  // not owned

    // Where model:// URIs and relative file names are looked for, besides the folder of the file that
    // names them, its subfolder models/ and the folders in SDF_PATH and GZ_SIM_RESOURCE_PATH.
    std::vector<std::string> modelFolders;
};

// Throws LoadError. dInitODE2 is the caller's job.
std::unique_ptr<SdfScene> loadWorld(const std::string &file, const LoadOptions &options = {});

// The same for a world in memory; `name` stands for the file in messages and for relative names.
std::unique_ptr<SdfScene> loadWorldText(const std::string &sdf, const std::string &name,
                                        const LoadOptions &options = {});

}  // namespace worlds
