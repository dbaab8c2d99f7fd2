// What the observer writes about the processes of a program, and odemt_check reads. In the folder that kFolderVariable names:
//
//   loaded        exists if the observer was loaded into any process
//   objects       of processes that made no world: the programs and libraries in them, a path a line
//   record-0000   one for each process that made a world, by order of that: a ProcessHeader, and from kHeaderBytes on a Step
//                 for each step of each world
//   states-0000   of the same processes, if kDumpVariable names a step: of each world, behind that step of its own, a WorldState
//   and its
//                 BodyStates
//
// Worlds and bodies have numbers by order of creation, from 0: worlds in their process, bodies in their world. Steps are counted
// from 1, in each world. Reals are compared bit by bit, but all NaNs are the same one.
#pragma once

#include <array>
#include <cstdint>

namespace check {

constexpr const char *kFolderVariable = "ODEMT_OBSERVER_FOLDER";
constexpr const char *kDumpVariable = "ODEMT_OBSERVER_DUMP";  // a step
constexpr const char *kLastVariable = "ODEMT_OBSERVER_LAST";  // the step of any world behind which its process ends

constexpr std::uint64_t kMagic = 0x6f64656d74303031;  // "odemt001"
constexpr std::uint64_t kHeaderBytes = 4096;
constexpr std::uint32_t kNoProcess = 0xffffffff;

struct ProcessHeader {
    std::uint64_t magic;
    std::uint64_t steps;                // that are written
    std::uint64_t stepNanoseconds;      // in dWorldStep and dWorldQuickStep, of all threads together
    std::uint64_t observerNanoseconds;  // in what the observer does after them
    std::uint32_t parent;               // number of the process that this one was forked from with its worlds, or kNoProcess
    std::uint32_t isOurs;               // its library is ODE_MT
    std::uint32_t isDouble;             // and has double precision; else no step is recorded
    std::uint32_t isFull;               // a step was lost: no room, or no rights, for the file
    std::uint32_t hasOneMaker;          // all its worlds were made by one thread: they have their numbers in each run
    char library[1024], program[1024];  // paths
};
static_assert(sizeof(ProcessHeader) <= kHeaderBytes);

struct Step {
    std::uint32_t world, bodies;
    std::uint64_t number, hash;
};

// Words: bits of a real, or a whole number.
struct Field {
    const char *name;
    std::uint32_t words;
    bool isReal;
};

constexpr std::array<Field, 7> kBodyFields = {{{"position", 3, true},
                                               {"quaternion", 4, true},
                                               {"linear velocity", 3, true},
                                               {"angular velocity", 3, true},
                                               {"force", 3, true},
                                               {"torque", 3, true},
                                               {"enabled flag", 1, false}}};
constexpr std::uint32_t kBodyWords = 20;

struct BodyState {
    std::uint64_t number;
    std::uint64_t words[kBodyWords];  // of kBodyFields, in their order
};

constexpr std::array<Field, 3> kStepFields = {{{"step size", 1, true}, {"stepper", 1, false}, {"result of the stepper", 1, false}}};
constexpr std::uint32_t kStepWords = 3;
constexpr std::uint64_t kWorldStep = 0, kWorldQuickStep = 1;  // values of "stepper"

struct WorldState {
    std::uint64_t world, step, bodies;
    std::uint64_t words[kStepWords];  // of kStepFields, in their order
};

}  // namespace check
