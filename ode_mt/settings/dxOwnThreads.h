// How many threads worlds and spaces may use that have a number of their own (dODE_MT_SetWorldThreads, dODE_MT_SetSpaceThreads), in place of
// the process's (dxSettings).
//
// Each keeps its own number (dxOwnThreadNumber; that of a world is in its dxWorldState). Of all numbers of threads the largest is known: there are as
// many workers as it says. Any thread may call.
#pragma once

#include <ode/ode.h>

#include <atomic>

#include "settings/dxSettings.h"

namespace dxOwnThreads {

// Of an own number, the one in force: 0 is the process's.
inline unsigned inForce(unsigned own) { return own != 0 ? own : dxSettings::instance().threads(); }

// The largest of all; 0: there is none.
unsigned largest();

// Somebody has another number than before; 0: none.
void exchange(unsigned before, unsigned now);

}  // namespace dxOwnThreads

// The number of a world or space, as long as it lives.
class dxOwnThreadNumber {
public:
    dxOwnThreadNumber() = default;
    ~dxOwnThreadNumber() {
        if (m_own != 0) dxOwnThreads::exchange(m_own, 0);
    }
    dxOwnThreadNumber(const dxOwnThreadNumber &) = delete;
    dxOwnThreadNumber &operator=(const dxOwnThreadNumber &) = delete;

    // Its own, or else the process's.
    unsigned inForce() const { return dxOwnThreads::inForce(own()); }

    // 0: the process's.
    void choose(unsigned threads) { dxOwnThreads::exchange(m_own.exchange(threads), threads); }

    unsigned own() const { return m_own.load(std::memory_order_relaxed); }

private:
    std::atomic<unsigned> m_own{0};
};
