#include "dynamics/quick_step/fast/dxIterativeSolver.h"

#include <algorithm>
#include <cmath>

#include "core/dxReserve.h"
#include "dynamics/quick_step/fast/dxFreeMotion.h"
#include "dynamics/quick_step/fast/dxIterativeWorld.h"
#include "dynamics/quick_step/fast/dxRowContacts.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

// Of the iterations: so many are made in any case, and so many at the end are not over-relaxed, which leaves smaller residuals.
constexpr double kLeastPart = 0.4;
constexpr unsigned kSmoothing = 3;

// So many of the iterations take pressures and friction together, which heaps in motion need; the others pressures first, which what stands
// needs (docs/iterative-solver.md, "Pressures first").
constexpr double kWholePart = 0.4;
constexpr unsigned kParts = 3;

// By how much friction changes in these others, of what its own row asks for: with all of it bricks in a row push one another apart.
constexpr dReal kFrictionInParts = dReal(0.7);

// Kept forces may be so much worse than none: what they have wrong nearby, where bodies have hit one another, sweeps mend at once, and the
// rest of them is worth more than that (docs/iterative-solver.md).
constexpr double kMostHarm = 100;

// Energies of other joints' rows are found in every so many sweeps, but not where no use is made of them, and not in the last ones, which they
// could hardly save.
constexpr unsigned kMeasured = 5;

// A sweep that changes so much more than another one before it does not lead to the solution.
constexpr double kGrowth = 3;

// More contacts fit no cache, and a sweep takes as long as it takes to read them: a response is 104 bytes beside 248.
constexpr unsigned kMaxResponses = 4096;

// So many take all rows of each contact at once. Those after them have three parts.
unsigned wholeSweepsOf(unsigned most, const std::vector<dxContactPack> &packs) {
    const auto hasSecond = [](const dxContactPack &pack) { return pack.contactCount > 1; };
    return std::any_of(packs.begin(), packs.end(), hasSecond) ? static_cast<unsigned>(std::ceil(kWholePart * most)) : most;
}

unsigned iterationsOf(const dxIslandStep &step) { return static_cast<unsigned>(std::max(step.world->qs.num_iterations, 0)); }

}  // namespace

void dxIterativeSolver::begin(const dxIslandStep &step, dxIslandBody *masses) {
    const std::size_t count = step.island.bodyCount;
    m_velocities.resize(count + 1);
    m_velocities[count] = dxVelocity();
    if (step.islandWorkers == nullptr) return makePlan(step);
    const auto jobs = static_cast<unsigned>((count + dxBodyLoops::kBodiesPerJob - 1) / dxBodyLoops::kBodiesPerJob);
    step.runner().forBlocks(dxParallelStage::Bodies, 1 + jobs, [&](unsigned block, unsigned) {
        if (block == 0) return makePlan(step);
        const std::size_t first = (block - 1) * dxBodyLoops::kBodiesPerJob;
        dxFindFreeMotion(step, first, std::min(first + dxBodyLoops::kBodiesPerJob, count), masses, m_velocities.data());
    });
}

void dxIterativeSolver::makePlan(const dxIslandStep &step) {
    m_plan.make(step.island);
    const unsigned contacts = m_plan.packedContacts();
    if (m_contacts.size() < contacts) m_contacts.resize(contacts);
    m_hasResponses = contacts <= kMaxResponses;
    if (m_hasResponses && m_responses.size() < contacts) m_responses.resize(contacts);
    m_packEnergies.resize(m_plan.packs().size());
    m_chunkEnergies.resize(m_plan.chunks().size());
    m_firstEnergies.resize(m_plan.islands().size());
    m_islandEnergies.resize(m_plan.islands().size());
    m_others.reserve(m_plan);
    placeLanes();
    const unsigned most = iterationsOf(step);
    m_wholeSweeps = wholeSweepsOf(most, m_plan.packs());
    m_sweeps.begin(m_plan, 1 + m_wholeSweeps + (most - m_wholeSweeps) * kParts);
}

void dxIterativeSolver::reserveAs(const dxIterativeSolver &other) {
    m_plan.reserveAs(other.m_plan);
    m_sweeps.reserveAs(other.m_sweeps);
    m_others.reserveAs(other.m_others);
    m_contacts.reserve(other.m_contacts.capacity());
    m_responses.reserve(other.m_responses.capacity());
    m_lanes.reserve(other.m_lanes.capacity());
    m_velocities.reserve(other.m_velocities.capacity());
    m_packEnergies.reserve(other.m_packEnergies.capacity());
    m_chunkEnergies.reserve(other.m_chunkEnergies.capacity());
    m_firstEnergies.reserve(other.m_firstEnergies.capacity());
    m_islandEnergies.reserve(other.m_islandEnergies.capacity());
}

void dxIterativeSolver::placeLanes() {
    dxFill(m_lanes, m_plan.packs().size() * dxLanes::kCount, nullptr);
    for (const dxConstraintPlan::Manifold &manifold : m_plan.manifolds())
        m_lanes[std::size_t(manifold.pack) * dxLanes::kCount + manifold.lane] = &manifold;
}

void dxIterativeSolver::solve(const dxIslandStep &step, dxIslandBody *bodies, const dxOtherJoints &joints, dxQuietMotion &motion) {
    // Joints other than contacts may have pushed their bodies when they were asked for their rows.
    if (step.islandWorkers == nullptr || !m_plan.otherJoints().empty())
        dxFindFreeMotion(step, bodies, m_velocities.data());  // parallel
    prepare(step, bodies, joints);  // parallel
    sweep(step, bodies);            // parallel
    writeVelocities(step, motion);  // parallel
    const dxContactReader reader(step, bodies);
    reader.list(m_plan.manifolds());
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned) {
        reader.keep(packs(), m_lanes.data(), chunk.firstPack, chunk.endPack);
    });
    if (m_hasFeedback.load(std::memory_order_relaxed)) reader.giveFeedback(packs(), m_plan.manifolds());
    dxRowContacts(step, m_plan).keep(m_others);
    m_others.finish(step.stepSize);
    joints.giveFeedback();
}

void dxIterativeSolver::prepare(const dxIslandStep &step, const dxIslandBody *bodies, const dxOtherJoints &joints) {
    const dxContactReader reader(step, bodies);
    m_hasFeedback.store(false, std::memory_order_relaxed);
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned i) {
        if (reader.read(packs(), m_lanes.data(), chunk.firstPack, chunk.endPack)) m_hasFeedback.store(true, std::memory_order_relaxed);
        m_chunkEnergies[i] = dxPrepareContacts(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
    });
    const bool isWarm = step.iterativeWorld->isWarm();
    m_others.begin(joints, m_plan);
    if (isWarm) dxRowContacts(step, m_plan).start(m_others);
    m_firstEnergy = m_others.prepare(joints, bodies, step.island.bodyCount, m_velocities.data(), step.stepSize, step.world->qs.w);
    for (const double part : m_chunkEnergies) m_firstEnergy += part;
    m_firstEnergies[0] = m_firstEnergy;  // if there is one island
    sumByIsland(m_firstEnergies);
}

void dxIterativeSolver::sweep(const dxIslandStep &step, dxIslandBody *bodies) {
    const double tolerance = step.iterativeWorld->tolerance();
    const unsigned most = iterationsOf(step);
    m_leastSweeps = static_cast<unsigned>(std::ceil(kLeastPart * most));
    const bool hasFriction = !m_plan.manifolds().empty() || m_others.hasFriction();
    m_factor = {step.world->qs.w, hasFriction ? step.world->qs.w : std::min(step.world->qs.w, dReal(1))};
    m_smoothFrom = most > kSmoothing ? most - kSmoothing : 0;
    m_leastEnergy = HUGE_VAL;
    double energy = 0;
    m_sweeps.run(
        step.runner(), [this](unsigned chunk, unsigned round) { return solveChunk(chunk, round); },
        [&](unsigned round, double part) {
            if (round == 0) {
                if (step.iterativeWorld->isWarm()) startColdWhereWorse(step, bodies, part);
                return false;
            }
            const auto [sweep, sweepPart] = sweepOf(round);
            energy = dxIsFirst(sweepPart) ? part : energy + part;
            if (!dxIsLast(sweepPart) || !isMeasured(sweep)) return false;
            watchGrowth(energy, sweep >= m_smoothFrom);
            return sweep >= m_leastSweeps && energy <= m_firstEnergy * tolerance * tolerance && isSmallEverywhere(tolerance);
        });
}

bool dxIterativeSolver::isMeasured(unsigned sweep) const {
    if (m_plan.otherJoints().empty()) return true;
    return sweep % kMeasured == 0 && sweep <= m_smoothFrom && (sweep >= m_leastSweeps || m_factor.friction > 1);
}

// Round 0 applies the impulses that the last step has left, as if that were a sweep. Joints other than contacts have all their rows in the
// first part.
double dxIterativeSolver::solveChunk(unsigned index, unsigned round) {
    const dxConstraintPlan::Chunk &chunk = m_plan.chunks()[index];
    const auto [sweep, part] = sweepOf(round);
    double energy = 0;
    if (chunk.firstPack != chunk.endPack) {
        if (sweep == 0)
            energy += dxApplyImpulses(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
        else
            energy += dxSweepContacts(packs(), chunk.firstPack, chunk.endPack, part, factorOf({sweep, part}), m_velocities.data());
    }
    if (chunk.firstOther != chunk.endOther && dxIsFirst(part)) {
        if (sweep == m_smoothFrom + 1) m_others.relax(chunk.firstOther, chunk.endOther);
        if (sweep == 0)
            energy += m_others.apply(chunk.firstOther, chunk.endOther, m_velocities.data());
        else
            energy += m_others.sweep(chunk.firstOther, chunk.endOther, m_velocities.data(), sweep, isMeasured(sweep));
    }
    return energy;
}

dxIterativeSolver::Round dxIterativeSolver::sweepOf(unsigned round) const {
    if (round <= m_wholeSweeps) return {round, dxSweepPart::Contacts};
    constexpr dxSweepPart parts[kParts] = {dxSweepPart::Pressures, dxSweepPart::EvenFriction, dxSweepPart::OddFriction};
    const unsigned beyond = round - m_wholeSweeps - 1;
    return {m_wholeSweeps + 1 + beyond / kParts, parts[beyond % kParts]};
}

dxOverRelaxation dxIterativeSolver::factorOf(const Round &round) const {
    const dReal most = round.sweep > m_smoothFrom ? 1 : dInfinity;
    return {std::min(m_factor.pressure, most), std::min(m_factor.friction, round.part == dxSweepPart::Contacts ? most : kFrictionInParts)};
}

// Of a single island the sum is known anyway.
void dxIterativeSolver::sumByIsland(std::vector<double> &energies) const {
    if (energies.size() == 1) return;
    std::fill(energies.begin(), energies.end(), 0.0);
    for (const dxConstraintPlan::Manifold &manifold : m_plan.manifolds())
        energies[m_plan.islandOf(manifold)] += static_cast<double>(m_packEnergies[manifold.pack].lane[manifold.lane]);
    for (std::size_t i = 0; i < m_plan.otherJoints().size(); ++i)
        energies[m_plan.islandOf(m_plan.otherJoints()[i])] += m_others.energies()[i];
}

// The last step's forces may be those of another scene: a program has set bodies back, or changed their masses. Such an island begins
// without any. `energy`: what kept forces add to the energy that the solution makes least.
void dxIterativeSolver::startColdWhereWorse(const dxIslandStep &step, dxIslandBody *bodies, double energy) {
    const std::vector<dxConstraintPlan::Island> &islands = m_plan.islands();
    m_islandEnergies[0] = energy;  // if there is one island
    sumByIsland(m_islandEnergies);
    const auto isWorse = [this](unsigned island) {
        return !(m_islandEnergies[island] <= kMostHarm * m_firstEnergies[island]);  // NaN is
    };
    bool isAny = false;
    for (unsigned i = 0; i < islands.size(); ++i) {
        if (!isWorse(i)) continue;
        isAny = true;
        dxFindFreeMotion(step, islands[i].firstBody, islands[i].endBody, bodies, m_velocities.data());
    }
    if (!isAny) return;
    for (const dxConstraintPlan::Manifold &manifold : m_plan.manifolds()) {
        if (!isWorse(m_plan.islandOf(manifold))) continue;
        dxContactLanes *const contacts = m_contacts.data() + m_plan.packs()[manifold.pack].firstContact;
        for (unsigned k = 0; k < manifold.contactCount; ++k)
            for (dxLaneNumbers &impulse : contacts[k].impulse) impulse.lane[manifold.lane] = 0;
    }
    for (unsigned i = 0; i < m_plan.otherJoints().size(); ++i)
        if (isWorse(m_plan.islandOf(m_plan.otherJoints()[i]))) m_others.startCold(i);
}

// With friction that follows the normal's force, over-relaxation need not converge.
void dxIterativeSolver::watchGrowth(double energy, bool isSmoothing) {
    if (!isSmoothing && m_factor.friction > 1 && energy > kGrowth * m_leastEnergy) {
        m_factor.friction = 1;
        m_others.relaxFriction();
    }
    m_leastEnergy = std::min(m_leastEnergy, energy);
}

bool dxIterativeSolver::isSmallEverywhere(double tolerance) {
    if (m_islandEnergies.size() == 1) return true;
    sumByIsland(m_islandEnergies);
    for (std::size_t i = 0; i < m_islandEnergies.size(); ++i)
        if (m_islandEnergies[i] > m_firstEnergies[i] * tolerance * tolerance) return false;
    return true;
}

void dxIterativeSolver::writeVelocities(const dxIslandStep &step, dxQuietMotion &motion) {
    dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        std::copy_n(m_velocities[i].columns, 3, body.lvel);
        std::copy_n(m_velocities[i].columns + 3, 3, body.avel);
        motion.see(body);
    });
}
