// Workers that step one island together, and what they share from step to step: memory.
#pragma once

#include "dynamics/dxIdlePool.h"
#include "dynamics/sweep/dxSharedSweep.h"
#include "threading/dxTaskRunner.h"

struct dxIslandTeam {
    dxTaskRunner *runner = nullptr;
    dxSharedSweep sweep;
};

// Takes a team for the time of a step; its memory goes back to the process's pool.
class dxIslandTeamLease {
public:
    explicit dxIslandTeamLease(dxTaskRunner &runner);
    ~dxIslandTeamLease();
    dxIslandTeamLease(const dxIslandTeamLease &) = delete;
    dxIslandTeamLease &operator=(const dxIslandTeamLease &) = delete;

    dxIslandTeam &operator*() const { return *m_team; }

    // Frees what is kept; no step may be in progress.
    static void forget();

private:
    dxIdleLease<dxIslandTeam> m_team;
};
