#include "collision/broadphase/dxPairKeeping.h"

#include <algorithm>

namespace {

// An interrupted call may take any time: it counts as at most kMaxStep times the average, in a moving average of kCallsOfAverage calls.
constexpr double kMaxStep = 2;
constexpr unsigned kCallsOfAverage = 8;
constexpr unsigned kTimesToTrust = 3;
constexpr double kMinFactor = 1.0 / 8, kMaxFactor = 16;

// Factor by which finding all anew has to be cheaper: the geoms of kept pairs are prefetched for their callbacks, those of a row are not. That saves
// nothing where all are in the cache.
constexpr double kWorthOfKeeping = 1.5;
constexpr std::size_t kMaxCached = 512;  // geoms

// Up to this number of geoms an estimate takes as long as a call.
constexpr std::size_t kMaxUnestimated = dxBroadphaseThresholds::kMaxAlwaysWalked;

double costAnew(dxPairOrder order, const dxPairWork &work) {
    return (work.geoms > kMaxCached ? kWorthOfKeeping : 1) * dxCostOfFindingAnew(order, work);
}

}  // namespace

void dxPairKeeping::note(const dxPairWork &work) {
    if (m_order == dxPairOrder::Blocks && work.geoms <= kMaxUnestimated)
        noteFew(work.changed);
    else if (m_isKept)
        noteKept(work);
    else
        noteAnew(work);
}

// In a small space pairs are kept while it rests.
void dxPairKeeping::noteFew(std::size_t changed) {
    m_restedCalls = changed == 0 ? m_restedCalls + 1 : 0;
    m_isKept = m_restedCalls >= dxBroadphaseThresholds::kMinCallsRested;
}

void dxPairKeeping::noteTime(const dxPairWork &work, double ns) {
    const double estimate = dxCostOfKeeping(m_order, work);
    if (estimate <= 0) return;
    const bool isFirst = m_timed == 0;
    m_timed = std::min(m_timed + 1, kCallsOfAverage);
    const double factor = isFirst ? ns / estimate : std::clamp(ns / estimate, m_factor / kMaxStep, m_factor * kMaxStep);
    m_factor = std::clamp(m_factor + (factor - m_factor) / m_timed, kMinFactor, kMaxFactor);
}

void dxPairKeeping::overflow() {
    if (m_isKept) change();
}

void dxPairKeeping::change() {
    m_isKept = !m_isKept;
    m_saved = 0;
}

// Forgetting the pairs costs nothing, so a few calls have to prove that finding all anew saves time. In the first call every
// geom has changed, and no call has been timed.
void dxPairKeeping::noteKept(const dxPairWork &work) {
    if (m_timed < kTimesToTrust && m_keptCalls < kCallsOfAverage) {
        ++m_keptCalls;
        return;
    }
    const double anew = costAnew(m_order, work);
    m_saved = std::max(0.0, m_saved + m_factor * dxCostOfKeeping(m_order, work) - anew);
    if (m_saved > dxBroadphaseThresholds::kCallsSavedBeforeAnew * anew) change();
}

// All pairs have to be found once, and put in order, before they can be kept.
void dxPairKeeping::noteAnew(const dxPairWork &work) {
    if (work.pairs > dxPairLimitOf(m_order)(work.geoms) / 2) {
        m_saved = 0;
        return;
    }
    const double rest = 1 - static_cast<double>(work.changed) / static_cast<double>(std::max<std::size_t>(work.geoms, 1));
    dxPairWork kept = work, first = work;
    kept.found = static_cast<std::size_t>((1 - rest * rest) * static_cast<double>(work.overlaps));
    first.changed = work.geoms;
    first.found = work.overlaps;
    m_saved = std::max(0.0, m_saved + costAnew(m_order, work) - m_factor * dxCostOfKeeping(m_order, kept));
    if (m_saved > m_factor * dxCostOfKeeping(m_order, first)) change();
}
