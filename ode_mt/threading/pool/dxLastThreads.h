// Detects a process that is kept alive by its workers alone.
//
// A process whose first thread has ended by pthread_exit ends with its last thread. Sleeping workers are threads, too,
// and get no notification when the others end: one of them must poll.
#pragma once

#include <string>
#include <vector>

// True once the first thread has ended and only so many others are left. Where the system does not tell how many there are (no
// /proc, no descriptor free), true once the first thread has ended: threads that go on then do their steps alone, which is better
// than a process that nothing but SIGKILL ends.
bool dxMayBeLastThreads(unsigned threads);

// True once the first thread has ended and the names of all others begin with one of these. A thread has the name of the one that has made it,
// unless it takes another, so this holds for threads that others' libraries make for ours. False where the system does not tell.
bool dxAreLastThreads(const std::vector<std::string> &names);
