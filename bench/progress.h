// One line on standard error that says how far a long run is: a bar that is drawn anew in its place on a terminal, a new line
// every few seconds elsewhere.
#pragma once

#include "race.h"

#include <chrono>

namespace bench {

class Progress {
public:
    Progress(std::size_t worlds, const StoppingRule &rule);
    ~Progress() { clear(); }

    // What will be measured, and how long that takes at most.
    void announce(const std::vector<std::string> &worlds, const std::vector<Engine> &engines) const;

    void show(std::size_t world, const WorldResult &result);
    void clear();  // before other output, so that it starts on an empty line

private:
    using Clock = std::chrono::steady_clock;

    std::size_t m_worlds;
    StoppingRule m_rule;
    bool m_isTerminal;
    bool m_isShown = false;
    Clock::time_point m_next = Clock::now();
};

}  // namespace bench
