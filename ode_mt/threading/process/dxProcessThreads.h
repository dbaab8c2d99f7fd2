// The threads of this process, as the system (/proc) tells: their names, and whether only workers are left.
//
// A process whose first thread has ended by pthread_exit ends with its last thread. Sleeping workers are threads, too, and get no notification when
// the others end: one of them must poll.
//
// Threading: any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

constexpr std::size_t kThreadNameSize = 16;  // the kernel's limit, the end included

// Reads the name of a thread, by its number. Returns false if the system does not tell. Throws std::bad_alloc.
bool dxReadThreadName(std::uint32_t thread, std::string &name);

// Returns whether the first thread has ended and only `threads` others are left. Where the system does not tell how many there are (no /proc, no
// descriptor free), returns whether the first thread has ended: threads that go on then do their steps alone, which is better than a process that
// only SIGKILL ends.
bool dxMayBeLastThreads(unsigned threads);

// Returns whether the first thread has ended and the names of all others begin with one of these. A thread has the name of the one that has made it,
// unless it takes another, so this holds for threads that others' libraries make for ours. False where the system does not tell.
bool dxAreLastThreads(const std::vector<std::string> &names);
