// How a factorisation is shared: which columns of the elimination tree are worked on side by side.
//
// A chunk is a range of columns that are some whole subtrees, so that no column of it gets anything from a column outside. Columns above
// all chunks are the top: they come one after the other, and the rows of one are shared. In a solve, what a chunk's columns subtract
// from rows at the top is summed up in spills of its own, which are added in the order of the chunks. So sums have one order, whoever
// works on which chunk, and the plan depends on the elimination order alone.
//
// A small factorisation is one chunk, without a top.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxEliminationOrder.h"

class dxFactorPlan {
public:
    struct Chunk {
        unsigned begin, end;            // columns
        unsigned firstSpill, endSpill;
    };

    void make(const dxEliminationOrder &order);

    const std::vector<Chunk> &chunks() const { return m_chunks; }

    // Ascending.
    const std::vector<unsigned> &top() const { return m_top; }

    // By the place in the top: products of blocks in the column.
    const std::vector<unsigned> &topWork() const { return m_topWork; }

    // The row at the top that the spill belongs to.
    const std::vector<unsigned> &spillRows() const { return m_spillRows; }

    // By block: the row that it is subtracted from; the number of bodies and more: a spill.
    const std::vector<unsigned> &targets() const { return m_targets; }

private:
    void weighSubtrees(const dxEliminationOrder &order);
    void cutTree(const dxEliminationOrder &order);
    void weighTop(const dxEliminationOrder &order);
    void listTargets(const dxEliminationOrder &order);

    std::vector<Chunk> m_chunks;
    std::vector<unsigned> m_top, m_topWork;
    std::vector<unsigned> m_spillRows, m_targets;
    std::vector<double> m_weights;      // of subtrees, by root: products of blocks
    std::vector<char> m_isTop;          // by column
    std::vector<unsigned> m_spillOf;    // by row: the chunk's
    double m_total = 0;
};
