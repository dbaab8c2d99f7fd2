// What the observer recorded of one run of a program (record_format.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/record_format.h"

namespace check {

// Where a world is: the number of its process, and its own in that.
struct WorldName {
    std::uint32_t process = 0, world = 0;

    bool operator==(const WorldName &other) const { return process == other.process && world == other.world; }
};

struct WorldRecord {
    WorldName name;
    std::uint64_t firstStep = 1;        // in this process; later ones than 1 in a child of a fork
    std::vector<std::uint64_t> hashes;  // of the states behind each step
    std::uint32_t mostBodies = 0;
    bool isNumbered = false;  // all worlds of its process were made by one thread: it has its number in each run

    std::uint64_t lastStep() const { return firstStep + hashes.size() - 1; }
};

struct ProcessRecord {
    std::string program, library;
    bool isOurs = false, isDouble = false, isFull = false;
    double stepSeconds = 0, observerSeconds = 0;
};

struct RunRecord {
    bool wasLoaded = false;            // the observer, into any process
    unsigned headless = 0;             // processes that made a world, of which nothing else could be written
    std::vector<std::string> objects;  // programs and libraries of processes that made no world, each once
    std::vector<ProcessRecord> processes;
    std::vector<WorldRecord> worlds;  // that made a step, by process and number

    std::uint64_t steps() const;
    double stepSeconds() const;
    double observerSeconds() const;
};

// Whether several processes make worlds, or several threads of one.
bool makesWorldsConcurrently(const RunRecord &run);

// Throws std::runtime_error if the files are not as the observer writes them.
RunRecord readRunRecord(const std::string &folder);

// The state of one world behind one step.
struct StoredState {
    WorldState world;
    std::vector<BodyState> bodies;  // by number
};

// Of all worlds of a process that made the step that was asked for. Empty: it made none.
std::vector<StoredState> readStates(const std::string &folder, std::uint32_t process);

}  // namespace check
