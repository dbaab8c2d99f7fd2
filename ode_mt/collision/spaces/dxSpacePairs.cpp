#include "collision/spaces/dxSpacePairs.h"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include "collision/broadphase/dxAdaptiveBroadphase.h"
#include "core/dxStopwatch.h"

namespace {

// Geoms below which no call is timed, because reading the clock would take too large a part of the time.
constexpr int kMinTimed = 24;

// The first kUpdatesTimedFirst updates of pairs are timed, except for the very first, which allocates memory; then one of kUpdatesPerTimed.
constexpr unsigned kUpdatesTimedFirst = 8, kUpdatesPerTimed = 4;

bool isTimedUpdate(unsigned update) { return (update != 1 && update <= kUpdatesTimedFirst) || update % kUpdatesPerTimed == 0; }

}  // namespace

dxPairsFound dxSpacePairs::findChanged() {
    dxPairsFound found = dxPairsFound::Kept;
    if (m_areOutdated || !m_geoms.members().changed().empty()) {
        if (!m_geoms.isOutermostCall()) return dxPairsFound::None;  // an outer call iterates over pairs()
        if (m_areOutdated) startAnew();
        m_areOutdated = false;
        m_isCheckDue = true;
        try {
            if (!m_order.prepare()) return dxPairsFound::None;
            found = m_keeping.isKept() && m_mayKeep ? updateKept() : findAnew();
        } catch (const std::bad_alloc &) {  // this call walks the geoms as upstream does
            giveUp();
            return dxPairsFound::None;
        }
    }
    if (m_isCheckDue && found == dxPairsFound::Kept) m_isCheckDue = m_order.requireValid();
    return found;
}

dxPairsFound dxSpacePairs::updateKept() {
    dxPairWork work;
    if (!m_arePairsKept) startAnew();
    work.geoms = static_cast<std::size_t>(m_geoms.count());
    work.comparisons = work.geoms * work.geoms / 2;
    work.changed = m_geoms.members().changed().size();
    const bool isTimed = m_geoms.count() >= kMinTimed && !m_geoms.hasRunner() && isTimedUpdate(++m_updates);
    std::optional<dxStopwatch> stopwatch;
    if (isTimed) stopwatch.emplace();
    m_order.update(m_pairs, work);
    const double ns = isTimed ? stopwatch->ns() : 0;
    if (isTooMany(m_pairs.size())) m_keeping.overflow();
    if (!m_keeping.isKept()) return findAnew();
    m_arePairsKept = true;
    m_geoms.forgetChanges();
    work.pairs = m_pairs.size();
    work.overlaps = std::max(work.found, work.pairs);
    if (m_broadphase != nullptr) return dxPairsFound::Kept;  // a broad phase that was set is always used
    if (isTimed) m_keeping.noteTime(work, ns);
    m_keeping.note(work);
    return dxPairsFound::Kept;
}

// Workers need all pairs before the first callback. These pairs are valid until a member changes; they have no keys.
dxPairsFound dxSpacePairs::findAnew() {
    if (m_arePairsKept) forget();
    if (!m_geoms.hasRunner() || isTooMany(m_pairsAnew)) return dxPairsFound::RowByRow;
    dxPairRows &rows = m_order.gatherRows();
    m_pairs.clear();
    collectRows(rows);
    m_geoms.members().forgetChanges();
    noteAnew(rows, m_pairs.size());
    return dxPairsFound::Kept;
}

void dxSpacePairs::collectRows(dxPairRows &rows) {
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        const std::size_t found = rows.find(row), before = m_pairs.size();
        const std::size_t first = rows.first(row);
        m_pairs.resize(before + found);
        for (std::size_t i = 0; i < found; ++i) {
            const std::size_t second = rows.second(i);
            m_pairs[before + i] = {rows.geom(first), rows.geom(second), {rows.slot(first), rows.slot(second)}};
        }
    }
}

void dxSpacePairs::noteAnew(const dxPairRows &rows, std::size_t pairs) {
    dxPairWork work;
    work.comparisons = rows.comparisons();
    work.geoms = rows.geoms();
    work.overlaps = rows.overlaps();
    work.pairs = pairs;
    noteAnew(work);
}

void dxSpacePairs::noteAnew(dxPairWork work) {
    m_pairsAnew = work.pairs;
    if (m_keeping.isKept()) return;
    work.changed = std::min(m_geoms.takeChanges(), work.geoms);
    m_keeping.note(work);
}

void dxSpacePairs::setBroadphase(std::unique_ptr<dxBroadphase> broadphase) {
    replaceBroadphase(std::move(broadphase));
    m_keeping = dxPairKeeping(m_geoms.pairOrder());
    startAnew();
}

void dxSpacePairs::replaceBroadphase(std::unique_ptr<dxBroadphase> broadphase) {
    m_broadphase = std::move(broadphase);
    m_geoms.setHasBroadphase(m_broadphase != nullptr);
}

void dxSpacePairs::startAnew() {
    m_pairs.clear();
    m_defaultBroadphase.reset();
    m_kept.reset();
    m_geoms.members().markAllChanged();
}

// Discards partial results. A broad phase that was set must be set again by its owner.
void dxSpacePairs::giveUp() {
    replaceBroadphase(nullptr);
    m_bruteForce.reset();
    m_matches = {};
    startAnew();
}

// Discards all pairs and frees their memory.
void dxSpacePairs::forget() {
    m_arePairsKept = false;
    startAnew();
    m_pairs = {};
    m_matches = {};
}

bool dxSpacePairs::isTooMany(std::size_t pairs) const {
    return pairs > dxPairLimitOf(m_geoms.pairOrder())(m_geoms.members().end());
}

void dxSpacePairs::updateRanked(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    dxBroadphaseFacts facts;
    facts.order = m_geoms.pairOrder();
    facts.geoms = m_geoms.count();
    facts.current = m_bruteForce != nullptr ? dxBroadphaseKind::OrderedBruteForce : dxBroadphaseKind::None;
    const bool isSmall = m_broadphase == nullptr && dxChooseBroadphase(facts) == dxBroadphaseKind::OrderedBruteForce;
    if (isSmall != (m_bruteForce != nullptr)) {
        m_bruteForce.reset(isSmall ? new dxBruteForcePairs : nullptr);
        startAnew();
    }
    if (isSmall)
        work.found = m_bruteForce->update(m_geoms.members(), pairs);
    else
        updateSorted(pairs, work);
}

void dxSpacePairs::updateSorted(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    m_matches.clear();
    findAndPlace(m_matches, pairs);
    work.found = m_matches.size();
}

void dxSpacePairs::findAndPlace(std::vector<dxBroadphase::Match> &matches, std::vector<dxOrderedPair> &pairs) {
    if (m_broadphase == nullptr && m_defaultBroadphase == nullptr)
        m_defaultBroadphase.reset(new dxAdaptiveBroadphase(dxPairLimitOf(m_geoms.pairOrder())));
    if (m_kept == nullptr) m_kept.reset(new dxKeptPairs);
    dxTaskRunner &runner = m_geoms.runner();
    (m_broadphase != nullptr ? m_broadphase : m_defaultBroadphase)->findOverlaps(m_geoms.members(), runner, matches);
    if (isTooMany(matches.size())) {
        m_keeping.overflow();
        forget();
        return;
    }
    m_kept->update(m_geoms.members(), matches, m_order, runner, pairs);
}
