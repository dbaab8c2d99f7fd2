// The members of each cluster, recomputed from scratch in every frame from the rules as the thesis states them
// (chapters 2 and 5 to 8): every inhabitant against every other, labels spread until nothing changes. What it
// shares with the code under test is the type of a box.
//
// Rules under which what has merged stays merged remember the labels of the last frame.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "ReferenceGrid.h"

struct ReferenceInhabitant {
    int id;  // not given again
    bool isDynamic;
    dxBounds box;
    std::set<dBodyID> bodies;
};

class ReferenceClusters {
public:
    explicit ReferenceClusters(const std::string &pass) : m_pass(pass) {}

    void frame(const std::vector<ReferenceInhabitant> &inhabitants);

    const ReferenceGrid &grid() const { return m_grid; }
    bool gridIsNew() const { return m_frameOfGrid == m_frame; }
    // `i` and `k` are indices into the inhabitants of the last frame.
    bool isBig(std::size_t i) const { return m_isBig[i]; }
    bool isClustered(std::size_t i) const { return m_label[i] != kNone; }
    bool together(std::size_t i, std::size_t k) const { return isClustered(i) && m_label[i] == m_label[k]; }
    bool duplicates(std::size_t dynamic, std::size_t fixed) const;
    bool pseudoMerges(std::size_t dynamic, std::size_t fixed) const;
    bool oneTask(std::size_t i, std::size_t k) const { return m_task.at(m_label[i]) == m_task.at(m_label[k]); }

private:
    static constexpr int kNone = -1;

    bool isSticky() const { return m_pass != "decluster"; }
    bool clustersStatics() const { return m_pass == "static" || m_pass == "static-unmerged"; }
    bool duplicatesStatics() const { return m_pass == "duplication" || m_pass == "decluster"; }
    void placeGrid();
    void label();
    bool belongTogether(std::size_t i, std::size_t k) const;
    bool areLinked(std::size_t i, std::size_t k) const;
    bool clusterSharesCell(int label, const ReferenceCells &cells) const;
    void makeTasks();
    template <class Related>
    void spread(std::vector<int> &labels, Related related) const;

    std::string m_pass;
    int m_frame = 0, m_frameOfGrid = 0;
    ReferenceGrid m_grid;
    std::map<int, int> m_before;  // id to label; empty: clusters are made for the first time
    std::vector<ReferenceInhabitant> m_inhabitants;
    std::vector<ReferenceCells> m_cells;
    std::vector<bool> m_isBig;
    std::vector<int> m_label;
    std::map<int, int> m_task;  // of a label
};
