// A command line of one of the programs, run, and what is demanded of its end.
#pragma once

#include "support/child_run.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fuzz_options {

enum class StandardFile { Kept, Closed, Full };

struct Command {
    std::string program;  // its file
    std::vector<std::string> arguments;
    std::map<std::string, std::string> environment;  // what is different in it
    std::string input;
    bool closesInput = false;
    StandardFile output = StandardFile::Kept, errors = StandardFile::Kept;
    std::vector<std::string> results;  // files that it is asked for, in its folder

    std::string text() const;  // as a shell would have it
};

// Runs the command in `folder`.
support::Ending run(const Command &command, const std::filesystem::path &folder);

// All files inside.
std::vector<std::string> filesIn(const std::filesystem::path &folder);

// Empty, or what is wrong: exit codes other than 0, 1 and 2, an error without a word, words that name no
// option, control characters, internal names, unrequested files. `before` are the files that
// were there.
std::string whatIsWrong(const Command &command, const support::Ending &ending,
                        const std::filesystem::path &folder, const std::vector<std::string> &before);

}  // namespace fuzz_options
