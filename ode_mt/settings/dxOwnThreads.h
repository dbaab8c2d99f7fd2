// Numbers of threads that worlds and spaces have of their own (dODE_MT_SetWorldThreads, dODE_MT_SetSpaceThreads), instead of that of
// the process (dxSettings).
//
// Each keeps its own number (dxOwnThreadNumber; that of a world is in its dxWorldState). The largest of all numbers is the size of the pool of
// workers.
//
// Threading: any thread.
#pragma once

#include <ode/ode.h>

#include <atomic>

#include "settings/dxSettings.h"

namespace dxOwnThreads {

// Returns the number in force for an own number: that of the process for 0.
inline unsigned inForce(unsigned own) { return own != 0 ? own : dxSettings::instance().threads(); }

// Returns the largest of all own numbers; 0: there is none.
unsigned largest();

// Called when a world or space changes its number; 0: none.
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

    // Returns its own number, or else that of the process.
    unsigned inForce() const { return dxOwnThreads::inForce(own()); }

    // 0: that of the process.
    void choose(unsigned threads) { dxOwnThreads::exchange(m_own.exchange(threads), threads); }

    unsigned own() const { return m_own.load(std::memory_order_relaxed); }

private:
    std::atomic<unsigned> m_own{0};
};
