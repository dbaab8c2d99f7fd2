// The symbolic factorisation of an island's matrix in body space: in which order bodies are eliminated, and which blocks
// of the factor are not zero. It depends on which bodies share joints, and on no number.
//
// Minimum degree: the body with the fewest neighbours is next, of several the first one; its neighbours become neighbours of
// one another. Source: George and Liu, "The evolution of the minimum degree ordering algorithm", SIAM Review 31, 1989. Here
// the graph is kept explicitly, without quotients: a node is a body of six rows, so that the numeric factorisation costs
// a hundred times as much as this one.
//
// Deterministic: numbers of bodies decide, and nothing else.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

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

    // Entries of a row: firstEntry(row) to firstEntry(row + 1), columns ascending.
    unsigned firstEntry(unsigned row) const { return m_rowStart[row]; }
    const RowEntry &entry(unsigned index) const { return m_entries[index]; }

    // Requires row > column and a block there.
    unsigned findBlock(unsigned row, unsigned column) const;

private:
    using Degree = std::pair<unsigned, unsigned>;  // number of neighbours, body

    void buildGraph(unsigned bodyCount, const std::vector<std::pair<unsigned, unsigned>> &pairs);
    void eliminate(unsigned body);
    void orderBodies(unsigned bodyCount);
    void listColumns();
    void listRows();

    std::vector<std::vector<unsigned>> m_neighbours;  // by body; once it is eliminated, its column's rows
    std::vector<unsigned> m_sequence, m_placeOf;
    std::vector<unsigned> m_columnStart, m_rowOf;
    std::vector<unsigned> m_rowStart;
    std::vector<RowEntry> m_entries;
    std::vector<Degree> m_heap;
    std::vector<unsigned> m_mark;
    unsigned m_lastMark = 0;
};
