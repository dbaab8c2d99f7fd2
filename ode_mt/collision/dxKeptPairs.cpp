#include "collision/dxKeptPairs.h"

#include <algorithm>

namespace {

// Pairs that one worker takes at once: some ten microseconds.
constexpr std::size_t kPiece = 256;

// Items between asking the memory for one and working on it.
constexpr std::size_t kAhead = 8;

}  // namespace

void dxKeptPairs::update(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                         const dxPairPlacer &placer, dxTaskRunner &runner, std::vector<dxOrderedPair> &pairs) {
    placeAll(members, matches, placer, runner);
    sortFound(runner);
    merge(members, pairs);
}

void dxKeptPairs::placeAll(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                           const dxPairPlacer &placer, dxTaskRunner &runner) {
    m_found.resize(matches.size());
    m_isPlaced.resize(matches.size());
    runner.forPieces(matches.size(), kPiece, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < end) placer.expect(matches[i + kAhead].a, matches[i + kAhead].b);
            const dxMembers::Slot a = matches[i].a, b = matches[i].b;
            const dxMembers::Member &memberA = members[a], &memberB = members[b];
            bool swapped = false;
            m_isPlaced[i] =
                dxMayMeet(memberA.filter, memberB.filter) && placer.place(a, b, m_found[i].key, swapped);
            m_found[i].pair = swapped ? dxOrderedPair{memberB.geom, memberA.geom, {b, a}}
                                      : dxOrderedPair{memberA.geom, memberB.geom, {a, b}};
        }
    });
}

// By the first word, then within each run of one word, which is as long as a geom has pairs.
void dxKeptPairs::sortFound(dxTaskRunner &runner) {
    m_items.clear();
    for (std::uint32_t i = 0; i < m_found.size(); ++i)
        if (m_isPlaced[i]) m_items.push_back({m_found[i].key.words[0], i});
    dxRadixSort(m_items, m_spare);
    m_nextKeys.resize(m_items.size());
    m_nextPairs.resize(m_items.size());
    runner.forPieces(m_items.size(), kPiece, [&](std::size_t begin, std::size_t end, unsigned) {
        sortRuns(begin, end);
    });
}

// Of the runs that begin in [begin, end).
void dxKeptPairs::sortRuns(std::size_t begin, std::size_t end) {
    const std::size_t size = m_items.size();
    while (begin != 0 && begin < end && m_items[begin].key == m_items[begin - 1].key) ++begin;
    while (begin < end) {
        std::size_t last = begin;
        for (; last < size && m_items[last].key == m_items[begin].key; ++last) {
            if (last + kAhead < size) __builtin_prefetch(&m_found[m_items[last + kAhead].index]);
            insertSorted(begin, last, m_found[m_items[last].index]);
        }
        begin = last;
    }
}

// Into the run from `begin` on, which has grown to `last`. Runs are short.
void dxKeptPairs::insertSorted(std::size_t begin, std::size_t last, const Found &found) {
    std::size_t at = last;
    for (; at > begin && found.key < m_nextKeys[at - 1]; --at) {
        m_nextKeys[at] = m_nextKeys[at - 1];
        m_nextPairs[at] = m_nextPairs[at - 1];
    }
    m_nextKeys[at] = found.key;
    m_nextPairs[at] = found.pair;
}

// What is left of the pairs of the last call, between the new ones.
void dxKeptPairs::merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    const auto isKept = [&](const dxOrderedPair &pair) {
        return !members.isChanged(pair.slots[0]) && !members.isChanged(pair.slots[1]);
    };
    m_keptKeys.clear();
    m_keptPairs.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!isKept(pairs[i])) continue;
        m_keptKeys.push_back(m_keys[i]);
        m_keptPairs.push_back(pairs[i]);
    }
    // From behind, so that what is new moves up within its own memory.
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
