// Signals that are waited for instead of handled: Ctrl-C and its like, and the end of the program.
#pragma once

#include <chrono>

namespace top {

// First of all. From here on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGCHLD wait until they are asked for.
void deferSignals();

// The next of them within the time; 0: none.
int waitForSignal(std::chrono::milliseconds most);

}  // namespace top
