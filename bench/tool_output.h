// What a tool says on its standard files: results, errors, and its end where nobody reads them any more.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace bench {

// To be called first. Standard output may be closed or full, which is an error like that of any other file. A file that is opened while
// standard output is closed would take its number, and all that is printed. From then on a standard output that is closed at the other end,
// and a file that may not grow, are reported by what writes.
void keepStandardFiles();

// Throws std::runtime_error with the reason.
void print(const std::string &text);

// Returns the exit code of a program that has ended with this code: 1 instead of 0 if output of other code (help) could not be
// written; the reason is printed to standard error.
int exitCodeAfterOutput(int exitCode);

constexpr int kWrongOption = 2;  // exit code

// A line on standard error, with control characters as \x1b: names and values may hold anything.
void printError(const std::string &message);

// The same for an option, with a second line that refers to --help. Returns kWrongOption.
int printOptionError(const std::string &message);

// Calls `read`, which parses a command line by `app` and throws where it is wrong, and prints what that says. Returns false if the program
// ends with `exitCode`: 0 for --help.
bool readCommandLine(const CLI::App &app, const std::function<void()> &read, int &exitCode);

// Ends a process whose output nobody reads any more, while it is at work that writes nothing.
//
// While it lives, five times a second a timer's signal looks whether standard output is a pipe whose other end is closed, as that of a
// program that was killed, and then ends the process. No thread is started: allocation and locks stay as fast as in a process that has
// one thread.
class ReaderWatch {
public:
    ReaderWatch();
    ~ReaderWatch();
    ReaderWatch(const ReaderWatch &) = delete;
    ReaderWatch &operator=(const ReaderWatch &) = delete;
};

}  // namespace bench
