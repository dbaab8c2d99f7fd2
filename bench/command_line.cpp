#include "command_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

#include "support/text.h"

namespace bench {

namespace {

// CLI11 reads 010 as 8.
bool isOctal(const std::string &word) { return word.size() > 1 && word[0] == '0' && std::isdigit(static_cast<unsigned char>(word[1])); }

template <class Number>
CLI::Validator numberBetween(const char *kind, Number least, Number most) {
    std::ostringstream range;
    range << std::setprecision(12) << kind << " from " << least << " to " << most;
    return CLI::Validator(
        [least, most, range = range.str()](const std::string &word) -> std::string {
            Number value = 0;
            const char *const end = word.data() + word.size();
            const auto [stopped, error] = std::from_chars(word.data(), end, value);
            // A NaN is in no range.
            const bool isIn = error == std::errc() && stopped == end && value >= least && value <= most;
            if (isIn && !isOctal(word)) return "";
            return "'" + word + "' is not a " + range;
        },
        "");
}

}  // namespace

CLI::Validator numberIn(double least, double most) { return numberBetween("number", least, most); }
CLI::Validator wholeNumberIn(long least, long most) { return numberBetween("whole number", least, most); }

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
