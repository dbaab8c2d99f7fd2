#include "dynamics/direct/dxEliminationOrder.h"

#include <algorithm>
#include <functional>

#include "core/dxNoIndex.h"

void dxEliminationOrder::find(unsigned bodyCount, const std::vector<std::pair<unsigned, unsigned>> &pairs) {
    buildGraph(bodyCount, pairs);
    orderBodies(bodyCount);
    listColumns();
    listRows();
}

void dxEliminationOrder::buildGraph(unsigned bodyCount, const std::vector<std::pair<unsigned, unsigned>> &pairs) {
    if (m_neighbours.size() < bodyCount) m_neighbours.resize(bodyCount);
    for (unsigned i = 0; i < bodyCount; ++i) m_neighbours[i].clear();
    for (const auto &[a, b] : pairs) {
        m_neighbours[a].push_back(b);
        m_neighbours[b].push_back(a);
    }
    for (unsigned i = 0; i < bodyCount; ++i) {
        std::vector<unsigned> &list = m_neighbours[i];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    m_mark.assign(bodyCount, 0);
    m_lastMark = 0;
}

// The heap keeps outdated entries, which are recognised by their degree.
void dxEliminationOrder::orderBodies(unsigned bodyCount) {
    m_sequence.clear();
    m_placeOf.assign(bodyCount, kNoIndex);
    m_heap.clear();
    for (unsigned i = 0; i < bodyCount; ++i) m_heap.emplace_back(m_neighbours[i].size(), i);
    std::make_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    while (!m_heap.empty()) {
        std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
        const auto [degree, body] = m_heap.back();
        m_heap.pop_back();
        if (m_placeOf[body] != kNoIndex || degree != m_neighbours[body].size()) continue;
        m_placeOf[body] = static_cast<unsigned>(m_sequence.size());
        m_sequence.push_back(body);
        eliminate(body);
    }
}

void dxEliminationOrder::eliminate(unsigned body) {
    const std::vector<unsigned> &clique = m_neighbours[body];
    for (const unsigned neighbour : clique) {
        std::vector<unsigned> &list = m_neighbours[neighbour];
        const std::size_t before = list.size();
        list.erase(std::find(list.begin(), list.end(), body));
        ++m_lastMark;
        m_mark[neighbour] = m_lastMark;
        for (const unsigned known : list) m_mark[known] = m_lastMark;
        for (const unsigned other : clique)
            if (m_mark[other] != m_lastMark) list.push_back(other);
        if (list.size() == before) continue;
        m_heap.emplace_back(list.size(), neighbour);
        std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    }
}

void dxEliminationOrder::listColumns() {
    m_columnStart.clear();
    m_rowOf.clear();
    for (const unsigned body : m_sequence) {
        const auto start = static_cast<unsigned>(m_rowOf.size());
        m_columnStart.push_back(start);
        for (const unsigned neighbour : m_neighbours[body]) m_rowOf.push_back(m_placeOf[neighbour]);
        std::sort(m_rowOf.begin() + start, m_rowOf.end());
    }
    m_columnStart.push_back(static_cast<unsigned>(m_rowOf.size()));
}

void dxEliminationOrder::listRows() {
    const unsigned bodies = bodyCount();
    m_rowStart.assign(bodies + 1, 0);
    for (const unsigned row : m_rowOf) ++m_rowStart[row + 1];
    for (unsigned i = 0; i < bodies; ++i) m_rowStart[i + 1] += m_rowStart[i];
    m_entries.resize(m_rowOf.size());
    std::vector<unsigned> &next = m_mark;
    next.assign(m_rowStart.begin(), m_rowStart.end());
    for (unsigned column = 0; column < bodies; ++column)
        for (unsigned block = m_columnStart[column]; block < m_columnStart[column + 1]; ++block)
            m_entries[next[m_rowOf[block]]++] = {column, block};
}

unsigned dxEliminationOrder::findBlock(unsigned row, unsigned column) const {
    const auto begin = m_rowOf.begin() + m_columnStart[column], end = m_rowOf.begin() + m_columnStart[column + 1];
    return static_cast<unsigned>(std::lower_bound(begin, end, row) - m_rowOf.begin());
}
