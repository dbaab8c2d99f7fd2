// The numeric factorisation H = L L' of a symmetric, positive definite matrix of 6 x 6 blocks, a block for each two bodies of an
// island that share joints or come to (dxEliminationOrder), and solves with it. Left-looking Cholesky: a column gets the
// products of all columns before it that have its row, and is then divided by its own diagonal block.
// Source: Golub and Van Loan, "Matrix Computations", 4.2; Davis, "Direct Methods for Sparse Linear Systems", chapter 4.
//
// Diagonal blocks are inverted, so that a solve has products of vectors, not a chain of 36 dependent operations for each body.
//
// The bits do not depend on the instruction set: a lane is a row of a block, and each element is one sum in one order, with products
// and sums apart (-ffp-contract=off).
//
// Several threads factorise the chunks of a dxFactorPlan side by side, and then the columns at its top, one after the other: each of them
// computes the diagonal block, which is little, and its own part of the blocks below it.
//
// Tried and dropped: right-looking, which writes a column of the heap of 400 as often as it has neighbours; rows of blocks as lanes of
// columns next to one another (supernodes), since columns of a wall share few: of 4096 columns of a heap of 5000 boxes, 3700 have rows of
// their own. Columns of supernodes one after the other in registers, two or three blocks of a column at a time, so that elements of the
// other factor are loaded once, and supernodes made longer by up to a third of zeros: all as fast as one block after the other (AVX-512),
// whose products and sums are what takes the time.
#pragma once

#include <algorithm>
#include <atomic>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"
#include "threading/pool/dxPhaseRunner.h"

// How a factorisation is shared: which columns of the elimination tree are worked on side by side.
//
// A chunk is a range of columns that are some whole subtrees, so that no column of it gets anything from a column outside. Columns above
// all chunks are the top: they come one after the other, and the rows of one are shared. In a solve, what a chunk's columns subtract
// from rows at the top is summed up in spills of its own, which are added in the order of the chunks. So sums have one order, whoever
// works on which chunk, and the plan depends on the elimination order alone.
//
// A small factorisation is one chunk, without a top.
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

// inv(L) of a diagonal block. Upper and lower triangles are 0.
struct dxPivotInverse {
    dxBodyBlock byColumns, byRows;
};

// What factorisations and solves read and write.
struct dxFactorArrays {
    const dxEliminationOrder &order;
    dxBodyBlock *diagonal, *below;
    dxPivotInverse *inverses;
    const unsigned *targets;  // dxFactorPlan
};

class dxBlockFactor {
public:
    // Keeps the order by reference, which gives the sizes of blocks. At most `threads` threads work on it. Throws std::bad_alloc.
    void shape(const dxEliminationOrder &order, unsigned threads = 1);

    // H, to be written before its columns are factorised: of the diagonal blocks the lower triangle is read.
    dxBodyBlocks &diagonal() { return m_diagonal; }
    dxBodyBlocks &below() { return m_below; }

    // Calls make(begin, end), which writes H in a range of columns, for all columns, and writes L over H, but for the diagonal blocks.
    // Returns false where H is not positive definite in this arithmetic; L is of no use then. Parallel.
    template <class Make>
    bool factorise(dxPhaseRunner &phases, const Make &make) {
        m_isRegular.store(true, std::memory_order_relaxed);
        if (m_plan.top().empty()) {
            forRanges(phases, m_order->bodyCount(), make);
            for (const dxFactorPlan::Chunk &chunk : m_plan.chunks()) factoriseColumns(chunk.begin, chunk.end, 0);
        } else {
            const auto chunks = static_cast<unsigned>(m_plan.chunks().size()), top = static_cast<unsigned>(m_plan.top().size());
            phases.forChunks(chunks + rangesOf(top), [&](unsigned chunk, unsigned share) {
                if (chunk < chunks) {
                    const dxFactorPlan::Chunk &columns = m_plan.chunks()[chunk];
                    make(columns.begin, columns.end);
                    factoriseColumns(columns.begin, columns.end, share);
                    return;
                }
                const unsigned begin = (chunk - chunks) * kColumnsPerRange, end = std::min(begin + kColumnsPerRange, top);
                for (unsigned i = begin; i < end; ++i) make(m_plan.top()[i], m_plan.top()[i] + 1);
            });
            factoriseTop(phases);
        }
        return m_isRegular.load(std::memory_order_relaxed);
    }

    // Writes inv(H) y over y. Parallel.
    void solve(dxPhaseRunner &phases, dxBodyVectors &y);

private:
    static constexpr unsigned kColumnsPerRange = 8;

    static unsigned rangesOf(unsigned columns) { return (columns + kColumnsPerRange - 1) / kColumnsPerRange; }

    template <class Make>
    static void forRanges(dxPhaseRunner &phases, unsigned columns, const Make &make) {
        phases.forChunks(rangesOf(columns), [&](unsigned range, unsigned) {
            make(range * kColumnsPerRange, std::min((range + 1) * kColumnsPerRange, columns));
        });
    }

    dxFactorArrays arrays();
    void factoriseColumns(unsigned begin, unsigned end, unsigned share);
    void factoriseTop(dxPhaseRunner &phases);

    const dxEliminationOrder *m_order = nullptr;
    dxFactorPlan m_plan;
    dxBodyBlocks m_diagonal, m_below;
    std::vector<dxPivotInverse> m_inverses;
    std::vector<std::vector<unsigned>> m_slotOf;  // by share: of a row in the column under way
    dxBodyVectors m_spills;
    std::atomic<bool> m_isRegular{true};
};
