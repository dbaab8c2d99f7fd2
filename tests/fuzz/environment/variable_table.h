// The library's variables as docs/settings.md promises them, and what it says of a value.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fuzz_environment {

struct Variable {
    std::string name;
    std::vector<std::string> words;  // that it takes: "auto", "serial" ...
    bool takesNumber = false, takesList = false;
    bool takesFraction = false;            // from 0 to 1, as "0.25" or "1e-3"
    std::optional<long long> least, most;  // of the number, where the table has them
    std::string standard;                  // what is taken when it is unset: the first word of the column
};

// Throws std::runtime_error when the document has no table.
std::vector<Variable> readVariableTable(const std::string &document);

// The names of heuristics, from the table of docs/clusters.md.
std::vector<std::string> readHeuristicNames(const std::string &document);

enum class Understanding {
    Unset,  // or empty
    Understood,
    OutOfRange,     // reported, and the nearest number taken
    NotUnderstood,  // reported, and the standard taken
    Untold          // the page does not say
};

struct Meaning {
    Understanding understanding;
    std::string taken;  // a word or a number; empty: any
};
Meaning meaningOf(const Variable &variable, const std::string &value,
                  const std::vector<std::string> &heuristics);

}  // namespace fuzz_environment
