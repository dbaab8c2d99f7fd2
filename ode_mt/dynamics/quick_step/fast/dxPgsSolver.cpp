#include "dynamics/quick_step/fast/dxPgsSolver.h"

#include <algorithm>
#include <cmath>

#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/quick_step/fast/dxFreeMotion.h"
#include "dynamics/quick_step/fast/dxJointReader.h"
#include "dynamics/quick_step/fast/dxJointSweep.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

// Part of the iterations that is made in any case, and number of the last ones that are not over-relaxed.
constexpr double kMinPart = 0.4;
constexpr unsigned kSmoothSweeps = 3;

// Part of the iterations that relax normals and friction together, which heaps in motion need. The others relax normals first, which standing
// structures need (docs/fast.md, "The sweeps").
constexpr double kAllRowsPart = 0.4;

// Part of its residual by which friction changes in sweeps of three parts: with all of it bricks in a row push one another apart.
constexpr dReal kFrictionInParts = dReal(0.7);

// Kept forces are used although their residual is larger than that of none, up to this factor: nearby errors, where bodies have hit one another, are
// corrected by a few sweeps, and the other forces are worth more than that (docs/fast.md).
constexpr double kMaxHarm = 100;

// Number of sweeps from one in which energies of rows are found to the next. They are not found where nothing depends on them, nor in the last
// sweeps, of which they could save hardly any.
constexpr unsigned kSweepsPerMeasurement = 5;

// A sweep whose change is larger than that of an earlier one by this factor does not lead to the solution.
constexpr double kGrowth = 3;

// More contacts fit no cache, and a sweep takes as long as reading them: a response is 104 bytes beside 124.
constexpr unsigned kMaxResponses = 8192;

// Number of chunks beside the first one of each phase, below which a sweep is done before another worker could begin.
constexpr std::size_t kMinBeside = 4;

// Returns the number of sweeps that relax all rows of each contact at once. The sweeps after them have three parts.
unsigned allRowsSweepsOf(unsigned iterations, dxArenaArray<const dxContactPack> packs) {
    const auto hasSecond = [](const dxContactPack &pack) { return pack.contactCount > 1; };
    return std::any_of(packs.begin(), packs.end(), hasSecond) ? static_cast<unsigned>(std::ceil(kAllRowsPart * iterations)) : iterations;
}

}  // namespace

// Before the stages: the bodies' free velocities, and the plan, which is one worker's.
void dxPgsSolver::begin(const dxIslandStep &step, dxIslandBody *masses) {
    const std::size_t count = step.island.bodyCount;
    reserve(0, step.runner().workers());
    m_arena.reset();
    m_masses = masses;
    m_velocities = m_arena.take<dxSpatialMotion>(count + 1);
    m_velocities[count] = dxSpatialMotion();
    if (step.islandWorkers == nullptr) return makePlan(step);
    const auto jobs = static_cast<unsigned>((count + dxBodyLoops::kBodiesPerJob - 1) / dxBodyLoops::kBodiesPerJob);
    step.runner().forBlocks(dxParallelStage::Bodies, 1 + jobs, [&](unsigned block, unsigned) {
        if (block == 0) return makePlan(step);
        const std::size_t first = (block - 1) * dxBodyLoops::kBodiesPerJob;
        dxFindFreeMotion(step, first, std::min(first + dxBodyLoops::kBodiesPerJob, count), masses, m_velocities.data());
    });
}

unsigned dxPgsSolver::readJoints(const dxIslandStep &step) { return dxJointReader(step, m_plan).read(m_jointLanes.data()); }

void dxPgsSolver::solve(const dxIslandStep &step, const dxRowJoints &joints, dxNotificationPolicy &notifications) {
    const Call call{step, joints, notifications};
    const auto iterate = [&] {
        for (const Stage stage : {Stage::WarmStart, Stage::Sweep, Stage::Smooth, Stage::Sum}) run(stage, call);
    };
    run(Stage::Prepare, call);
    if (m_plan.chunks().size() >= m_plan.phases().size() + kMinBeside)
        m_phases.run(dxParallelStage::PgsSweep, step.runner(), iterate);
    else
        iterate();
    run(Stage::Store, call);
}

// The stages on one page. u: velocities; p: impulses of contacts and rows; E: energies of packs, row joints and chunks.
void dxPgsSolver::run(Stage stage, const Call &call) {
    switch (stage) {
        case Stage::Prepare:  // packs parallel, rows serial. Reads joints, masses, the warm-start cache. Writes u, packs, rows, p, E
            return prepare(call.step, call.joints);
        case Stage::WarmStart:  // parallel by phases. Reads p. Writes u, E. Serial: islands that p would harm lose it
            return startWarm(call.step);
        case Stage::Sweep:  // parallel by phases. Reads packs, rows. Writes u, p, E. After each sweep, serial: reads E, writes the factors
            return iterate(stage, 1, m_firstSmoothSweep, call.step.fastQuickStep->tolerance());
        case Stage::Smooth:  // the same. Before the first one, parallel: writes rows
            endOverRelaxation();
            return iterate(stage, m_firstSmoothSweep, m_iterations + 1, call.step.fastQuickStep->tolerance());
        case Stage::Sum:  // parallel by phases. Reads p. Writes u
            return sumImpulses();
        case Stage::Store:  // bodies and packs parallel, rows and feedback serial. Reads u, p. Writes bodies, feedback, the warm-start cache
            return store(call.step, call.joints, call.notifications);
    }
}

void dxPgsSolver::makePlan(const dxIslandStep &step) {
    m_plan.make(step.island, m_arena);
    const unsigned contacts = m_plan.packedContacts();
    const std::size_t packs = m_plan.packs().size(), islands = m_plan.islands().size();
    m_contacts = m_arena.take<dxContactLanes>(contacts);
    m_responses = {};
    if (contacts <= kMaxResponses) m_responses = m_arena.take<dxContactResponse>(contacts);
    m_packEnergies = m_arena.take<dxLaneNumbers>(packs);
    m_chunkEnergies = m_arena.take<double>(m_plan.chunks().size());
    m_firstEnergies = m_arena.take<double>(islands);
    m_islandEnergies = m_arena.take<double>(islands);
    m_jointLanes = m_arena.take<dxJointLanes>(m_plan.packedRows());
    m_jointPackEnergies = m_arena.take<dxLaneNumbers>(m_plan.jointPacks().size());
    m_results = m_plan.hasLanes() ? m_arena.take<dxSpatialMotion>(m_velocities.size()) : m_velocities;
    m_lanes = m_arena.takeFilled<const dxConstraintPlan::Manifold *>(packs * dxLanes::kCount, nullptr);
    m_plan.forLaneManifolds([this](const dxConstraintPlan::Manifold &manifold) {
        m_lanes[std::size_t(manifold.pack) * dxLanes::kCount + manifold.lane] = &manifold;
    });
    m_rows.reserve(m_plan, m_arena);
    m_iterations = static_cast<unsigned>(std::max(step.world->qs.num_iterations, 0));
    m_minSweeps = static_cast<unsigned>(std::ceil(kMinPart * m_iterations));
    m_allRowsSweeps = allRowsSweepsOf(m_iterations, m_plan.packs());
    m_firstSmoothSweep = 1 + (m_iterations > kSmoothSweeps ? m_iterations - kSmoothSweeps : 0);
}

void dxPgsSolver::reserve(std::size_t memory, unsigned threads) {
    m_phases.reserve(threads);
    if (memory != 0) m_arena.reserve(memory);
}

void dxPgsSolver::prepare(const dxIslandStep &step, const dxRowJoints &joints) {
    // Joints other than contacts may have pushed their bodies when they were asked for their rows.
    if (step.islandWorkers == nullptr || !m_plan.hasContactsOnly()) dxFindFreeMotion(step, m_masses, m_velocities.data());
    if (m_plan.hasLanes()) std::copy(m_velocities.begin(), m_velocities.end(), m_results.begin());
    const dxContactReader reader(step, m_masses);
    const dxJointReader jointReader(step, m_plan);
    m_hasFeedback.store(false, std::memory_order_relaxed);
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned i) {
        m_chunkEnergies[i] = 0;
        if (chunk.firstJointPack != chunk.endJointPack) {
            jointReader.readBodies(chunk.firstJointPack, chunk.endJointPack, m_masses);
            m_chunkEnergies[i] = dxPrepareJoints(jointPacks(), chunk.firstJointPack, chunk.endJointPack, m_velocities.data());
        }
        if (chunk.firstPack == chunk.endPack) return;
        if (reader.read(packs(), m_lanes, chunk.firstPack, chunk.endPack)) m_hasFeedback.store(true, std::memory_order_relaxed);
        m_chunkEnergies[i] = dxPrepareContacts(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
    });
    m_rows.begin(joints, m_plan);
    if (step.fastQuickStep->isWarm()) m_rows.startWarm(step);
    const dReal factor = step.world->qs.w;
    m_firstEnergy = m_rows.prepare(joints, m_masses, step.island.bodyCount, m_velocities.data(), step.stepSize, factor);
    for (const double energy : m_chunkEnergies) m_firstEnergy += energy;
    m_firstEnergies[0] = m_firstEnergy;  // if there is one island
    sumByIsland(m_firstEnergies);
    const bool hasFriction = m_plan.hasContactLanes() || m_rows.hasFriction();
    m_factor = {factor, hasFriction ? factor : std::min(factor, dReal(1))};
    m_leastEnergy = HUGE_VAL;
    m_isConverged = m_plan.phases().empty();
}

// The impulses of the last step act as if they were a sweep's.
void dxPgsSolver::startWarm(const dxIslandStep &step) {
    if (m_isConverged) return;
    const double energy = solvePhases([this](const dxConstraintPlan::Chunk &chunk) {
        double found = 0;
        if (chunk.firstPack != chunk.endPack) found += dxApplyImpulses(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
        if (chunk.firstRowJoint != chunk.endRowJoint)
            found += m_rows.apply(chunk.firstRowJoint, chunk.endRowJoint, m_velocities.data());
        if (chunk.firstJointPack != chunk.endJointPack)
            found += dxApplyJointImpulses(jointPacks(), chunk.firstJointPack, chunk.endJointPack, m_velocities.data());
        return found;
    });
    if (step.fastQuickStep->isWarm()) startColdWhereWorse(step, energy);
}

// Sweeps [begin, end), or fewer.
void dxPgsSolver::iterate(Stage stage, unsigned begin, unsigned end, double tolerance) {
    for (unsigned number = begin; number < end && !m_isConverged; ++number) {
        const double energy = sweep(stage, number);
        if (!isMeasured(number)) continue;
        watchGrowth(stage, energy);
        m_isConverged = number >= m_minSweeps && energy <= m_firstEnergy * tolerance * tolerance && isSmallEverywhere(tolerance);
    }
}

// Rows are scaled by their over-relaxation.
void dxPgsSolver::endOverRelaxation() {
    if (m_isConverged || m_plan.rowJoints().empty()) return;
    const dxArenaArray<const dxConstraintPlan::Chunk> chunks = m_plan.chunks();
    m_phases.forChunks(static_cast<unsigned>(chunks.size()), [&](unsigned i, unsigned) {
        m_rows.endOverRelaxation(chunks[i].firstRowJoint, chunks[i].endRowJoint);
    });
}

// Returns the energy of the change.
double dxPgsSolver::sweep(Stage stage, unsigned number) {
    if (number <= m_allRowsSweeps) return sweepPart(dxSweepPart::AllRows, factorOf(stage, dxSweepPart::AllRows), number);
    double energy = 0;
    for (const dxSweepPart part : {dxSweepPart::Normals, dxSweepPart::EvenFriction, dxSweepPart::OddFriction})
        energy += sweepPart(part, factorOf(stage, part), number);
    return energy;
}

// Joints other than contacts, and contacts in rows, have all their rows in the first part of a sweep.
double dxPgsSolver::sweepPart(dxSweepPart part, const dxOverRelaxation &factor, unsigned number) {
    return solvePhases([&](const dxConstraintPlan::Chunk &chunk) {
        double found = 0;
        if (chunk.firstPack != chunk.endPack)
            found += dxSweepContacts(packs(), chunk.firstPack, chunk.endPack, part, factor, m_velocities.data());
        if (chunk.firstJointPack != chunk.endJointPack && dxIsFirst(part))
            found += dxSweepJoints(jointPacks(), chunk.firstJointPack, chunk.endJointPack, factor.normal, m_velocities.data());
        if (chunk.firstRowJoint != chunk.endRowJoint && dxIsFirst(part))
            found += m_rows.sweep(chunk.firstRowJoint, chunk.endRowJoint, m_velocities.data(), number, isMeasured(number));
        return found;
    });
}

void dxPgsSolver::sumImpulses() {
    if (!m_plan.hasLanes()) return;
    solvePhases([this](const dxConstraintPlan::Chunk &chunk) {
        if (chunk.firstPack != chunk.endPack) dxAddImpulses(packs(), chunk.firstPack, chunk.endPack, m_masses, m_results.data());
        if (chunk.firstJointPack != chunk.endJointPack)
            dxAddJointImpulses(jointPacks(), chunk.firstJointPack, chunk.endJointPack, m_masses, m_results.data());
        return chunk.firstRowJoint != chunk.endRowJoint ? m_rows.apply(chunk.firstRowJoint, chunk.endRowJoint, m_results.data()) : 0;
    });
}

void dxPgsSolver::store(const dxIslandStep &step, const dxRowJoints &joints, dxNotificationPolicy &notifications) {
    dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        std::copy_n(m_results[i].columns, 3, body.lvel);
        std::copy_n(m_results[i].columns + 3, 3, body.avel);
        notifications.add(body);
    });
    const dxContactReader reader(step, m_masses);
    reader.list(m_plan);
    const dxJointReader jointReader(step, m_plan);
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned) {
        reader.keep(packs(), m_lanes, chunk.firstPack, chunk.endPack);
        jointReader.keep(m_jointLanes.data(), chunk.firstJointPack, chunk.endJointPack);
    });
    if (m_hasFeedback.load(std::memory_order_relaxed)) reader.giveFeedback(packs(), m_plan);
    jointReader.giveFeedback(m_jointLanes.data());
    m_rows.keep(step);
    m_rows.finish(step.stepSize);
    joints.giveFeedback();
}

// Calls work(chunk, its number) for all chunks of the plan, in any order. Parallel, in Prepare and Store.
template <class Work>
void dxPgsSolver::forChunks(const dxIslandStep &step, const Work &work) {
    const dxArenaArray<const dxConstraintPlan::Chunk> chunks = m_plan.chunks();
    step.runner().forBlocks(dxParallelStage::Rows, static_cast<unsigned>(chunks.size()), [&](unsigned i, unsigned) { work(chunks[i], i); });
}

// Calls solve(chunk), which returns an energy, for the chunks of one phase after the other. Returns the sum of the energies.
template <class Solve>
double dxPgsSolver::solvePhases(const Solve &solve) {
    const dxArenaArray<const dxConstraintPlan::Chunk> chunks = m_plan.chunks();
    for (const dxConstraintPlan::Phase &phase : m_plan.phases())
        m_phases.forChunks(phase.endChunk - phase.firstChunk, [&](unsigned i, unsigned) {
            m_chunkEnergies[phase.firstChunk + i] = solve(chunks[phase.firstChunk + i]);
        });
    double sum = 0;  // in the order of the chunks, whoever solved them
    for (const double energy : m_chunkEnergies) sum += energy;
    return sum;
}

dxOverRelaxation dxPgsSolver::factorOf(Stage stage, dxSweepPart part) const {
    const dReal most = stage == Stage::Smooth ? 1 : dInfinity;
    return {std::min(m_factor.normal, most), std::min(m_factor.friction, part == dxSweepPart::AllRows ? most : kFrictionInParts)};
}

bool dxPgsSolver::isMeasured(unsigned sweep) const {
    if (m_plan.rowJoints().empty()) return true;
    return sweep % kSweepsPerMeasurement == 0 && sweep < m_firstSmoothSweep && (sweep >= m_minSweeps || m_factor.friction > 1);
}

// The sum of a single island is known anyway.
void dxPgsSolver::sumByIsland(dxArenaArray<double> energies) const {
    if (energies.size() == 1) return;
    std::fill(energies.begin(), energies.end(), 0.0);
    m_plan.forLaneManifolds([&](const dxConstraintPlan::Manifold &manifold) {
        energies[m_plan.islandOf(manifold)] += static_cast<double>(m_packEnergies[manifold.pack].lane[manifold.lane]);
    });
    m_plan.forLaneJoints([&](const dxConstraintPlan::LaneJoint &joint, unsigned pack, unsigned lane) {
        energies[m_plan.islandOf(joint)] += static_cast<double>(m_jointPackEnergies[pack].lane[lane]);
    });
    for (std::size_t i = 0; i < m_plan.rowJoints().size(); ++i)
        energies[m_plan.islandOf(m_plan.rowJoints()[i])] += m_rows.energies()[i];
}

// The last step's forces may be those of another scene: a program has set bodies back, or changed their masses. Such an island begins without
// forces. `energy`: by how much kept forces raise the energy that is smallest for the solution.
void dxPgsSolver::startColdWhereWorse(const dxIslandStep &step, double energy) {
    m_islandEnergies[0] = energy;  // if there is one island
    sumByIsland(m_islandEnergies);
    const auto isWorse = [this](unsigned island) {
        return !(m_islandEnergies[island] <= kMaxHarm * m_firstEnergies[island]);  // NaN is
    };
    const dxArenaArray<const dxConstraintPlan::Island> islands = m_plan.islands();
    bool isAny = false;
    for (unsigned i = 0; i < islands.size(); ++i) {
        if (!isWorse(i)) continue;
        isAny = true;
        dxFindFreeMotion(step, islands[i].firstBody, islands[i].endBody, m_masses, m_velocities.data());
    }
    if (!isAny) return;
    m_plan.forLaneManifolds([&](const dxConstraintPlan::Manifold &manifold) {
        if (!isWorse(m_plan.islandOf(manifold))) return;
        dxContactLanes *const contacts = m_contacts.data() + m_plan.packs()[manifold.pack].firstContact;
        for (unsigned k = 0; k < manifold.contactCount; ++k)
            for (dxLaneNumbers &impulse : contacts[k].impulse) impulse.lane[manifold.lane] = 0;
    });
    m_plan.forLaneJoints([&](const dxConstraintPlan::LaneJoint &joint, unsigned number, unsigned lane) {
        if (!isWorse(m_plan.islandOf(joint))) return;
        const dxJointPack &pack = m_plan.jointPacks()[number];
        for (unsigned k = 0; k < pack.rowCount; ++k) m_jointLanes[pack.firstRow + k].impulse.lane[lane] = 0;
    });
    for (unsigned i = 0; i < m_plan.rowJoints().size(); ++i)
        if (isWorse(m_plan.islandOf(m_plan.rowJoints()[i]))) m_rows.startCold(i);
}

// With friction that follows the normal's force, over-relaxation need not converge.
void dxPgsSolver::watchGrowth(Stage stage, double energy) {
    if (stage == Stage::Sweep && m_factor.friction > 1 && energy > kGrowth * m_leastEnergy) {
        m_factor.friction = 1;
        m_rows.endOverRelaxationOfFriction();
    }
    m_leastEnergy = std::min(m_leastEnergy, energy);
}

bool dxPgsSolver::isSmallEverywhere(double tolerance) const {
    if (m_islandEnergies.size() == 1) return true;
    sumByIsland(m_islandEnergies);
    for (std::size_t i = 0; i < m_islandEnergies.size(); ++i)
        if (m_islandEnergies[i] > m_firstEnergies[i] * tolerance * tolerance) return false;
    return true;
}
