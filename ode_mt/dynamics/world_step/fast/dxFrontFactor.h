// The numeric factorisation A = L D L' of a symmetric matrix in blocks of joints by fronts (dxFrontPlan.h), and the solution of A x = b.
//
// A front's columns are eliminated in groups: a group is factorised, and the columns behind it then get the products of all its columns at
// once, tiles of them being held in registers. b is the last row of each front, so that inv(L) b is found with L.
// Source: Golub and Van Loan, "Matrix Computations", 4.1 and 4.2 (block algorithms).
//
// Bits do not depend on the instruction set nor on threads: lanes are rows, each element is one sum in one order, products and sums are apart.
//
// Threading: chunks of the plan are factorised side by side; of a front at the top the columns behind a group are shared.
#pragma once

#include <atomic>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxFrontPlan.h"
#include "threading/pool/dxPhaseRunner.h"

// The numbers of a front. Rows of columns are the pivots, those below, and b; a column has those from its own on, and before it scratch.
struct dxFrontNumbers {
    unsigned pivots, rows;         // scalar rows
    unsigned stride, updateStride;
    double *panel;                 // columns of the pivots
    double *update;                // columns of the rows below, from the line of the first of these rows on
    double *inverses, *diagonals;  // of the pivots: inv(D), elements of A
    double *multipliers;           // scratch: of a group, its columns times inv(D)

    static constexpr unsigned kMaxGroup = 24;  // columns

    unsigned columns() const { return pivots + rows; }
    unsigned firstUpdateLine() const { return stride - updateStride; }
    double *column(unsigned pivot) const { return panel + std::size_t(pivot) * stride; }
    double *multipliersOf(unsigned k) const { return multipliers + std::size_t(k) * stride; }  // of the group's column k

    // Of a row below the pivots, counted from the first of these: its column, from that line on.
    double *updateColumn(unsigned row) const { return update + std::size_t(row) * updateStride; }

    // Groups of a front have nearly as many columns each.
    unsigned endOfGroup(unsigned begin) const {
        const unsigned left = pivots - begin, groups = (left + kMaxGroup - 1) / kMaxGroup;
        return begin + (left + groups - 1) / groups;
    }
};

class dxFrontFactor {
public:
    // Keeps the plan by reference. Throws std::bad_alloc.
    void shape(const dxFrontPlan &plan);

    // At most `threads` threads will work on it. Throws std::bad_alloc.
    void reserve(unsigned threads);

    // Calls make(front, numbers, share), which adds the blocks of A that the front's joints begin, and b, to its panel, once for each front.
    // Returns false where a pivot is rounding beside its diagonal's element, or is no finite number. Parallel.
    template <class Make>
    bool factorise(dxPhaseRunner &phases, const Make &make) {
        m_isRegular.store(true, std::memory_order_relaxed);
        const auto &chunks = m_plan->chunks();
        const auto factoriseFront = [&](unsigned front, unsigned share, const auto &eliminateFront) {
            const dxFrontNumbers numbers = begin(front, share);
            make(m_plan->fronts()[front], numbers, share);
            assemble(front, numbers);
            eliminateFront(numbers);
            finish(front, numbers);
        };
        phases.forChunks(static_cast<unsigned>(chunks.size()), [&](unsigned chunk, unsigned share) {
            for (unsigned front = chunks[chunk].begin; front < chunks[chunk].end && isRegular(); ++front)
                factoriseFront(front, share, [this](const dxFrontNumbers &numbers) { eliminate(numbers); });
        });
        for (std::size_t i = 0; i < m_plan->top().size() && isRegular(); ++i)
            factoriseFront(m_plan->top()[i], 0, [&](const dxFrontNumbers &numbers) { eliminate(numbers, phases); });
        return isRegular();
    }

    // Finds x. Parallel.
    void substitute(dxPhaseRunner &phases);

    // Of a joint, its part of x.
    const double *solutionOf(unsigned joint) const { return m_x.data() + m_plan->firstPivotOf(joint); }

private:
    struct Scratch {
        dxBodyVectors multipliers;  // of a group
        dxBodyVectors rows;         // x of a front's rows
    };

    bool isRegular() const { return m_isRegular.load(std::memory_order_relaxed); }
    dxFrontNumbers numbersOf(unsigned front, unsigned share);
    dxFrontNumbers begin(unsigned front, unsigned share);
    void assemble(unsigned front, const dxFrontNumbers &numbers);
    void eliminate(const dxFrontNumbers &numbers);
    void eliminate(const dxFrontNumbers &numbers, dxPhaseRunner &phases);
    void addUpdates(unsigned front, const dxFrontNumbers &numbers, bool toPivots);
    void finish(unsigned front, const dxFrontNumbers &numbers);
    void substitute(unsigned front, unsigned share);

    const dxFrontPlan *m_plan = nullptr;
    dxBodyVectors m_panels, m_updates;
    std::vector<double> m_inverses, m_diagonals, m_x;  // by scalar pivot
    std::vector<Scratch> m_scratch;                    // by share
    std::atomic<bool> m_isRegular{true};
};
