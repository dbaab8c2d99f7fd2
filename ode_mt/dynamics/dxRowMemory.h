// Memory for the packed rows of one island, borrowed from the process.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/sweep/dxSweep.h"

class dxRowMemory {
public:
    dxRowMemory() = default;
    ~dxRowMemory() { giveBack(); }
    dxRowMemory(const dxRowMemory &) = delete;
    dxRowMemory &operator=(const dxRowMemory &) = delete;

    // Undefined contents.
    dxSweepRow *take(std::size_t rows);
    dxSweepRow *get() const { return m_borrowed != nullptr ? m_borrowed->data() : nullptr; }
    void giveBack();

    // Frees what the process keeps; no step may be in progress.
    static void forget();

private:
    std::vector<dxSweepRow> *m_borrowed = nullptr;
};
