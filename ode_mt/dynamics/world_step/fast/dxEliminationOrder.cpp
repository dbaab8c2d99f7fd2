#include "dynamics/world_step/fast/dxEliminationOrder.h"

#include <algorithm>
#include <functional>

#include "core/dxNoIndex.h"

void dxEliminationGraph::eliminateAll(unsigned nodeCount, const std::vector<std::pair<unsigned, unsigned>> &edges) {
    build(nodeCount, edges);
    m_sequence.clear();
    m_heap.clear();
    m_fill.assign(nodeCount, -1);
    m_degree.assign(nodeCount, 0);
    m_isEliminated.assign(nodeCount, 0);
    m_isChanged.assign(nodeCount, 0);
    m_triangles.resize(nodeCount);
    for (unsigned node = 0; node < nodeCount; ++node) {
        countTriangles(node);
        update(node);
    }
    while (!m_heap.empty()) {
        std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
        const Entry next = m_heap.back();
        m_heap.pop_back();
        const bool isValid = next.fill == m_fill[next.node] && next.degree == m_degree[next.node];
        if (isValid && !m_isEliminated[next.node]) eliminate(next.node);
    }
}

void dxEliminationGraph::build(unsigned nodeCount, const std::vector<std::pair<unsigned, unsigned>> &edges) {
    if (m_neighbours.size() < nodeCount) m_neighbours.resize(nodeCount);
    for (unsigned i = 0; i < nodeCount; ++i) m_neighbours[i].clear();
    for (const auto &[a, b] : edges) {
        m_neighbours[a].push_back(b);
        m_neighbours[b].push_back(a);
    }
    for (unsigned i = 0; i < nodeCount; ++i) {
        std::vector<unsigned> &list = m_neighbours[i];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    m_mark.assign(nodeCount, 0);
    m_lastMark = 0;
}

void dxEliminationGraph::mark(unsigned node) {
    ++m_lastMark;
    m_mark[node] = m_lastMark;
    for (const unsigned neighbour : m_neighbours[node]) m_mark[neighbour] = m_lastMark;
}

void dxEliminationGraph::countTriangles(unsigned node) {
    mark(node);
    unsigned edges = 0;
    for (const unsigned neighbour : m_neighbours[node])
        for (const unsigned other : m_neighbours[neighbour]) edges += other > neighbour && other != node && isMarked(other);
    m_triangles[node] = edges;
}

void dxEliminationGraph::update(unsigned node) {
    const auto degree = static_cast<unsigned>(m_neighbours[node].size());
    const double n = degree, fill = degree > 0 ? (n * (n - 1) / 2 - m_triangles[node]) / n : 0;
    if (fill == m_fill[node] && degree == m_degree[node]) return;
    m_fill[node] = fill;
    m_degree[node] = degree;
    m_heap.push_back({fill, degree, node});
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
}

void dxEliminationGraph::eliminate(unsigned node) {
    m_isEliminated[node] = 1;
    m_sequence.push_back(node);
    const std::vector<unsigned> &clique = m_neighbours[node];
    for (std::size_t i = 0; i + 1 < clique.size(); ++i) {
        mark(clique[i]);
        for (std::size_t k = i + 1; k < clique.size(); ++k)
            if (!isMarked(clique[k])) connect(clique[i], clique[k]);
    }
    remove(node);
    for (const unsigned changed : m_changed) {
        m_isChanged[changed] = 0;
        update(changed);
    }
    m_changed.clear();
}

// Its neighbours, which are all neighbours of one another, lose it and the edges to it.
void dxEliminationGraph::remove(unsigned node) {
    const std::vector<unsigned> &clique = m_neighbours[node];
    for (const unsigned neighbour : clique) {
        std::vector<unsigned> &list = m_neighbours[neighbour];
        *std::find(list.begin(), list.end(), node) = list.back();
        list.pop_back();
        m_triangles[neighbour] -= static_cast<unsigned>(clique.size()) - 1;
        noteChange(neighbour);
    }
}

void dxEliminationGraph::noteChange(unsigned node) {
    if (m_isChanged[node]) return;
    m_isChanged[node] = 1;
    m_changed.push_back(node);
}

// Requires that `a` and its neighbours are marked.
void dxEliminationGraph::connect(unsigned a, unsigned b) {
    unsigned common = 0;
    for (const unsigned other : m_neighbours[b]) {
        if (!isMarked(other)) continue;
        ++common;
        ++m_triangles[other];
        noteChange(other);
    }
    m_triangles[a] += common;
    m_triangles[b] += common;
    m_neighbours[a].push_back(b);
    m_neighbours[b].push_back(a);
    m_mark[b] = m_lastMark;
}

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
