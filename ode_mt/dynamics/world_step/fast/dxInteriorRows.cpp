#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxInteriorRows.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxInteriorRows.h"

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

using Rows = dxInteriorRows;
using Step = dxInteriorLoops::Step;
using V = hn::Vec<BodyTag>;

// Vectors that are kBodyLanes together.
constexpr unsigned kVectors = kBodyLanes / hn::MaxLanes(BodyTag());

// One sum, or one maximum, a lane.
class LaneSums {
public:
    LaneSums() {
        for (V &sum : m_sums) sum = hn::Zero(BodyTag());
    }
    void add(unsigned vector, V value) { m_sums[vector] = hn::Add(m_sums[vector], value); }

    // What is no number is ignored.
    void raise(unsigned vector, V value) { m_sums[vector] = hn::IfThenElse(hn::Gt(value, m_sums[vector]), value, m_sums[vector]); }

    double sum() const {
        alignas(64) double lanes[kBodyLanes];
        store(lanes);
        return addUp(lanes);
    }
    double largest() const {
        alignas(64) double lanes[kBodyLanes];
        store(lanes);
        double value = lanes[0];
        for (const double lane : lanes) value = lane > value ? lane : value;
        return value;
    }

private:
    void store(double *lanes) const {
        for (unsigned i = 0; i < kVectors; ++i) hn::Store(m_sums[i], BodyTag(), lanes + i * hn::Lanes(BodyTag()));
    }

    V m_sums[kVectors];
};

// Calls work(row, vector) for vectors of rows.
template <class Work>
HWY_INLINE void forVectors(unsigned begin, unsigned end, const Work &work) {
    const unsigned lanes = static_cast<unsigned>(hn::Lanes(BodyTag()));
    for (unsigned row = begin; row < end; row += kBodyLanes)
        for (unsigned vector = 0; vector < kVectors; ++vector) work(row + vector * lanes, vector);
}

HWY_INLINE V load(const std::vector<double> &array, unsigned row) { return hn::LoadU(BodyTag(), array.data() + row); }
HWY_INLINE void store(V value, std::vector<double> &array, unsigned row) { hn::StoreU(value, BodyTag(), array.data() + row); }

void prepare(Rows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled) {
    const BodyTag d;
    forVectors(begin, end, [&](unsigned i, unsigned) HWY_ATTR {
        const auto s = hn::Sub(hn::Sub(load(rows.b, i), hn::LoadU(d, change + i)), hn::Mul(load(rows.c, i), load(rows.x, i)));
        const auto byLow = hn::Div(load(rows.pullLow, i), load(rows.toLow, i));
        const auto byHigh = hn::Div(load(rows.pullHigh, i), load(rows.toHigh, i));
        const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Add(hn::Add(load(rows.softness, i), byLow), byHigh));
        const auto w = hn::IfThenElseZero(hn::Ne(load(rows.low, i), load(rows.high, i)), inverse);
        store(s, rows.s, i);
        hn::StoreU(w, d, weight + i);
        hn::StoreU(hn::Mul(s, w), d, scaled + i);
    });
}

Step predict(Rows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    const BodyTag d;
    LaneSums loss, energy;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto dx = hn::Mul(hn::Sub(load(rows.s, i), hn::LoadU(d, change + i)), hn::LoadU(d, weight + i));
        const auto pullLow = load(rows.pullLow, i), pullHigh = load(rows.pullHigh, i), zero = hn::Zero(d), one = hn::Set(d, 1.0);
        const auto partLow = hn::Div(dx, load(rows.toLow, i)), partHigh = hn::Div(dx, load(rows.toHigh, i));
        const auto dPullLow = hn::Sub(hn::Neg(pullLow), hn::Mul(pullLow, partLow));
        const auto dPullHigh = hn::Sub(hn::Mul(pullHigh, partHigh), pullHigh);
        store(dx, rows.dx, i);
        store(dPullLow, rows.dPullLow, i);
        store(dPullHigh, rows.dPullHigh, i);
        loss.raise(vector, hn::Neg(partLow));
        loss.raise(vector, partHigh);
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(pullLow, zero), hn::Add(one, partLow)));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(pullHigh, zero), hn::Sub(one, partHigh)));
        energy.add(vector, hn::Mul(dx, hn::Sub(dPullLow, dPullHigh)));
    });
    return {loss.largest(), energy.sum()};
}

void correct(Rows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled) {
    const BodyTag d;
    forVectors(begin, end, [&](unsigned i, unsigned) HWY_ATTR {
        const auto dx = load(rows.dx, i), zero = hn::Zero(d), goal = hn::Set(d, target);
        const auto low = hn::IfThenElseZero(hn::Gt(load(rows.pullLow, i), zero), hn::Sub(goal, hn::Mul(dx, load(rows.dPullLow, i))));
        const auto high = hn::IfThenElseZero(hn::Gt(load(rows.pullHigh, i), zero), hn::Add(goal, hn::Mul(dx, load(rows.dPullHigh, i))));
        const auto byLow = hn::Div(low, load(rows.toLow, i)), byHigh = hn::Div(high, load(rows.toHigh, i));
        const auto q = hn::Sub(hn::Add(load(rows.s, i), byLow), byHigh);
        store(low, rows.dPullLow, i);
        store(high, rows.dPullHigh, i);
        store(q, rows.s, i);
        hn::StoreU(hn::Mul(q, hn::LoadU(d, weight + i)), d, scaled + i);
    });
}

Step finish(Rows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    const BodyTag d;
    LaneSums loss;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto dx = hn::Mul(hn::Sub(load(rows.s, i), hn::LoadU(d, change + i)), hn::LoadU(d, weight + i));
        const auto pullLow = load(rows.pullLow, i), pullHigh = load(rows.pullHigh, i), zero = hn::Zero(d);
        const auto toLow = load(rows.toLow, i), toHigh = load(rows.toHigh, i);
        const auto dPullLow = hn::Sub(hn::Div(hn::Sub(load(rows.dPullLow, i), hn::Mul(pullLow, dx)), toLow), pullLow);
        const auto dPullHigh = hn::Sub(hn::Div(hn::Add(load(rows.dPullHigh, i), hn::Mul(pullHigh, dx)), toHigh), pullHigh);
        store(dx, rows.dx, i);
        store(dPullLow, rows.dPullLow, i);
        store(dPullHigh, rows.dPullHigh, i);
        loss.raise(vector, hn::Div(hn::Neg(dx), toLow));
        loss.raise(vector, hn::Div(dx, toHigh));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(pullLow, zero), hn::Div(hn::Neg(dPullLow), pullLow)));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(pullHigh, zero), hn::Div(hn::Neg(dPullHigh), pullHigh)));
    });
    return {loss.largest(), 0};
}

double advance(Rows &rows, unsigned begin, unsigned end, double length) {
    const BodyTag d;
    LaneSums products;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto part = hn::Set(d, length), zero = hn::Zero(d);
        const auto dx = hn::Mul(part, load(rows.dx, i));
        auto pullLow = load(rows.pullLow, i), pullHigh = load(rows.pullHigh, i);
        const auto hasLow = hn::Gt(pullLow, zero), hasHigh = hn::Gt(pullHigh, zero);
        const auto toLow = hn::Add(load(rows.toLow, i), hn::IfThenElseZero(hasLow, dx));
        const auto toHigh = hn::Sub(load(rows.toHigh, i), hn::IfThenElseZero(hasHigh, dx));
        pullLow = hn::Add(pullLow, hn::IfThenElseZero(hasLow, hn::Mul(part, load(rows.dPullLow, i))));
        pullHigh = hn::Add(pullHigh, hn::IfThenElseZero(hasHigh, hn::Mul(part, load(rows.dPullHigh, i))));
        store(hn::Add(load(rows.x, i), dx), rows.x, i);
        store(toLow, rows.toLow, i);
        store(toHigh, rows.toHigh, i);
        store(pullLow, rows.pullLow, i);
        store(pullHigh, rows.pullHigh, i);
        products.add(vector, hn::Add(hn::Mul(pullLow, toLow), hn::Mul(pullHigh, toHigh)));
    });
    return products.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxDirect {
HWY_EXPORT(prepare);
HWY_EXPORT(predict);
HWY_EXPORT(correct);
HWY_EXPORT(finish);
HWY_EXPORT(advance);
}  // namespace dxDirect

void dxInteriorRows::resize(unsigned rows, unsigned padded) {
    for (std::vector<double> *array : {&low, &high, &b, &c, &x, &pullLow, &pullHigh, &dx, &dPullLow, &dPullHigh, &s}) {
        array->resize(rows);
        array->resize(padded, 0.0);
    }
    softness.resize(rows);
    softness.resize(padded, 1.0);
    for (std::vector<double> *array : {&toLow, &toHigh}) {
        array->resize(rows);
        array->resize(padded, kFarLimit);
    }
}

namespace dxInteriorLoops {

void prepare(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled) {
    HWY_DYNAMIC_DISPATCH(dxDirect::prepare)(rows, begin, end, change, weight, scaled);
}

Step predict(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    return HWY_DYNAMIC_DISPATCH(dxDirect::predict)(rows, begin, end, change, weight);
}

void correct(dxInteriorRows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled) {
    HWY_DYNAMIC_DISPATCH(dxDirect::correct)(rows, begin, end, target, weight, scaled);
}

Step finish(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    return HWY_DYNAMIC_DISPATCH(dxDirect::finish)(rows, begin, end, change, weight);
}

double advance(dxInteriorRows &rows, unsigned begin, unsigned end, double length) {
    return HWY_DYNAMIC_DISPATCH(dxDirect::advance)(rows, begin, end, length);
}

}  // namespace dxInteriorLoops
#endif
