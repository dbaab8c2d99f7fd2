#include "dynamics/step/dxStepWorlds.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <optional>
#include <vector>

#include "core/dxStopwatch.h"
#include "dynamics/step/dxDeferredRun.h"
#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/dxStep.h"
#include "dynamics/step/dxWorldRuns.h"
#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/step/islands/dxIslandSurvey.h"
#include "dynamics/step/random/dxSingleStepper.h"
#include "quickstep.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkersRunner.h"
#include "settings/dxWorldStatistics.h"
#include "step.h"
#include "threading/process/dxProcess.h"
#include "threading/timeline/dxTimeline.h"

namespace {

const dxWorldStepper kSteppers[] = {
    {dWorldStep, &dxStepIsland, &dxEstimateStepMemoryRequirements, dxStepperKind::WorldExact},
    {dWorldQuickStep, &dxQuickStepIsland, &dxEstimateQuickStepMemoryRequirements, dxStepperKind::QuickExact},
};

// Parallel worlds have another overhead than parallel islands, so they have a model of their own.
dxProcessObject<dxCostModel> worldCosts;

// Number of chunks of worlds for each worker: enough that all workers end at about the same time.
constexpr unsigned kChunksPerWorker = 24;

bool stepInOrder(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize) {
    bool areStepped = true;
    for (unsigned i = 0; i < count; ++i) areStepped &= stepper.step(worlds[i], stepSize) != 0;
    return areStepped;
}

struct World {
    dxWorld *world;
    dxWorldProcessIslandsInfo islands;
    std::uint64_t draws;
    bool isPrepared;
};

// One run of worlds, which are the units of a deferred run.
class Worlds {
public:
    // Throws std::bad_alloc.
    Worlds(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize, unsigned workers)
        : m_first(worlds), m_stepper(stepper), m_stepSize(stepSize), m_count(count), m_workers(workers), m_worlds(count) {
        for (unsigned i = 0; i < count; ++i) m_worlds[i].world = worlds[i];
        m_run.begin(count, workers, false);  // dxWorldRuns leaves worlds to the loop where the user has handlers
    }

    // Returns whether all have been stepped.
    bool step() {
        forChunks(dxParallelStage::WorldPreparation, m_workers, [this](unsigned index, unsigned worker) { prepare(index, worker); });
        reserve();
        if (dxTimeline::isCounted())
            for (const World &world : m_worlds) dxWorldStatistics::enrol(world.world);
        const unsigned together = shareFeedback() ? 1 : m_workers;
        forChunks(dxParallelStage::Worlds, together, [this](unsigned index, unsigned worker) { stepWorld(index, worker); });
        return commit();
    }

    double busyNs() const { return m_run.busyNs(); }

private:
    dxStepCall callOf(World &world) const {
        return dxIslandStepper::makeCall(world.world, world.islands, m_stepSize, m_stepper.island);
    }

    template <class Work>
    void forChunks(dxParallelStage stage, unsigned workers, const Work &work) {
        const std::uint64_t count = m_count, chunks = std::min(m_count, workers * kChunksPerWorker);
        dxWorkersRunner(workers).forBlocks(stage, static_cast<unsigned>(chunks), [&](unsigned chunk, unsigned worker) {
            const dxStopwatch stopwatch;
            const auto end = static_cast<unsigned>((chunk + 1) * count / chunks);
            for (auto index = static_cast<unsigned>(chunk * count / chunks); index < end; ++index) work(index, worker);
            m_run.addBusy(worker, stopwatch.ns());
        });
    }

    // On a worker. A joint that reports an error does so in the step itself.
    void prepare(unsigned index, unsigned worker) {
        World &world = m_worlds[index];
        world.isPrepared = dxPrepareWorldIslands(world.world, world.islands, m_stepSize, m_stepper.estimate);
        world.draws = 0;
        if (!world.isPrepared) return;
        const dxStepCall call = callOf(world);
        const bool draws = dxIslandStepper::drawsRandomNumbers(call);
        dxIslandCursor cursor(call.info);
        for (unsigned i = 0; i < call.count; ++i) {
            const dxIsland island = cursor.next();
            if (draws) world.draws += dxIslandStepper::drawsOf(call, dxCountRows(island).value_or(0));
            collectFeedback(island, index, worker);
        }
    }

    // Without memory for it the worlds go in order.
    void collectFeedback(const dxIsland &island, unsigned index, unsigned worker) try {
        m_run.collectFeedback(island, index, worker);
    } catch (const std::bad_alloc &) {
        m_mayShareFeedback.store(true, std::memory_order_relaxed);
    }

    void reserve() {
        if (std::all_of(m_worlds.begin(), m_worlds.end(), [](const World &world) { return world.draws == 0; })) return;
        const dxSingleStepper inTurn;
        m_run.reserve(m_count, [this](unsigned index) { return m_worlds[index].draws; });
    }

    // Whether joints of two worlds write to one feedback structure, or to two that overlap.
    bool shareFeedback() try {
        if (m_mayShareFeedback.load(std::memory_order_relaxed)) return true;
        bool isShared = false;
        m_run.forSharedFeedback([&isShared](unsigned) { isShared = true; });
        return isShared;
    } catch (const std::bad_alloc &) {
        return true;
    }

    // Runs on a worker. There are no handlers: an error ends the process as soon as it is delivered, so worlds after it need no step.
    void stepWorld(unsigned index, unsigned worker) {
        World &world = m_worlds[index];
        if (!world.isPrepared || !m_run.isNeeded(index)) return;
        m_run.run(index, worker, [&] { dxStepOnThisThread(world.world, world.islands, m_stepSize, m_stepper.island, worker); });
    }

    // A world that was interrupted has reported its error, which ends the process. If there was no memory to keep the report, the world reports it
    // again.
    bool commit() {
        const unsigned end = m_run.interrupted();
        m_run.commit(end, [this](unsigned index) { notifyMoved(m_worlds[index]); });
        const auto isPrepared = [](const World &world) { return world.isPrepared; };
        const bool areStepped = std::all_of(m_worlds.begin(), m_worlds.begin() + end, isPrepared);
        return stepInOrder(m_first + end, m_count - end, m_stepper, m_stepSize) && areStepped;
    }

    static void notifyMoved(const World &world) {
        if (!world.isPrepared) return;
        dxIslandCursor cursor(world.islands);
        for (auto count = world.islands.GetIslandsCount(); count > 0; --count) dxNotifyMoved(cursor.next());
    }

    dxWorld *const *const m_first;
    const dxWorldStepper &m_stepper;
    const dReal m_stepSize;
    const unsigned m_count, m_workers;
    std::vector<World> m_worlds;
    dxDeferredRun m_run;
    std::atomic<bool> m_mayShareFeedback{false};
};

// Without memory this is the loop.
bool stepRun(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize, unsigned workers, double &busyNs) {
    std::optional<Worlds> run;
    try {
        run.emplace(worlds, count, stepper, stepSize, std::min(workers, count));
    } catch (const std::bad_alloc &) {
        return stepInOrder(worlds, count, stepper, stepSize);
    }
    const bool areStepped = run->step();
    busyNs += run->busyNs();
    return areStepped;
}

bool stepRuns(dxWorld *const *worlds, const std::vector<dxWorldRun> &runs, const dxWorldStepper &stepper, dReal stepSize, unsigned workers,
              double &busyNs) {
    bool areStepped = true;
    for (const dxWorldRun &run : runs) {
        dxWorld *const *const first = worlds + run.begin;
        const unsigned count = run.end - run.begin;
        areStepped &= run.isShared && count > 1 ? stepRun(first, count, stepper, stepSize, workers, busyNs)
                                                : stepInOrder(first, count, stepper, stepSize);
    }
    return areStepped;
}

unsigned chooseWorkers(const dxWorldStepper &stepper, const dxWorldCosts &costs, unsigned limit) {
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) return limit;
    return worldCosts->chooseWorkers(stepper.kind, costs.total, costs.largest, limit);
}

}  // namespace

const dxWorldStepper *dxFindWorldStepper(const char *name) {
    if (std::strcmp(name, "step") == 0) return &kSteppers[0];
    return std::strcmp(name, "quick") == 0 ? &kSteppers[1] : nullptr;
}

bool dxStepWorlds(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize) {
    const unsigned limit = std::min(dxWorldRuns::workerLimit(), count);
    if (limit < 2) return stepInOrder(worlds, count, stepper, stepSize);
    const dxWorldCosts costs = dxWorldRuns::costs(worlds, count);
    const unsigned workers = chooseWorkers(stepper, costs, limit);
    std::vector<dxWorldRun> runs{};
    try {
        if (workers > 1) runs = dxWorldRuns::cut(worlds, count, stepper, workers);
    } catch (const std::bad_alloc &) {
    }
    const dxStopwatch stopwatch;
    if (runs.empty()) {
        const bool areStepped = stepInOrder(worlds, count, stepper, stepSize);
        worldCosts->learnSerial(stepper.kind, costs.total, stopwatch.ns());
        return areStepped;
    }
    double busyNs = 0;
    const bool areStepped = stepRuns(worlds, runs, stepper, stepSize, workers, busyNs);
    const bool isOneRun = runs.size() == 1 && runs.front().isShared;
    if (isOneRun) worldCosts->learnParallel(stepper.kind, costs.total, costs.largest, workers, busyNs, stopwatch.ns());
    return areStepped;
}
