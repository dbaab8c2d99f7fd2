// What is wrong with an element's text, by its rule, in words.
#pragma once

#include "loader/read/element_rules.h"

#include <string>
#include <vector>

namespace worlds {

// Empty when nothing is. `isQuaternion` says that a pose is written with a quaternion.
std::string complaint(const ElementRule &rule, const std::string &text, bool isQuaternion = false);

// The value of a mask that is no cause for a complaint.
unsigned readMask(const std::string &text);

// "3 numbers between 1e-09 and 1e+16", for documentation.
std::string describe(const ElementRule &rule);

// Of a limit that is negative where there is none, as SDF and Gazebo have it.
double limitOrNone(double value);

}  // namespace worlds
