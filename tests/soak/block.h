// The results of a block of frames, and a line of JSON for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace soak {

struct Block {
    std::string library;          // path of the libode.so.8 that played it
    std::uint64_t hash = 0;       // of all that was to be seen
    std::size_t liveBytes = 0;    // that malloc has given out and not got back
    std::size_t residentBytes = 0;
    int threads = 0;              // of the process
    unsigned workers = 0;         // most that took part in a step or a collision so far
    std::uint64_t frames = 0;     // of all scenes so far
};

std::string lineOf(const Block &block);

// Throws std::runtime_error if it is not such a line.
Block blockOf(const std::string &line);

}  // namespace soak
