// Copies the coverage counters of a forked child to its parent, where libFuzzer reads them.
//
// The compiler counts how often each edge of instrumented code is taken in a byte of the section __sancov_cntrs
// (-fsanitize-coverage=inline-8bit-counters). A child has its own copy of that section, and may end by a signal at any
// point, so it counts in memory that it shares with its parent. Not in the parent's own section: its first and last pages have
// other variables on them.
//
// Threads: none but the caller may run.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

class SharedCounters {
public:
    // Throws std::runtime_error if there is no code with counters, or no memory for them.
    SharedCounters();
    SharedCounters(const SharedCounters &) = delete;
    SharedCounters &operator=(const SharedCounters &) = delete;

    // In the child: what it counts from now on reaches the parent.
    void share() const noexcept;
    // In the parent, when the child has ended: takes its counters as this process's.
    void collect() const noexcept;

private:
    std::uint8_t *m_pages;   // that have the counters
    std::size_t m_size;      // of these pages, in bytes
    std::uint8_t *m_shared;  // as many
};

}  // namespace fuzz
