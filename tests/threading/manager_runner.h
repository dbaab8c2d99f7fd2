// Workers of a thread manager as a task runner.
#pragma once

#include "threading/dxTaskRunner.h"
#include "threading/dxThreadManagerPthread.h"

#include <atomic>

class ManagerRunner final : public dxTaskRunner {
public:
    explicit ManagerRunner(unsigned workers) : m_workers(workers) { m_manager.resize(workers); }

    unsigned workers() const override { return m_workers; }

    void run(unsigned blocks, dxThreadManager::Task task, void *context) override {
        struct Job {
            dxThreadManager::Task task;
            void *context;
            std::atomic<unsigned> *byOthers;
        } job{task, context, &m_byOthers};
        const auto counted = [](void *of, unsigned block, unsigned worker) {
            const Job &running = *static_cast<const Job *>(of);
            running.task(running.context, block, worker);
            if (worker != 0) running.byOthers->fetch_add(1, std::memory_order_relaxed);
        };
        m_manager.run(blocks, m_workers, counted, &job);
    }

    // Blocks that were not the caller's, so far.
    unsigned blocksOfOthers() const { return m_byOthers.load(std::memory_order_relaxed); }

private:
    const unsigned m_workers;
    std::atomic<unsigned> m_byOthers{0};
    dxThreadManagerPthread m_manager;
};
