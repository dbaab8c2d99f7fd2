// As many threads as clusters (thesis 10.3). Not in the default choice of heuristics.
//
// The thesis tried it, found no benefit and dropped it: the count follows every merge and split, and with
// some thread libraries each change creates or ends threads. Here the engine cuts the work into chunks that
// do not depend on the threads, and the cost model decides how many threads are used, so there is still less to gain.
// It stays for measurement: an alert comes whenever the number changes.
//
// Results of chunks do not depend on the thread that runs them, so any answer is right.
#pragma once

#include <algorithm>

#include "clusters/heuristics/dxHeuristic.h"

class dxThreadCountHeuristic final : public dxHeuristic {
public:
    // `limit` is the number of threads that the user allows. Takes effect at the next tick, if running.
    void observe(unsigned clusters, unsigned limit) {
        m_clusters = clusters;
        m_limit = std::max(limit, 1u);
    }

    // Returns a number from 1 to the limit.
    unsigned threads() const { return running() && m_wanted != 0 ? std::min(m_wanted, m_limit) : m_limit; }

private:
    void judge() override {
        const unsigned before = threads();
        m_wanted = std::max(m_clusters, 1u);
        alert(before, threads());
    }
    void forget() override { m_wanted = 0; }

    unsigned m_clusters = 1;
    unsigned m_limit = 1;
    unsigned m_wanted = 0;  // 0: nothing is known yet
};
