// What happened to clusters from one frame to the next: names that stay, merges (thesis chapter 2) and splits (chapter 8).
#pragma once

#include <cstdint>
#include <vector>

#include "clusters/dxClusters.h"

struct dxClusterChange {
    enum class Kind { merge, split };
    Kind kind;
    unsigned from, into;  // names: `from` became part of `into`; or `into` came off `from`
};

class dxClusterHistory {
public:
    // Gives the dynamic clusters of `now` their names: each has that of the cluster of `before` most of whose
    // members it holds, if no other has a better claim, else a new one. Names are not given again.
    void follow(const dxClusters &before, dxClusters &now);
    // A search found all clusters as they were.
    void rest() { m_changes.clear(); }

    // Of the last search.
    const std::vector<dxClusterChange> &changes() const { return m_changes; }
    unsigned merges() const { return m_merges; }  // since the start
    unsigned splits() const { return m_splits; }

private:
    struct Share {
        int now, before;
        int members;
    };

    void gatherShares(const dxClusters &before, const dxClusters &now);
    void report(dxClusterChange::Kind kind, unsigned from, unsigned into);

    std::vector<Share> m_shares;
    std::vector<dxClusterChange> m_changes;
    std::vector<std::uint8_t> m_nameIsTaken;  // of the cluster before
    std::vector<int> m_counts, m_touched;     // of the cluster now: members by the cluster before
    unsigned m_nextName = 1, m_merges = 0, m_splits = 0;
};
