// The symbolic factorisation of an island's matrix in body space: in which order bodies are eliminated, and which blocks
// of the factor are not zero. It depends on which bodies share joints, and on no number.
//
// The order is that of dxEliminationGraph, sorted so that the elimination tree is in postorder: a column's parent is the first row below
// its diagonal, and the columns of a subtree stand side by side, their root last. The factor has the same blocks.
// Source: Davis, "Direct Methods for Sparse Linear Systems", chapter 4.
//
// Deterministic: numbers of bodies decide, and nothing else.
#pragma once

#include <tuple>
#include <utility>
#include <vector>

// In which order nodes of a graph are eliminated: a node's neighbours become neighbours of one another, and the next node is one that
// adds few edges.
//
// Minimum mean fill: of all nodes the one with the fewest new edges per neighbour is next, of several the one with the fewest neighbours,
// of several the first one. Sources: Tinney and Walker, "Direct solutions of sparse network equations by optimally ordered triangular
// factorization", Proceedings of the IEEE 55, 1967 (scheme 3); Rothberg and Eisenstat, "Node selection strategies for bottom-up sparse
// matrix ordering", SIAM Journal on Matrix Analysis and Applications 19, 1998 (the mean). The number of new edges is exact: each node
// knows how many of its neighbours are neighbours of one another, and a new edge changes that of its ends and their common neighbours
// only. So it takes about as long as minimum degree.
//
// Tried and dropped: minimum degree (products of blocks of the heap of 5000: 421,000 for 291,000); minimum fill with ties by degree
// (312,000); nested dissection by positions, leaves of 50 to 1600 bodies by minimum degree (843,000 to 569,000).
class dxEliminationGraph {
public:
    // `edges`: in any order, each any number of times.
    void eliminateAll(unsigned nodeCount, const std::vector<std::pair<unsigned, unsigned>> &edges);

    // All nodes, in the order of their elimination.
    const std::vector<unsigned> &sequence() const { return m_sequence; }

    // Of a node when it was eliminated, in any order: all of them come later.
    const std::vector<unsigned> &laterNeighbours(unsigned node) const { return m_neighbours[node]; }

private:
    struct Entry {
        double fill;  // per neighbour
        unsigned degree, node;

        bool operator>(const Entry &other) const {
            return std::tie(fill, degree, node) > std::tie(other.fill, other.degree, other.node);
        }
    };

    void build(unsigned nodeCount, const std::vector<std::pair<unsigned, unsigned>> &edges);
    void countTriangles(unsigned node);
    void update(unsigned node);
    void eliminate(unsigned node);
    void remove(unsigned node);
    void connect(unsigned a, unsigned b);
    void noteChange(unsigned node);
    void mark(unsigned node);
    bool isMarked(unsigned node) const { return m_mark[node] == m_lastMark; }

    std::vector<std::vector<unsigned>> m_neighbours;  // that are not eliminated
    std::vector<unsigned> m_triangles;                // edges between a node's neighbours
    std::vector<double> m_fill;                       // of a node's valid entry in the heap
    std::vector<unsigned> m_degree;                   // of the same
    std::vector<char> m_isEliminated;
    std::vector<Entry> m_heap;                        // with entries that are no longer valid
    std::vector<unsigned> m_sequence;
    std::vector<unsigned> m_mark;                     // of a node's neighbours, itself included
    unsigned m_lastMark = 0;
    std::vector<unsigned> m_changed;                  // nodes whose entry may be no longer valid
    std::vector<char> m_isChanged;
};

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
