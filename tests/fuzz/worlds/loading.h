// What came of loading a world, in a process of its own, and of its first frames.
#pragma once

#include "worlds/world_case.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fuzz_worlds {

struct Loading {
    enum class Result {
        Loaded,
        Refused,     // by a LoadError
        SlowToStep,  // loaded, but its frames take longer than there is time for
        Broken       // anything else: `fault` says what
    };

    Result result = Result::Broken;
    std::string fault;   // "time over while it loads", "signal 11 ... while it steps: ..."
    std::string errors;  // standard error
    std::size_t peakMemory = 0;

    std::string errorKind, message, placeFile, placePath;  // of the LoadError
    std::vector<std::string> warnings;
    std::uint64_t digest = 0;       // of the initial state, from ODE
    std::uint64_t laterDigest = 0;  // and some frames later
    double loadSeconds = 0;

    bool sameStateAs(const Loading &other) const {
        return digest == other.digest && laterDigest == other.laterDigest;
    }
};

// `folder` holds the case's files.
Loading load(const WorldCase &world, const std::filesystem::path &folder);

}  // namespace fuzz_worlds
