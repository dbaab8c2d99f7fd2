#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxLaneProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/kernels/dxLaneProducts.h"
#include "dynamics/world_step/kernels/dxLineLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// Rows of the matrix are read as streams, eight at a time, and the sums kept in `result`.
constexpr unsigned kStreams = 8;

// Up to this many vectors from the first lane to the last, sums are kept in registers, so many at a time.
constexpr std::size_t kMaxShortVectors = 32, kSumsAtOnce = 4;

HWY_INLINE bool isVectorWanted(const dxLaneProductsTask &task, std::size_t lane) {
    const unsigned *const wanted = task.wanted + lane / kHalfLine;
    if constexpr (hn::MaxLanes(LineTag()) > kHalfLine) return (wanted[0] | wanted[1]) != 0;
    return wanted[0] != 0;
}

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
    const std::size_t end = std::size_t(task.endBlock) * kLineLanes;
    for (std::size_t lane = std::size_t(task.beginBlock) * kLineLanes; lane < end; lane += hn::Lanes(d)) {
        if (!isVectorWanted(task, lane)) continue;
        const auto product = [&](unsigned k) { return hn::Mul(hn::Load(d, stream[k] + lane), factor[k]); };
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

// The sums of the vectors that begin at `lanes`, over all columns.
template <std::size_t Vectors>
HWY_INLINE void sumInRegisters(const dxLaneProductsTask &task, const std::size_t *lanes) {
    const LineTag d;
    std::size_t lane[Vectors];
    LineVector sum[Vectors];
    for (std::size_t v = 0; v < Vectors; ++v) {
        lane[v] = lanes[v];
        sum[v] = hn::Zero(d);
    }
    const auto stream = [&](unsigned k) { return task.matrix + task.columns[k] * task.rowSkip; };
    unsigned k = 0;
    for (; k + 4 <= task.count; k += 4) {
        const dReal *const streams[4] = {stream(k), stream(k + 1), stream(k + 2), stream(k + 3)};
        LineVector factor[4];
        for (unsigned i = 0; i < 4; ++i) factor[i] = hn::Set(d, task.factors[k + i]);
        for (std::size_t v = 0; v < Vectors; ++v) {
            const auto product = [&](unsigned i) { return hn::Mul(hn::Load(d, streams[i] + lane[v]), factor[i]); };
            sum[v] = hn::Add(sum[v], hn::Add(hn::Add(hn::Add(product(0), product(1)), product(2)), product(3)));
        }
    }
    for (; k < task.count; ++k) {
        const dReal *const single = stream(k);
        const LineVector factor = hn::Set(d, task.factors[k]);
        for (std::size_t v = 0; v < Vectors; ++v)
            sum[v] = hn::Add(sum[v], hn::Mul(hn::Load(d, single + lane[v]), factor));
    }
    for (std::size_t v = 0; v < Vectors; ++v) hn::Store(sum[v], d, task.result + lane[v]);
}

// Which vectors are wanted is as good as random: they are listed first, without a branch.
HWY_INLINE void computeShort(const dxLaneProductsTask &task) {
    std::size_t lanes[kMaxShortVectors + 1], count = 0;
    const std::size_t end = std::size_t(task.endBlock) * kLineLanes;
    for (std::size_t lane = std::size_t(task.beginBlock) * kLineLanes; lane < end; lane += hn::Lanes(LineTag())) {
        lanes[count] = lane;
        count += isVectorWanted(task, lane);
    }
    std::size_t done = 0;
    for (; done + kSumsAtOnce <= count; done += kSumsAtOnce) sumInRegisters<kSumsAtOnce>(task, lanes + done);
    switch (count - done) {
    case 3: return sumInRegisters<3>(task, lanes + done);
    case 2: return sumInRegisters<2>(task, lanes + done);
    case 1: return sumInRegisters<1>(task, lanes + done);
    }
}

void computeLaneProducts(const dxLaneProductsTask &task) {
    const LineTag d;
    const std::size_t begin = std::size_t(task.beginBlock) * kLineLanes, end = std::size_t(task.endBlock) * kLineLanes;
    if (end - begin <= kMaxShortVectors * hn::Lanes(d)) return computeShort(task);
    for (std::size_t lane = begin; lane < end; lane += hn::Lanes(d)) hn::Store(hn::Zero(d), d, task.result + lane);
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
