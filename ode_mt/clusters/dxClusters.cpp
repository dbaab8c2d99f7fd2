#include "clusters/dxClusters.h"

#include <algorithm>
#include <tuple>

void dxClusters::clear(std::size_t slots) {
    m_of.assign(slots, kNone);
    m_count = m_dynamicCount = 0;
}

int dxClusters::addCluster(bool isDynamic) {
    if (m_count == static_cast<int>(m_clusters.size())) m_clusters.emplace_back();
    Cluster &cluster = m_clusters[m_count];
    cluster.members.clear();
    cluster.duplicated.clear();
    cluster.staticClusters.clear();
    cluster.name = 0;
    cluster.task = m_count;
    m_dynamicCount += isDynamic;
    return m_count++;
}

void dxClusters::addMember(int cluster, Slot slot) {
    m_clusters[cluster].members.push_back(slot);
    m_of[slot] = cluster;
}

void dxClusterHistory::follow(const dxClusters &before, dxClusters &now) {
    constexpr unsigned kUnnamed = 0;
    m_changes.clear();
    gatherShares(before, now);
    m_nameIsTaken.assign(before.dynamicCount(), 0);
    for (const Share &share : m_shares) {  // the largest first
        if (now[share.now].name != kUnnamed || m_nameIsTaken[share.before]) continue;
        now[share.now].name = before[share.before].name;
        m_nameIsTaken[share.before] = 1;
    }
    for (int cluster = 0; cluster < now.dynamicCount(); ++cluster)
        if (now[cluster].name == kUnnamed) now[cluster].name = m_nextName++;
    for (const Share &share : m_shares) {
        const unsigned old = before[share.before].name, name = now[share.now].name;
        if (old == name) continue;
        if (m_nameIsTaken[share.before]) report(dxClusterChange::Kind::split, old, name);
        else report(dxClusterChange::Kind::merge, old, name);
    }
}

void dxClusterHistory::gatherShares(const dxClusters &before, const dxClusters &now) {
    m_shares.clear();
    m_counts.assign(before.dynamicCount(), 0);
    for (int cluster = 0; cluster < now.dynamicCount(); ++cluster) {
        m_touched.clear();
        for (const dxClusters::Slot slot : now[cluster].members) {
            const int old = before.of(slot);
            if (old == dxClusters::kNone || old >= before.dynamicCount()) continue;
            if (m_counts[old]++ == 0) m_touched.push_back(old);
        }
        for (const int old : m_touched) {
            m_shares.push_back({cluster, old, m_counts[old]});
            m_counts[old] = 0;
        }
    }
    std::sort(m_shares.begin(), m_shares.end(), [](const Share &a, const Share &b) {
        return std::make_tuple(-a.members, a.before, a.now) < std::make_tuple(-b.members, b.before, b.now);
    });
}

void dxClusterHistory::report(dxClusterChange::Kind kind, unsigned from, unsigned into) {
    m_changes.push_back({kind, from, into});
    ++(kind == dxClusterChange::Kind::merge ? m_merges : m_splits);
}
