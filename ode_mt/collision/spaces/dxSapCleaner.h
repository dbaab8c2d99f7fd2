// The cleaner of sweep-and-prune spaces, which keep their geoms in two arrays (dxSapLists): a member's rank follows from its place among the
// clean ones.
//
// It also chooses whether calls walk: a walk sorts and sweeps as upstream does, and needs neither ranks nor boxes of members.
// Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <vector>

#include "collision/spaces/dxSapLists.h"
#include "collision/spaces/dxSapState.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"

class dxSapCleaner final : public dxSpaceCleaner {
public:
    dxSapCleaner(dxSpaceGeoms &geoms, dxSpacePairs &pairs, dxSapState &state) : m_geoms(geoms), m_pairs(pairs), m_state(state) {}

    const dxSapLists &lists() const { return m_lists; }
    // dxSpace::cleanGeoms().
    void clean();
    // dxSpace::dirty().
    void makeDirty(dxGeom *geom);
    // Takes boxes and gives ranks. The members that are dirty get theirs when they are cleaned.
    void stopWalking();

    void reserveMemory(Slot slots) override;
    void onAdded(dxGeom *geom, Slot slot) override;
    void onRemoved(Slot slot) override;
    bool cleanToCollide() override;
    bool readAgain() override;

private:
    void chooseToWalk();
    bool isServedBySweep(int moved) const;
    void cleanAndRank();
    void takeBox(dxGeom *geom, dxRank rank);
    dxBounds boundsOf(const dxGeom *geom, const dxSapBox &box) const;
    void rankSuccessor(Slot slot, std::size_t place);
    bool hasUncleanBox() const;

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    dxSapState &m_state;
    dxSapLists m_lists;
    std::vector<dxGeom *> m_toClean;
    bool m_isMessedUp = false;  // as in upstream's assertion: a cleaning was nested in a cleaning, or left
};
