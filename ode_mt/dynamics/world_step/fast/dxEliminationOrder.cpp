#include "dynamics/world_step/fast/dxEliminationOrder.h"

#include <algorithm>

#include "core/dxNoIndex.h"

void dxEliminationOrder::find(unsigned bodyCount, const std::vector<std::pair<unsigned, unsigned>> &pairs) {
    m_graph.eliminateAll(bodyCount, pairs);
    placeBodies();
    listColumns();
    listRows();
}

// Postorder. Of several children the one with the most neighbours is last: its column continues in its parent's (dxFactorPlan).
void dxEliminationOrder::placeBodies() {
    const std::vector<unsigned> &eliminated = m_graph.sequence();
    const auto count = static_cast<unsigned>(eliminated.size());
    m_placeOf.resize(count);
    for (unsigned i = 0; i < count; ++i) m_placeOf[eliminated[i]] = i;
    m_parent.assign(count, kNoIndex);
    m_firstChild.assign(count + 1, kNoIndex);  // the last: of no node, roots
    m_nextSibling.assign(count, kNoIndex);
    const auto degree = [&](unsigned i) { return m_graph.laterNeighbours(eliminated[i]).size(); };
    for (unsigned i = 0; i < count; ++i) {
        for (const unsigned neighbour : m_graph.laterNeighbours(eliminated[i])) m_parent[i] = std::min(m_parent[i], m_placeOf[neighbour]);
        unsigned *link = &m_firstChild[m_parent[i] != kNoIndex ? m_parent[i] : count];  // the most neighbours first: a stack turns them
        while (*link != kNoIndex && degree(*link) > degree(i)) link = &m_nextSibling[*link];
        m_nextSibling[i] = *link;
        *link = i;
    }
    m_sequence.resize(count);
    m_stack.clear();
    for (unsigned root = m_firstChild[count]; root != kNoIndex; root = m_nextSibling[root]) m_stack.push_back(root);
    std::reverse(m_stack.begin(), m_stack.end());
    for (unsigned place = count; place > 0;) {  // from the last place on: parents before children
        const unsigned node = m_stack.back();
        m_stack.pop_back();
        m_sequence[--place] = eliminated[node];
        const std::size_t begin = m_stack.size();
        for (unsigned child = m_firstChild[node]; child != kNoIndex; child = m_nextSibling[child]) m_stack.push_back(child);
        std::reverse(m_stack.begin() + static_cast<std::ptrdiff_t>(begin), m_stack.end());
    }
    for (unsigned i = 0; i < count; ++i) m_placeOf[m_sequence[i]] = i;
}

void dxEliminationOrder::listColumns() {
    m_columnStart.clear();
    m_rowOf.clear();
    for (const unsigned body : m_sequence) {
        const auto start = static_cast<unsigned>(m_rowOf.size());
        m_columnStart.push_back(start);
        for (const unsigned neighbour : m_graph.laterNeighbours(body)) m_rowOf.push_back(m_placeOf[neighbour]);
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
    m_next.assign(m_rowStart.begin(), m_rowStart.end());
    for (unsigned column = 0; column < bodies; ++column)
        for (unsigned block = m_columnStart[column]; block < m_columnStart[column + 1]; ++block)
            m_entries[m_next[m_rowOf[block]]++] = {column, block};
}

unsigned dxEliminationOrder::parentOf(unsigned column) const {
    return m_columnStart[column] < m_columnStart[column + 1] ? m_rowOf[m_columnStart[column]] : kNoIndex;
}

unsigned dxEliminationOrder::findBlock(unsigned row, unsigned column) const {
    const auto begin = m_rowOf.begin() + m_columnStart[column], end = m_rowOf.begin() + m_columnStart[column + 1];
    return static_cast<unsigned>(std::lower_bound(begin, end, row) - m_rowOf.begin());
}
