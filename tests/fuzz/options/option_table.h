// The options of a program, as its --help lists them: none is forgotten.
#pragma once

#include <string>
#include <vector>

namespace fuzz_options {

struct Option {
    std::string name;                  // "--frames", or "world" of a positional one
    std::string type;                  // "TEXT", "INT", "FLOAT", "UINT"; empty: a flag
    std::vector<std::string> choices;  // of {a,b,c} behind the type
    bool isPositional = false;
};

// Throws std::runtime_error when the text lists no option.
std::vector<Option> readOptionTable(const std::string &help);

}  // namespace fuzz_options
