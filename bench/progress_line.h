// One line on standard error that says how far a long run is: drawn anew in its place on a terminal, a new line every few seconds elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace bench {

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

}  // namespace bench
