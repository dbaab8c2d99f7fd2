// How far a long run is, on standard error.
#pragma once

#include <chrono>
#include <string>

#include "race.h"

namespace bench {

// One line on standard error that says how far a long run is: drawn anew in its place on a terminal, a new line every few seconds elsewhere.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    bool isOnTerminal() const { return m_isTerminal; }

    // Whether it is time for a new text. To be asked before each, as the next one is due some time after the answer is yes.
    bool isDue();
    void show(const std::string &text);
    void clear();  // before other output, so that it starts on an empty line

private:
    using Clock = std::chrono::steady_clock;

    const bool m_isTerminal;
    bool m_isShown = false;
    Clock::time_point m_next = Clock::now();
};

// How far the bench is, as a line with a bar on a terminal.
class Progress {
public:
    Progress(std::size_t worlds, const StoppingRule &rule);

    // What will be measured, and how long that takes at most.
    void announce(const std::vector<std::string> &worlds, const std::vector<Engine> &engines) const;

    void showLoading(const std::string &world, const Engine &engine);
    void show(std::size_t world, const WorldResult &result);
    void clear() { m_line.clear(); }  // before other output, so that it starts on an empty line

private:
    std::size_t m_worlds;
    StoppingRule m_rule;
    ProgressLine m_line;
};

}  // namespace bench
