#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/direct/dxRowProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/direct/dxBlockFactor.h"
#include "dynamics/direct/dxBodyLanes-inl.h"
#include "dynamics/direct/dxDirectProblem.h"
#include "dynamics/direct/dxRowProducts.h"

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

// What a manifold reads of a body that it does not have.
constexpr dxBodyVector kNoMotion = {};

void multiply(const dxDirectProblem &problem, const dxBodyVectors &u, std::vector<double> &result) {
    const BodyTag d;
    const dxBodyVector *const jacobian = problem.jacobian.data();
    for (const dxManifold &manifold : problem.manifolds) {
        const bool hasFirst = manifold.body[0] != dxManifold::kNoBody, hasSecond = manifold.body[1] != dxManifold::kNoBody;
        const dxBodyVector &first = hasFirst ? u[manifold.body[0]] : kNoMotion;
        const dxBodyVector &second = hasSecond ? u[manifold.body[1]] : kNoMotion;
        for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row) {
            const dxBodyVector *const sides = jacobian + 2 * row;
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

void multiplyTransposed(const dxDirectProblem &problem, const std::vector<double> &x, dxBodyVectors &result) {
    const BodyTag d;
    const dxBodyVector *const jacobian = problem.jacobian.data();
    for (dxBodyVector &sum : result) sum = {};
    for (const dxManifold &manifold : problem.manifolds)
        for (unsigned side = 0; side < 2; ++side) {
            if (manifold.body[side] == dxManifold::kNoBody) continue;
            dxBodyVector &target = result[manifold.body[side]];
            for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
                auto sum = hn::Load(d, target.lane + lane);
                for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row)
                    sum = hn::Add(sum, hn::Mul(hn::Load(d, jacobian[2 * row + side].lane + lane), hn::Set(d, x[row])));
                hn::Store(sum, d, target.lane + lane);
            }
        }
}

void multiplyBodies(const dxBodyBlocks &blocks, const dxBodyVectors &u, dxBodyVectors &result) {
    const BodyTag d;
    for (std::size_t body = 0; body < blocks.size(); ++body)
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

void makeMatrix(const dxDirectProblem &problem, const std::vector<double> &weight, dxBodyBlocks &diagonal, dxBodyBlocks &below) {
    std::copy(problem.mass.begin(), problem.mass.end(), diagonal.begin());
    std::fill(below.begin(), below.end(), dxBodyBlock{});
    for (const dxManifold &manifold : problem.manifolds) {
        const unsigned rows = manifold.endRow - manifold.firstRow;
        const dxBodyVector *const first = problem.jacobian.data() + 2 * std::size_t(manifold.firstRow), *const second = first + 1;
        const double *const weights = weight.data() + manifold.firstRow;
        const bool hasFirst = manifold.body[0] != dxManifold::kNoBody, hasSecond = manifold.body[1] != dxManifold::kNoBody;
        if (hasFirst) addProducts(diagonal[manifold.body[0]], first, first, weights, rows);
        if (hasSecond) addProducts(diagonal[manifold.body[1]], second, second, weights, rows);
        if (hasFirst && hasSecond) addProducts(below[manifold.block], second, first, weights, rows);
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
HWY_EXPORT(makeMatrix);
}  // namespace dxDirect

namespace dxRowProducts {

void multiply(const dxDirectProblem &problem, const dxBodyVectors &u, std::vector<double> &result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiply)(problem, u, result);
}

void multiplyTransposed(const dxDirectProblem &problem, const std::vector<double> &x, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiplyTransposed)(problem, x, result);
}

void multiplyBodies(const dxBodyBlocks &blocks, const dxBodyVectors &u, dxBodyVectors &result) {
    HWY_DYNAMIC_DISPATCH(dxDirect::multiplyBodies)(blocks, u, result);
}

void makeMatrix(const dxDirectProblem &problem, const std::vector<double> &weight, dxBlockFactor &factor) {
    HWY_DYNAMIC_DISPATCH(dxDirect::makeMatrix)(problem, weight, factor.diagonal(), factor.below());
}

}  // namespace dxRowProducts
#endif
