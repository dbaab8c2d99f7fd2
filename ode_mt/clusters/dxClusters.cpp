#include "clusters/dxClusters.h"

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
