// The one table of SDF elements: what the loader does with each, what type of value it holds, how many
// numbers, in which range, how often it may be written, and in which versions. Checks (element_check.h),
// messages (value_check.h) and ../../elements.md are made from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace worlds {

enum class Use {
    Read,
    ReadBySelf,   // with everything inside: its reader names what it does not know
    NoPhysics,    // left aside with everything inside: it changes no motion in ODE
    DefaultOnly,  // accepted while it holds SDF's default, which asks for nothing; else, with a note, left aside
};

enum class Type {
    Group,      // holds elements and no text
    Any,        // not checked: of elements that are ignored or compared with a default
    Text,       // a name or URI
    Choice,     // one of `choices`
    Flag,       // true, false, 1 or 0
    Numbers,    // `count` of them
    Direction,  // three numbers that are not all zero
    Whole,      // one number, written in digits alone
    Mask,       // the same, or hexadecimal as 0x1f
    Limit,      // one number; infinite, or beyond largestNumber, means "no limit"
    Pose,  // x y z and roll pitch yaw, or with rotation_format="quat_xyzw" a quaternion x y z w; empty: no
           // change
};

enum class Often { Once, Any };

// SDF's own mark for "no limit". Larger lengths, masses and the like make ODE compute with infinity.
constexpr double largestNumber = 1e16;

// A smaller mass or size has an inverse, or a square, that ODE cannot use.
constexpr double smallestPositive = 1e-20;

// No name, word or URI is longer, in characters.
constexpr std::size_t longestText = 1000;

// Versions of SDF are counted by their second number: 9 for 1.9.
constexpr int oldestVersion = 2, newestVersion = 12;
std::string versionName(int version);
// None for a version that is not supported.
std::optional<int> versionNamed(const std::string &name);

struct ElementRule {
    Use use = Use::Read;
    Type type = Type::Group;
    int count = 0;  // of numbers
    double least = 0, most = 0;
    Often often = Often::Once;
    std::vector<std::string> choices = {};     // of a Choice
    std::vector<std::string> needs = {};       // children of a Group that have to be there
    bool needsOneChild = false;                // a Group with exactly one child
    std::vector<std::string> needsOneOf = {};  // children of a Group, one of which at least has to be there
    std::string usual = {};                    // SDF's default, of DefaultOnly
    std::string note = {};                     // for the warning where NoPhysics or DefaultOnly leave something aside
    int until = newestVersion;                 // the last version that has it
};

// The rule for an element, or null when it is not supported in that version. `path` starts at the innermost
// world, model, link, collision or joint around it: "link/inertial/mass".
const ElementRule *findElementRule(const std::string &path, int version = oldestVersion);

struct NamedRule {
    std::string path;
    ElementRule rule;
};
// Returns the rules in the order of the documentation.
const std::vector<NamedRule> &elementRules();

// Where the elements inside `path` are looked up: "link" for "model/link", else `path` itself.
std::string elementContext(const std::string &path);

// An attribute. Where it selects what an element is, those of its values that are supported.
struct AttributeRule {
    std::string path, attribute;
    bool isNeeded = false;
    std::vector<std::string> values = {};  // empty: any
    int since = oldestVersion;             // the first version that has it
};
// Those of poses are the same for all, and not among these.
const std::vector<AttributeRule> &attributeRules();
std::vector<const AttributeRule *> attributeRulesOf(const std::string &path);

// The table as documentation: the text of ../../elements.md, which a test compares.
std::string elementDocs();

}  // namespace worlds
