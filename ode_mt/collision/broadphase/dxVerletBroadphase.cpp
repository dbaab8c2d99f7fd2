#include "collision/broadphase/dxVerletBroadphase.h"

#include <cmath>
#include <cstring>

#include "core/dxPrefetch.h"

namespace {

// The skin, as a share of a box's longest edge. A wider one means fewer lists and more candidates that do not touch.
constexpr dReal kSkin = 0.05;

// A box that moves gets room for this many calls, but not for more than its longest edge.
constexpr dReal kPredictedCalls = 8;

// Growing a stored box takes at least a three hundredth of the time of making a list, whatever the number of boxes;
// and appended candidates are compared at every call.
constexpr std::size_t kGrowthsForAList = 250;
constexpr std::size_t kMaxByFresh = 2;  // a list that has grown by this factor is rebuilt

// A list is made if one of this many members has left its stored box in one call.
constexpr std::size_t kManyEscaped = 8;

// A chunk takes some ten microseconds.
constexpr std::size_t kMembersPerChunk = 512, kCandidatesPerChunk = 2048;

// Prefetch distance, in members.
constexpr std::size_t kPrefetchDistance = 8;

// Marks beside those of dxPackedBoxes: the slot has a stored box; the box is not within it.
constexpr dxPackedBoxes::Marks kStored = 4, kEscaped = 8;

bool isSame(const dxBounds &a, const dxBounds &b) { return std::memcmp(a.v, b.v, sizeof a.v) == 0; }

// A NaN bound overlaps everything.
dxBounds withoutNaN(dxBounds box) {
    for (int bound = 0; bound < 6; ++bound)
        if (std::isnan(box.v[bound])) box.v[bound] = bound % 2 == 0 ? -dInfinity : dInfinity;
    return box;
}

}  // namespace

// There is no list while it is updated: nothing is left half done if memory runs out.
void dxVerletBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    ++m_calls;
    const bool hadList = m_hasList, isPaused = m_callsWithout > 0;
    m_hasList = false;
    if (!isPaused && !(hadList && noteChanges(members, runner))) {
        countShortList(hadList);
        if (m_callsWithout == 0) makeList(members, runner);
    }
    if (m_callsWithout > 0) {
        --m_callsWithout;
        m_cellGrid.findOverlaps(members, runner, matches);
        return;
    }
    if (m_candidates.size() > m_maxPairs(members.end())) {  // perhaps not all were found
        m_cellGrid.findOverlaps(members, runner, matches);
        return;
    }
    compareCandidates(runner, matches);
    forgetChanges(members);
    m_hasList = true;
}

void dxVerletBroadphase::countShortList(bool hadList) {
    using Threshold = dxBroadphaseThresholds;
    m_shortLists = hadList && m_calls < Threshold::kMinCallsPerList ? m_shortLists + 1 : 0;
    if (m_shortLists < Threshold::kMaxShortLists) return;
    m_shortLists = 0;
    m_callsWithout = Threshold::kCallsWithoutList;
}

void dxVerletBroadphase::makeList(const dxMembers &members, dxTaskRunner &runner) {
    resize(members.end());
    m_grown = members;
    for (Slot slot = 0; slot < members.end(); ++slot) {
        m_boxes.marks(slot) = 0;
        if (members[slot].geom != nullptr) takeMember(members, slot);
    }
    m_candidates.clear();
    m_cellGrid.findOverlaps(m_grown, runner, m_candidates);
    m_freshCandidates = m_candidates.size();
    m_calls = m_growths = 0;
    ++m_lists;
}

void dxVerletBroadphase::takeMember(const dxMembers &members, Slot slot) {
    const bool isChanged = members.isChanged(slot);
    m_boxes.marks(slot) = dxPackedBoxes::kKnown | kStored | (isChanged ? dxPackedBoxes::kChanged : 0);
    m_boxes.set(slot, members[slot].bounds);
    store(slot, boxToStore(members, slot));
    m_grown.setBounds(slot, m_stored[slot]);
    m_grown.markChanged(slot);
    m_starts[slot] = {members[slot].geom, members[slot].bounds};
}

void dxVerletBroadphase::resize(std::size_t slots) {
    m_boxes.resize(slots);
    m_starts.resize(slots);
    m_stored.resize(slots);
    while (m_storedColumns.size() < slots) m_storedColumns.push(dxBounds());
}

void dxVerletBroadphase::store(Slot slot, const dxBounds &box) {
    m_stored[slot] = box;
    m_storedColumns.set(slot, box);
}

// The motion since the last list predicts the next. Members at rest have no skin.
dxBounds dxVerletBroadphase::boxToStore(const dxMembers &members, Slot slot) const {
    const dxBounds &box = members[slot].bounds, &start = m_starts[slot].box;
    const bool isOld = m_starts[slot].geom == members[slot].geom;
    if (!box.isProper()) return withoutNaN(box);
    if (isOld && !members.isChanged(slot) && isSame(box, start)) return box;
    const dReal edge = box.longestEdge();
    dxBounds stored = box.grown(kSkin * edge);
    if (!isOld) return stored;
    const dReal callsPerCall = kPredictedCalls / static_cast<dReal>(m_calls);
    for (int bound = 0; bound < 6; ++bound) {
        const dReal way = std::fmax(-edge, std::fmin(edge, (box.v[bound] - start.v[bound]) * callsPerCall));
        const bool isOutwards = bound % 2 == 0 ? way < 0 : way > 0;
        if (isOutwards) stored.v[bound] += way;
    }
    return stored;
}

bool dxVerletBroadphase::noteChanges(const dxMembers &members, dxTaskRunner &runner) {
    resize(members.end());
    const std::vector<Slot> &changed = members.changed();
    runner.forChunks(dxParallelStage::VerletChanges, changed.size(), kMembersPerChunk,
        [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kPrefetchDistance < end) prefetch(members, changed[i + kPrefetchDistance]);
            noteBox(members, changed[i]);
        }
    });
    m_escaped.clear();
    for (const Slot slot : changed)
        if ((m_boxes.marks(slot) & kEscaped) != 0) m_escaped.push_back(slot);
    if (m_growths + m_escaped.size() > kGrowthsForAList || m_escaped.size() * kManyEscaped > members.end())
        return false;
    const std::size_t longest = kMaxByFresh * (m_freshCandidates + members.end());
    for (const Slot slot : m_escaped) {
        if (m_candidates.size() > longest) return false;
        grow(members, slot);
    }
    return true;
}

void dxVerletBroadphase::prefetch(const dxMembers &members, Slot slot) const {
    members.prefetch(slot);
    m_boxes.prefetchForWrite(slot);
    dxPrefetch::line(&m_stored[slot]);
}

void dxVerletBroadphase::noteBox(const dxMembers &members, Slot slot) {
    dxPackedBoxes::Marks &marks = m_boxes.marks(slot);
    const bool hasStored = (marks & kStored) != 0;
    marks = hasStored ? kStored : 0;
    if (members[slot].geom == nullptr) return;
    const dxBounds &box = members[slot].bounds;
    m_boxes.set(slot, box);
    marks |= dxPackedBoxes::kKnown | dxPackedBoxes::kChanged;
    if (!hasStored || !m_stored[slot].contains(box)) marks |= kEscaped;
}

void dxVerletBroadphase::grow(const dxMembers &members, Slot slot) {
    dxPackedBoxes::Marks &marks = m_boxes.marks(slot);
    const bool hadStored = (marks & kStored) != 0;
    const dxBounds before = m_stored[slot];
    dxBounds grown = boxToStore(members, slot);
    if (hadStored) grown.include(before);
    m_met.resize(m_storedColumns.size());
    const std::size_t met = dxOverlappingRows(m_storedColumns, grown, 0, m_storedColumns.size(), m_met.data());
    for (std::size_t i = 0; i < met; ++i) {
        const Slot other = m_met[i];
        if (other == slot || (m_boxes.marks(other) & kStored) == 0) continue;
        if (!hadStored || !before.overlaps(m_stored[other])) m_candidates.push_back({slot, other});
    }
    store(slot, grown);
    marks = static_cast<dxPackedBoxes::Marks>((marks | kStored) & ~kEscaped);
    ++m_growths;
}

void dxVerletBroadphase::compareCandidates(dxTaskRunner &runner, std::vector<Match> &matches) {
    if (m_found.size() < runner.workers()) m_found.resize(runner.workers());
    for (Found &found : m_found) found.count = 0;
    runner.forChunks(dxParallelStage::VerletCandidates, m_candidates.size(), kCandidatesPerChunk,
        [&](std::size_t begin, std::size_t end, unsigned worker) {
        Found &found = m_found[worker];
        if (found.matches.size() < found.count + (end - begin)) found.matches.resize(2 * found.count + (end - begin));
        found.count += dxOverlappingCandidates(m_boxes, m_candidates.data() + begin, end - begin,
                                               found.matches.data() + found.count);
    });
    for (const Found &found : m_found)
        matches.insert(matches.end(), found.matches.data(), found.matches.data() + found.count);
}

void dxVerletBroadphase::forgetChanges(const dxMembers &members) {
    for (const Slot slot : members.changed())
        m_boxes.marks(slot) = static_cast<dxPackedBoxes::Marks>(m_boxes.marks(slot) & ~dxPackedBoxes::kChanged);
}
