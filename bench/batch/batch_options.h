// The command line of odemt_batch.
#pragma once

#include <optional>
#include <string>

namespace batch {

struct BatchOptions {
    std::string planFile;
    std::string output;
    unsigned workers = 0;
    bool isResumed = false, isQuiet = false, lists = false;
};

// None if the program ends with `exitCode`.
std::optional<BatchOptions> readBatchOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace batch
