// The functions of ODE's that scripts call: which arguments each takes, what its numbers mean, where upstream lets it be
// called, and the call itself.
#pragma once

#include "call.h"
#include "objects.h"

#include "call_trace.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace fuzz {

// The meaning of a number: in ordinary scripts it is drawn from a plausible range.
enum class Meaning { size, time, place, speed, fraction, angle, coordinate, any, count, level, flag, bits, choice, parameter };

constexpr int kAnyType = -1, kWithPose = -2, kOnBody = -3;  // of Parameter::type

struct Parameter {
    enum class Kind { object, nullableObject, number, numbers, word };

    Kind kind = Kind::number;
    ObjectKind object = ObjectKind::geom;
    int type = kAnyType;  // class of geoms or spaces, or type of joints
    Meaning meaning = Meaning::any;
    int length = 1;         // of numbers
    bool isPose = false;    // the numbers are a rotation (12) or a quaternion (4)
    std::vector<std::string> words;
};

class Player;
using Arguments = std::vector<Argument>;

struct Function {
    std::string name;
    std::vector<Parameter> parameters;
    // Makes the call and records its result in the trace. `result` is the object that it makes, if any. False: not all of the
    // objects live; nothing was called.
    std::function<bool(Player &, const Arguments &, Reference &result)> call;
    ObjectKind makes = ObjectKind::geom;
    bool isMaker = false;
    bool leavesHalves = false;  // left by a jump from an assertion, upstream has half done what cannot be undone
    std::array<int, places> weights{};  // how often it is drawn in each place; 0: upstream does not allow it there
    // Makes of drawn arguments some that upstream accepts. False: there are none.
    std::function<bool(const Objects &, Arguments &)> adjust;
};

const std::vector<Function> &functions();
const Function *functionOf(const std::string &name);

// Each returns the functions of one header.
void addBodyFunctions(std::vector<Function> &all);
void addGeomFunctions(std::vector<Function> &all);
void addJointFunctions(std::vector<Function> &all);
void addSpaceFunctions(std::vector<Function> &all);
void addWorldFunctions(std::vector<Function> &all);
void addNewFunctions(std::vector<Function> &all);  // of newer releases of ODE, where the release has them
void addProgramFunctions(std::vector<Function> &all);
void addSettingFunctions(std::vector<Function> &all);

// What upstream asserts of arguments (adjustments.cpp).
void addAdjustments(std::vector<Function> &all);

}  // namespace fuzz
