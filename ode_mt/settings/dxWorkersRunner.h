// Workers as a task runner, for one call: those of the process, or those that the user lent to a world. Each run is an event of the timeline.
//
// Threading: the thread that makes the call.
#pragma once

#include <algorithm>

#include <ode/ode.h>

#include "threading/dxTaskRunner.h"

class dxWorkersRunner final : public dxTaskRunner {
public:
    // `world`: the one whose step it is, if it is a step.
    explicit dxWorkersRunner(unsigned workers, const dxWorld *world = nullptr) : m_workers(workers), m_world(world) {
        std::fill_n(m_ranABlock, workers, false);
    }

    unsigned workers() const override { return m_workers; }
    void run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) override;

    // Returns how many workers, the caller included, have run a block so far.
    unsigned tookPart() const;

private:
    unsigned m_workers;
    const dxWorld *m_world;
    bool m_ranABlock[dODE_MT_MAX_THREADS];  // the first m_workers; each written by its worker alone
};
