#include "dynamics/iterative/dxIterativeSolver.h"

#include <algorithm>
#include <cmath>

#include "dynamics/islands/dxForBodies.h"
#include "dynamics/iterative/dxFreeMotion.h"
#include "dynamics/iterative/dxIterativeWorld.h"

namespace {

// Of the iterations: so many are made in any case, and so many at the end are not over-relaxed, which leaves smaller residuals.
constexpr double kLeastPart = 0.4;
constexpr unsigned kSmoothing = 3;

// More contacts fit no cache, and a sweep takes as long as it takes to read them: a response is 72 bytes beside 248.
constexpr unsigned kMaxResponses = 4096;

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
    m_energies.resize(m_plan.chunks().size());
    m_others.reserve(m_plan);
    placeLanes();
    m_sweeps.begin(m_plan, iterationsOf(step) + 1);
}

void dxIterativeSolver::reserveAs(const dxIterativeSolver &other) {
    m_plan.reserveAs(other.m_plan);
    m_sweeps.reserveAs(other.m_sweeps);
    m_others.reserveAs(other.m_others);
    m_contacts.reserve(other.m_contacts.capacity());
    m_responses.reserve(other.m_responses.capacity());
    m_lanes.reserve(other.m_lanes.capacity());
    m_velocities.reserve(other.m_velocities.capacity());
    m_energies.reserve(other.m_energies.capacity());
}

void dxIterativeSolver::placeLanes() {
    m_lanes.assign(m_plan.packs().size() * dxLanes::kCount, nullptr);
    for (const dxConstraintPlan::Manifold &manifold : m_plan.manifolds())
        m_lanes[std::size_t(manifold.pack) * dxLanes::kCount + manifold.lane] = &manifold;
}

void dxIterativeSolver::solve(const dxIslandStep &step, dxIslandBody *bodies, const dxOtherJoints &joints, dxQuietMotion &motion) {
    // Joints other than contacts may have pushed their bodies when they were asked for their rows.
    if (step.islandWorkers == nullptr || !m_plan.otherJoints().empty())
        dxFindFreeMotion(step, bodies, m_velocities.data());  // parallel
    const double energy = prepare(step, bodies, joints);  // parallel
    sweep(step, energy);                                  // parallel
    writeVelocities(step, motion);                        // parallel
    const dxContactReader reader(step, bodies);
    reader.list(m_plan.manifolds());
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned) {
        reader.keep(packs(), m_lanes.data(), chunk.firstPack, chunk.endPack);
    });
    reader.giveFeedback(packs(), m_plan.manifolds());
    m_others.finish(joints, step.stepSize);
    joints.giveFeedback();
}

// Returns the energy of the residual without impulses.
double dxIterativeSolver::prepare(const dxIslandStep &step, const dxIslandBody *bodies, const dxOtherJoints &joints) {
    const dxContactReader reader(step, bodies);
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned i) {
        reader.read(packs(), m_lanes.data(), chunk.firstPack, chunk.endPack);
        m_energies[i] = dxPrepareContacts(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
    });
    double energy = m_others.prepare(joints, m_plan, bodies, m_velocities.data(), step.stepSize, step.world->qs.w,
                                     step.iterativeWorld->isWarm());
    for (const double part : m_energies) energy += part;
    return energy;
}

void dxIterativeSolver::sweep(const dxIslandStep &step, double energy) {
    const double tolerance = step.iterativeWorld->tolerance(), enough = energy * tolerance * tolerance;
    const unsigned most = iterationsOf(step), least = static_cast<unsigned>(std::ceil(kLeastPart * most));
    m_factor = step.world->qs.w;
    m_smoothFrom = most > kSmoothing ? most - kSmoothing : 0;
    m_sweeps.run(
        step.runner(), [this](unsigned chunk, unsigned sweep) { return solveChunk(chunk, sweep); },
        [=](unsigned sweep, double change) { return sweep >= least && change <= enough; });
}

// Sweep 0 applies the impulses that the last step has left.
double dxIterativeSolver::solveChunk(unsigned index, unsigned sweep) {
    const dxConstraintPlan::Chunk &chunk = m_plan.chunks()[index];
    double energy = 0;
    if (chunk.firstPack != chunk.endPack) {
        if (sweep == 0)
            dxApplyImpulses(packs(), chunk.firstPack, chunk.endPack, m_velocities.data());
        else
            energy += dxSweepContacts(packs(), chunk.firstPack, chunk.endPack, sweep > m_smoothFrom ? 1 : m_factor,
                                      m_velocities.data());
    }
    if (chunk.firstOther != chunk.endOther) {
        if (sweep == 0)
            m_others.apply(chunk.firstOther, chunk.endOther, m_velocities.data());
        else
            energy += m_others.sweep(chunk.firstOther, chunk.endOther, m_velocities.data());
    }
    return energy;
}

void dxIterativeSolver::writeVelocities(const dxIslandStep &step, dxQuietMotion &motion) {
    dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        std::copy_n(m_velocities[i].columns, 3, body.lvel);
        std::copy_n(m_velocities[i].columns + 3, 3, body.avel);
        motion.see(body);
    });
}
