// Memory for the packed rows of one island, borrowed from the process.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dynamics/dxIdlePool.h"
#include "dynamics/sweep/dxSweep.h"

class dxRowMemory {
public:
    // Undefined contents. NULL: there is no memory.
    dxSweepRow *take(std::size_t rows);
    dxSweepRow *get() const { return m_rows ? (*m_rows)->data() : nullptr; }
    void giveBack() { m_rows.reset(); }

    // Frees what the process keeps; no step may be in progress.
    static void forget();

private:
    std::optional<dxIdleLease<std::vector<dxSweepRow>>> m_rows;
};
