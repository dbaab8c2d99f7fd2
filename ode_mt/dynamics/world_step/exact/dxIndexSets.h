// The sets of Dantzig's algorithm: the free set C, whose rows have w = 0, and the clamped set N, whose rows are at a
// limit.
//
// Upstream permutes rows and columns of the problem, so that C, N and the remaining rows are contiguous. Sums over a
// set have that order, and it breaks ties between rows; so upstream's positions are kept, but only as a list of
// indexes: no data moves. C has a second order, that of the rows of its factorisation.
#pragma once

class dxIndexSets {
public:
    static constexpr unsigned kWords = 3;  // words of storage for each index

    // `storage`: kWords * n words. The first `bilateral` indexes are in C.
    dxIndexSets(unsigned n, unsigned bilateral, unsigned *storage);

    unsigned countC() const { return m_countC; }
    unsigned countN() const { return m_countN; }

    // Indexes by position: first C, then N, then the others.
    const unsigned *indexes() const { return m_indexAt; }
    unsigned indexAt(unsigned position) const { return m_indexAt[position]; }

    // Positions in C before it are their own indexes, and have the same place in the factorisation: most of C, as
    // long as no row has been in N.
    unsigned inPlace() const { return m_inPlace < m_countC ? m_inPlace : m_countC; }

    // C in the order of the factorisation: indexes, and their positions.
    const unsigned *factorIndexes() const { return m_factorIndex; }
    const unsigned *factorPositions() const { return m_factorPosition; }

    void addNextToC() { moveToC(m_countC + m_countN); }  // the first index of the others
    void addNextToN() { ++m_countN; }
    void moveFromNToC(unsigned position);

    // The row of the factorisation that belongs to a position in C.
    unsigned factorRowAt(unsigned position) const;
    void moveFromCToN(unsigned position, unsigned factorRow);

private:
    void moveToC(unsigned position);

    unsigned m_countC, m_countN = 0;
    unsigned m_inPlace;  // it may be beyond C
    unsigned *const m_indexAt;
    unsigned *const m_factorIndex;
    unsigned *const m_factorPosition;
};
