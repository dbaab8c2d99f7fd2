#include "collision/callbacks/dxPairTasks.h"

#include <algorithm>
#include <numeric>

#include "collision/narrowphase/dxHeightField.h"
#include "collision/narrowphase/dxConcurrentColliders.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxNoIndex.h"

namespace {

// Of a pair whose collision may write to it: whether it may write to this geom of the two, or run the user's code for
// it. The others are only read.
bool isWrittenTo(const dxGeom *geom) {
    const int type = geom->type;
    return dxIsHeightField(*geom) || type == dGeomTransformClass || type == dTriMeshClass ||
           type >= dFirstUserClass || dGeomIsSpace(const_cast<dxGeom *>(geom));
}

// Without looking at data that the program has destroyed.
class Readers {
public:
    bool mayCollideAnywhere(const dxOrderedPair &pair) {
        return isThere(pair.first) && isThere(pair.second) && dxMayCollideConcurrently(*pair.first, *pair.second);
    }

private:
    // Most pairs of a terrain follow one another.
    bool isThere(const dxGeom *geom) {
        if (!dxIsHeightField(*geom)) return true;
        const dxHeightfieldData *const data = dxHeightsOf(*geom);
        if (data == m_data) return m_isThere;
        m_data = data;
        return m_isThere = dxLiveHeightfields::has(data);
    }

    const dxHeightfieldData *m_data = nullptr;
    bool m_isThere = false;
};

}  // namespace

void dxPairTasks::cut(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *search, unsigned wanted,
                      bool sharingBodies) {
    Readers readers;
    const auto mayBeAnywhere = [&readers](const dxOrderedPair &pair) { return readers.mayCollideAnywhere(pair); };
    if (sharingBodies && search == nullptr && std::all_of(pairs.begin(), pairs.end(), mayBeAnywhere))
        cutAnywhere(wanted, static_cast<std::uint32_t>(pairs.size()));
    else
        cutBetweenSets(pairs, search, wanted, sharingBodies);
}

// As they come: neighbours in the order of pairs are mostly neighbours in memory.
void dxPairTasks::cutAnywhere(unsigned wanted, std::uint32_t pairs) {
    m_tasks.clear();
    for (std::uint64_t task = 0; task < wanted; ++task)
        m_tasks.push_back({static_cast<std::uint32_t>(task * pairs / wanted),
                           static_cast<std::uint32_t>((task + 1) * pairs / wanted)});
    m_order.resize(pairs);
    std::iota(m_order.begin(), m_order.end(), std::uint32_t{0});
}

void dxPairTasks::cutBetweenSets(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *search, unsigned wanted,
                                 bool sharingBodies) {
    Slot end = 0;
    for (const dxOrderedPair &pair : pairs) end = std::max({end, pair.slots[0] + 1, pair.slots[1] + 1});
    m_sets.reset(end);
    m_exclusive.assign(end, 0);
    m_isTied.assign(end, 0);
    m_isSharingBodies = sharingBodies;
    if (!pairs.empty()) m_space = pairs.front().first->parent_space;
    m_memory.reset(end);
    for (const dxOrderedPair &pair : pairs) {
        m_memory.look(pair.first, pair.slots[0]);
        m_memory.look(pair.second, pair.slots[1]);
    }
    m_memory.sort();
    Readers readers;
    for (const dxOrderedPair &pair : pairs)
        if (!readers.mayCollideAnywhere(pair)) markWritten(pair);
    if (!sharingBodies)
        for (const dxOrderedPair &pair : pairs) {
            tieBody(pair.first, pair.slots[0]);
            tieBody(pair.second, pair.slots[1]);
        }
    uniteSharedMemory();
    uniteExclusive(pairs);
    if (search != nullptr) uniteGroups(pairs, *search);
    sizeSets(pairs);
    shareOut(wanted, pairs.size());
}

// Upstream's height fields transform the other geom, and its body with it, while they collide it: every geom with a
// pose.
void dxPairTasks::markWritten(const dxOrderedPair &pair) {
    for (int i = 0; i < 2; ++i) {
        const dxGeom *const geom = i == 0 ? pair.first : pair.second;
        const bool isTurned = m_memory.hasHeights(pair.slots[1 - i]) && (geom->gflags & GEOM_PLACEABLE) != 0;
        if (isTurned || isWrittenTo(geom)) m_exclusive[pair.slots[i]] = 1;
        tieBody(geom, pair.slots[i]);
    }
}

// All pairs of the geom's body belong together; of a nested space, those of all bodies in it. What a body's geoms have in
// common is found by its list of them: nothing is written to the body, whose geoms in another space another thread of the
// user's may be colliding.
void dxPairTasks::tieBody(const dxGeom *geom, Slot slot) {
    if (m_isTied[slot]) return;
    if (IS_SPACE(geom)) {
        m_isTied[slot] = 1;
        if (!m_isSharingBodies) tieNested(geom, slot);
    } else if (geom->body != nullptr) {
        m_isTied[slot] = m_exclusive[slot] = 1;
        uniteGeomsOf(geom->body, slot);
    }
}

void dxPairTasks::tieNested(const dxGeom *space, Slot slot) {
    dBodyID done = nullptr;  // most often the geoms of a body are neighbours
    for (const dxGeom *geom = static_cast<const dxSpace *>(space)->first; geom != nullptr; geom = geom->next) {
        if (IS_SPACE(geom))
            tieNested(geom, slot);
        else if (geom->body != done && geom->body != nullptr)
            uniteGeomsOf(done = geom->body, slot);
    }
}

// By the members of the space that its geoms are, or are nested in.
void dxPairTasks::uniteGeomsOf(dBodyID body, Slot slot) {
    for (const dxGeom *geom = body->geom; geom != nullptr; geom = geom->body_next) {
        const dxGeom *member = geom;
        while (member != nullptr && member->parent_space != m_space) member = member->parent_space;
        if (member == nullptr) continue;
        const Slot other = dxOrderedSpace::slotOf(member);
        if (other == slot || other >= m_exclusive.size()) continue;  // it has no pairs
        m_exclusive[slot] = m_exclusive[other] = 1;
        if (member == geom) m_isTied[other] = 1;
        m_sets.unite(slot, other);
    }
}

void dxPairTasks::uniteExclusive(const std::vector<dxOrderedPair> &pairs) {
    for (const dxOrderedPair &pair : pairs)
        if (m_exclusive[pair.slots[0]] && m_exclusive[pair.slots[1]]) m_sets.unite(pair.slots[0], pair.slots[1]);
}

// Memory that is only read, by colliders that have copies of what they write to, belongs to no task.
void dxPairTasks::uniteSharedMemory() {
    const std::vector<dxColliderMemory::Use> &uses = m_memory.uses();
    for (std::size_t i = 0, end; i < uses.size(); i = end) {
        bool isWritten = false;
        for (end = i; end < uses.size() && uses[end].memory == uses[i].memory; ++end)
            isWritten = isWritten || m_exclusive[uses[end].slot];
        for (std::size_t k = i; isWritten && k < end; ++k) {
            m_exclusive[uses[k].slot] = 1;
            m_sets.unite(uses[i].slot, uses[k].slot);
        }
    }
}

void dxPairTasks::uniteGroups(const std::vector<dxOrderedPair> &pairs, const dxBroadphase &search) {
    std::vector<std::uint32_t> firstOfGroup;
    for (const dxOrderedPair &pair : pairs)
        for (const Slot slot : pair.slots) {
            const int group = m_exclusive[slot] ? search.groupOf(slot) : dxBroadphase::kNoGroup;
            if (group == dxBroadphase::kNoGroup) continue;
            const auto index = static_cast<std::size_t>(group);
            if (index >= firstOfGroup.size()) firstOfGroup.resize(index + 1, kNoIndex);
            std::uint32_t &first = firstOfGroup[index];
            if (first == kNoIndex) first = slot;
            m_sets.unite(first, slot);
        }
}

dxPairTasks::Slot dxPairTasks::ownerOf(const dxOrderedPair &pair) const {
    return m_exclusive[pair.slots[0]] || !m_exclusive[pair.slots[1]] ? pair.slots[0] : pair.slots[1];
}

void dxPairTasks::sizeSets(const std::vector<dxOrderedPair> &pairs) {
    m_setOfPair.resize(pairs.size());
    m_sizeOfSet.assign(m_exclusive.size(), 0);
    m_usedSets.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::uint32_t set = m_setOfPair[i] = m_sets.find(ownerOf(pairs[i]));
        if (m_sizeOfSet[set]++ == 0) m_usedSets.push_back(set);
    }
}

// Large sets first, each a task of its own; small ones are combined in order until they are as large as a task should
// be.
void dxPairTasks::shareOut(unsigned wanted, std::size_t pairs) {
    const std::size_t least = pairs / wanted + 1;
    m_taskOfSet.assign(m_exclusive.size(), kNoIndex);
    m_tasks.clear();
    m_largeSets.clear();
    for (const std::uint32_t set : m_usedSets)
        if (m_sizeOfSet[set] >= least) m_largeSets.push_back(set);
    std::sort(m_largeSets.begin(), m_largeSets.end(),
              [&](std::uint32_t a, std::uint32_t b) { return m_sizeOfSet[a] > m_sizeOfSet[b]; });
    for (const std::uint32_t set : m_largeSets) addToTask(set, true);
    std::size_t size = least;  // of the last task
    for (const std::uint32_t set : m_usedSets) {
        if (m_sizeOfSet[set] >= least) continue;
        addToTask(set, size >= least);
        size = m_tasks.back().end;
    }
    sortIntoTasks(pairs);
}

// While tasks are combined, their ends hold their sizes.
void dxPairTasks::addToTask(std::uint32_t set, bool isFirst) {
    if (isFirst) m_tasks.push_back({0, 0});
    m_taskOfSet[set] = static_cast<std::uint32_t>(m_tasks.size() - 1);
    m_tasks.back().end += m_sizeOfSet[set];
}

void dxPairTasks::sortIntoTasks(std::size_t pairs) {
    std::uint32_t begin = 0;
    m_fill.clear();
    for (Task &task : m_tasks) {
        task = {begin, begin + task.end};
        m_fill.push_back(begin);
        begin = task.end;
    }
    m_order.resize(pairs);
    for (std::uint32_t i = 0; i < pairs; ++i) m_order[m_fill[m_taskOfSet[m_setOfPair[i]]]++] = i;
}
