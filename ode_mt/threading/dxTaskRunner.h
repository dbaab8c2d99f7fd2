// Runs the blocks of a job: on workers, or on the calling thread alone. It is passed to parts of the engine that can
// run in parallel but do not decide whether that pays.
//
// Threading: as dxThreadManager.
#pragma once

#include <atomic>
#include <cstddef>
#include <new>
#include <type_traits>

#include "threading/dxParallelStage.h"
#include "threading/dxThreadManager.h"

class dxTaskRunner {
public:
    // Returns an upper bound of the number of threads in `run`; all workers have smaller numbers.
    virtual unsigned workers() const = 0;

    // As dxThreadManager::run, for a job of the stage.
    virtual void run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) = 0;

    // Calls work(block, worker) for every block. If one throws std::bad_alloc, that is thrown on the calling thread, after all have ended: on a
    // worker it would end the process.
    template <class Work>
    void forBlocks(dxParallelStage stage, unsigned blocks, Work &&work) {
        struct Job {
            std::remove_reference_t<Work> &work;
            std::atomic<bool> isShortOfMemory{false};
        } job{work};
        const auto task = [](void *context, unsigned block, unsigned worker) {
            Job &running = *static_cast<Job *>(context);
            try {
                running.work(block, worker);
            } catch (const std::bad_alloc &) {
                running.isShortOfMemory.store(true, std::memory_order_relaxed);
            }
        };
        run(stage, blocks, task, &job);
        if (job.isShortOfMemory.load(std::memory_order_relaxed)) throw std::bad_alloc();
    }

    // Calls work(begin, end, worker) for chunks of [0, count) of at most `chunk` items.
    template <class Work>
    void forChunks(dxParallelStage stage, std::size_t count, std::size_t chunk, Work &&work) {
        forBlocks(stage, static_cast<unsigned>((count + chunk - 1) / chunk), [&](unsigned block, unsigned worker) {
            const std::size_t begin = block * chunk;
            work(begin, begin + chunk < count ? begin + chunk : count, worker);
        });
    }

    // Returns a runner that uses the calling thread alone, which is worker 0.
    static dxTaskRunner &alone();

protected:
    ~dxTaskRunner() = default;
};

namespace dxTaskRunners {

class Alone final : public dxTaskRunner {
public:
    unsigned workers() const override { return 1; }
    void run(dxParallelStage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        for (unsigned block = 0; block < blocks; ++block) task(context, block, 0);
    }
};

}  // namespace dxTaskRunners

inline dxTaskRunner &dxTaskRunner::alone() {
    static dxTaskRunners::Alone runner;
    return runner;
}
