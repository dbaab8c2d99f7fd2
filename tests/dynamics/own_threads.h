// Runs the blocks of a job on threads of its own, one for each block, so that all of them take part.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "threading/dxTaskRunner.h"
#include "threading/pool/dxPhaseRunner.h"

class OwnThreads final : public dxTaskRunner {
public:
    explicit OwnThreads(unsigned count) : m_count(count) {}

    unsigned workers() const override { return m_count; }
    void run(dxParallelStage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        std::vector<std::thread> threads;
        for (unsigned block = 0; block < blocks; ++block) threads.emplace_back([=] { task(context, block, block); });
        for (std::thread &thread : threads) thread.join();
    }

private:
    const unsigned m_count;
};

// Calls body(phases), the control of phases, for several numbers of threads that share them.
template <class Body>
void onSeveralThreads(const Body &body) {
    for (const unsigned threads : {1u, 2u, 3u, 5u, 8u, 16u}) {
        SCOPED_TRACE(std::to_string(threads) + " threads");
        dxPhaseRunner phases;
        phases.reserve(threads);
        OwnThreads runner(threads);
        phases.run(dxParallelStage::Count, runner, [&] { body(phases); });
    }
}
