// Checks of numeric options: one rule for all, and a message that names the range as a person would write it.
//
// A number is what std::from_chars reads of the whole word: no NaN, no infinity, no overflow, nothing behind
// it.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

CLI::Validator numberIn(double least, double most);
CLI::Validator wholeNumberIn(long least, long most);

}  // namespace bench
