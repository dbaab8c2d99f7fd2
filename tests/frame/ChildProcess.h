// Runs a function in a forked child and keeps how it ended and what it wrote to standard error.
#pragma once

#include <functional>
#include <string>

struct ChildEnd {
    int status = 0;  // as waitpid gives it
    std::string errors;

    bool exitedWith(int code) const;
    bool killedBy(int signal) const;
};

// A child that has not ended after 20 s is killed by SIGALRM. It ends with exit status 0 if the function
// returns, without running what was registered with atexit.
ChildEnd runInChild(const std::function<void()> &function);

// Whether the function returned true in the child.
bool trueInChild(const std::function<bool()> &function);
