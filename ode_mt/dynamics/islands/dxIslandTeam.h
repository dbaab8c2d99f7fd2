// Workers that step one large island together, and their state from step to step: memory and measurements.
#pragma once

#include "threading/dxSharingPolicy.h"
#include "threading/dxTaskRunner.h"
#include "threading/process/dxIdlePool.h"

struct dxIslandTeam {
    dxTaskRunner *runner = nullptr;
    bool sharesAlways = false;  // parallel whenever the island is large enough; otherwise the measured times decide
    dxSharingPolicy solvePolicy;  // of the exact step's triangular solves
};

// Borrows the workers' state for a step; its memory is returned to the process's pool.
class dxIslandTeamLease {
public:
    dxIslandTeamLease(dxTaskRunner &runner, bool sharesAlways);
    ~dxIslandTeamLease();
    dxIslandTeamLease(const dxIslandTeamLease &) = delete;
    dxIslandTeamLease &operator=(const dxIslandTeamLease &) = delete;

    dxIslandTeam &operator*() const { return *m_team; }

    // Frees what is kept; no step may be in progress.
    static void forget();

private:
    dxIdleLease<dxIslandTeam> m_team;
};
