// Standard output that may be closed or full, which is an error like that of any other file.
#pragma once

#include <string>

namespace bench {

// To be called first. A file that is opened while standard output is closed would take its number, and all that is printed.
// From then on a standard output that is closed at the other end, and a file that may not grow, are reported by what writes.
void keepStandardFiles();

// Throws std::runtime_error with the reason.
void print(const std::string &text);

// Returns the exit code of a program that has ended with this code: 1 instead of 0 if output of other code (help) could not be
// written; the reason is printed to standard error.
int exitCodeAfterOutput(int exitCode);

}  // namespace bench
