#include "collision/spaces/dxSpaceGeoms.h"

#include <algorithm>

#include "collision/pairs/dxPairPrefetch.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxNoIndex.h"
#include "threading/dxUpstreamScope.h"

namespace {

// Geoms in a chunk: some ten microseconds of work.
constexpr std::size_t kBoxesPerChunk = 128;

// Prefetch distance, in geoms.
constexpr std::size_t kBoxPrefetchDistance = 4;

// Returns whether cleaning the geom, or a geom within it, may run a function of the user's.
bool mayRunUserCode(const dxGeom *geom) { return geom->type >= dFirstUserClass || geom->type == dGeomTransformClass || IS_SPACE(geom); }

}  // namespace

dxSpaceGeoms::Slot dxSpaceGeoms::add(dxGeom *geom) {
    m_cleaner.reserveMemory(m_members.end() + 1);
    const Slot slot = m_members.add(geom);
    m_members.setPresence(slot, dxGeomIsEnabled(geom));
    geom->tome_ex = reinterpret_cast<dxGeom **>(static_cast<std::uintptr_t>(slot) + 1);
    m_cleaner.onAdded(geom, slot);
    return slot;
}

void dxSpaceGeoms::remove(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_cleaner.onRemoved(slot);
    geom->tome_ex = nullptr;
    m_members.remove(slot);
    m_index.drop(slot);
}

void dxSpaceGeoms::release() {
    for (Slot slot = 0; slot < m_members.end(); ++slot)
        if (dxGeom *const geom = m_members.geomIn(slot)) geom->tome_ex = nullptr;
}

// All geoms must be of built-in classes, whose boxes depend only on the geoms, their data and their bodies. A function of the user's may change
// these, or leave by a jump, and geoms behind it would have boxes that upstream has not computed.
bool dxSpaceGeoms::computeBoxes(const std::vector<dxGeom *> &geoms) {
    if (m_runner == nullptr || geoms.size() < kBoxesPerChunk) return false;
    if (std::any_of(geoms.begin(), geoms.end(), mayRunUserCode)) return false;
    std::atomic<bool> areAll{true};
    m_runner->forChunks(dxParallelStage::Boxes, geoms.size(), kBoxesPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kBoxPrefetchDistance < end) dxPairPrefetch::pose(geoms[i + kBoxPrefetchDistance]);
            try {
                const dxInterruptingScope scope;
                geoms[i]->recomputeAABB();
            } catch (const dxUpstreamInterrupted &) {  // an assertion, which fails again in clean()
                areAll.store(false, std::memory_order_relaxed);
            }
        }
    });
    return areAll.load(std::memory_order_relaxed);
}

void dxSpaceGeoms::cleanComputed(const std::vector<dxGeom *> &geoms, dxRank first, std::vector<Slot> &slots) {
    slots.resize(geoms.size());
    m_runner->forChunks(dxParallelStage::Boxes, geoms.size(), kBoxesPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kBoxPrefetchDistance < end) m_members.prefetch(slotOf(geoms[i + kBoxPrefetchDistance]));
            dxGeom *const geom = geoms[i];
            const Slot slot = slotOf(geom);
            geom->gflags &= ~GEOM_DIRTY;
            const bool isPlaced =
                m_members.place(slot, first - static_cast<dxRank>(i), dxBounds(geom->aabb), dxFilterOf(geom), dxGeomIsEnabled(geom));
            slots[i] = isPlaced ? slot : kNoIndex;
        }
    });
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        if (slots[i] == kNoIndex) {
            rank(geoms[i], first - static_cast<dxRank>(i));
        } else {
            m_members.moved(slots[i]);
            m_index.loosen(slots[i], m_members[slots[i]].bounds);
            ++m_changes;
        }
    }
}

void dxSpaceGeoms::clean(const std::vector<dxGeom *> &geoms, std::size_t index) {
    if (index + kBoxPrefetchDistance < geoms.size()) dxPairPrefetch::pose(geoms[index + kBoxPrefetchDistance]);
    clean(geoms[index]);
}

void dxSpaceGeoms::clean(dxGeom *geom) {
    m_runner = nullptr;  // until resumeRunner(): a function of the user's may run
    if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
    geom->recomputeAABB();
    geom->gflags &= ~GEOM_DIRTY;
}

void dxSpaceGeoms::rank(dxGeom *geom, dxRank rank, const dxBounds &bounds) {
    const Slot slot = slotOf(geom);
    m_members.setRank(slot, rank);
    m_members.setPresence(slot, dxGeomIsEnabled(geom));  // a geom without a size counts as disabled
    m_members.setBounds(slot, bounds, dxFilterOf(geom));
    m_members.markChanged(slot);
    m_index.loosen(slot, bounds);
    ++m_changes;
}

bool dxSpaceGeoms::isWorthWalking(int moved, std::size_t comparisons) const {
    dxBroadphaseFacts facts;
    facts.order = m_order;
    facts.current = m_walking ? dxBroadphaseKind::ListWalk : dxBroadphaseKind::None;
    facts.mayWalk = mayWalk();
    facts.geoms = count();
    facts.moved = moved;
    facts.comparisons = comparisons;
    return dxChooseBroadphase(facts) == dxBroadphaseKind::ListWalk;
}

void dxSpaceGeoms::lookForStaleGeoms() {
    const std::unique_lock<std::mutex> alone(m_lookingForStaleGeoms, std::try_to_lock);
    if (!alone) return;
    const std::uint64_t missed = dxMissedNotifications.count();
    bool hasStaleGeoms = m_cleaner.readAgain();
    for (dxGeom *geom = m_space.first; geom != nullptr && !hasStaleGeoms; geom = geom->next) {
        dxOrderedSpace *const inner = IS_SPACE(geom) ? dxOrderedSpace::from(static_cast<dxSpace *>(geom)) : nullptr;
        hasStaleGeoms = inner != nullptr && inner->hasStaleGeoms();
    }
    m_hasStaleGeoms.store(hasStaleGeoms, std::memory_order_relaxed);
    m_notificationsMissed.store(missed, std::memory_order_release);
}

void dxSpaceGeoms::noteStaleGeoms() {
    m_hasStaleGeoms.store(true, std::memory_order_relaxed);
    if (m_space.parent_space != nullptr) dxMissedNotifications.add();
}

void dxSpaceGeoms::filtersChanged(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_members.setFilter(slot, dxFilterOf(geom));
    m_members.markChanged(slot);
    ++m_changes;
}

void dxSpaceGeoms::enabledChanges(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_members.noteSwitch(slot);
    ++m_changes;
    ++m_switches;
    if (isLeftOut(slot)) ++m_reenabled;
}

bool dxSpaceGeoms::applySwitches() {
    if (m_space.lock_count > 1) return false;
    for (const Slot slot : m_members.switched())
        if (const dxGeom *const geom = m_members.geomIn(slot)) m_members.setPresence(slot, dxGeomIsEnabled(geom));
    m_members.forgetSwitches();
    return true;
}
