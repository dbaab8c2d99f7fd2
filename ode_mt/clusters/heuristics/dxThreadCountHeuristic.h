// As many threads as clusters (thesis 10.3). Not in the default choice of heuristics.
//
// The thesis tried it, found no benefit and dropped it: the count follows every merge and split, and with
// some thread libraries each change creates or ends threads. Here the engine cuts the work into blocks that
// do not depend on the threads, and the cost model decides how many are used, so there is still less to gain.
// It stays for measurement: an alert comes whenever the number goes up or down.
//
// Threads compute blocks whose results do not depend on who runs them, so any answer is right.
#pragma once

#include <algorithm>

#include "clusters/heuristics/dxHeuristic.h"

class dxThreadCountHeuristic final : public dxHeuristic {
public:
    // `limit`: the most threads the user allows. Takes effect at the next tick, if running.
    void observe(unsigned clusters, unsigned limit) {
        m_clusters = clusters;
        m_limit = std::max(limit, 1u);
    }

    unsigned threads() const;  // from 1 to the limit

private:
    void judge() override;
    void forget() override;

    unsigned m_clusters = 1;
    unsigned m_limit = 1;
    unsigned m_wanted = 0;  // 0: nothing is known yet
};
