// A job of many short phases, one after the other, that the workers of one run share: a run for each phase would cost more than the
// phase. One thread has the control: it runs the job, and hands out the chunks of each phase. The others wait for phases and take chunks.
//
// Which thread takes a chunk affects nothing but speed. Each thread begins with its own share of a phase's chunks, the same in each phase,
// so that what they read is in its caches, and then takes those of others. The first thread to come has the control. A thread that comes late, or
// never, is not waited for. A thread waits only for chunks that running threads hold, so that any number of them finishes, one included.
//
// Threading: a share holds the phase, its next chunk and the end of its chunks in one number. So a thread that takes a chunk knows that its
// phase is in progress, and with it what to call.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "core/dxCacheLine.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxTaskRunner.h"
#include "threading/pool/dxSpin.h"

class dxPhaseRunner {
public:
    // Makes room for this number of threads. Throws std::bad_alloc.
    void reserve(unsigned threads) {
        if (threads <= m_capacity) return;
        m_shares = std::make_unique<Share[]>(threads);
        m_capacity = threads;
    }

    unsigned capacity() const { return m_capacity; }  // number of threads for which it is reserved

    // Calls control(). The runner's workers share its phases. Requires that there are no more of them than reserved.
    template <class Control>
    void run(dxParallelStage stage, dxTaskRunner &runner, const Control &control) {
        m_threads = runner.workers();
        if (m_threads < 2) return control();
        m_isControlled.store(false, std::memory_order_relaxed);
        m_isOver.store(false, std::memory_order_relaxed);
        m_phase.store(0, std::memory_order_relaxed);
        for (unsigned share = 0; share < m_threads; ++share) m_shares[share].ticket.store(0, std::memory_order_relaxed);
        runner.forBlocks(stage, m_threads, [&](unsigned share, unsigned) {
            if (m_isControlled.exchange(true, std::memory_order_relaxed)) return help(share);
            const End end(m_isOver);
            m_own = share;
            control();
        });
        m_threads = 1;
    }

    // In control: returns how many threads may take part.
    unsigned threads() const { return m_threads; }

    // In control: calls work(chunk, share) for all chunks, fewer than a million. Threads that do so at the same time have different
    // shares. `work` does not throw.
    template <class Work>
    void forChunks(unsigned chunks, const Work &work) {
        if (m_threads < 2 || chunks < 2) {
            for (unsigned chunk = 0; chunk < chunks; ++chunk) work(chunk, m_threads < 2 ? 0 : m_own);
            return;
        }
        open(chunks, [](const void *context, unsigned chunk, unsigned share) { (*static_cast<const Work *>(context))(chunk, share); },
             &work);
        takeChunks(m_own, m_phase.load(std::memory_order_relaxed));
        awaitOthers(chunks);
    }

private:
    using Task = void (*)(const void *context, unsigned chunk, unsigned share);

    struct alignas(kCacheLine) Share {
        std::atomic<std::uint64_t> ticket{0};
    };

    // Ends the waiting of the others, also where control throws.
    class End {
    public:
        explicit End(std::atomic<bool> &isOver) : m_isOver(isOver) {}
        ~End() { m_isOver.store(true, std::memory_order_release); }
        End(const End &) = delete;
        End &operator=(const End &) = delete;

    private:
        std::atomic<bool> &m_isOver;
    };

    // A ticket: the phase, the end of the share's chunks, the next one.
    static constexpr unsigned kChunkBits = 20, kPhaseBits = 64 - 2 * kChunkBits;
    static constexpr std::uint64_t kChunkMask = (std::uint64_t(1) << kChunkBits) - 1;
    static std::uint64_t phaseOf(std::uint64_t ticket) { return ticket >> 2 * kChunkBits; }
    static std::uint64_t endOf(std::uint64_t ticket) { return ticket >> kChunkBits & kChunkMask; }
    static std::uint64_t chunkOf(std::uint64_t ticket) { return ticket & kChunkMask; }
    static unsigned afterPhase(unsigned phase) { return (phase + 1) & ((1u << kPhaseBits) - 1); }

    // Of a share's chunks.
    std::uint64_t boundary(unsigned share, unsigned chunks) const { return std::uint64_t(share) * chunks / m_threads; }

    void open(unsigned chunks, Task task, const void *context) {
        dxPerturb(dxSchedulePoint::PublishPhase);
        m_task.store(task, std::memory_order_relaxed);
        m_context.store(context, std::memory_order_relaxed);
        m_finished.store(0, std::memory_order_relaxed);
        const unsigned phase = afterPhase(m_phase.load(std::memory_order_relaxed));
        for (unsigned share = 0; share < m_threads; ++share) {
            const std::uint64_t begin = boundary(share, chunks), end = boundary(share + 1, chunks);
            m_shares[share].ticket.store((std::uint64_t(phase) << kChunkBits | end) << kChunkBits | begin, std::memory_order_release);
        }
        m_phase.store(phase, std::memory_order_release);
    }

    void takeChunks(unsigned own, unsigned phase) {
        for (unsigned i = 0; i < m_threads; ++i) {
            const unsigned share = own + i < m_threads ? own + i : own + i - m_threads;
            while (takeChunk(share, phase, own)) {
            }
        }
    }

    // Returns false if the share has no more of this phase.
    bool takeChunk(unsigned share, unsigned phase, unsigned own) {
        dxPerturb(dxSchedulePoint::ClaimPhaseChunk);
        std::atomic<std::uint64_t> &ticket = m_shares[share].ticket;
        std::uint64_t taken = ticket.load(std::memory_order_acquire);
        do {
            if (phaseOf(taken) != phase || chunkOf(taken) >= endOf(taken)) return false;
        } while (!ticket.compare_exchange_weak(taken, taken + 1, std::memory_order_acquire));
        const Task task = m_task.load(std::memory_order_relaxed);
        task(m_context.load(std::memory_order_relaxed), static_cast<unsigned>(chunkOf(taken)), own);
        m_finished.fetch_add(1, std::memory_order_release);
        return true;
    }

    void help(unsigned share) {
        for (unsigned phase = 0; !m_isOver.load(std::memory_order_acquire);) {
            const unsigned now = m_phase.load(std::memory_order_acquire);
            if (now != phase) takeChunks(share, now);
            phase = now;
            dxPerturb(dxSchedulePoint::AwaitPublishedPhase);
            dxAwait([&] { return m_phase.load(std::memory_order_acquire) != phase || m_isOver.load(std::memory_order_acquire); });
        }
    }

    void awaitOthers(unsigned chunks) const {
        if (m_finished.load(std::memory_order_acquire) == chunks) return;
        dxPerturb(dxSchedulePoint::AwaitPhaseChunks);
        dxAwait([&] { return m_finished.load(std::memory_order_acquire) == chunks; });
    }

    std::unique_ptr<Share[]> m_shares;
    unsigned m_capacity = 0, m_threads = 1;
    unsigned m_own = 0;  // the share of the thread that has the control
    alignas(kCacheLine) std::atomic<bool> m_isControlled{false};
    std::atomic<Task> m_task{nullptr};
    std::atomic<const void *> m_context{nullptr};
    alignas(kCacheLine) std::atomic<unsigned> m_phase{0};  // that were opened
    std::atomic<bool> m_isOver{false};
    alignas(kCacheLine) std::atomic<unsigned> m_finished{0};  // chunks of this phase
};
