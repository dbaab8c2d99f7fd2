#include "collision/dxKeptPairs.h"

#include <algorithm>

void dxKeptPairs::update(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                         const dxPairPlacer &placer, std::vector<dxOrderedPair> &pairs) {
    m_found.clear();
    for (const dxPairSearch::Match &match : matches) placeMatch(match, members, placer);
    std::sort(m_found.begin(), m_found.end());
    merge(members, pairs);
}

void dxKeptPairs::placeMatch(const dxPairSearch::Match &match, const dxMembers &members,
                             const dxPairPlacer &placer) {
    dxGeom *const a = members[match.a].geom, *const b = members[match.b].geom;
    dxPairKey key;
    bool swapped = false;
    if (!dxMayMeet(a, b) || !placer.place(match.a, match.b, key, swapped)) return;
    if (swapped)
        m_found.push_back({key, {b, a, {match.b, match.a}}});
    else
        m_found.push_back({key, {a, b, {match.a, match.b}}});
}

void dxKeptPairs::merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    m_nextKeys.clear();
    m_nextPairs.clear();
    const auto push = [&](const dxPairKey &key, const dxOrderedPair &pair) {
        m_nextKeys.push_back(key);
        m_nextPairs.push_back(pair);
    };
    auto found = m_found.cbegin();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (members.isChanged(pairs[i].slots[0]) || members.isChanged(pairs[i].slots[1])) continue;
        for (; found != m_found.cend() && found->key < m_keys[i]; ++found) push(found->key, found->pair);
        push(m_keys[i], pairs[i]);
    }
    for (; found != m_found.cend(); ++found) push(found->key, found->pair);
    m_keys.swap(m_nextKeys);
    pairs.swap(m_nextPairs);
}
