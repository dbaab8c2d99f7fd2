// Signals that a tool which runs programs takes when it is ready for them: those that ask a process to end (SIGINT, SIGTERM, SIGHUP,
// SIGQUIT), and SIGCHLD, the end of a child.
//
// Threading: of a process with one thread.
#pragma once

#include <chrono>

#include "support/process.h"

namespace support {

// From here on these signals wait until they are asked for. Programs that are started in a group of their own do not inherit that.
void deferSignals();

// Returns the next of them within the time; 0: none.
int waitForSignal(std::chrono::milliseconds most);

// Returns a file that is ready to be read (poll) while one of them waits.
Descriptor signalFile();

}  // namespace support
