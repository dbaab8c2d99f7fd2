#include "dynamics/islands/dxIslandTeam.h"

#include "threading/process/dxProcessObject.h"

namespace {

dxProcessObject<dxIdlePool<dxIslandTeam>> pool;

}  // namespace

dxIslandTeamLease::dxIslandTeamLease(dxTaskRunner &runner, bool sharesAlways) : m_team(*pool) {
    m_team->runner = &runner;
    m_team->sharesAlways = sharesAlways;
}

dxIslandTeamLease::~dxIslandTeamLease() { m_team->runner = nullptr; }

void dxIslandTeamLease::forget() {
    pool->clear([](dxIslandTeam *team) { delete team; });
}
