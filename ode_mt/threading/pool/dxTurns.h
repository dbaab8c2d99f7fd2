// Blocks of a run whose results are needed by all blocks after them: they are computed side by side as far as that goes,
// and finished one after the other.
//
// Blocks of a run start in ascending order (dxThreadManager::run), so that the first unfinished one is held by a
// thread that waits for nobody: any number of threads, one included, gets all finished.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "threading/dxPerturbation.h"
#include "threading/pool/dxNap.h"
#include "threading/pool/dxSpin.h"

class dxTurns {
public:
    // Blocks that are finished: all before it.
    unsigned finished() const { return m_finished.load(std::memory_order_acquire); }

    // Waits until `blocks` are finished; what they wrote is then visible. Returns how many are.
    unsigned await(unsigned blocks) const {
        unsigned known = finished();
        if (known < blocks) dxPerturb(dxSchedulePoint::AwaitTurn);
        for (int looks = 0; known < blocks; ++looks, known = finished()) wait(looks);
        return known;
    }

    // Of the block that is the next to be finished, by its thread.
    void finish(unsigned block) {
        dxPerturb(dxSchedulePoint::FinishTurn);
        m_finished.store(block + 1, std::memory_order_release);
    }

private:
    // Looks before a thread lets others run, of which one may hold the block that is waited for; and before it sleeps: to a
    // thread of higher priority the others are no reason to stop.
    static constexpr int kPatience = 256, kCourtesy = 1024;
    static constexpr std::chrono::microseconds kSleep{20};

    static void wait(int looks) {
        if (looks < kPatience && dxProcessorCount() > 1)
            dxPause();
        else if (looks < kCourtesy)
            std::this_thread::yield();
        else
            dxNap(kSleep);
    }

    alignas(128) std::atomic<unsigned> m_finished{0};
};
