#include "program_line.h"

#include "support/text.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace bench {

std::vector<std::string> parseProgramLine(CLI::App &app, int argc, const char *const *argv) {
    const char *const *const end = argv + argc;
    const char *const *const dashes = std::find_if(argv + 1, end, [](const char *word) { return std::strcmp(word, "--") == 0; });
    app.parse(static_cast<int>(dashes - argv), argv);
    std::vector<std::string> command;
    if (dashes != end) command.assign(dashes + 1, end);
    if (command.empty() || command[0].empty())
        throw std::invalid_argument("no program given: " + app.get_name() + " [OPTIONS] -- PROGRAM [ARGUMENT...]");
    return command;
}

void checkThreadCount(const std::string &word) {
    if (word == "auto") return;
    int number = -1;
    const char *const end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || stopped != end || number < 0 || number > 1024)
        throw std::invalid_argument("--threads: " + support::quote(word) + " is neither a number from 0 to 1024 nor auto");
}

}  // namespace bench
