#include "dynamics/world_step/fast/dxFactorPlan.h"

#include "core/dxNoIndex.h"

namespace {

// Products of blocks, at some 10 ns: less is not shared.
constexpr double kMinShared = 2000;

// A subtree of more than this part of all products is cut.
constexpr double kMaxPart = 1.0 / 24;

// A column's other work, in products of blocks: its own blocks and its pivot.
double workOf(double blocks) { return blocks * (blocks + 1) / 2 + blocks + 8; }

}  // namespace

void dxFactorPlan::make(const dxEliminationOrder &order) {
    weighSubtrees(order);
    cutTree(order);
    weighTop(order);
    listTargets(order);
}

// Children come before their parents.
void dxFactorPlan::weighSubtrees(const dxEliminationOrder &order) {
    m_total = 0;
    m_weights.assign(order.bodyCount(), 0);
    for (unsigned column = 0; column < order.bodyCount(); ++column) {
        const double work = workOf(order.firstBlock(column + 1) - order.firstBlock(column));
        m_total += work;
        m_weights[column] += work;
        const unsigned parent = order.parentOf(column);
        if (parent != kNoIndex) m_weights[parent] += m_weights[column];
    }
}

// A chunk ends with a subtree, before a column of the top, or when it is large enough.
void dxFactorPlan::cutTree(const dxEliminationOrder &order) {
    const double most = m_total < kMinShared ? 2 * m_total : kMaxPart * m_total;
    m_chunks.clear();
    m_top.clear();
    m_isTop.assign(order.bodyCount(), 0);
    for (unsigned column = 0; column < order.bodyCount(); ++column) m_isTop[column] = m_weights[column] > most;
    double weight = 0;
    bool isOpen = false;
    for (unsigned column = 0; column < order.bodyCount(); ++column) {
        if (m_isTop[column]) {
            m_top.push_back(column);
            isOpen = false;
            continue;
        }
        if (!isOpen) {
            m_chunks.push_back({column, column, 0, 0});
            weight = 0;
            isOpen = true;
        }
        m_chunks.back().end = column + 1;
        const unsigned parent = order.parentOf(column);
        if (parent != kNoIndex && !m_isTop[parent]) continue;
        weight += m_weights[column];
        isOpen = weight <= most / 2;
    }
}

void dxFactorPlan::weighTop(const dxEliminationOrder &order) {
    m_topWork.clear();
    for (const unsigned column : m_top) {
        unsigned work = order.firstBlock(column + 1) - order.firstBlock(column);
        for (unsigned e = order.firstEntry(column); e < order.firstEntry(column + 1); ++e)
            work += order.firstBlock(order.entry(e).column + 1) - order.entry(e).block;
        m_topWork.push_back(work);
    }
}

void dxFactorPlan::listTargets(const dxEliminationOrder &order) {
    const unsigned bodies = order.bodyCount();
    m_targets.resize(order.blockCount());
    for (const unsigned column : m_top)
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block)
            m_targets[block] = order.rowOf(block);
    m_spillRows.clear();
    m_spillOf.assign(bodies, kNoIndex);
    for (Chunk &chunk : m_chunks) {
        chunk.firstSpill = static_cast<unsigned>(m_spillRows.size());
        for (unsigned block = order.firstBlock(chunk.begin); block < order.firstBlock(chunk.end); ++block) {
            const unsigned row = order.rowOf(block);
            m_targets[block] = row;
            if (!m_isTop[row]) continue;
            if (m_spillOf[row] == kNoIndex || m_spillOf[row] < chunk.firstSpill) {
                m_spillOf[row] = static_cast<unsigned>(m_spillRows.size());
                m_spillRows.push_back(row);
            }
            m_targets[block] = bodies + m_spillOf[row];
        }
        chunk.endSpill = static_cast<unsigned>(m_spillRows.size());
    }
}
