#include "frame/dxStep.h"

#include <ode/error.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>
#include <optional>

#include "dynamics/dxBodyIntegration.h"
#include "dynamics/dxIslandCall.h"
#include "dynamics/dxIslandSurvey.h"
#include "dynamics/dxLoneStepper.h"
#include "dynamics/dxRandom.h"
#include "dynamics/dxReservedDraws.h"
#include "dynamics/dxRowShuffle.h"
#include "dynamics/dxWorkingMemory.h"
#include "dynamics/exactstep/dxExactStep.h"
#include "dynamics/quickstep/dxQuickStep.h"
#include "frame/dxIslandSharing.h"
#include "frame/dxSettings.h"
#include "frame/dxStepStatistics.h"
#include "frame/dxWorkersRunner.h"
#include "frame/dxWorldWorkers.h"
#include "quickstep.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxPerturbation.h"
#include "threading/dxProcessObject.h"
#include "threading/dxSharingPace.h"

namespace {

using Clock = std::chrono::steady_clock;

double nsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

dxProcessObject<dxCostModel> costModel;

// Islands cheaper than this share a block, so that taking a block costs little beside its work.
constexpr double kLeastBlockNs = 3e3;

// More blocks than workers even out what the cost model misjudges.
constexpr unsigned kBlocksPerWorker = 8;

// Joints that make an island large enough to be stepped by several workers together.
constexpr unsigned kLeastTeamJoints = 500;

// The exact step's: at three rows a contact its LCP begins to be worth sharing; under an algorithm that is
// asked for by name it is shared earlier. It is not shared as well as islands side by side, so that the rest
// of the world has to be small.
constexpr unsigned kLeastExactTeamJoints = 134, kLeastExactTeamJointsByName = 64;
constexpr double kLeastExactTeamPart = 0.9;

// Members of a team wait for one another, so more of them than cores would only get in one another's way. An
// algorithm that is asked for by name gets so many on any machine: what they do can be tested there.
constexpr unsigned kLeastTeam = 4;

// For a time per cost to be remembered like the time of a call: that of a step of one millisecond.
constexpr double kCostOfReference = 1e6;

// Whether large islands are stepped by teams, under auto. For the process, as the cost model: what it
// measures is the machine. Steps that find it in use do without.
struct TeamPace {
    std::mutex mutex;
    dxSharingPace pace;
};
dxProcessObject<TeamPace> teamPace;

// The world's own arena for the time of a step.
class WorldArena {
public:
    explicit WorldArena(dxWorld *world)
        : m_context(world->unsafeGetWorldProcessingContext()), m_arena(m_context->ObtainStepperMemArena()) {}
    ~WorldArena() { m_context->ReturnStepperMemArena(m_arena); }
    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessContext *m_context;
    dxWorldProcessMemArena *m_arena;
};

// By upstream's own steppers, which post their stages to the implementation that the user gave the world.
bool stepByPosting(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t estimate) {
    const dxLoneStepper inTurn;
    return dxProcessIslands(world, info, stepSize, stepper, estimate);
}

}  // namespace

// Seam: upstream's dWorldStep and dWorldQuickStep call this instead of dxProcessIslands.
bool dxStepIslands(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize,
                   dstepper_fn_t stepper, dmaxcallcountestimate_fn_t maxCallCountEstimator) {
    if (dxWorldWorkers::haveToBeAsked(world)) return stepByPosting(world, info, stepSize, stepper, maxCallCountEstimator);
    if (!dxWorldWorkers::prepare(world)) return false;
    dxStep(world, info, stepSize, stepper).run();
    return true;
}

dxStep::dxStep(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper)
    : m_world(world),
      m_info(info),
      m_stepSize(stepSize),
      m_kind(stepper == &dxQuickStepIsland ? dxStepperKind::Quick : dxStepperKind::World),
      m_count(static_cast<unsigned>(info.GetIslandsCount())),
      m_userHandlers(dGetErrorHandler() || dGetDebugHandler() || dGetMessageHandler()),
      m_interrupted(m_count) {}

void dxStep::run() {
    const unsigned limit = mayShare() ? workerLimit() : 1;
    if (limit < 2) {
        runInOrder();
        return;
    }
    estimateCosts();
    const bool mayHaveTeam = hasTeamIsland(limit);
    const Clock::time_point start = Clock::now();
    if (mayHaveTeam && shallHaveTeam()) {
        runWithTeam(limit);
        rememberTeam(true, nsSince(start));
        return;
    }
    const unsigned workers = chooseWorkers(limit);
    if (workers >= 2) {
        runShared(workers);
    } else {
        runInOrder();
        if (m_costsKnown) costModel->learnSerial(m_kind, m_totalCost, nsSince(start));
    }
    if (mayHaveTeam) rememberTeam(false, nsSince(start));
}

// --- with a team --------------------------------------------------------------------------------------

// In order, each large island by all workers together.
void dxStep::runWithTeam(unsigned workers) {
    const unsigned most = std::max(dxSettings::instance().cores(), kLeastTeam);
    dxWorkersRunner runner(std::min(workers, most), m_world);
    std::optional<dxIslandTeamLease> lease;
    try {
        m_team = &*lease.emplace(runner, dxSettings::instance().algorithm() != dxAlgorithm::Auto);
    } catch (const std::bad_alloc &) {  // then without one
    }
    runInOrder();
    m_team = nullptr;
    dxStepStatistics::instance().countTeamStep(runner.tookPart());
}

// One island takes so long that the others would have to wait for it.
bool dxStep::hasTeamIsland(unsigned limit) const {
    if (m_largestJoints < leastTeamJoints() || !m_costsKnown) return false;
    const double part = m_kind == dxStepperKind::Quick ? 1.0 / limit : kLeastExactTeamPart;
    return m_largestCost >= part * m_totalCost;
}

// The exact step measures its LCPs instead (dxSolveTeam).
bool dxStep::isTeamMeasured() const {
    return m_kind == dxStepperKind::Quick && dxSettings::instance().algorithm() == dxAlgorithm::Auto;
}

bool dxStep::shallHaveTeam() const {
    if (!isTeamMeasured()) return true;
    const std::unique_lock<std::mutex> hold(teamPace->mutex, std::try_to_lock);
    return hold && teamPace->pace.shallShare();
}

void dxStep::rememberTeam(bool hadTeam, double ns) const {
    if (!isTeamMeasured()) return;
    const std::unique_lock<std::mutex> hold(teamPace->mutex, std::try_to_lock);
    if (hold) teamPace->pace.remember(hadTeam, ns * kCostOfReference / m_totalCost);
}

// --- in order -----------------------------------------------------------------------------------------

void dxStep::runInOrder() {
    if (!drawsRandomNumbers()) {
        stepInOrder(dxIslandCursor(m_info), m_count);
        return;
    }
    const dxLoneStepper stepper;
    if (stepper.alone()) {
        stepInOrder(dxIslandCursor(m_info), m_count);
    } else {
        runInOrderReserving();
    }
}

void dxStep::runInOrderReserving() {
    // Up to the first callback of the user nothing can look at the random sequence: those islands take
    // their numbers as one block.
    std::uint64_t draws = 0;
    unsigned quiet = 0;
    for (dxIslandCursor cursor(m_info); quiet < m_count; ++quiet) {
        const dxIsland island = cursor.next();
        if (dxHasMovedCallback(island)) break;
        const std::optional<unsigned> rows = dxCountRows(island);
        if (!rows) break;
        draws += drawsOf(*rows);
    }
    dxIslandCursor cursor(m_info);
    if (quiet > 0) {
        const std::uint32_t seed = dxRandom::takeSharedBlock(draws);
        dxReservedDraws reserved(seed, dxRandom::jump(seed, draws));
        stepInOrder(cursor, quiet);
    }
    for (unsigned i = 0; i < quiet; ++i) cursor.next();
    stepInOrder(cursor, m_count - quiet);
}

void dxStep::stepInOrder(dxIslandCursor cursor, unsigned count) {
    if (count == 0) return;
    const WorldArena arena(m_world);
    for (unsigned i = 0; i < count; ++i) stepIsland(cursor.next(), arena.get());
}

void dxStep::stepIsland(const dxIsland &island, dxWorldProcessMemArena *arena) {
    arena->ResetState();
    dxIslandTeam *const team = m_team != nullptr && island.jointCount >= leastTeamJoints() ? m_team : nullptr;
    if (m_kind == dxStepperKind::Quick) {
        dxQuickStep({m_world, m_stepSize, island, arena, team});
        return;
    }
    constexpr unsigned kOneThread = 1;  // all of upstream's stages one after the other on this thread
    dxIslandCall call(m_world, m_stepSize, kOneThread, arena, island.bodies, island.joints);
    call.AssignIslandSelection(island.bodies, island.joints, island.bodyCount, island.jointCount);
    call.team = team;
    dxExactStepIsland(&call);
}

bool dxStep::drawsRandomNumbers() const { return drawsOf(2) != 0; }

// Upstream shuffles the rows before every eighth iteration but the first: m - 1 draws each time.
std::uint64_t dxStep::drawsOf(unsigned rows) const {
    if (m_kind != dxStepperKind::Quick || rows == 0 || m_world->qs.num_iterations < 1) return 0;
    const std::uint64_t shuffles =
        (static_cast<unsigned>(m_world->qs.num_iterations) - 1) / kShuffleInterval;
    return (rows - 1) * shuffles;
}

// --- shared out ---------------------------------------------------------------------------------------

void dxStep::runShared(unsigned workers) {
    const Clock::time_point start = Clock::now();
    if (!prepareShared(workers)) {
        m_records.reset();
        runInOrder();
        return;
    }
    unsigned rest;
    {
        const WorldArena arena(m_world);
        m_records->workers[0].arena = arena.get();
        reserveRandomNumbers();
        dxWorkersRunner(workers, m_world)
            .forBlocks(dxParallelStage::Islands, static_cast<unsigned>(m_records->blocks.size()),
                       [this](unsigned block, unsigned worker) { stepBlock(block, worker); });
        stepLeftovers();
        learn(workers, nsSince(start));
        rest = commit();
    }
    finishInOrder(rest);
}

// Changes nothing of the world's. False: there is no memory for it.
bool dxStep::prepareShared(unsigned workers) try {
    prepareRecords(workers);
    const unsigned chunks = std::min(m_count, workers * kBlocksPerWorker);
    dxWorkersRunner(workers, m_world).forBlocks(dxParallelStage::IslandSurvey, chunks, [this, chunks](unsigned chunk, unsigned worker) {
        const std::uint64_t count = m_count;
        survey(chunk * count / chunks, (chunk + 1) * count / chunks, worker);
    });
    orderSharedFeedback();
    double cost = 0;
    for (unsigned i = 0; i < m_inOrderFrom; ++i) cost += m_records->islands[i].cost;
    const double least = std::max(kLeastBlockNs, cost / (kBlocksPerWorker * workers));
    dxShareIslands(*m_records, m_inOrderFrom, least);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

void dxStep::prepareRecords(unsigned workers) {
    m_records = dxStepRecords::borrow();
    m_records->islands.resize(m_count);
    dxIslandCursor cursor(m_info);
    for (dxIslandRecord &record : m_records->islands) {
        record = {};
        record.island = cursor.next();
        record.cost = dxCostModel::islandCost(m_kind, m_world->qs.num_iterations, record.island.bodyCount,
                                              record.island.jointCount);
    }
    if (m_records->workers.size() < workers) m_records->workers.resize(workers);
    for (dxWorkerRecord &worker : m_records->workers) {
        worker.reset();
        // One worker may come to survey all islands: room for what the last step found keeps a steady state
        // from allocating.
        worker.feedbacks.reserve(m_records->feedbacks.size());
    }
}

void dxStep::survey(unsigned begin, unsigned end, unsigned worker) {
    for (unsigned i = begin; i < end; ++i) {
        dxIslandRecord &record = m_records->islands[i];
        record.inOrder = dxHasMovedCallback(record.island);
        if (drawsRandomNumbers()) {
            const std::optional<unsigned> rows = dxCountRows(record.island);
            record.rows = rows.value_or(0);
            record.inOrder = record.inOrder || !rows;
        }
        dxCollectFeedback(record.island, i, m_records->workers[worker].feedbacks);
    }
}

// Two joints may have been given one feedback structure: upstream's later island overwrites it.
void dxStep::orderSharedFeedback() {
    std::vector<dxFeedbackUse> &uses = m_records->feedbacks;
    uses.clear();
    for (const dxWorkerRecord &worker : m_records->workers) {
        uses.insert(uses.end(), worker.feedbacks.begin(), worker.feedbacks.end());
    }
    std::sort(uses.begin(), uses.end(), [](const dxFeedbackUse &a, const dxFeedbackUse &b) {
        return a.feedback != b.feedback ? a.feedback < b.feedback : a.island < b.island;
    });
    for (std::size_t i = 1; i < uses.size(); ++i) {
        const bool shared = uses[i].feedback == uses[i - 1].feedback && uses[i].island != uses[i - 1].island;
        if (shared) m_records->islands[uses[i - 1].island].inOrder = true;
    }
    const auto first = std::find_if(m_records->islands.begin(), m_records->islands.end(),
                                    [](const dxIslandRecord &record) { return record.inOrder; });
    m_inOrderFrom = static_cast<unsigned>(first - m_records->islands.begin());
}

void dxStep::reserveRandomNumbers() {
    if (!drawsRandomNumbers()) return;
    std::uint64_t draws = 0;
    for (unsigned i = 0; i < m_inOrderFrom; ++i) draws += drawsOf(m_records->islands[i].rows);
    std::uint32_t seed = dxRandom::takeSharedBlock(draws);
    for (unsigned i = 0; i < m_inOrderFrom; ++i) {
        m_records->islands[i].seed = seed;
        seed = dxRandom::jump(seed, drawsOf(m_records->islands[i].rows));
    }
    m_randomEnd = seed;
}

void dxStep::stepBlock(unsigned block, unsigned worker) {
    const Clock::time_point start = Clock::now();
    const dxIslandBlock range = m_records->blocks[block];
    for (unsigned i = range.begin; i < range.end; ++i) stepDeferred(m_records->order[i], worker);
    m_records->workers[worker].busyNs += nsSince(start);
}

void dxStep::stepDeferred(unsigned index, unsigned worker) {
    dxPerturb(dxSchedulePoint::StepIsland);
    if (index > m_interrupted.load(std::memory_order_relaxed)) return;  // would be taken back
    dxIslandRecord &record = m_records->islands[index];
    dxWorkerRecord &own = m_records->workers[worker];
    if (own.arena == nullptr) {
        own.arena = dxWorkingMemory::take(m_records->workers[0].arena->GetMemorySize());
        if (own.arena == nullptr) return;
    }
    record.worker = worker;
    record.undoBegin = own.undo.mark();
    try {
        if (m_userHandlers) own.undo.save(record.island);
    } catch (const std::bad_alloc &) {
        return interruptAt(index);
    }
    record.undoEnd = own.undo.mark();
    record.stepped = true;
    ++own.islands;
    try {
        dxDeferredIsland scope(index, record.seed, m_userHandlers, own.reports);
        stepIsland(record.island, own.arena);
    } catch (const dxIslandInterrupted &) {
        dxPerturb(dxSchedulePoint::InterruptIsland);
        interruptAt(index);
    }
}

void dxStep::interruptAt(unsigned island) {
    unsigned first = m_interrupted.load(std::memory_order_relaxed);
    while (island < first && !m_interrupted.compare_exchange_weak(first, island, std::memory_order_relaxed)) {
    }
}

void dxStep::stepLeftovers() {
    for (unsigned i = 0; i < m_inOrderFrom; ++i) {
        if (!m_records->islands[i].stepped) stepDeferred(i, 0);
    }
}

// Makes the steps of the islands visible in upstream's order, up to the first one that cannot be: one
// that has to be stepped in order, was interrupted, or has a geom in a space that is being collided.
// Returns that one.
unsigned dxStep::commit() {
    dxPerturb(dxSchedulePoint::CommitIslands);
    unsigned end = std::min(m_inOrderFrom, m_interrupted.load(std::memory_order_relaxed));
    if (m_userHandlers) {
        for (unsigned i = 0; i < end; ++i) {
            if (dxTouchesLockedSpace(m_records->islands[i].island)) end = i;
        }
        takeBack(end);
    }
    for (unsigned i = 0; i < end; ++i) {
        deliverReports(i);
        dxNotifyMoved(m_records->islands[i].island);
    }
    deliverReports(end);

    unsigned islands = 0, used = 0;
    for (dxWorkerRecord &worker : m_records->workers) {
        islands += worker.islands;
        used += worker.islands != 0;
        if (&worker != &m_records->workers[0] && worker.arena) dxWorkingMemory::giveBack(worker.arena);
    }
    dxStepStatistics::instance().countParallelStep(islands, used);
    return end;
}

void dxStep::takeBack(unsigned begin) {
    for (unsigned i = begin; i < m_inOrderFrom; ++i) {
        const dxIslandRecord &record = m_records->islands[i];
        if (record.stepped) m_records->workers[record.worker].undo.restore(record.undoBegin, record.undoEnd);
    }
}

// Reports are kept only where the user has no handlers: a message goes to stderr, and an error ends the
// process, so an interrupted island is the last to report. Whoever stepped the island has them, and few
// islands have any.
void dxStep::deliverReports(unsigned island) const {
    if (island == m_count) return;
    for (const dxKeptReport &report : m_records->workers[m_records->islands[island].worker].reports)
        if (report.island == island) report.deliver();
}

void dxStep::finishInOrder(unsigned begin) {
    if (begin == m_count) return;
    const bool reserved = drawsRandomNumbers() && begin < m_inOrderFrom;
    const std::uint32_t seed = reserved ? m_records->islands[begin].seed : 0;
    const unsigned reservedCount = m_inOrderFrom - std::min(begin, m_inOrderFrom);
    m_records.reset();  // from here on user code runs, which may leave the step and never come back

    dxIslandCursor cursor(m_info);
    for (unsigned i = 0; i < begin; ++i) cursor.next();
    if (reserved && !dxRandom::rewindShared(m_randomEnd, seed)) {
        dxReservedDraws draws(seed, m_randomEnd);
        stepInOrder(cursor, reservedCount);
        for (unsigned i = 0; i < reservedCount; ++i) cursor.next();
        begin = m_inOrderFrom;
    }
    stepInOrder(cursor, m_count - begin);
}

void dxStep::learn(unsigned workers, double wallNs) const {
    double busyNs = 0;
    for (const dxWorkerRecord &worker : m_records->workers) busyNs += worker.busyNs;
    if (m_inOrderFrom == m_count && m_interrupted.load(std::memory_order_relaxed) == m_count) {
        costModel->learnParallel(m_kind, m_totalCost, m_largestCost, workers, busyNs, wallNs);
    }
}

// --- who may work -------------------------------------------------------------------------------------

// The steps of most small worlds are over before a clock could be read: they cost one look at their only
// island.
bool dxStep::mayShare() const {
    if (mayBeEndless()) return false;
    if (m_count != 1) return m_count > 1;
    return dxIslandCursor(m_info).next().jointCount >= leastTeamJoints();
}

// Upstream takes a negative number of iterations for one above two thousand million, and never returns from an island with
// rows. It may never come to that island, though: one before it may report an error to a handler that leaves the step.
bool dxStep::mayBeEndless() const {
    constexpr unsigned kMostIterations = 100000;
    return m_kind == dxStepperKind::Quick && static_cast<unsigned>(m_world->qs.num_iterations) > kMostIterations;
}

unsigned dxStep::leastTeamJoints() const {
    if (m_kind == dxStepperKind::Quick) return kLeastTeamJoints;
    return dxSettings::instance().algorithm() == dxAlgorithm::Auto ? kLeastExactTeamJoints
                                                                   : kLeastExactTeamJointsByName;
}

void dxStep::estimateCosts() {
    dxIslandCursor cursor(m_info);
    for (unsigned i = 0; i < m_count; ++i) {
        const dxIsland island = cursor.next();
        if (island.bodies[0]->moved_callback != nullptr) break;  // it and what follows goes in order
        const double cost =
            dxCostModel::islandCost(m_kind, m_world->qs.num_iterations, island.bodyCount, island.jointCount);
        m_totalCost += cost;
        m_largestCost = std::max(m_largestCost, cost);
        m_largestJoints = std::max(m_largestJoints, island.jointCount);
        m_costsKnown = i + 1 == m_count;
    }
}

// For islands side by side. 1: the caller alone.
unsigned dxStep::chooseWorkers(unsigned limit) {
    const unsigned most = std::min(limit, m_count);
    if (most < 2) return 1;
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) return most;
    return costModel->chooseWorkers(m_kind, m_totalCost, m_largestCost, most);
}

unsigned dxStep::workerLimit() const {
    const dxAlgorithm algorithm = dxSettings::instance().algorithm();
    if (algorithm == dxAlgorithm::Serial) return 1;
    unsigned limit =
        dxWorldWorkers::given(m_world) ? dxWorldWorkers::count(m_world) : dxSettings::instance().threads();
    const unsigned asked = m_world->islands_max_threads;
    if (asked != dWORLDSTEP_THREADCOUNT_UNLIMITED) limit = std::min(limit, asked);
    if (algorithm == dxAlgorithm::Auto) limit = std::min(limit, dxSettings::instance().cores());
    return limit >= 2 && dxTrapsFloatingPoint() ? 1 : limit;
}
