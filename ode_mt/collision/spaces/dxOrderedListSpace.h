// Base of the spaces in which upstream walks a list of geoms: the simple and the hash space.
//
// Upstream moves a geom to the front of its list when it changes, and only then. Of two members, the one with the
// higher rank is further to the front.
#pragma once

#include <climits>
#include <cstdint>
#include <vector>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxSoleCleaner.h"
#include "collision/spaces/dxWalking.h"
#include "core/dxPublished.h"

class dxOrderedListSpace : public dxOrderedSpace {
public:
    void cleanGeoms() override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

protected:
    using dxOrderedSpace::dxOrderedSpace;

    // Whether nothing but upstream's list is needed: this call walks it, whatever moves.
    bool isWalkedOnly() const {
        return m_walking && count <= dxBroadphaseThresholds::kMaxAlwaysWalked && mayWalk() && !m_isInterrupted && isSureOfMembers();
    }
    bool hasDirty() const { return first != nullptr && (first->gflags & GEOM_DIRTY) != 0; }
    // Whether no geom is to be cleaned, nor is being cleaned by another thread, which has begun with the first.
    bool isClean() const {
        if (hasDirty()) return false;
        std::atomic_thread_fence(std::memory_order_acquire);
        return !m_isInterrupted;
    }
    // As upstream does. Requires a locked space and isWalkedOnly().
    void cleanWalked();
    void cleanToCollide() override;
    bool isLeftOut(Slot slot) const override;
    bool requireRanks() override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;
    bool hasStrayMembers() const override;
    void reserveMemory(Slot slots) override;
    void comes(dxGeom *geom, Slot slot) override;

private:
    bool isAtRest() const;
    void cleanAlone();
    // Returns whether ranks represent the list and all boxes that upstream would read are up to date.
    bool ranksStand() const { return !m_walking && !m_hasBadBox; }
    int minMovedToWalk() const { return mayWalk() ? dxMinMovedToWalk(pairOrder(), count) : INT_MAX; }
    void gatherDirty();
    void cleanDirty();
    int cleanFrom(dxGeom *geom);
    void cleanBehind(dxGeom *geom);
    void rankAll();
    void chooseToWalk();
    void stopWalking();
    void rankBehindClean(dxGeom *geom, dxRank rank);

    dxWalking m_walking;
    // A cleaning has begun and not ended: it is in progress, or a jump left it.
    dxPublished<bool> m_isInterrupted{false};
    // There may be dirty geoms behind clean ones, or the list is walked.
    dxPublished<bool> m_isIrregular{false};
    bool m_hasBadBox = false;  // one of those dirty geoms has a box that is not up to date
    std::vector<dxGeom *> m_dirty;  // front first; those of the last call, until others are gathered, some of which may be gone
    std::vector<Slot> m_dirtySlots;  // of a cleaning on workers
    std::uint64_t m_cleanings = 0;
    dxSoleCleaner m_cleaner;
};
