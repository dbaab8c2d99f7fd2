// A command as a user types it into a shell, without input unless it gives itself some.
#pragma once

#include <sys/wait.h>

#include <cstddef>
#include <cstdio>
#include <string>

struct Outcome {
    int exitCode;
    std::string output;  // and errors
};

inline Outcome runShell(const std::string &command) {
    FILE *const pipe = popen(("(" + command + ") 2>&1 </dev/null").c_str(), "r");
    std::string output;
    char bytes[4096];
    while (const std::size_t count = std::fread(bytes, 1, sizeof bytes, pipe)) output.append(bytes, count);
    return {WEXITSTATUS(pclose(pipe)), output};
}
