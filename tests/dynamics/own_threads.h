// Runs the blocks of a job on threads of its own, one for each block, so that all of them take part.
#pragma once

#include <thread>
#include <vector>

#include "threading/dxTaskRunner.h"

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
