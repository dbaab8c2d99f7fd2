// The order in which the rows of joints that are no lanes are taken (docs/iterative-solver.md, "Other joints"): that of the plan where
// there are contacts alone, otherwise upstream's, those that other rows bound last; after some sweeps a random one. It follows from what
// the rows ask for (dxStateNumbers.h).
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/step/islands/dxIslandProblem.h"

class dxRowOrder {
public:
    // Throws std::bad_alloc, as reserveAs().
    void reserve(std::size_t joints, std::size_t rows);
    // Takes as much memory as another one has.
    void reserveAs(const dxRowOrder &other);

    // `firstRow`: by joint of the plan, and the end.
    void make(const dxConstraintPlan &plan, const std::vector<unsigned> &firstRow, const dxConstraintRow *rows);

    // Random orders follow from all numbers that are given since make().
    void mix(double number);

    // Before the first sweep: if one thread takes all rows, neighbours wait for one another less often from now on, with the same results. Of
    // `problem` rows, accelerations and bodyCount are needed; rows act on bodies that move.
    void schedule(dxIslandProblem problem);

    // Rows of joints [begin, end) of plan.othersInOrder(), which are a chunk of the plan or all.
    struct Rows {
        const int *first, *last;

        const int *begin() const { return first; }
        const int *end() const { return last; }
        unsigned count() const { return static_cast<unsigned>(last - first); }
    };
    Rows of(unsigned begin, unsigned end) const;
    Rows all() const { return {m_rows.data(), m_rows.data() + m_rows.size()}; }

    // The same in the sweep with this number, from 1.
    Rows inSweep(unsigned begin, unsigned end, unsigned sweep);

private:
    void shuffle(unsigned first, unsigned last, unsigned sweep);

    bool m_isSerial = false;
    std::uint64_t m_seed = 0;
    std::vector<int> m_rows;        // by chunk
    std::vector<unsigned> m_first;  // in m_rows: by joint in the plan's order, and the end
};
