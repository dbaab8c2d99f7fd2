#include "dynamics/iterative/dxIterativeSolver.h"

#include <algorithm>
#include <cmath>

#include "dynamics/iterative/dxIterativeWorld.h"

namespace {

constexpr std::size_t kBodiesPerJob = 64;

// Of the iterations: so many are made in any case, and so many at the end are not over-relaxed, which leaves smaller residuals.
constexpr double kLeastPart = 0.4;
constexpr unsigned kSmoothing = 3;

unsigned iterationsOf(const dxIslandStep &step) { return static_cast<unsigned>(std::max(step.world->qs.num_iterations, 0)); }

}  // namespace

void dxIterativeSolver::begin(const dxIslandStep &step) {
    m_plan.make(step.island);
    m_velocities.resize(step.island.bodyCount + std::size_t{1});
    if (m_contacts.size() < m_plan.packedContacts()) m_contacts.resize(m_plan.packedContacts());
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
    m_lanes.reserve(other.m_lanes.capacity());
    m_velocities.reserve(other.m_velocities.capacity());
    m_energies.reserve(other.m_energies.capacity());
}

void dxIterativeSolver::placeLanes() {
    m_lanes.assign(m_plan.packs().size() * dxLanes::kCount, nullptr);
    for (const dxConstraintPlan::Manifold &manifold : m_plan.manifolds())
        m_lanes[std::size_t(manifold.pack) * dxLanes::kCount + manifold.lane] = &manifold;
}

void dxIterativeSolver::solve(const dxIslandStep &step, const dxIslandBody *bodies, const dxOtherJoints &joints) {
    findFreeVelocities(step, bodies);                     // parallel
    const double energy = prepare(step, bodies, joints);  // parallel
    sweep(step, energy);                                  // parallel
    writeVelocities(step);                                // parallel
    const dxContactReader reader(step, bodies);
    reader.list(m_plan.manifolds());
    forChunks(step, [&](const dxConstraintPlan::Chunk &chunk, unsigned) {
        reader.keep(packs(), m_lanes.data(), chunk.firstPack, chunk.endPack);
    });
    reader.giveFeedback(packs(), m_plan.manifolds());
    m_others.finish(joints, step.stepSize);
    joints.giveFeedback();
}

// v + h inv(M) f
void dxIterativeSolver::findFreeVelocities(const dxIslandStep &step, const dxIslandBody *bodies) {
    const dReal h = step.stepSize;
    step.runner().forChunks(
        dxParallelStage::RightHandSides, step.island.bodyCount, kBodiesPerJob, [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t i = begin; i < end; ++i) {
                const dxBody &body = *step.island.bodies[i];
                dReal *const velocity = m_velocities[i].columns;
                const dReal perForce = h * bodies[i].invMass;
                for (int axis = 0; axis < 3; ++axis) {
                    const dReal *const inertia = bodies[i].invInertia + 3 * axis;
                    velocity[axis] = body.lvel[axis] + perForce * body.facc[axis];
                    velocity[3 + axis] =
                        body.avel[axis] + h * (inertia[0] * body.tacc[0] + inertia[1] * body.tacc[1] + inertia[2] * body.tacc[2]);
                }
            }
        });
    m_velocities[step.island.bodyCount] = dxVelocity();
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

void dxIterativeSolver::writeVelocities(const dxIslandStep &step) {
    step.runner().forChunks(dxParallelStage::RightHandSides, step.island.bodyCount, kBodiesPerJob,
                            [&](std::size_t begin, std::size_t end, unsigned) {
                                for (std::size_t i = begin; i < end; ++i) {
                                    dxBody &body = *step.island.bodies[i];
                                    std::copy_n(m_velocities[i].columns, 3, body.lvel);
                                    std::copy_n(m_velocities[i].columns + 3, 3, body.avel);
                                }
                            });
}
