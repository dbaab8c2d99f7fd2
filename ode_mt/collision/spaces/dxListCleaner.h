// The cleaner of the spaces in which upstream walks a list of geoms: the simple and the hash space.
//
// Upstream moves a geom to the front of its list when it changes, and only then. It cleans from the front on, and stops at the first geom that is
// clean. Of two members, the one with the higher rank is further to the front.
//
// Threading: cleanToCollide() on one thread; several threads may call clean(), as queries do. One of them cleans, and the others wait for a limited
// time: it may be in a bounding-box function of the user's that waits for something else, may have left it by a jump, or be a thread that a fork has
// left behind. A thread that has left by a jump stays the cleaner, and may clean again, until cleanToCollide().
#pragma once

#include <atomic>
#include <climits>
#include <cstdint>
#include <thread>
#include <vector>

#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpaceParts.h"
#include "core/dxPublished.h"

class dxListCleaner final : public dxSpaceCleaner {
public:
    explicit dxListCleaner(dxSpaceGeoms &geoms) : m_geoms(geoms) {}

    // dxSpace::cleanGeoms().
    void clean();
    // The same as upstream does, without ranks. Requires a locked space and isWalkedOnly().
    void cleanWalked();

    void reserveMemory(Slot slots) override;
    void onAdded(dxGeom *geom, Slot slot) override;
    void onRemoved(Slot /*slot*/) override {}
    bool cleanToCollide() override;
    bool readAgain() override;

    bool hasDirty() const { return first() != nullptr && (first()->gflags & GEOM_DIRTY) != 0; }
    // Whether no geom is to be cleaned, nor is being cleaned by another thread, which has begun with the first.
    bool isClean() const {
        if (hasDirty()) return false;
        std::atomic_thread_fence(std::memory_order_acquire);
        return !m_isInterrupted;
    }
    // Returns whether cleaning would change nothing: several threads may ask so at the same time.
    bool isAtRest() const;
    // Returns whether ranks represent the list and all boxes that upstream would read are up to date.
    bool ranksStand() const { return !m_geoms.walking() && !m_hasBadBox; }
    // Whether nothing but upstream's list is needed: this call walks it, whatever moves.
    bool isWalkedOnly() const {
        return m_geoms.walking() && m_geoms.count() <= dxBroadphaseThresholds::kMaxAlwaysWalked && m_geoms.mayWalk() && !m_isInterrupted &&
               m_geoms.isSure();
    }
    // Gives ranks, until many geoms move again.
    void stopWalking();

private:
    // Number of attempts: some milliseconds, in which ten thousand geoms are cleaned.
    static constexpr int kMaxAttempts = 10000;

    dxGeom *first() const { return m_geoms.space().first; }
    bool becomeCleaner();
    void dismissCleaner() { m_cleaningThread.store(std::thread::id(), std::memory_order_release); }
    void cleanAlone();
    int minMovedToWalk() const { return m_geoms.mayWalk() ? dxMinMovedToWalk(m_geoms.pairOrder(), m_geoms.count()) : INT_MAX; }
    void gatherDirty();
    void cleanDirty();
    int cleanFrom(dxGeom *geom);
    void cleanBehind(dxGeom *geom);
    void rankAll();
    void chooseToWalk();
    void rankBehindClean(dxGeom *geom, dxRank rank);

    dxSpaceGeoms &m_geoms;
    // A cleaning has begun and not ended: it is in progress, or a jump left it.
    dxPublished<bool> m_isInterrupted{false};
    // There may be dirty geoms behind clean ones, or the list is walked.
    dxPublished<bool> m_isIrregular{false};
    bool m_hasBadBox = false;  // one of those dirty geoms has a box that is not up to date
    std::vector<dxGeom *> m_dirty;  // front first; those of the last call, until others are gathered, some of which may be gone
    std::vector<Slot> m_dirtySlots;  // of a cleaning on workers
    std::uint64_t m_cleanings = 0;
    std::atomic<std::thread::id> m_cleaningThread{};
};

// What both kinds of spaces do in dSpaceCollide2.
namespace dxListQuery {

// As upstream's collide2, from a member on. Returns how many members it has met.
std::size_t collideFrom(dxGeom *member, void *data, dxGeom *geom, dNearCallback *callback);

// collide2() of a space that is clean and worth no index: as upstream, whatever is known of the members. Returns false, and does nothing, for
// another space, also one that another thread is cleaning.
bool collideAll(dxSpaceGeoms &geoms, const dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback);

// dxSpaceWalker::collideWith().
void collideWith(dxSpaceGeoms &geoms, dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback);

}  // namespace dxListQuery
