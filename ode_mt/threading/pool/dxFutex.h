// Sleeping on a 32-bit word (Linux futex, private to the process).
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

using dxFutexWord = std::atomic<std::uint32_t>;

// Sleeps while the word holds `expected`. May return early: the caller checks its condition again.
void dxFutexWait(dxFutexWord &word, std::uint32_t expected);

// The same for so long at most. False: it has passed.
bool dxFutexWaitFor(dxFutexWord &word, std::uint32_t expected, std::chrono::nanoseconds most);

// Wakes up to `count` sleepers. The word may already belong to another object: waking accesses no memory.
void dxFutexWake(dxFutexWord &word, unsigned count);
