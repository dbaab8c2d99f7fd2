#include "collision/spaces/sweep_and_prune/dxSapPairOrder.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/dxPrefetch.h"

// ---- Rows ------------------------------------------------------------------------------------------------------------------------------

void dxSapRows::clear(std::size_t swept) {
    dxPairRows::clear();
    m_columns.resize(swept);
    m_places.clear();
}

void dxSapRows::pushSwept(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxSapBox &box) {
    m_columns.set(geoms(), box);
    pushElement(geom, slot, filter);
}

std::size_t dxSapRows::find(std::size_t row) {
    std::size_t count;
    if (row < m_columns.size()) {
        const dxSapMeetings meetings = m_meetBehind(m_columns, row, m_found.data());
        countWork(meetings.compared, meetings.rows);
        count = meetings.rows;
    } else {
        count = pairInfinite(row);
        countWork(count, count);
    }
    return keepAgreeing(row, count);
}

// Pairs a geom with the infinite geoms behind it and with all swept ones. As upstream, it does not compare boxes.
std::size_t dxSapRows::pairInfinite(std::size_t row) {
    const auto behind = m_found.begin() + static_cast<std::ptrdiff_t>(geoms() - row - 1);
    std::iota(m_found.begin(), behind, static_cast<std::uint32_t>(row + 1));
    return static_cast<std::size_t>(std::copy(m_places.begin(), m_places.end(), behind) - m_found.begin());
}

// ---- Kept pairs ------------------------------------------------------------------------------------------------------------------------

// Returns false if there is NaN among the keys: then what upstream finds does not follow from boxes.
bool dxSapPairOrder::prepare() {
    m_swept.clear();
    m_infinite.clear();
    m_keys.clear();
    m_isSorted = false;
    bool hasNaN = false;
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + kSapPrefetchDistance < list.size()) dxPrefetch::line(&m_state.members[list[i + kSapPrefetchDistance].slot]);
        const Slot slot = list[i].slot;
        dxSapMember &member = m_state.members[slot];
        if (!m_state.axes.areAll()) member.box = m_state.axes.boxOf(list[i].geom);  // a geom's bits may be bounds
        member.part = !m_geoms.members().isPresent(slot) ? dxSapPart::absent : member.box.isInfinite ? dxSapPart::infinite : dxSapPart::swept;
        if (member.part == dxSapPart::infinite) m_infinite.push_back(slot);
        if (member.part != dxSapPart::swept) continue;
        m_swept.push_back(slot);
        m_keys.push_back(member.box.low);
        hasNaN = hasNaN || std::isnan(member.box.low);
        // An inverted box meets a box with the same lower bound only if it is behind that box in the sort, and which of them is behind may change
        // with other members.
        if (!(member.box.low <= member.box.high)) m_geoms.members().markChanged(slot);
    }
    return !hasNaN;
}

void dxSapPairOrder::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    sortSwept();
    m_matches.clear();
    for (std::size_t i = 0; i < std::min(m_sweptPairs, pairs.size()); ++i) {
        const Slot a = pairs[i].slots[0], b = pairs[i].slots[1];
        if (m_geoms.members().areUnchanged(a, b)) m_matches.push_back({a, b});
    }
    pairs.clear();
    m_pairs.findAndPlace(m_matches, pairs);
    work.found = m_matches.size();
    work.comparisons = m_state.comparisons;
    m_sweptPairs = pairs.size();
    pairInfinite(pairs);
}

dxPairRows &dxSapPairOrder::gatherRows() {
    sortSwept();
    const dxMembers &members = m_geoms.members();
    m_rows.clear(m_inOrder.size());
    for (const Slot slot : m_inOrder) m_rows.pushSwept(members[slot].geom, slot, members[slot].filter, m_state.members[slot].box);
    for (const Slot slot : m_infinite) m_rows.pushInfinite(members[slot].geom, slot, members[slot].filter);
    if (!m_infinite.empty())
        for (const Slot slot : m_swept) m_rows.pushPlace(m_state.members[slot].position);
    m_rows.finish();
    return m_rows;
}

// Sorts once in each call in which upstream sorts, because each sort changes the state.
void dxSapPairOrder::sortSwept() {
    if (std::exchange(m_isSorted, true)) return;
    m_inOrder.clear();
    if (m_swept.empty()) return;
    for (const std::uint32_t index : m_state.sort.sort(m_keys)) {
        m_state.members[m_swept[index]].position = static_cast<std::uint32_t>(m_inOrder.size());
        m_inOrder.push_back(m_swept[index]);
    }
}

bool dxSapPairOrder::primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const {
    const dxSapMember &memberA = m_state.members[a], &memberB = m_state.members[b];
    if (memberA.part != dxSapPart::swept || memberB.part != dxSapPart::swept) return false;
    swapped = memberB.position < memberA.position;
    const dxSapMember &earlier = swapped ? memberB : memberA, &later = swapped ? memberA : memberB;
    word = earlier.position;
    return earlier.box.meets(later.box);
}

bool dxSapPairOrder::secondaryKey(Slot /*first*/, Slot second, dxPairKey &key) const {
    key.words[1] = m_state.members[second].position;
    key.words[2] = key.words[3] = 0;
    return true;
}

void dxSapPairOrder::prefetch(Slot slot) const {
    m_geoms.members().prefetch(slot);
    dxPrefetch::line(&m_state.members[slot]);
}

void dxSapPairOrder::pairInfinite(std::vector<dxOrderedPair> &pairs) const {
    for (std::size_t i = 0; i < m_infinite.size(); ++i) {
        for (std::size_t j = i + 1; j < m_infinite.size(); ++j) pairIfMayMeet(m_infinite[i], m_infinite[j], pairs);
        for (const Slot slot : m_swept) pairIfMayMeet(m_infinite[i], slot, pairs);
    }
}

void dxSapPairOrder::pairIfMayMeet(Slot a, Slot b, std::vector<dxOrderedPair> &pairs) const {
    const dxMembers::Member &memberA = m_geoms.members()[a], &memberB = m_geoms.members()[b];
    if (dxFiltersAgree(memberA.filter, memberB.filter)) pairs.push_back({memberA.geom, memberB.geom, {a, b}});
}
