// The cleaner of sweep-and-prune spaces, which keep their geoms in two lists (dxSapLists): a member's rank follows from its place among the clean
// ones.
//
// The cleaner also chooses whether calls walk: a walk sorts and sweeps as upstream does, and needs neither ranks nor boxes of members.
// Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"
#include "collision/spaces/sweep_and_prune/dxSapState.h"
#include "collision/spaces/sweep_and_prune/dxSapWalk.h"

// The members of a sweep-and-prune space in the two lists that upstream keeps: the dirty ones in the order in which they became dirty, and the clean
// ones. When an entry is removed, the last one of its list takes its place.
//
// Both orders are visible to programs: in dSpaceGetGeom, in the callbacks of dSpaceCollide2, and in the order of geoms with equal bounds.
class dxSapLists {
public:
    using Slot = dxMembers::Slot;

    struct Entry {
        dxGeom *geom;
        Slot slot;
    };

    const std::vector<Entry> &dirty() const { return m_dirty; }
    const std::vector<Entry> &clean() const { return m_clean; }

    bool isDirty(Slot slot) const { return m_places[slot].isDirty; }
    // Returns the index of a member in its list.
    std::size_t placeOf(Slot slot) const { return m_places[slot].index; }

    // Reserves memory for members in the slots below `slots`; the other functions then allocate nothing.
    void reserveMemory(Slot slots);
    // Appends a member to the dirty ones.
    void add(Slot slot, dxGeom *geom);
    void remove(Slot slot);
    // Moves a clean member behind the dirty ones.
    void makeDirty(Slot slot);
    // Moves the dirty ones behind the clean ones.
    void cleanAll();

private:
    struct Place {
        std::uint32_t index;
        bool isDirty;
    };

    void append(const Entry &entry, bool isDirty);

    std::vector<Entry> m_dirty, m_clean;
    std::vector<Place> m_places;  // by slot
};

class dxSapCleaner final : public dxSpaceCleaner {
public:
    dxSapCleaner(dxSpaceGeoms &geoms, dxSpacePairs &pairs, dxSapState &state, dxSapLastWalk &lastWalk)
        : m_geoms(geoms), m_pairs(pairs), m_state(state), m_lastWalk(lastWalk) {}

    const dxSapLists &lists() const { return m_lists; }
    // dxSpace::cleanGeoms().
    void clean();
    // dxSpace::dirty().
    void makeDirty(dxGeom *geom);
    // Ends walks: sets boxes and ranks of the clean members. Dirty members get theirs when they are cleaned.
    void stopWalking();

    void reserveMemory(Slot slots) override;
    void onAdded(dxGeom *geom, Slot slot) override;
    void onRemoved(Slot slot) override;
    bool cleanToCollide() override;
    bool readAgain() override;

private:
    void chooseToWalk();
    bool isServedByLastWalk(int moved) const;
    void cleanAndRank();
    void setBoxAndRank(dxGeom *geom, dxRank rank);
    dxBounds boundsOf(const dxGeom *geom, const dxSapBox &box) const;
    void rankSuccessor(Slot slot, std::size_t place);
    bool hasUncleanBox() const;

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    dxSapState &m_state;
    dxSapLastWalk &m_lastWalk;
    dxSapLists m_lists;
    std::vector<dxGeom *> m_toClean;
    bool m_isMessedUp = false;  // upstream's word: a cleaning was nested in another one, or was left before its end
};
