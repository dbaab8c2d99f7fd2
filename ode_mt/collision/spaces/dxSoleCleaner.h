// Selects the thread that cleans a space when several threads query it after a change.
//
// The second thread waits for a limited time: the first one may be in a bounding-box function of the user's that waits
// for something else, may have left it by a jump, or be a thread that a fork has left behind. One that has left by a
// jump stays the cleaner, and may clean again; a call that no other may overlap (dSpaceCollide) resets it.
#pragma once

#include <atomic>
#include <thread>

#include "threading/dxPerturbation.h"

class dxSoleCleaner {
public:
    // Becomes the cleaner, unless another thread is and remains it.
    class Scope {
    public:
        explicit Scope(dxSoleCleaner &cleaner) : m_cleaner(cleaner), m_isMine(cleaner.take()) {}
        ~Scope() {
            if (m_isMine) m_cleaner.dismiss();
        }
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

        bool isMine() const { return m_isMine; }

    private:
        dxSoleCleaner &m_cleaner;
        const bool m_isMine;
    };

    void dismiss() { m_thread.store(std::thread::id(), std::memory_order_release); }

private:
    // Number of attempts: some milliseconds, in which ten thousand geoms are cleaned.
    static constexpr int kMaxAttempts = 10000;

    bool take() {
        const std::thread::id self = std::this_thread::get_id();
        for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
            std::thread::id cleaner;
            dxPerturb(dxSchedulePoint::ClaimCleaning);
            if (m_thread.compare_exchange_weak(cleaner, self, std::memory_order_acq_rel) || cleaner == self)
                return true;
            dxPerturb(dxSchedulePoint::AwaitCleaning);
            std::this_thread::yield();
        }
        return false;
    }

    std::atomic<std::thread::id> m_thread{};
};
