#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxNormalEquations.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxNormalEquations.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

// What a manifold reads of a body that it does not have.
constexpr dxBodyVector kNoMotion = {};

void multiply(const dxBodySpaceProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result) {
    const BodyTag d;
    const dxBodyVector *const jacobian = problem.jacobian.data();
    for (std::size_t i = chunk.firstManifold; i < problem.manifolds.size() && problem.manifolds[i].firstRow < chunk.end; ++i) {
        const dxManifold &manifold = problem.manifolds[i];
        const bool hasFirst = manifold.body[0] != dxManifold::kNoBody, hasSecond = manifold.body[1] != dxManifold::kNoBody;
        const dxBodyVector &first = hasFirst ? u[manifold.body[0]] : kNoMotion;
        const dxBodyVector &second = hasSecond ? u[manifold.body[1]] : kNoMotion;
        const unsigned begin = std::max(manifold.firstRow, chunk.begin), end = std::min(manifold.endRow, chunk.end);
        for (unsigned row = begin; row < end; ++row) {
            const dxBodyVector *const sides = jacobian + 2 * std::size_t(row);
            dxBodyVector products;
            for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
                const auto a = hn::Mul(hn::Load(d, sides[0].lane + lane), hn::Load(d, first.lane + lane));
                const auto b = hn::Mul(hn::Load(d, sides[1].lane + lane), hn::Load(d, second.lane + lane));
                hn::Store(hn::Add(a, b), d, products.lane + lane);
            }
            result[row] = addUp(products.lane);
        }
    }
}

void multiplyTransposed(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
                        const double *x, dxBodyVectors &result) {
    const BodyTag d;
    for (unsigned body = chunk.begin; body < chunk.end; ++body)
        for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
            auto sum = hn::Zero(d);
            for (unsigned i = chunks.firstSide(body); i < chunks.firstSide(body + 1); ++i) {
                const dxManifold &manifold = problem.manifolds[chunks.side(i).manifold];
                const dxBodyVector *const jacobian = problem.jacobian.data() + chunks.side(i).side;
                for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row)
                    sum = hn::Add(sum, hn::Mul(hn::Load(d, jacobian[2 * std::size_t(row)].lane + lane), hn::Set(d, x[row])));
            }
            hn::Store(sum, d, result[body].lane + lane);
        }
}

void multiplyBodies(const dxBodyBlocks &blocks, const dxProblemChunks::Bodies &chunk, const dxBodyVectors &u, dxBodyVectors &result) {
    const BodyTag d;
    for (unsigned body = chunk.begin; body < chunk.end; ++body)
        for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
            auto sum = hn::Zero(d);
            for (unsigned c = 0; c < kBodyAxes; ++c)
                sum = hn::Add(sum, hn::Mul(hn::Load(d, blocks[body].column[c].lane + lane), hn::Set(d, u[body].lane[c])));
            hn::Store(sum, d, result[body].lane + lane);
        }
}

// target += left' W right, over the manifold's rows that have a weight.
HWY_INLINE void addProducts(dxBodyBlock &target, const dxBodyVector *left, const dxBodyVector *right, const double *weight,
                            unsigned rows) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d)) {
        hn::Vec<BodyTag> sum[kBodyAxes];
        for (unsigned c = 0; c < kBodyAxes; ++c) sum[c] = hn::Load(d, target.column[c].lane + lane);
        for (unsigned row = 0; row < rows; ++row) {
            if (weight[row] == 0) continue;
            const auto weighted = hn::Mul(hn::Load(d, left[2 * row].lane + lane), hn::Set(d, weight[row]));
            HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c)
                sum[c] = hn::Add(sum[c], hn::Mul(weighted, hn::Set(d, right[2 * row].lane[c])));
        }
        for (unsigned c = 0; c < kBodyAxes; ++c) hn::Store(sum[c], d, target.column[c].lane + lane);
    }
}

void makeColumn(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, unsigned body, const double *weight,
                dxBodyBlock &diagonal, dxBodyBlock *below) {
    diagonal = problem.mass[body];
    for (unsigned i = chunks.firstSide(body); i < chunks.firstSide(body + 1); ++i) {
        const unsigned side = chunks.side(i).side;
        const dxManifold &manifold = problem.manifolds[chunks.side(i).manifold];
        const unsigned rows = manifold.endRow - manifold.firstRow;
        const dxBodyVector *const first = problem.jacobian.data() + 2 * std::size_t(manifold.firstRow), *const second = first + 1;
        const double *const weights = weight + manifold.firstRow;
        addProducts(diagonal, first + side, first + side, weights, rows);
        if (side == 0 && manifold.body[1] != dxManifold::kNoBody) addProducts(below[manifold.block], second, first, weights, rows);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(multiply);
HWY_EXPORT(multiplyTransposed);
HWY_EXPORT(multiplyBodies);
HWY_EXPORT(makeColumn);
}  // namespace dxFastStepKernels

namespace {

// A microsecond of work or so.
constexpr unsigned kRowsPerChunk = 256;

// A body's own work, in rows.
constexpr unsigned kRowsPerBody = 8;

}  // namespace

void dxProblemChunks::make(const dxBodySpaceProblem &problem) {
    listSides(problem);
    cutRows(problem);
    cutBodies(problem);
}

void dxProblemChunks::listSides(const dxBodySpaceProblem &problem) {
    m_firstSide.assign(problem.bodyCount + 1, 0);
    for (const dxManifold &manifold : problem.manifolds)
        for (const unsigned body : manifold.body)
            if (body != dxManifold::kNoBody) ++m_firstSide[body + 1];
    for (unsigned body = 0; body < problem.bodyCount; ++body) m_firstSide[body + 1] += m_firstSide[body];
    m_next.assign(m_firstSide.begin(), m_firstSide.end());
    m_sides.resize(m_firstSide[problem.bodyCount]);
    for (unsigned manifold = 0; manifold < problem.manifolds.size(); ++manifold)
        for (unsigned side = 0; side < 2; ++side) {
            const unsigned body = problem.manifolds[manifold].body[side];
            if (body != dxManifold::kNoBody) m_sides[m_next[body]++] = {manifold, side};
        }
}

void dxProblemChunks::cutRows(const dxBodySpaceProblem &problem) {
    m_rows.clear();
    const unsigned count = padded(problem.rowCount);
    unsigned manifold = 0;
    for (unsigned begin = 0; begin < count; begin += kRowsPerChunk) {
        while (manifold < problem.manifolds.size() && problem.manifolds[manifold].endRow <= begin) ++manifold;
        m_rows.push_back({begin, std::min(begin + kRowsPerChunk, count), manifold});
    }
}

void dxProblemChunks::cutBodies(const dxBodySpaceProblem &problem) {
    m_bodies.clear();
    unsigned rows = kRowsPerChunk;
    for (unsigned body = 0; body < problem.bodyCount; ++body) {
        if (rows >= kRowsPerChunk) {
            m_bodies.push_back({body, body});
            rows = 0;
        }
        rows += kRowsPerBody;
        for (unsigned i = m_firstSide[body]; i < m_firstSide[body + 1]; ++i) {
            const dxManifold &manifold = problem.manifolds[m_sides[i].manifold];
            rows += manifold.endRow - manifold.firstRow;
        }
        m_bodies.back().end = body + 1;
    }
}

namespace dxRowProducts {

void multiply(const dxBodySpaceProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::multiply)(problem, chunk, u, result);
}

void multiplyTransposed(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
                        const double *x, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::multiplyTransposed)(problem, chunks, chunk, x, result);
}

void multiplyBodies(const dxBodyBlocks &blocks, const dxProblemChunks::Bodies &chunk, const dxBodyVectors &u, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::multiplyBodies)(blocks, chunk, u, result);
}

void makeColumns(const dxBodySpaceProblem &problem, const dxProblemChunks &chunks, const dxEliminationOrder &order, unsigned begin,
                 unsigned end, const double *weight, dxBlockFactor &factor) {
    std::fill(factor.below().begin() + order.firstBlock(begin), factor.below().begin() + order.firstBlock(end), dxBodyBlock{});
    for (unsigned body = begin; body < end; ++body)
        HWY_DYNAMIC_DISPATCH(dxFastStepKernels::makeColumn)(problem, chunks, body, weight, factor.diagonal()[body], factor.below().data());
}

}  // namespace dxRowProducts

void dxNormalEquations::begin(const dxBodySpaceProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads) {
    m_problem = &problem;
    m_order = &order;
    m_phases = &phases;
    m_chunks.make(problem);
    m_factor.shape(order, threads);
    for (std::vector<double> *array : {&m_weight, &m_scaled, &m_change}) array->assign(paddedRows(), 0);
    m_force.resize(problem.bodyCount);
    m_motion.resize(problem.bodyCount);
    m_factorisations = 0;
}

void dxNormalEquations::findMotion(const std::vector<double> &x) {
    m_phases->forChunks(static_cast<unsigned>(m_chunks.bodies().size()), [&](unsigned chunk, unsigned) {
        const dxProblemChunks::Bodies &bodies = m_chunks.bodies()[chunk];
        dxRowProducts::multiplyTransposed(*m_problem, m_chunks, bodies, x.data(), m_force);
        dxRowProducts::multiplyBodies(m_problem->inverseMass, bodies, m_force, m_motion);
    });
}

const double *dxNormalEquations::changeByMotion(const Rows &rows) {
    dxRowProducts::multiply(*m_problem, rows, m_motion, m_change.data());
    return m_change.data();
}

bool dxNormalEquations::factorise() {
    ++m_factorisations;
    return m_factor.factorise(*m_phases, [&](unsigned begin, unsigned end) {
        dxRowProducts::makeColumns(*m_problem, m_chunks, *m_order, begin, end, m_weight.data(), m_factor);
    });
}

void dxNormalEquations::solveBodies() {
    m_phases->forChunks(static_cast<unsigned>(m_chunks.bodies().size()), [&](unsigned chunk, unsigned) {
        dxRowProducts::multiplyTransposed(*m_problem, m_chunks, m_chunks.bodies()[chunk], m_scaled.data(), m_force);
    });
    m_factor.solve(*m_phases, m_force);
}

const double *dxNormalEquations::changeBySolution(const Rows &rows) {
    dxRowProducts::multiply(*m_problem, rows, m_force, m_change.data());
    return m_change.data();
}

bool dxNormalEquations::factorise(const std::vector<double> &d) {
    forRows([&](const Rows &rows, unsigned) {
        for (unsigned i = rows.begin; i < rows.end; ++i) m_weight[i] = 1 / d[i];
    });
    return factorise();
}

void dxNormalEquations::solve(const std::vector<double> &q, std::vector<double> &dx) {
    forRows([&](const Rows &rows, unsigned) {
        for (unsigned i = rows.begin; i < rows.end; ++i) m_scaled[i] = q[i] * m_weight[i];
    });
    solveBodies();
    forRows([&](const Rows &rows, unsigned) {
        const double *const change = changeBySolution(rows);
        for (unsigned i = rows.begin; i < rows.end; ++i) dx[i] = (q[i] - change[i]) * m_weight[i];
    });
}

void dxNormalEquations::findResidual(const std::vector<double> &x, std::vector<double> &s) {
    findMotion(x);
    forRows([&](const Rows &rows, unsigned) {
        const double *const change = changeByMotion(rows);
        const unsigned end = std::min(rows.end, m_problem->rowCount);
        for (unsigned i = rows.begin; i < end; ++i) s[i] = m_problem->b[i] - change[i] - m_problem->c[i] * x[i];
    });
}
#endif
