// Which elements of SDF the loader reads, which it leaves aside, and what numbers they may hold.
#pragma once

#include <string>
#include <vector>

namespace worlds {

enum class Use {
    Read,
    ReadBySelf,   // with everything inside: its reader names what it does not know
    NoPhysics,    // left aside with everything inside: it changes no motion in ODE
    DefaultOnly,  // accepted while it holds SDF's default, which asks for nothing
};

enum class Holds {
    Anything,
    Limit,  // a number; infinite means "no limit"
    NotNegativeLimit,
    Finite,  // up to largestNumber, and so are the rest
    NotNegative,
    Positive,
    Share,  // 0 to 1
};

// SDF's own mark for "no limit". Larger lengths, masses and the like make ODE compute with infinity.
constexpr double largestNumber = 1e16;

struct ElementRule {
    Use use = Use::Read;
    Holds holds = Holds::Anything;
};

// The rule for an element, or null when it is not supported. `path` starts at the innermost world,
// model, link, collision or joint around it: "link/inertial/mass".
const ElementRule *findElementRule(const std::string &path);

// Where the elements inside `path` are looked up: "link" for "model/link", else `path` itself.
std::string elementContext(const std::string &path);

// An attribute that selects what an element is, and the values that are supported.
struct AttributeRule {
    std::string path, attribute;
    std::vector<std::string> values;
};
const std::vector<AttributeRule> &attributeRules();

}  // namespace worlds
