#include "dynamics/step/dxWorldRuns.h"

#include <algorithm>
#include <utility>

#include "core/dxPointerSet.h"
#include "dynamics/step/dxStepStrategy.h"
#include "settings/dxLentThreads.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkersRunner.h"
#include "settings/dxWorldState.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxUpstreamScope.h"

namespace {

// Worlds in a chunk of the survey: with some hundred bodies, which take longer than claiming a chunk.
constexpr std::size_t kSurveyChunk = 16;

// A world that takes this many times the share of a thread is stepped by all of them.
constexpr double kLargeWorld = 1.2;

// Assumed for worlds of small islands, where the number of iterations makes little difference.
constexpr int kIterations = 20;

bool hasUserAllocator() {
    return dGetAllocHandler() != nullptr || dGetReallocHandler() != nullptr || dGetFreeHandler() != nullptr;
}

bool hasMovedCallback(const dxWorld &world) {
    for (const dxBody *body = world.firstbody; body != nullptr; body = static_cast<const dxBody *>(body->next))
        if (body->moved_callback != nullptr) return true;
    return false;
}

// On a worker.
bool goesAlone(const dxWorld &world) {
    const bool hasOwnMemory = world.wmem != nullptr && world.wmem->GetMemoryManager() != nullptr;
    return hasOwnMemory || dxMayBeEndless(world) || dxWorldWorkers::given(&world) || dxWorldSettings::of(&world).threads != 0 ||
           hasMovedCallback(world);
}

// Returns the cost as if the world were one island.
double upperCost(const dxWorld &world, dxStepperKind kind) {
    return dxCostModel::islandCost(kind, world.qs.num_iterations, static_cast<unsigned>(world.nb), static_cast<unsigned>(world.nj));
}

class Cut {
public:
    explicit Cut(dxWorld *const *worlds) : m_worlds(worlds) {}

    void append(unsigned index, bool isShared) {
        const dxStepWorkingMemory *const memory = m_worlds[index]->wmem;
        const bool isFirstUse = memory == nullptr || m_memories.insert(memory);
        const bool joins = !m_runs.empty() && m_runs.back().isShared == isShared && (isFirstUse || !isShared);
        if (!joins) m_runs.push_back({index, index, isShared});
        m_runs.back().end = index + 1;
    }

    std::vector<dxWorldRun> runs() { return std::move(m_runs); }

private:
    dxWorld *const *m_worlds;
    dxPointerSet m_memories;  // of all runs: there is one run too many where three worlds share one
    std::vector<dxWorldRun> m_runs;
};

}  // namespace

unsigned dxWorldRuns::workerLimit() {
    const dxSettings &settings = dxSettings::instance();
    if (settings.algorithm() == dxAlgorithm::Serial || dxTrapsFloatingPoint()) return 1;
    return settings.algorithm() == dxAlgorithm::Auto ? std::min(settings.threads(), settings.cores()) : settings.threads();
}

dxWorldCosts dxWorldRuns::costs(dxWorld *const *worlds, unsigned count) {
    dxWorldCosts costs;
    for (unsigned i = 0; i < count; ++i) {
        const double cost = dxCostModel::islandCost(dxStepperKind::QuickExact, kIterations, static_cast<unsigned>(worlds[i]->nb),
                                                    static_cast<unsigned>(worlds[i]->nj));
        costs.total += cost;
        costs.largest = std::max(costs.largest, cost);
    }
    return costs;
}

std::vector<dxWorldRun> dxWorldRuns::cut(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, unsigned workers) {
    if (dxHasUserHandlers() || hasUserAllocator()) return {{0, count, false}};
    std::vector<char> isAlone(count);
    dxWorkersRunner(workers).forChunks(dxParallelStage::WorldSurvey, count, kSurveyChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) isAlone[i] = goesAlone(*worlds[i]);
    });
    double total = 0;
    for (unsigned i = 0; i < count; ++i) total += upperCost(*worlds[i], stepper.kind);
    const double large = kLargeWorld * total / std::min(workers, count);
    Cut cut(worlds);
    for (unsigned i = 0; i < count; ++i) cut.append(i, isAlone[i] == 0 && upperCost(*worlds[i], stepper.kind) <= large);
    return cut.runs();
}
