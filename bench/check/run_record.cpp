#include "check/run_record.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

namespace check {

namespace {

std::string numbered(const std::string &folder, const char *kind, std::uint32_t number) {
    char name[32];
    std::snprintf(name, sizeof name, "/%s-%04u", kind, number);
    return folder + name;
}

template <class Value>
bool readValue(std::istream &stream, Value &value) {
    return static_cast<bool>(stream.read(reinterpret_cast<char *>(&value), sizeof value));
}

[[noreturn]] void failAt(const std::string &path) { throw std::runtime_error("'" + path + "' is no record of the observer"); }

void readProcess(std::istream &stream, const std::string &path, std::uint32_t number, RunRecord &run) {
    ProcessHeader header{};
    // There was no room for it, or the process was killed while it made the file.
    if (!readValue(stream, header) || header.magic == 0) {
        ++run.headless;
        return;
    }
    if (header.magic != kMagic) failAt(path);
    constexpr double kNanosecond = 1e-9;
    run.processes.push_back({header.program, header.library, header.isOurs != 0, header.isDouble != 0, header.isFull != 0,
                             kNanosecond * static_cast<double>(header.stepNanoseconds),
                             kNanosecond * static_cast<double>(header.observerNanoseconds)});
    stream.seekg(static_cast<std::streamoff>(kHeaderBytes));
    std::map<std::uint32_t, WorldRecord> worlds;
    for (std::uint64_t i = 0; i < header.steps; ++i) {
        Step step{};
        if (!readValue(stream, step)) failAt(path);
        WorldRecord &world = worlds[step.world];
        if (world.hashes.empty()) {
            world.name = {number, step.world};
            world.firstStep = step.number;
            world.isNumbered = header.hasOneMaker != 0;
        }
        if (step.number != world.lastStep() + 1) failAt(path);
        world.hashes.push_back(step.hash);
        world.mostBodies = std::max(world.mostBodies, step.bodies);
    }
    for (auto &[key, world] : worlds) run.worlds.push_back(std::move(world));
}

}  // namespace

std::uint64_t RunRecord::steps() const {
    std::uint64_t sum = 0;
    for (const WorldRecord &world : worlds) sum += world.hashes.size();
    return sum;
}

double RunRecord::stepSeconds() const {
    double sum = 0;
    for (const ProcessRecord &process : processes) sum += process.stepSeconds;
    return sum;
}

double RunRecord::observerSeconds() const {
    double sum = 0;
    for (const ProcessRecord &process : processes) sum += process.observerSeconds;
    return sum;
}

bool makesWorldsConcurrently(const RunRecord &run) {
    return std::any_of(run.worlds.begin(), run.worlds.end(),
                       [&](const WorldRecord &world) { return !world.isNumbered || world.name.process != run.worlds[0].name.process; });
}

RunRecord readRunRecord(const std::string &folder) {
    RunRecord run;
    run.wasLoaded = std::filesystem::exists(folder + "/loaded");
    std::set<std::string> seen;
    std::ifstream objects(folder + "/objects");
    for (std::string line; std::getline(objects, line);)
        if (seen.insert(line).second) run.objects.push_back(line);
    for (std::uint32_t number = 0;; ++number) {
        const std::string path = numbered(folder, "record", number);
        std::ifstream stream(path, std::ios::binary);
        if (!stream) return run;
        readProcess(stream, path, number, run);
    }
}

std::vector<StoredState> readStates(const std::string &folder, std::uint32_t process) {
    const std::string path = numbered(folder, "states", process);
    std::ifstream stream(path, std::ios::binary);
    std::vector<StoredState> states;
    for (StoredState state{}; stream && readValue(stream, state.world);) {
        state.bodies.resize(state.world.bodies);
        for (BodyState &body : state.bodies)
            if (!readValue(stream, body)) failAt(path);
        states.push_back(state);
    }
    return states;
}

}  // namespace check
