// One run of Dantzig's algorithm.
//
// Rows are taken one after another; those before the current one satisfy the conditions of the LCP. A row that does not
// is driven to zero: x(i) changes, and x(C) with it so that w(C) stays 0, until w(i) is 0 or x(i) at a limit. The
// maximum step ends when a row of the clamped set N would leave its bound, or one of the free set C would reach a
// limit; that row then changes its set (pivot). Source: Baraff 1994 (dxDantzig.h).
#pragma once

#include "dynamics/world_step/exact/dxDantzigArrays.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "dynamics/world_step/exact/dxForwardSolves.h"
#include "dynamics/world_step/exact/dxIndexSets.h"
#include "dynamics/world_step/exact/dxLcpWorkers.h"
#include "dynamics/world_step/exact/dxSparseRows.h"

class dxWorldProcessMemArena;

class dxDantzigRun {
public:
    // Allocates L from `given`, everything else from `arena`, of which it needs memory(n) bytes; reads the problem and
    // writes only that memory. Products with 0 are skipped if `maySkipZeros`: b is finite, results
    // are rounded to nearest, and so far as is known the matrix is finite, too.
    dxDantzigRun(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *given, dxWorldProcessMemArena *arena,
                 const dxDantzigProblem &problem, bool maySkipZeros);
    static std::size_t memory(unsigned n);

    void solve();

    // Writes x into the problem.
    void deliver() const;

    // Writes the limits under which x is the solution: those of friction rows, too.
    void deliverLimits(dReal *pairsLoHi) const;

    // Returns whether products with 0 must not be left out after all: what has been solved is of no use.
    bool isUnfit() const { return m_isUnfit; }

    // Returns whether the algorithm gave up because the maximum step was not positive.
    bool hasFailed() const { return m_hasFailed; }
    dReal failedLength() const { return m_failedLength; }

private:
    using Limits = dxLimitPair;

    // The event that ends a step.
    enum class Event { Solved, AtLow, AtHigh, LeavesN, CReachesLow, CReachesHigh };
    struct MaximumStep {
        dReal length;
        Event event;
        unsigned position;  // of the row that changes its set
    };

    void solveBilateralRows();
    void setFrictionLimits(unsigned first);
    bool driveToZero(unsigned i);
    bool pivot(unsigned i);
    void findFactorColumn(unsigned index);
    void findDirection(unsigned i, bool isUp);
    void findDeltaX(bool isUp);
    void findDeltaW(unsigned i, bool isUp);
    bool isSparseDue(unsigned i) const;
    void buildSparse();
    void findProducts(unsigned i);
    dReal multiplyByDeltaX(unsigned index) const;
    MaximumStep findMaximumStep(unsigned i, bool isUp) const;
    void limitByOwnBounds(unsigned i, bool isUp, MaximumStep &step) const;
    void limitByN(MaximumStep &step) const;
    void limitByC(MaximumStep &step) const;
    void apply(unsigned i, bool isUp, dReal length);
    bool finish(unsigned i, const MaximumStep &step);
    void giveUp(unsigned i, dReal length);

    void addToC(unsigned i);
    void addToN(unsigned i, bool isHigh);
    dReal sideAt(unsigned row, bool isHigh) const;
    void moveFromNToC(unsigned position);
    void moveFromCToN(unsigned position, bool isHigh);
    void appendFactorRow(unsigned index, dReal product);
    void removeFactorRow(unsigned factorRow);
    unsigned firstSolved(unsigned count) const;
    // D^-1 L^-1 A(C,i) is stored where it will be if i enters C: in the row behind the last one of L.
    dReal *scaled() const { return m_L[m_sets.countC()]; }

    dxLcpWorkers m_islandWorkers;
    const dxDantzigProblem &m_problem;
    const unsigned m_n;
    unsigned *const m_order;  // the problem's row for each of ours
    const unsigned m_bilateral;
    const dxDantzigArrays m_arrays;
    const dxReorderedTriangle m_source;
    dxLcpMatrix m_A;
    dxIndexSets m_sets;
    const unsigned m_skip;         // of the rows of L, before any was removed
    dReal *const m_factor, **const m_L;  // A(C,C) = L D L': its rows in the order of the factorisation
    dReal *const m_d;                    // 1/D
    unsigned *const m_begins;      // of the rows of L
    const dxSkyline m_skyline;   // the same, if products with 0 are left out
    dxForwardSolves m_forward;

    dxWorldProcessMemArena *const m_arena;  // for m_sparse, when rows are in N
    dxSparseRows m_sparse;

    unsigned m_countLeaving = 0;  // in the list m_arrays.leaving
    bool m_isUnfit = false;
    bool m_hasFailed = false;
    dReal m_failedLength = 0;
};
