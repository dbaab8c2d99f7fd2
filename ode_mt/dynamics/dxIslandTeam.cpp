#include "dynamics/dxIslandTeam.h"

#include "dynamics/dxIdlePool.h"
#include "threading/dxProcessObject.h"

namespace {

dxProcessObject<dxIdlePool<dxIslandTeam>> pool;

}  // namespace

dxIslandTeamLease::dxIslandTeamLease(dxTaskRunner &runner) : m_team(pool->takeOrMake()) { m_team->runner = &runner; }

dxIslandTeamLease::~dxIslandTeamLease() {
    m_team->runner = nullptr;
    pool->giveBack(m_team);
}

void dxIslandTeamLease::forget() {
    pool->clear([](dxIslandTeam *team) { delete team; });
}
