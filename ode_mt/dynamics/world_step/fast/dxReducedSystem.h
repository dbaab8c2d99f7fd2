// Solves (J inv(M) J' + D) dx = q, for a diagonal matrix D > 0, in the space of bodies: H du = J' inv(D) q with H = M + J' inv(D) J, then
// dx = inv(D) (q - J du). Rows whose D is infinite get dx = 0.
//
// All vectors over rows have dxProblemChunks::padded elements. Loops over them are given as work on chunks, so that what belongs
// together is done while it is in the cache.
//
// Threading: everything is parallel, by the phases of dxPhaseRunner.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxBlockFactor.h"
#include "dynamics/world_step/fast/dxDirectProblem.h"
#include "dynamics/world_step/fast/dxProblemChunks.h"
#include "threading/pool/dxPhaseRunner.h"

class dxReducedSystem {
public:
    using Rows = dxProblemChunks::Rows;

    // The problem, the order and the phases outlive what follows. At most so many threads share the phases. Throws std::bad_alloc.
    void begin(const dxDirectProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads);

    unsigned rowChunks() const { return static_cast<unsigned>(m_chunks.rows().size()); }
    unsigned paddedRows() const { return dxProblemChunks::padded(m_problem->rowCount); }

    // Calls work(chunk, its number) for all chunks of rows.
    template <class Work>
    void forRows(const Work &work) {
        m_phases->forChunks(rowChunks(), [&](unsigned chunk, unsigned) { work(m_chunks.rows()[chunk], chunk); });
    }

    // The motion of the bodies, inv(M) J' x, and J times it, in the rows of a chunk.
    void findMotion(const std::vector<double> &x);
    const double *changeByMotion(const Rows &rows);

    // Factorises with weights 1/D. Returns false where H is not positive definite in this arithmetic.
    double *weight() { return m_weight.data(); }
    bool factorise();

    // du for what was written there, q/D, and J du in the rows of a chunk.
    double *scaled() { return m_scaled.data(); }
    void solveBodies();
    const double *changeBySolution(const Rows &rows);

    // All of it.
    bool factorise(const std::vector<double> &d);
    void solve(const std::vector<double> &q, std::vector<double> &dx);

    // s = b - (J inv(M) J' + c) x, which is -w.
    void findResidual(const std::vector<double> &x, std::vector<double> &s);

    unsigned factorisations() const { return m_factorisations; }

private:
    const dxDirectProblem *m_problem = nullptr;
    const dxEliminationOrder *m_order = nullptr;
    dxPhaseRunner *m_phases = nullptr;
    dxProblemChunks m_chunks;
    dxBlockFactor m_factor;
    std::vector<double> m_weight;  // 1 / D
    std::vector<double> m_scaled;  // q / D
    std::vector<double> m_change;  // J du
    dxBodyVectors m_force, m_motion;
    unsigned m_factorisations = 0;
};
