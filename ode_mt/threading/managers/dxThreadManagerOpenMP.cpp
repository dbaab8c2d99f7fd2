#include "threading/managers/dxThreadManagerOpenMP.h"

#include <algorithm>

#include "core/dxCacheLine.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxJobBoard.h"

namespace {

class Region {
public:
    Region(const dxOpenMPRuntime &runtime, unsigned blocks, dxThreadManager::Task task, void *context)
        : m_runtime(runtime), m_blocks(blocks), m_task(task), m_context(context) {
        m_environment.capture();
    }

    void run(unsigned team) {
        m_runtime.parallel([](void *region) { static_cast<Region *>(region)->work(); }, this, team);
        m_environment.raiseFlags();
    }

private:
    void work() {
        const unsigned worker = m_runtime.threadNumber();
        dxFloatEnvironmentScope scope(m_environment);
        for (;;) {
            dxPerturb(dxSchedulePoint::ClaimTeamBlock);
            const unsigned long long block = m_next.fetch_add(1, std::memory_order_relaxed);
            if (block >= m_blocks) break;
            m_task(m_context, static_cast<unsigned>(block), worker);
        }
        scope.shareFlags();
    }

    const dxOpenMPRuntime &m_runtime;
    const unsigned m_blocks;
    const dxThreadManager::Task m_task;
    void *const m_context;
    dxFloatEnvironment m_environment;
    alignas(kCacheLine) std::atomic<unsigned long long> m_next{0};
};

// Counts how often pools were ended, by any manager: they are the runtime's.
std::atomic<unsigned> pools{1};

// The largest team that was tried for the calling thread's pool, and the count of pools at that time.
struct Probed {
    unsigned pools;
    unsigned team;
};
thread_local Probed probed{0, 0};

}  // namespace

dxThreadManagerOpenMP::dxThreadManagerOpenMP(const dxOpenMPRuntime &runtime, dxCreateThread create) : m_runtime(runtime), m_create(create) {
    listenToForks();
}

dxThreadManagerOpenMP::~dxThreadManagerOpenMP() {
    ignoreForks();
    stop();
}

std::unique_ptr<dxThreadManager> dxThreadManagerOpenMP::make(dxCreateThread create) {
    const std::optional<dxOpenMPRuntime> runtime = dxOpenMPRuntime::load();
    return runtime ? std::make_unique<dxThreadManagerOpenMP>(*runtime, create) : nullptr;
}

void dxThreadManagerOpenMP::resize(unsigned workers) {
    const unsigned wanted = dxClampWorkers(workers);
    if (wanted < m_size.load()) stop();
    m_allowed.store(kMaxWorkers);
    m_size.store(wanted);
}

void dxThreadManagerOpenMP::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, m_size.load(), m_allowed.load()});
    if (most < 2 || m_isAlone || m_isBusy.exchange(true)) {
        dxRunAlone(blocks, task, context);
        return;
    }
    const unsigned team = allowedTeam(most);
    m_runtime.prepareRegions();
    Region(m_runtime, blocks, task, context).run(team);
    m_isBusy.store(false);
}

void dxThreadManagerOpenMP::stop() {
    m_runtime.endThreads();
    ++pools;
    m_allowed.store(kMaxWorkers);
}

void dxThreadManagerOpenMP::beforeFork() {
    m_areRegionsSafeInChild = m_runtime.prepareFork();
    ++pools;
}

void dxThreadManagerOpenMP::inForkedChild() {
    m_isAlone = m_isAlone || !m_areRegionsSafeInChild;
    m_isBusy.store(false);
}

// Called by the run that has the region.
unsigned dxThreadManagerOpenMP::allowedTeam(unsigned wanted) {
    if (probed.pools != pools.load()) probed = {pools.load(), 1};
    if (wanted <= probed.team) return wanted;
    int refusal = 0;
    const unsigned team = 1 + dxProbeThreads(m_create, wanted - 1, refusal);
    probed.team = team;
    if (refusal != 0) {
        m_allowed.store(team);
        if (!m_isReported) dxReportRefusal(name(), team, m_size.load(), refusal);
        m_isReported = true;
    }
    return team;
}
