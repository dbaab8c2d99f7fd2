#include "collision/pairs/dxKeptPairs.h"

#include <algorithm>
#include <atomic>

#include "core/dxNoIndex.h"

namespace {

// Pairs in a chunk: some ten microseconds of work.
constexpr std::size_t kPairsPerChunk = 256;

// Prefetch distance, in items.
constexpr std::size_t kPrefetchDistance = 8;

// Pairs of one geom, up to which they are sorted by insertion.
constexpr std::size_t kMaxShortRun = 32;

}  // namespace

void dxKeptPairs::update(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                         const dxPairKeys &order, dxTaskRunner &runner, std::vector<dxOrderedPair> &pairs) {
    sortByPrimaryKey(members, matches, order, runner);
    placeAll(members, order, runner);
    merge(members, pairs);
}

void dxKeptPairs::sortByPrimaryKey(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                             const dxPairKeys &order, dxTaskRunner &runner) {
    m_items.resize(matches.size());
    std::atomic<bool> allHaveKeys{true};
    runner.forChunks(dxParallelStage::PairKeys, matches.size(), kPairsPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        bool all = true;
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kPrefetchDistance < end) {
                order.prefetch(matches[i + kPrefetchDistance].a);
                order.prefetch(matches[i + kPrefetchDistance].b);
            }
            const dxMembers::Slot a = matches[i].a, b = matches[i].b;
            std::uint64_t word = 0;
            bool swapped = false;
            const bool hasKey = dxFiltersAgree(members[a].filter, members[b].filter) && order.primaryKey(a, b, word, swapped);
            m_items[i] = hasKey ? dxSortItem{word, swapped ? b : a, swapped ? a : b} : dxSortItem{0, kNoIndex, kNoIndex};
            all = all && hasKey;
        }
        if (!all) allHaveKeys.store(false, std::memory_order_relaxed);
    });
    const auto isNoPair = [](const dxSortItem &item) { return item.index == kNoIndex; };
    if (!allHaveKeys) m_items.erase(std::remove_if(m_items.begin(), m_items.end(), isNoPair), m_items.end());
    dxRadixSort(m_items, m_spare);
}

void dxKeptPairs::placeAll(const dxMembers &members, const dxPairKeys &order, dxTaskRunner &runner) {
    m_nextKeys.resize(m_items.size());
    m_nextPairs.resize(m_items.size());
    if (m_longRuns.size() < runner.workers()) m_longRuns.resize(runner.workers());
    std::atomic<bool> allPlaced{true};
    runner.forChunks(dxParallelStage::KeptPairKeys, m_items.size(), kPairsPerChunk,
        [&](std::size_t begin, std::size_t end, unsigned worker) {
        if (!placeRuns(members, order, begin, end, m_longRuns[worker]))
            allPlaced.store(false, std::memory_order_relaxed);
    });
    if (!allPlaced) removeUnplaced();
}

// Places the runs of equal primary keys that begin in [begin, end). Returns whether upstream reports all pairs of these runs; pairs that it does not
// report are last in their runs, without geoms.
bool dxKeptPairs::placeRuns(const dxMembers &members, const dxPairKeys &order, std::size_t begin,
                            std::size_t end, LongRun &longRun) {
    const std::size_t size = m_items.size();
    bool all = true;
    while (begin != 0 && begin < end && m_items[begin].key == m_items[begin - 1].key) ++begin;
    while (begin < end) {
        std::size_t last = begin, placed = begin;
        for (; last < size && m_items[last].key == m_items[begin].key; ++last) {
            if (last + kPrefetchDistance < size) order.prefetch(m_items[last + kPrefetchDistance].partner);
            const dxMembers::Slot first = m_items[last].index, second = m_items[last].partner;
            dxPairKey key;
            key.words[0] = m_items[last].key;
            if (!order.secondaryKey(first, second, key)) continue;
            m_nextKeys[placed] = key;
            m_nextPairs[placed++] = {members[first].geom, members[second].geom, {first, second}};
        }
        sortRun(begin, placed, longRun);
        all = all && placed == last;
        for (; placed != last; ++placed) m_nextPairs[placed].first = nullptr;
        begin = last;
    }
    return all;
}

// Sorts by insertion, because runs are mostly short. Tried and dropped: a branch-free counting sort, which takes as long.
void dxKeptPairs::sortRun(std::size_t begin, std::size_t end, LongRun &longRun) {
    const std::size_t count = end - begin;
    if (count > kMaxShortRun) return sortLongRun(begin, end, longRun);
    dxPairKey *const keys = m_nextKeys.data() + begin;
    dxOrderedPair *const pairs = m_nextPairs.data() + begin;
    for (std::size_t i = 1; i < count; ++i) {
        const dxPairKey key = keys[i];
        const dxOrderedPair pair = pairs[i];
        std::size_t at = i;
        for (; at > 0 && key < keys[at - 1]; --at) {
            keys[at] = keys[at - 1];
            pairs[at] = pairs[at - 1];
        }
        keys[at] = key;
        pairs[at] = pair;
    }
}

void dxKeptPairs::sortLongRun(std::size_t begin, std::size_t end, LongRun &run) {
    run.clear();
    run.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) run.push_back({m_nextKeys[i], m_nextPairs[i]});
    std::sort(run.begin(), run.end(), [](const Placed &a, const Placed &b) { return a.key < b.key; });
    for (std::size_t i = begin; i < end; ++i) {
        m_nextKeys[i] = run[i - begin].key;
        m_nextPairs[i] = run[i - begin].pair;
    }
}

void dxKeptPairs::removeUnplaced() {
    std::size_t placed = 0;
    for (std::size_t i = 0; i < m_nextPairs.size(); ++i) {
        if (m_nextPairs[i].first == nullptr) continue;
        m_nextKeys[placed] = m_nextKeys[i];
        m_nextPairs[placed++] = m_nextPairs[i];
    }
    m_nextKeys.resize(placed);
    m_nextPairs.resize(placed);
}

// Merges the pairs of the last call of which both geoms are unchanged with the new pairs.
void dxKeptPairs::merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    m_keptKeys.clear();
    m_keptPairs.clear();
    // No pair is kept if fewer than two members are unchanged.
    const std::size_t candidates = members.end() - members.changed().size() < 2 ? 0 : pairs.size();
    for (std::size_t i = 0; i < candidates; ++i) {
        if (!members.areUnchanged(pairs[i].slots[0], pairs[i].slots[1])) continue;
        m_keptKeys.push_back(m_keys[i]);
        m_keptPairs.push_back(pairs[i]);
    }
    // From the back, so that new pairs move within their own memory.
    std::size_t found = m_nextKeys.size(), kept = m_keptKeys.size();
    m_nextKeys.resize(found + kept);
    m_nextPairs.resize(found + kept);
    while (kept != 0) {
        const std::size_t to = found + kept - 1;
        if (found != 0 && m_keptKeys[kept - 1] < m_nextKeys[found - 1]) {
            --found;
            m_nextKeys[to] = m_nextKeys[found];
            m_nextPairs[to] = m_nextPairs[found];
        } else {
            --kept;
            m_nextKeys[to] = m_keptKeys[kept];
            m_nextPairs[to] = m_keptPairs[kept];
        }
    }
    m_keys.swap(m_nextKeys);
    pairs.swap(m_nextPairs);
}
