// The symbolic factorisation of an island's matrix in body space: in which order bodies are eliminated, and which blocks
// of the factor are not zero. It depends on which bodies share joints, and on no number.
//
// The order is that of dxEliminationGraph, sorted so that the elimination tree is in postorder: a column's parent is the first row below
// its diagonal, and the columns of a subtree stand side by side, their root last. The factor has the same blocks.
// Source: Davis, "Direct Methods for Sparse Linear Systems", chapter 4.
//
// Deterministic: numbers of bodies decide, and nothing else.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxEliminationGraph.h"

class dxEliminationOrder {
public:
    // Entries of the factor's rows: block `block` stands in column `column`.
    struct RowEntry {
        unsigned column, block;
    };

    // `pairs`: bodies that share joints, in any order and as often as there are joints.
    void find(unsigned bodyCount, const std::vector<std::pair<unsigned, unsigned>> &pairs);

    unsigned bodyCount() const { return static_cast<unsigned>(m_placeOf.size()); }
    unsigned blockCount() const { return static_cast<unsigned>(m_rowOf.size()); }  // below the diagonal
    unsigned placeOf(unsigned body) const { return m_placeOf[body]; }

    // Blocks of a column, by places: firstBlock(column) to firstBlock(column + 1), rows ascending.
    unsigned firstBlock(unsigned column) const { return m_columnStart[column]; }
    unsigned rowOf(unsigned block) const { return m_rowOf[block]; }

    // In the elimination tree; kNoIndex: none.
    unsigned parentOf(unsigned column) const;

    // Entries of a row: firstEntry(row) to firstEntry(row + 1), columns ascending.
    unsigned firstEntry(unsigned row) const { return m_rowStart[row]; }
    const RowEntry &entry(unsigned index) const { return m_entries[index]; }

    // Requires row > column and a block there.
    unsigned findBlock(unsigned row, unsigned column) const;

private:
    void placeBodies();
    void listColumns();
    void listRows();

    dxEliminationGraph m_graph;
    std::vector<unsigned> m_sequence, m_placeOf;
    std::vector<unsigned> m_parent, m_firstChild, m_nextSibling;  // by place in the graph's order
    std::vector<unsigned> m_stack;
    std::vector<unsigned> m_columnStart, m_rowOf;
    std::vector<unsigned> m_rowStart;
    std::vector<RowEntry> m_entries;
    std::vector<unsigned> m_next;
};
