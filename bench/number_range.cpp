#include "number_range.h"

#include <cctype>
#include <charconv>
#include <iomanip>
#include <sstream>
#include <string>

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

}  // namespace bench
