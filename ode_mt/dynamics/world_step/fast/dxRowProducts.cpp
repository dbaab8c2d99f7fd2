#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxRowProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBlockFactor.h"
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxDirectProblem.h"
#include "dynamics/world_step/fast/dxRowProducts.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

// What a manifold reads of a body that it does not have.
constexpr dxBodyVector kNoMotion = {};

void multiply(const dxDirectProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result) {
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

void multiplyTransposed(const dxDirectProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
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

void makeColumn(const dxDirectProblem &problem, const dxProblemChunks &chunks, unsigned body, const double *weight,
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
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxDirect {
HWY_EXPORT(multiply);
HWY_EXPORT(multiplyTransposed);
HWY_EXPORT(multiplyBodies);
HWY_EXPORT(makeColumn);
}  // namespace dxDirect

namespace dxRowProducts {

void multiply(const dxDirectProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiply)(problem, chunk, u, result);
}

void multiplyTransposed(const dxDirectProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
                        const double *x, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiplyTransposed)(problem, chunks, chunk, x, result);
}

void multiplyBodies(const dxBodyBlocks &blocks, const dxProblemChunks::Bodies &chunk, const dxBodyVectors &u, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiplyBodies)(blocks, chunk, u, result);
}

void makeColumns(const dxDirectProblem &problem, const dxProblemChunks &chunks, const dxEliminationOrder &order, unsigned begin,
                 unsigned end, const double *weight, dxBlockFactor &factor) {
    std::fill(factor.below().begin() + order.firstBlock(begin), factor.below().begin() + order.firstBlock(end), dxBodyBlock{});
    for (unsigned body = begin; body < end; ++body)
        HWY_DYNAMIC_DISPATCH(dxDirect::makeColumn)(problem, chunks, body, weight, factor.diagonal()[body], factor.below().data());
}

}  // namespace dxRowProducts
#endif
