#include "collision/callbacks/dxPairTasks.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "collision/narrowphase/dxConcurrentColliders.h"
#include "collision/narrowphase/dxHeightField.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxNoIndex.h"

namespace {

// Returns whether colliders may write to this geom, or run the user's code for it. Requires a geom of a pair that may not be collided
// concurrently.
bool isWrittenTo(const dxGeom *geom) {
    const int type = geom->type;
    return dxIsHeightField(*geom) || type == dGeomTransformClass || type == dTriMeshClass ||
           type >= dFirstUserClass || dGeomIsSpace(const_cast<dxGeom *>(geom));
}

// Finds the pairs that may be collided on any thread, without access to data that the program has destroyed.
class ConcurrentPairs {
public:
    bool has(const dxOrderedPair &pair) {
        return isThere(pair.first) && isThere(pair.second) && dxMayCollideConcurrently(*pair.first, *pair.second);
    }

private:
    // Keeps the last answer, because most pairs of a terrain are neighbours in the order.
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

void dxColliderMemory::reset(Slot end) {
    m_members.assign(end, 0);
    m_uses.clear();
}

void dxColliderMemory::add(const dxGeom *member, Slot slot) {
    if ((m_members[slot] & kAdded) != 0) return;
    m_members[slot] |= kAdded;
    addUses(member, slot);
}

// Leaves out disabled geoms in nested spaces: they are never collided, and the geoms of their transforms may have been destroyed.
void dxColliderMemory::addUses(const dxGeom *geom, Slot slot) {
    if (dxIsHeightField(*geom)) {
        m_members[slot] |= kHasHeights;
        m_uses.push_back({dxHeightsOf(*geom), slot});
    } else if (geom->type == dGeomTransformClass) {
        const dxGeom *const inner = dGeomTransformGetGeom(const_cast<dxGeom *>(geom));
        if (inner == nullptr) return;
        m_uses.push_back({inner, slot});
        addUses(inner, slot);
    } else if (IS_SPACE(geom)) {
        for (const dxGeom *inner = static_cast<const dxSpace *>(geom)->first; inner != nullptr; inner = inner->next)
            if ((inner->gflags & GEOM_ENABLED) != 0) addUses(inner, slot);
    }
}

void dxColliderMemory::sort() {
    std::sort(m_uses.begin(), m_uses.end(), [](const Use &a, const Use &b) {
        return a.memory != b.memory ? std::less<const void *>()(a.memory, b.memory) : a.slot < b.slot;
    });
}

void dxPairTasks::cut(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *broadphase, unsigned wanted,
                      bool sharingBodies) {
    ConcurrentPairs concurrent;
    const auto isConcurrent = [&concurrent](const dxOrderedPair &pair) { return concurrent.has(pair); };
    if (sharingBodies && broadphase == nullptr && std::all_of(pairs.begin(), pairs.end(), isConcurrent))
        cutInOrder(wanted, static_cast<std::uint32_t>(pairs.size()));
    else
        cutBetweenSets(pairs, broadphase, wanted, sharingBodies);
}

// Pairs that are neighbours in the order are mostly neighbours in memory.
void dxPairTasks::cutInOrder(unsigned wanted, std::uint32_t pairs) {
    m_tasks.clear();
    for (std::uint64_t task = 0; task < wanted; ++task)
        m_tasks.push_back({static_cast<std::uint32_t>(task * pairs / wanted),
                           static_cast<std::uint32_t>((task + 1) * pairs / wanted)});
    m_order.resize(pairs);
    std::iota(m_order.begin(), m_order.end(), std::uint32_t{0});
}

void dxPairTasks::cutBetweenSets(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *broadphase, unsigned wanted,
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
        m_memory.add(pair.first, pair.slots[0]);
        m_memory.add(pair.second, pair.slots[1]);
    }
    m_memory.sort();
    ConcurrentPairs concurrent;
    for (const dxOrderedPair &pair : pairs)
        if (!concurrent.has(pair)) markWritten(pair);
    if (!sharingBodies)
        for (const dxOrderedPair &pair : pairs) {
            tieBody(pair.first, pair.slots[0]);
            tieBody(pair.second, pair.slots[1]);
        }
    uniteSharedMemory();
    uniteExclusive(pairs);
    if (broadphase != nullptr) uniteGroups(pairs, *broadphase);
    sizeSets(pairs);
    assignTasks(wanted, pairs.size());
}

// Upstream's height fields transform the other geom, and its body with it, while they collide it, if it has a pose.
void dxPairTasks::markWritten(const dxOrderedPair &pair) {
    for (int i = 0; i < 2; ++i) {
        const dxGeom *const geom = i == 0 ? pair.first : pair.second;
        const bool isTransformed = m_memory.hasHeights(pair.slots[1 - i]) && (geom->gflags & GEOM_PLACEABLE) != 0;
        if (isTransformed || isWrittenTo(geom)) m_exclusive[pair.slots[i]] = 1;
        tieBody(geom, pair.slots[i]);
    }
}

// Unites all pairs of the geom's body; of a nested space, those of all bodies in it. The body's list of geoms is read, and nothing is written
// to the body: another thread of the user's may be colliding its geoms in another space.
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
    dBodyID done = nullptr;  // the geoms of a body are mostly neighbours
    for (const dxGeom *geom = static_cast<const dxSpace *>(space)->first; geom != nullptr; geom = geom->next) {
        if (IS_SPACE(geom))
            tieNested(geom, slot);
        else if (geom->body != done && geom->body != nullptr)
            uniteGeomsOf(done = geom->body, slot);
    }
}

// Finds the members of the space that are geoms of the body or contain one.
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

// Memory that is only read, because colliders write to copies, belongs to no task.
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

void dxPairTasks::uniteGroups(const std::vector<dxOrderedPair> &pairs, const dxBroadphase &broadphase) {
    std::vector<std::uint32_t> firstOfGroup;
    for (const dxOrderedPair &pair : pairs)
        for (const Slot slot : pair.slots) {
            const int group = m_exclusive[slot] ? broadphase.groupOf(slot) : dxBroadphase::kNoGroup;
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

// Each large set becomes a task of its own, the largest first. Small sets are combined in order until they reach the size of a task.
void dxPairTasks::assignTasks(unsigned wanted, std::size_t pairs) {
    const std::size_t minSize = pairs / wanted + 1;
    m_taskOfSet.assign(m_exclusive.size(), kNoIndex);
    m_tasks.clear();
    m_largeSets.clear();
    for (const std::uint32_t set : m_usedSets)
        if (m_sizeOfSet[set] >= minSize) m_largeSets.push_back(set);
    std::sort(m_largeSets.begin(), m_largeSets.end(),
              [&](std::uint32_t a, std::uint32_t b) { return m_sizeOfSet[a] > m_sizeOfSet[b]; });
    for (const std::uint32_t set : m_largeSets) addToTask(set, true);
    std::size_t size = minSize;  // of the last task
    for (const std::uint32_t set : m_usedSets) {
        if (m_sizeOfSet[set] >= minSize) continue;
        addToTask(set, size >= minSize);
        size = m_tasks.back().end;
    }
    sortIntoTasks(pairs);
}

// Until sortIntoTasks(), the end of a task holds its size.
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
