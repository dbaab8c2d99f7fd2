// Workers of a thread manager as a task runner, of which one other than the caller takes part in every run: the caller continues
// with its first block when one of them has a block, or after a while.
#pragma once

#include "threading/dxTaskRunner.h"
#include "threading/managers/dxThreadManagerPthread.h"
#include "threading/pool/dxSpin.h"

#include <atomic>
#include <chrono>

class ManagerRunner final : public dxTaskRunner {
public:
    explicit ManagerRunner(unsigned workers) : m_workers(workers) { m_manager.resize(workers); }

    unsigned workers() const override { return m_workers; }

    void run(dxParallelStage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        struct Job {
            dxThreadManager::Task task;
            void *context;
            bool isShared;
            std::atomic<unsigned> byOthers{0};
        } job{task, context, blocks > 1 && m_workers > 1};
        const auto counted = [](void *of, unsigned block, unsigned worker) {
            Job &running = *static_cast<Job *>(of);
            if (worker != 0)
                running.byOthers.fetch_add(1, std::memory_order_relaxed);
            else if (running.isShared)
                dxSpinUntil([&] { return running.byOthers.load(std::memory_order_relaxed) != 0; }, kLongest);
            running.task(running.context, block, worker);
        };
        m_manager.run(blocks, m_workers, counted, &job);
        m_byOthers += job.byOthers.load(std::memory_order_relaxed);
    }

    // Blocks that were not the caller's, so far.
    unsigned blocksOfOthers() const { return m_byOthers; }

private:
    static constexpr std::chrono::milliseconds kLongest{20};

    const unsigned m_workers;
    unsigned m_byOthers = 0;
    dxThreadManagerPthread m_manager;
};
