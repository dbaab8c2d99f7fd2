#include "dynamics/step/dxStepWorlds.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <optional>
#include <vector>

#include "core/dxAtomicLeast.h"
#include "core/dxCacheLine.h"
#include "core/dxStopwatch.h"
#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/dxStep.h"
#include "dynamics/step/dxWorldRuns.h"
#include "dynamics/step/islands/dxBodyIntegration.h"
#include "dynamics/step/islands/dxDeferredIsland.h"
#include "dynamics/step/islands/dxIslandSurvey.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/random/dxRandom.h"
#include "dynamics/step/random/dxSingleStepper.h"
#include "quickstep.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkersRunner.h"
#include "settings/dxWorldStatistics.h"
#include "step.h"
#include "threading/process/dxProcessObject.h"
#include "threading/timeline/dxTimeline.h"

namespace {

const dxWorldStepper kSteppers[] = {
    {dWorldStep, &dxStepIsland, &dxEstimateStepMemoryRequirements, dxStepperKind::WorldExact},
    {dWorldQuickStep, &dxQuickStepIsland, &dxEstimateQuickStepMemoryRequirements, dxStepperKind::QuickExact},
};

// What sharing worlds out costs is another thing than what sharing islands out does: a model of its own.
dxProcessObject<dxCostModel> worldCosts;

// Chunks of worlds that a worker takes at once: so many a worker that the last ones end at about the same time.
constexpr unsigned kChunksPerWorker = 24;

struct World {
    dxWorld *world;
    dxWorldProcessIslandsInfo islands;
    std::uint64_t draws;
    std::uint32_t seed;  // the random sequence before its first draw
    unsigned worker;     // who stepped it
    bool isPrepared;
};

struct alignas(kCacheLine) Worker {
    std::vector<dxKeptReport> reports;
    std::vector<dxFeedbackUse> feedbacks;
    double busyNs = 0;
};

// One run.
class Run {
public:
    Run(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize, unsigned workers)
        : m_stepper(stepper), m_stepSize(stepSize), m_count(count), m_worlds(count), m_workers(workers), m_interrupted(count) {
        for (unsigned i = 0; i < count; ++i) m_worlds[i].world = worlds[i];
    }

    bool step() {
        forChunks(dxParallelStage::WorldPreparation, workers(), [this](unsigned index, unsigned worker) { prepare(index, worker); });
        reserve();
        if (dxTimeline::isCounted())
            for (const World &world : m_worlds) dxWorldStatistics::enrol(world.world);
        const unsigned together = shareFeedback() ? 1 : workers();
        forChunks(dxParallelStage::Worlds, together, [this](unsigned index, unsigned worker) { stepWorld(index, worker); });
        commit();
        return std::all_of(m_worlds.begin(), m_worlds.end(), [](const World &world) { return world.isPrepared; });
    }

    double busyNs() const {
        double busy = 0;
        for (const Worker &worker : m_workers) busy += worker.busyNs;
        return busy;
    }

private:
    unsigned workers() const { return static_cast<unsigned>(m_workers.size()); }

    dxStepCall callOf(World &world) const {
        return {world.world, world.islands, m_stepSize, dxIslandStepper::kindOf(world.world, m_stepper.island),
                static_cast<unsigned>(world.islands.GetIslandsCount())};
    }

    template <class Work>
    void forChunks(dxParallelStage stage, unsigned workers, const Work &work) {
        const std::uint64_t count = m_count, chunks = std::min(m_count, workers * kChunksPerWorker);
        dxWorkersRunner(workers).forBlocks(stage, static_cast<unsigned>(chunks), [&](unsigned chunk, unsigned worker) {
            const dxStopwatch stopwatch;
            const auto end = static_cast<unsigned>((chunk + 1) * count / chunks);
            for (auto index = static_cast<unsigned>(chunk * count / chunks); index < end; ++index) work(index, worker);
            m_workers[worker].busyNs += stopwatch.ns();
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
        dxCollectFeedback(island, index, m_workers[worker].feedbacks);
    } catch (const std::bad_alloc &) {
        m_mayShareFeedback.store(true, std::memory_order_relaxed);
    }

    // No step of another thread draws in between (contract C7).
    void reserve() {
        std::uint64_t draws = 0;
        for (const World &world : m_worlds) draws += world.draws;
        if (draws == 0) return;
        std::uint32_t seed;
        {
            const dxSingleStepper inTurn;
            seed = dxRandom::takeSharedBlock(draws);
        }
        for (World &world : m_worlds) {
            world.seed = seed;
            seed = dxRandom::jump(seed, world.draws);
        }
    }

    // Whether joints of two worlds write to one feedback structure, or to two that overlap.
    bool shareFeedback() const try {
        if (m_mayShareFeedback.load(std::memory_order_relaxed)) return true;
        std::vector<dxFeedbackUse> uses;
        for (const Worker &worker : m_workers) uses.insert(uses.end(), worker.feedbacks.begin(), worker.feedbacks.end());
        std::sort(uses.begin(), uses.end(), [](const dxFeedbackUse &a, const dxFeedbackUse &b) { return a.feedback < b.feedback; });
        // Of structures of which each overlaps the one before it, some two neighbours are of different worlds if any are.
        return std::adjacent_find(uses.begin(), uses.end(), [](const dxFeedbackUse &a, const dxFeedbackUse &b) {
                   return a.island != b.island && dxOverlap(a, b);
               }) != uses.end();
    } catch (const std::bad_alloc &) {
        return true;
    }

    // On a worker. There are no handlers: an error ends the process as soon as it is delivered, so worlds after it need no step.
    void stepWorld(unsigned index, unsigned worker) {
        World &world = m_worlds[index];
        if (!world.isPrepared || index > m_interrupted.load(std::memory_order_relaxed)) return;
        world.worker = worker;
        try {
            dxDeferredIsland scope(index, world.seed, false, m_workers[worker].reports);
            dxStepOnThisThread(world.world, world.islands, m_stepSize, m_stepper.island, worker);
        } catch (const dxUpstreamInterrupted &) {
            dxLowerTo(m_interrupted, index);
        }
    }

    void commit() {
        const bool areReports = std::any_of(m_workers.begin(), m_workers.end(), [](const Worker &worker) { return !worker.reports.empty(); });
        for (unsigned index = 0; index < m_count; ++index) {
            if (areReports) deliverReports(index);
            if (m_worlds[index].isPrepared) notifyMoved(m_worlds[index]);
        }
    }

    void deliverReports(unsigned index) const {
        for (const Worker &worker : m_workers)
            for (const dxKeptReport &report : worker.reports)
                if (report.island == index) report.deliver();
    }

    static void notifyMoved(const World &world) {
        dxIslandCursor cursor(world.islands);
        for (auto count = world.islands.GetIslandsCount(); count > 0; --count) dxNotifyMoved(cursor.next());
    }

    const dxWorldStepper &m_stepper;
    const dReal m_stepSize;
    const unsigned m_count;
    std::vector<World> m_worlds;
    std::vector<Worker> m_workers;
    std::atomic<bool> m_mayShareFeedback{false};
    std::atomic<unsigned> m_interrupted;  // first world whose step has ended in an error
};

bool stepInOrder(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize) {
    bool areStepped = true;
    for (unsigned i = 0; i < count; ++i) areStepped &= stepper.step(worlds[i], stepSize) != 0;
    return areStepped;
}

// Without memory for more it is the loop.
bool stepRun(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize, unsigned workers, double &busyNs) {
    std::optional<Run> run;
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
