#include "threading/managers/dxThreadManagerOpenMP.h"

#include <algorithm>

#include "threading/dxFloatEnvironment.h"
#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxJobBoard.h"

namespace {

class Region {
public:
    Region(const dxOpenMPRuntime &openmp, unsigned blockCount, dxThreadManager::Task blockTask, void *taskContext)
        : runtime(openmp), blocks(blockCount), task(blockTask), context(taskContext) {
        environment.capture();
    }

    void run(unsigned team) {
        runtime.parallel([](void *region) { static_cast<Region *>(region)->work(); }, this, team);
        environment.raiseFlags();
    }

private:
    void work() {
        const unsigned worker = runtime.threadNumber();
        dxFloatEnvironmentScope scope(environment);
        for (;;) {
            dxPerturb(dxSchedulePoint::ClaimTeamBlock);
            const unsigned long long block = next.fetch_add(1, std::memory_order_relaxed);
            if (block >= blocks) break;
            task(context, static_cast<unsigned>(block), worker);
        }
        scope.shareFlags();
    }

    const dxOpenMPRuntime &runtime;
    const unsigned blocks;
    const dxThreadManager::Task task;
    void *const context;
    dxFloatEnvironment environment;
    alignas(64) std::atomic<unsigned long long> next{0};
};

// Counts the times that pools were ended, by whichever manager: they are the runtime's.
std::atomic<unsigned> pools{1};

// The largest team that was tried out for the calling thread's pool, and which life of the pools that was.
struct Probed {
    unsigned pools;
    unsigned team;
};
thread_local Probed probed{0, 0};

}  // namespace

dxThreadManagerOpenMP::dxThreadManagerOpenMP(const dxOpenMPRuntime &openmp, dxCreateThread creation) : runtime(openmp), create(creation) {
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
    if (wanted < size.load()) stop();
    allowed.store(dxMaxWorkers);
    size.store(wanted);
}

void dxThreadManagerOpenMP::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, size.load(), allowed.load()});
    if (most < 2 || alone || busy.exchange(true)) {
        dxRunAlone(blocks, task, context);
        return;
    }
    const unsigned team = allowedTeam(most);
    runtime.prepareRegions();
    Region(runtime, blocks, task, context).run(team);
    busy.store(false);
}

void dxThreadManagerOpenMP::stop() {
    runtime.endThreads();
    ++pools;
    allowed.store(dxMaxWorkers);
}

void dxThreadManagerOpenMP::beforeFork() {
    regionsSafeInChild = runtime.prepareFork();
    ++pools;
}

void dxThreadManagerOpenMP::inForkedChild() {
    alone = alone || !regionsSafeInChild;
    busy.store(false);
}

// Called by the run that has the region.
unsigned dxThreadManagerOpenMP::allowedTeam(unsigned wanted) {
    if (probed.pools != pools.load()) probed = {pools.load(), 1};
    if (wanted <= probed.team) return wanted;
    int refusal = 0;
    const unsigned team = 1 + dxProbeThreads(create, wanted - 1, refusal);
    probed.team = team;
    if (refusal != 0) {
        allowed.store(team);
        if (!reported) dxReportRefusal(name(), team, size.load(), refusal);
        reported = true;
    }
    return team;
}
