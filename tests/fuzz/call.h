// A call of ODE's as a script has it: names of objects and numbers, written as in C.
//
//   body3 = dBodyCreate(world0);
//   dBodySetPosition(body3, 0.5, nan, 1e+300);
//
// A call that is made in a callback of another one follows that, with the number of the callback within it:
//
//   dSpaceCollide(space0);
//     near 4: dBodyDisable(body3);
#pragma once

#include <string>
#include <vector>

namespace fuzz {

enum class ObjectKind { world, space, body, geom, joint, group, meshData, heightData };
constexpr int objectKinds = 8;
const char *nameOf(ObjectKind kind);

struct Reference {
    ObjectKind kind = ObjectKind::geom;
    int number = -1;  // -1: NULL

    bool operator==(const Reference &other) const { return kind == other.kind && number == other.number; }
};

struct Argument {
    enum class Kind { number, numbers, reference, word };

    Kind kind = Kind::number;
    std::vector<double> numbers;
    Reference reference;
    std::string word;
};
Argument argumentOf(double number);
Argument argumentOf(const Reference &reference);

// Whose code makes the call: the program's own between frames, or a callback.
enum class Where {
    between,
    near,
    moved,
    message,   // the message handler
    collider,  // of a class of geoms of the program's
    box,       // its bounding-box function
    triangle,  // the callbacks of a mesh
    height     // of a height field
};
constexpr int places = 8;

struct Call {
    Where where = Where::between;
    int turn = 0;  // which of the near-callbacks, say, of the call before it
    std::string function;
    std::vector<Argument> arguments;
    Reference result;  // the object that it makes
};

std::string textOf(const Argument &argument);
std::string textOf(const Call &call);
// Throws std::runtime_error that names the line.
Call callOf(const std::string &line);

using Script = std::vector<Call>;
std::string textOf(const Script &script);
Script scriptOf(const std::string &text);  // skips comments (#), empty lines and what was seen (four spaces)

}  // namespace fuzz
