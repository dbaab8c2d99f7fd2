// How many threads worlds and spaces may use that have a number of their own (dODE_MT_SetWorldThreads, dODE_MT_SetSpaceThreads), in place of
// the process's (dxSettings).
//
// A world's number is kept in a list beside the worlds, since a world is upstream's structure; a space keeps its own
// (dxOwnThreadNumber). Limits for solving are kept likewise. Of all numbers of threads the largest is known: there are as many workers as it says. A step looks at one size as long as
// no world has a number. Any thread may call.
#pragma once

#include <ode/ode.h>

#include <atomic>

#include "settings/dxSettings.h"

namespace dxOwnThreads {

// The world's own number; 0: it has none.
unsigned of(const dxWorld *world);

// 0: the process's number. Throws std::bad_alloc, and changes nothing then.
void choose(const dxWorld *world, unsigned threads);

// The limit of threads that solve one island of the world, where the program has set one (dWSTP_LCPSolvingMaxThreads);
// dWORLDSTEP_THREADCOUNT_UNLIMITED: it has not, or has set none.
unsigned solvingLimit(const dxWorld *world);

// Throws std::bad_alloc, and changes nothing then.
void limitSolving(const dxWorld *world, unsigned threads);

// The world is about to be destroyed.
void forget(const dxWorld *world);

// Of an own number, the one in force: 0 is the process's.
inline unsigned inForce(unsigned own) { return own != 0 ? own : dxSettings::instance().threads(); }

// The largest of all; 0: there is none.
unsigned largest();

// Somebody has another number than before; 0: none.
void exchange(unsigned before, unsigned now);

}  // namespace dxOwnThreads

// The number of a space, as long as the space lives.
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
