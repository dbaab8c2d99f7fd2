// Forward solves with the factorisation of A(C,C): Y = L^-1 A(C,j), for a block of columns j at a time.
//
// Dantzig's algorithm solves for one column after another, and C changes little in between: it grows by a row, or loses
// one. The first rows of Y depend on the first rows of L only, so they are kept: for each block of columns, as many as
// are known. A request for a column updates its whole block, since the other lanes are free: most columns of the block
// will be requested soon.
//
// Columns of A have leading zeros, and so have their solutions; of these only the number is stored.
//
// From 32 blocks on there is memory for three quarters of them: with the sparse rows (dxSparseRows.h) that is the
// memory of upstream. Most columns of C are never requested again. A block without a free place evicts the least
// recently used one (LRU).
//
// Upstream's rows after the last whole group of four (dxSolveL1Plain.h) are added up in another order, so
// only whole groups are kept.
#pragma once

#include "dynamics/world_step/exact/dxIndexSets.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "dynamics/world_step/exact/dxLcpWorkers.h"
#include "dynamics/world_step/kernels/dxTriangle.h"

class dxForwardSolves {
public:
    // Columns first..n-1 of n. Elements of storage, aligned to the cache's lines, and words: for the first column
    // the most.
    static std::size_t size(unsigned n, unsigned first);
    static std::size_t words(unsigned n) { return kWords * (dxLcpBlock(n) + std::size_t(1)); }

    // `L`: the rows of the factor; `skyline`: its.
    dxForwardSolves(const dxLcpMatrix &A, const dxIndexSets &sets, const dReal *const *L,
                    const dxSkyline &skyline, unsigned n, unsigned first, dReal *storage, unsigned *words);

    // solved(row) = (L^-1 A(C,column))(row), and scaled(row) = copy(row) = solved(row) d(row), for all rows of C
    struct Results {
        dReal *solved, *scaled, *copy;
    };
    void solve(unsigned column, const dReal *d, const Results &results, const dxLcpWorkers &islandWorkers);

    // Invalidates rows of L from `row` on.
    void forgetFrom(unsigned row);

private:
    static constexpr unsigned kWords = 5;  // for each block

    dReal *block(unsigned index) const {
        return m_solutions + std::size_t(m_place[index - m_firstBlock]) * m_n * kLineLanes;
    }
    void findPlace(unsigned index);
    unsigned leastRecentlyUsedPlace() const;
    void extend(unsigned index, unsigned rows, const dxLcpWorkers &islandWorkers);
    void extendZeros(unsigned index, unsigned rows);
    bool isGroupZero(unsigned index, unsigned first) const;

    const dxLcpMatrix &m_A;
    const dxIndexSets &m_sets;
    const dReal *const *const m_L;
    const dxSkyline &m_skyline;
    const unsigned m_n, m_firstBlock, m_endBlock, m_places;
    dReal *const m_solutions;  // by place, then by row
    // For each block, multiples of four:
    unsigned *const m_known;  // rows
    unsigned *const m_zeros;  // the first of them, which are all 0

    unsigned *const m_place;  // by block: place of its solutions, or kNoIndex
    // By place:
    unsigned *const m_blockAt;
    unsigned *const m_usedAt;  // time of its last use
    unsigned m_taken = 0;       // places
    unsigned m_time = 0;
};
