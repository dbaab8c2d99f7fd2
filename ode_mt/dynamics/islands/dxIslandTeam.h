// Workers that step one island together, and what they share from step to step: memory, and what has been
// measured.
#pragma once

#include "threading/dxSharingPolicy.h"
#include "threading/dxTaskRunner.h"
#include "threading/process/dxIdlePool.h"

struct dxIslandTeam {
    dxTaskRunner *runner = nullptr;
    bool sharesAlways = false;  // whatever is large enough, else what has been faster of late
    dxSharingPolicy solvePolicy;  // of the exact step's triangular solves
};

// Takes a team for the time of a step; its memory goes back to the process's pool.
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
