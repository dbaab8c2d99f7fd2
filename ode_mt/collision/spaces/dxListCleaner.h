// The cleaner of the spaces in which upstream walks a list of geoms, the simple and the hash space; and their queries (dxListQuery).
//
// Upstream moves a geom to the front of its list when it changes, and only then. It cleans from the front on, and stops at the first geom that is
// clean. Of two members, the one with the higher rank is further to the front.
//
// Threading: cleanToCollide() on one thread; several threads may call clean(), as queries do. One of them, the cleaner, cleans; the others wait for a
// limited time, because the cleaner may be in a bounding-box function of the user's that waits for something else, may have left it by a jump, or may
// not exist in this process after a fork. A thread that has left by a jump remains the cleaner, and may clean again, until cleanToCollide().
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
    // Cleans as upstream does, without ranks. Requires a locked space and isWalkedOnly().
    void cleanWalked();

    void reserveMemory(Slot slots) override;
    void onAdded(dxGeom *geom, Slot slot) override;
    void onRemoved(Slot /*slot*/) override {}
    bool cleanToCollide() override;
    bool readAgain() override;

    bool hasDirty() const { return first() != nullptr && (first()->gflags & GEOM_DIRTY) != 0; }
    // Returns whether there is no geom to clean and no cleaning is in progress. (A cleaning on another thread begins with the first geom.)
    bool isClean() const {
        if (hasDirty()) return false;
        std::atomic_thread_fence(std::memory_order_acquire);
        return !m_isInterrupted;
    }
    // Returns whether cleaning would change nothing. Several threads may ask at the same time.
    bool isAtRest() const;
    // Returns whether ranks represent the list and all boxes that upstream would read are up to date.
    bool areRanksValid() const { return !m_geoms.walking() && !m_hasBadBox; }
    // Returns whether a call needs nothing but upstream's list, because it walks the list whatever moves.
    bool isWalkedOnly() const {
        return m_geoms.walking() && m_geoms.count() <= dxBroadphaseThresholds::kMaxAlwaysWalked && m_geoms.mayWalk() && !m_isInterrupted &&
               m_geoms.isSure();
    }
    // Ends walks: assigns ranks to all members.
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
    // A cleaning has begun and not ended: it is in progress, or was left by a jump.
    dxPublished<bool> m_isInterrupted{false};
    // There may be dirty geoms behind clean ones, or the list is walked.
    dxPublished<bool> m_isIrregular{false};
    bool m_hasBadBox = false;        // one of those dirty geoms has a box that is not up to date
    std::vector<dxGeom *> m_dirty;   // front first; between calls those of the last call, some of which may have been destroyed
    std::vector<Slot> m_dirtySlots;  // scratch of a cleaning on workers
    std::uint64_t m_cleanings = 0;
    std::atomic<std::thread::id> m_cleaningThread{};
};

// dSpaceCollide2 in both kinds of spaces.
namespace dxListQuery {

// Executes upstream's collide2 for a space that is clean and does not need an index, without a look at what is kept of its members. For other spaces,
// or while another thread is cleaning, it returns false and does nothing.
bool collideAll(dxSpaceGeoms &geoms, const dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback);

// dxSpaceWalker::collideWith().
void collideWith(dxSpaceGeoms &geoms, dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback);

}  // namespace dxListQuery
