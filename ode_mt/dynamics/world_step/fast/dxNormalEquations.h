// Solves (J inv(M) J' + D) dx = q, for a diagonal matrix D > 0, in the space of bodies: H du = J' inv(D) q with H = M + J' inv(D) J, then
// dx = inv(D) (q - J du). Rows whose D is infinite get dx = 0.
//
// All vectors over rows have dxProblemChunks::padded elements. Loops over them are given as work on chunks, so that what belongs
// together is done while it is in the cache.
//
// Bits do not depend on the instruction set: lanes are directions of a body, and sums over lanes have one order (dxBodyLanes-inl.h). A
// body's sums are over its manifolds, in their order.
//
// Threading: everything is parallel, by the phases of dxPhaseRunner.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxBlockFactor.h"
#include "dynamics/world_step/fast/dxBodySpaceProblem.h"
#include "threading/pool/dxPhaseRunner.h"

// How the loops over an island's rows and bodies are shared: chunks of both, with what a chunk of bodies reads of rows. They depend on
// the problem alone.
class dxProblemChunks {
public:
    // One side of a manifold.
    struct Side {
        unsigned manifold, side;
    };

    struct Rows {
        unsigned begin, end;    // multiples of kBodyLanes, the last end too
        unsigned firstManifold;  // that has a row here
    };

    struct Bodies {
        unsigned begin, end;
    };

    void make(const dxBodySpaceProblem &problem);

    const std::vector<Rows> &rows() const { return m_rows; }
    const std::vector<Bodies> &bodies() const { return m_bodies; }

    // Of a body: firstSide(body) to firstSide(body + 1), manifolds ascending.
    unsigned firstSide(unsigned body) const { return m_firstSide[body]; }
    const Side &side(unsigned index) const { return m_sides[index]; }

    // With as many rows as vectors of any length read: those beyond the problem's are fixed at 0.
    static unsigned padded(unsigned rows) { return (rows + kBodyLanes - 1) / kBodyLanes * kBodyLanes; }

private:
    void listSides(const dxBodySpaceProblem &problem);
    void cutRows(const dxBodySpaceProblem &problem);
    void cutBodies(const dxBodySpaceProblem &problem);

    std::vector<unsigned> m_firstSide, m_next;
    std::vector<Side> m_sides;
    std::vector<Rows> m_rows;
    std::vector<Bodies> m_bodies;
};

// Products of the Jacobian, row by row, and the matrix in body space, in chunks.
namespace dxRowProducts {

// result = J u
void multiply(const dxBodySpaceProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result);

// result = J' x
void multiplyTransposed(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
                        const double *x, dxBodyVectors &result);

// result = M u or inv(M) u, for the blocks of one of the two
void multiplyBodies(const dxBodyBlocks &blocks, const dxProblemChunks::Bodies &chunk, const dxBodyVectors &u, dxBodyVectors &result);

// Columns of H = M + J' W J for the diagonal matrix W; rows with weight 0 are skipped.
void makeColumns(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, const dxEliminationOrder &order, unsigned begin,
                 unsigned end, const double *weight, dxBlockFactor &factor);

}  // namespace dxRowProducts

class dxNormalEquations {
public:
    using Rows = dxProblemChunks::Rows;

    // The problem, the order and the phases outlive what follows. At most `threads` threads share the phases. Throws std::bad_alloc.
    void begin(const dxBodySpaceProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads);

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
    const dxBodySpaceProblem *m_problem = nullptr;
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
