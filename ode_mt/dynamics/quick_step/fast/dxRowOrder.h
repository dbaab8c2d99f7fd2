// The order in which a sweep takes the rows of joints that are solved in rows (docs/fast.md, "Other joints"). At first it is that of
// the plan where there are only contacts, otherwise upstream's, in which rows that other rows bound come last. After some sweeps it is a
// random one, which follows from what the rows ask for (dxStateNumbers.h).
#pragma once

#include <cstdint>

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/step/islands/dxIslandProblem.h"

class dxRowOrder {
public:
    // Takes memory for numbers of joints and rows that make() may not exceed. Throws std::bad_alloc.
    void reserve(std::size_t joints, std::size_t rows, dxStepArena &arena);

    // `firstRow`: by joint of the plan, and the end.
    void make(const dxConstraintPlan &plan, dxArenaArray<const unsigned> firstRow, const dxConstraintRow *rows);

    // Random orders follow from all numbers that are given since make().
    void mix(double number);

    // Called before the first sweep: if one thread takes all rows, neighbours wait for one another less often from now on, with the same results.
    // Requires rows, accelerations and bodyCount in `problem`, and that rows act on bodies that move.
    void schedule(dxIslandProblem problem);

    // Rows of joints [begin, end) of plan.rowJointsInOrder(), which are a chunk of the plan or all.
    dxArenaArray<const int> of(unsigned begin, unsigned end) const;
    dxArenaArray<const int> all() const { return m_rows; }

    // The same in the sweep with this number, from 1.
    dxArenaArray<const int> inSweep(unsigned begin, unsigned end, unsigned sweep);

private:
    void shuffle(unsigned first, unsigned last, unsigned sweep);

    bool m_isSerial = false;
    std::uint64_t m_seed = 0;
    dxArenaArray<int> m_rows;        // by chunk
    dxArenaArray<unsigned> m_first;  // in m_rows: by joint in the plan's order, and the end
};
