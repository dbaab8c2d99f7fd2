// model.config, the file of a model's folder that says which file describes the model.
#pragma once

#include "loader/load_error.h"

#include <string>

namespace worlds {

// The name, within the folder, of the file for the newest version of SDF that the loader knows. Throws LoadError at
// `place`, where `model` is included.
std::string readModelConfig(const std::string &folder, const Place &place, const std::string &model);

}  // namespace worlds
