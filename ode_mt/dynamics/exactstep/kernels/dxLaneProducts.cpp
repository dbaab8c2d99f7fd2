#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/exactstep/kernels/dxLaneProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/exactstep/kernels/dxLaneProducts.h"
#include "dynamics/exactstep/kernels/dxLineLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// Rows of the matrix are read as streams, eight at a time, and the sums kept in `result`.
constexpr unsigned kStreams = 8;

// result(row) += the products with Streams columns
template <unsigned Streams>
HWY_INLINE void addStreams(const dxLaneProductsTask &task, unsigned first) {
    const LineTag d;
    const dReal *stream[Streams];
    LineVector factor[Streams];
    for (unsigned k = 0; k < Streams; ++k) {
        stream[k] = task.matrix + task.columns[first + k] * task.rowSkip;
        factor[k] = hn::Set(d, task.factors[first + k]);
    }
    for (unsigned block = task.beginBlock; block < task.endBlock; ++block) {
        if ((task.wanted[2 * block] | task.wanted[2 * block + 1]) == 0) continue;
        for (std::size_t i = 0; i < kLineLanes; i += hn::Lanes(d)) {
            const std::size_t lane = std::size_t(block) * kLineLanes + i;
            const auto product = [&](unsigned k) {
                return hn::Mul(hn::Load(d, stream[k] + lane), factor[k]);
            };
            auto sum = hn::Load(d, task.result + lane);
            if constexpr (Streams == 1) {
                sum = hn::Add(sum, product(0));
            } else {
                for (unsigned k = 0; k < Streams; k += 4)
                    sum = hn::Add(sum, hn::Add(hn::Add(hn::Add(product(k), product(k + 1)), product(k + 2)),
                                               product(k + 3)));
            }
            hn::Store(sum, d, task.result + lane);
        }
    }
}

void computeLaneProducts(const dxLaneProductsTask &task) {
    const LineTag d;
    for (std::size_t lane = std::size_t(task.beginBlock) * kLineLanes;
         lane < std::size_t(task.endBlock) * kLineLanes; lane += hn::Lanes(d))
        hn::Store(hn::Zero(d), d, task.result + lane);
    unsigned k = 0;
    for (; k + kStreams <= task.count; k += kStreams) addStreams<kStreams>(task, k);
    if (k + 4 <= task.count) {
        addStreams<4>(task, k);
        k += 4;
    }
    for (; k < task.count; ++k) addStreams<1>(task, k);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(computeLaneProducts);
}  // namespace dxSolve

void dxComputeLaneProducts(const dxLaneProductsTask &task) {
    HWY_DYNAMIC_DISPATCH(dxSolve::computeLaneProducts)(task);
}
#endif
