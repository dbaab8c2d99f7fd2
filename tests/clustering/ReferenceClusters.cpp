#include "ReferenceClusters.h"

namespace {

// The constants of docs/clusters.md.
constexpr int kCellsPerAxis = 5;
constexpr int kFramesBetweenGrids = 16;

}  // namespace

void ReferenceClusters::frame(const std::vector<ReferenceInhabitant> &inhabitants) {
    ++m_frame;
    m_inhabitants = inhabitants;
    placeGrid();
    m_cells.clear();
    m_isBig.clear();
    for (const ReferenceInhabitant &inhabitant : m_inhabitants) {
        m_cells.push_back(m_grid.cellsOf(inhabitant.box));
        m_isBig.push_back(!inhabitant.box.isProper() ||
                          m_cells.back().count() > kCellsPerAxis * kCellsPerAxis / 2);
    }
    label();
    makeTasks();
    m_before.clear();
    for (std::size_t i = 0; i < m_inhabitants.size(); ++i)
        if (isClustered(i)) m_before[m_inhabitants[i].id] = m_label[i];
}

void ReferenceClusters::placeGrid() {
    std::vector<dxBounds> moving;
    for (const ReferenceInhabitant &inhabitant : m_inhabitants)
        if (inhabitant.isDynamic) moving.push_back(inhabitant.box);
    const bool due = m_frame - m_frameOfGrid >= kFramesBetweenGrids && m_grid.isOutgrownBy(moving);
    if (m_frame > 1 && !due) return;
    m_grid = ReferenceGrid::around(moving, kCellsPerAxis);
    m_frameOfGrid = m_frame;
    m_before.clear();
}

template <class Related>
void ReferenceClusters::spread(std::vector<int> &labels, Related related) const {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < labels.size(); ++i)
            for (std::size_t k = 0; k < labels.size(); ++k)
                if (labels[i] != kNone && labels[k] != kNone && labels[k] > labels[i] && related(i, k)) {
                    labels[k] = labels[i];
                    changed = true;
                }
    }
}

void ReferenceClusters::label() {
    m_label.assign(m_inhabitants.size(), kNone);
    for (std::size_t i = 0; i < m_inhabitants.size(); ++i)
        if (!m_isBig[i] && (m_inhabitants[i].isDynamic || clustersStatics())) m_label[i] = static_cast<int>(i);
    spread(m_label, [&](std::size_t i, std::size_t k) { return belongTogether(i, k); });
}

bool ReferenceClusters::belongTogether(std::size_t i, std::size_t k) const {
    const ReferenceInhabitant &a = m_inhabitants[i], &b = m_inhabitants[k];
    if (a.isDynamic != b.isDynamic) return false;
    if (!a.isDynamic && m_pass == "static-unmerged") return false;
    if (isSticky()) {
        const auto oldA = m_before.find(a.id), oldB = m_before.find(b.id);
        if (oldA != m_before.end() && oldB != m_before.end() && oldA->second == oldB->second) return true;
    }
    if (a.isDynamic && areLinked(i, k)) return true;
    const bool floods = a.isDynamic && (!isSticky() || m_before.empty());
    return floods ? m_cells[i].touch(m_cells[k]) : m_cells[i].share(m_cells[k]);
}

bool ReferenceClusters::areLinked(std::size_t i, std::size_t k) const {
    for (const dBodyID a : m_inhabitants[i].bodies)
        for (const dBodyID b : m_inhabitants[k].bodies)
            if (a == b || dAreConnected(a, b)) return true;
    return false;
}

bool ReferenceClusters::clusterSharesCell(int label, const ReferenceCells &cells) const {
    for (std::size_t i = 0; i < m_label.size(); ++i)
        if (m_label[i] == label && m_cells[i].share(cells)) return true;
    return false;
}

bool ReferenceClusters::duplicates(std::size_t dynamic, std::size_t fixed) const {
    return duplicatesStatics() && clusterSharesCell(m_label[dynamic], m_cells[fixed]);
}

bool ReferenceClusters::pseudoMerges(std::size_t dynamic, std::size_t fixed) const {
    if (!clustersStatics() || !isClustered(fixed)) return false;
    for (std::size_t i = 0; i < m_label.size(); ++i)
        if (m_label[i] == m_label[fixed] && clusterSharesCell(m_label[dynamic], m_cells[i])) return true;
    return false;
}

// Dynamic clusters around one static cluster are one task.
void ReferenceClusters::makeTasks() {
    std::vector<int> tasks = m_label;
    spread(tasks, [&](std::size_t i, std::size_t k) {
        if (m_label[i] == m_label[k]) return true;
        const bool iMoves = m_inhabitants[i].isDynamic, kMoves = m_inhabitants[k].isDynamic;
        return clustersStatics() && iMoves != kMoves && m_cells[i].share(m_cells[k]);
    });
    m_task.clear();
    for (std::size_t i = 0; i < tasks.size(); ++i)
        if (isClustered(i)) m_task[m_label[i]] = tasks[i];
}
