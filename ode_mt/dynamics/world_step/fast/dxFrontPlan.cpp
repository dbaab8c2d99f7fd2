#include "dynamics/world_step/fast/dxFrontPlan.h"

#include <algorithm>

#include "core/dxNoIndex.h"

void dxFrontPlan::make(const dxEliminationOrder &order, const std::vector<unsigned> &rowsOf) {
    m_firstPivot.assign(1, 0);
    for (const unsigned rows : rowsOf) m_firstPivot.push_back(m_firstPivot.back() + rows);
    cutTree(order);
    makeFronts(order);
    placeRows(order);
    listChildren();
    listRuns();
    placeUpdates();
}

void dxFrontPlan::cutTree(const dxEliminationOrder &order) {
    m_factorPlan.make(order);
    const auto chunks = static_cast<unsigned>(m_factorPlan.chunks().size());
    m_regionOf.assign(order.bodyCount(), chunks);
    for (unsigned chunk = 0; chunk < chunks; ++chunk) {
        const dxFactorPlan::Chunk &joints = m_factorPlan.chunks()[chunk];
        std::fill(m_regionOf.begin() + joints.begin, m_regionOf.begin() + joints.end, chunk);
    }
}

// A joint is in the front of the one before it if that has no other row below itself, and both are of one region.
void dxFrontPlan::makeFronts(const dxEliminationOrder &order) {
    m_fronts.clear();
    m_frontOf.clear();
    unsigned blocksBefore = 0;
    for (unsigned joint = 0; joint < order.bodyCount(); ++joint) {
        const unsigned blocks = order.firstBlock(joint + 1) - order.firstBlock(joint);
        const bool goesOn = joint > 0 && order.parentOf(joint - 1) == joint && blocksBefore == blocks + 1 &&
                            m_regionOf[joint - 1] == m_regionOf[joint];
        if (goesOn)
            m_fronts.back().end = joint + 1;
        else
            m_fronts.push_back({joint, joint + 1});
        m_frontOf.push_back(static_cast<unsigned>(m_fronts.size()) - 1);
        blocksBefore = blocks;
    }
}

void dxFrontPlan::placeRows(const dxEliminationOrder &order) {
    m_rowJoints.clear();
    m_rowPlaces.clear();
    m_panelSize = 0;
    m_mostRows = 0;
    for (Front &front : m_fronts) {
        front.pivots = m_firstPivot[front.end] - m_firstPivot[front.begin];
        front.firstRow = static_cast<unsigned>(m_rowJoints.size());
        for (unsigned block = order.firstBlock(front.end - 1); block < order.firstBlock(front.end); ++block) {
            const unsigned joint = order.rowOf(block);
            m_rowJoints.push_back(joint);
            m_rowPlaces.push_back(front.rows);
            front.rows += m_firstPivot[joint + 1] - m_firstPivot[joint];
        }
        front.endRow = static_cast<unsigned>(m_rowJoints.size());
        front.panel = m_panelSize;
        m_panelSize += front.panelSize();
        m_mostRows = std::max(m_mostRows, front.pivots + front.rows);
    }
}

unsigned dxFrontPlan::parentOf(const Front &front) const {
    return front.firstRow < front.endRow ? m_frontOf[m_rowJoints[front.firstRow]] : kNoIndex;
}

void dxFrontPlan::listChildren() {
    for (const Front &front : m_fronts)
        if (parentOf(front) != kNoIndex) ++m_fronts[parentOf(front)].endChild;
    unsigned count = 0;
    for (Front &front : m_fronts) {
        const unsigned children = front.endChild;
        front.firstChild = front.endChild = count;
        count += children;
    }
    m_children.resize(count);
    for (unsigned i = 0; i < m_fronts.size(); ++i) {
        const unsigned parent = parentOf(m_fronts[i]);
        if (parent != kNoIndex) m_children[m_fronts[parent].endChild++].front = i;
    }
}

void dxFrontPlan::listRuns() {
    m_runs.clear();
    for (const Front &parent : m_fronts)
        for (unsigned i = parent.firstChild; i < parent.endChild; ++i) {
            Child &child = m_children[i];
            child.firstRun = static_cast<unsigned>(m_runs.size());
            listRuns(parent, m_fronts[child.front]);
            child.endRun = static_cast<unsigned>(m_runs.size());
        }
}

// All rows of a child are rows of its parent, in the same order. A run ends with the parent's pivots.
void dxFrontPlan::listRuns(const Front &parent, const Front &child) {
    unsigned next = parent.firstRow;
    for (unsigned row = child.firstRow; row < child.endRow; ++row) {
        const unsigned joint = m_rowJoints[row], length = m_firstPivot[joint + 1] - m_firstPivot[joint];
        if (joint >= parent.end)
            while (m_rowJoints[next] != joint) ++next;
        const unsigned to = joint < parent.end ? m_firstPivot[joint] - m_firstPivot[parent.begin] : parent.pivots + m_rowPlaces[next];
        if (row > child.firstRow && to == m_runs.back().to + m_runs.back().length && to != parent.pivots)
            m_runs.back().length += length;
        else
            m_runs.push_back({m_rowPlaces[row], to, length});
    }
    m_runs.push_back({child.rows, parent.pivots + parent.rows, 1});
}

// Updates of a region are a stack: a front's is made above those of its children, and then moved down to the place of the first of these.
// Children of a front at the top that are in chunks stay where they are.
void dxFrontPlan::placeUpdates() {
    m_chunks.clear();
    m_top.clear();
    m_updateSize = 0;
    std::size_t stackEnd = 0;
    const auto place = [&](Front &front) {
        front.madeAt = front.update = stackEnd;
        for (unsigned i = front.endChild; i-- > front.firstChild;) {
            const Front &child = m_fronts[m_children[i].front];
            if (m_regionOf[child.begin] == m_regionOf[front.begin]) front.update = child.update;
        }
        stackEnd = front.update + front.updateSize();
        m_updateSize = std::max(m_updateSize, front.madeAt + front.updateSize());
    };
    for (const dxFactorPlan::Chunk &joints : m_factorPlan.chunks()) {
        m_chunks.push_back({m_frontOf[joints.begin], m_frontOf[joints.end - 1] + 1});
        stackEnd = m_updateSize;
        for (unsigned i = m_chunks.back().begin; i < m_chunks.back().end; ++i) place(m_fronts[i]);
    }
    stackEnd = m_updateSize;
    for (const unsigned joint : m_factorPlan.top()) {
        const unsigned front = m_frontOf[joint];
        if (m_fronts[front].begin != joint) continue;
        place(m_fronts[front]);
        m_top.push_back(front);
    }
}
