// How far the bench is, as a line with a bar on a terminal.
#pragma once

#include "progress_line.h"
#include "race.h"

namespace bench {

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
