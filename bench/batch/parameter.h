// What a parameter of a plan changes:
//
//   gravity, erp, cfm, iterations, …    a property of the world, set when it has been made (kProperties in parameter.cpp)
//   /sdf/world/model[robot]/plugin/speed   the text of an element of an SDF world, before it is loaded; …/plugin@filename an attribute
//   any other name                      the part ${name} of the world's name or file, or of a text that is another parameter's value
#pragma once

#include "scenes/scene.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace batch {

using Values = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

// Throws std::invalid_argument: what is wrong with a plan at that key.
[[noreturn]] void fail(const std::string &key, const std::string &what);

// Throws std::invalid_argument that names the parameter, if it means nothing in this world or cannot have the value. Opens no file.
void checkParameter(const std::string &name, const nlohmann::ordered_json &value, const std::string &world);

// Replaces each ${name} in the text.
void insertValue(std::string &text, const std::string &name, const nlohmann::ordered_json &value);

// Sets the properties among the values.
void setProperties(const scenes::Scene &scene, const Values &values);

// The text of an SDF file with the elements among the values changed; the file's name is for messages. Throws std::invalid_argument.
std::string changeElements(const std::string &sdf, const std::string &file, const Values &values);
bool changesElements(const Values &values);

}  // namespace batch
