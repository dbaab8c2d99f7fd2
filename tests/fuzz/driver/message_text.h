// What every message of the project's programs keeps to, and what sanitizers say of them.
#pragma once

#include <string>

namespace fuzz_driver {

// Empty when `text` is one line without control characters; else what it has.
std::string whatIsNoPlainLine(const std::string &text);

// The same for a text of several lines.
std::string whatIsNoPlainText(const std::string &text);

// Internal names that mean nothing to the user: of files in memory, of functions of the standard library.
// Empty when there is none.
std::string innerNameIn(const std::string &text);

// Exit code of a process that a sanitizer has ended, if setSanitizerOptions was called before it was started.
constexpr int kSanitizerExitCode = 99;

// Makes sanitizers of programs that are executed from now on end them with kSanitizerExitCode.
void setSanitizerOptions();

// The part of a text that a sanitizer wrote; empty when there is none.
std::string sanitizerReportIn(const std::string &text);

// With control characters as \x1b, and the middle of long texts omitted.
std::string shown(const std::string &text, std::size_t most = 400);

}  // namespace fuzz_driver
