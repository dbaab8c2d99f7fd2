// Ordered completion of the blocks of a run whose results all later blocks need: blocks compute in parallel as far
// as possible, and finish in order.
//
// Blocks of a run start in ascending order (dxThreadManager::run), so the first unfinished one is held by a thread that
// does not wait: any number of threads, one included, finishes all.
//
// Threading: the blocks of one run.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "core/dxGuards.h"
#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxSpin.h"

class dxOrderedCompletion {
public:
    // Returns the number of finished blocks, which are the first ones.
    unsigned finished() const { return m_finished.load(std::memory_order_acquire); }

    // Waits until `blocks` are finished; what they wrote is then visible. Returns the number of finished blocks.
    unsigned await(unsigned blocks) const {
        unsigned known = finished();
        if (known < blocks) dxPerturb(dxSchedulePoint::AwaitInOrder);
        for (int polls = 0; known < blocks; ++polls, known = finished()) wait(polls);
        return known;
    }

    // Marks the next block as finished. Called by the thread that holds it.
    void finish(unsigned block) {
        dxPerturb(dxSchedulePoint::FinishInOrder);
        m_finished.store(block + 1, std::memory_order_release);
    }

private:
    // Numbers of polls before a thread yields, and before it sleeps: a yield does not let threads of lower priority run.
    static constexpr int kSpinPolls = 256, kYieldPolls = 1024;
    static constexpr std::chrono::microseconds kSleep{20};

    static void wait(int polls) {
        if (polls < kSpinPolls && dxProcessorCount() > 1)
            dxPause();
        else if (polls < kYieldPolls)
            std::this_thread::yield();
        else
            dxSleep(kSleep);
    }

    alignas(128) std::atomic<unsigned> m_finished{0};
};
