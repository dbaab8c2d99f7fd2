// The record of one run of a scenario: the library that ran it, a hash for every stage of every step and, if
// asked for, every value of one step.
//
// Hashes are chained: a stage's hash holds everything seen before it. Two equal last hashes therefore
// mean two equal runs, and the first pair that differs is the first difference.
#pragma once

#include "reading.h"

#include <string>
#include <vector>

namespace exactness {

struct Engine {
    std::string library;  // path of the libode.so.8 that the loader took
    bool isOdeMt = false;
    unsigned parallelSteps = 0;
    unsigned parallelIslands = 0;
    unsigned teamSteps = 0;
    unsigned parallelCollisions = 0;
    unsigned maxWorkers = 0;  // that took part in one step or in the callbacks of one collision
    std::string instructionSet;  // that vector code ran with; empty: none ran
};

struct StageHash {
    int step;
    std::string stage;
    std::uint64_t hash;
};

struct Value {
    std::string stage;
    std::string object;  // "body 12"
    std::string field;   // "linear velocity"
    std::vector<Word> words;
    std::string text;
};

struct Record {
    Engine engine;
    std::vector<StageHash> stages;
    std::vector<Value> values;  // of one step

    void write(const std::string &path) const;
    static Record read(const std::string &path);  // throws std::runtime_error naming the file
};

}  // namespace exactness
