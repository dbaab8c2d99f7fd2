// The process's workers as a task runner, for the length of one call.
#pragma once

#include <ode/ode_MT.h>

#include "frame/dxWorkers.h"
#include "threading/dxTaskRunner.h"

class dxWorkersRunner final : public dxTaskRunner {
public:
    explicit dxWorkersRunner(unsigned workers) : m_workers(workers) {}

    unsigned workers() const override { return m_workers; }
    void run(unsigned blocks, dxThreadManager::Task task, void *context) override;

    // How many workers, the caller included, have run a block so far.
    unsigned tookPart() const;

private:
    unsigned m_workers;
    bool m_ranABlock[dODE_MT_MAX_THREADS] = {};  // each written by its worker alone
};
