// The sweep-and-prune (SAP) space: geoms are sorted along an axis, and each is paired with those that begin before it
// ends; pairs with geoms of infinite extent on that axis follow. docs/collision-order.md.
//
// Unlike the other spaces this one keeps its geoms in two arrays (dxSapLists); a member's rank follows from its place
// among the clean ones. It tests which geoms are enabled before it sorts, so enabling or disabling a geom changes
// pairs().
#pragma once

#include <vector>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxSapBox.h"
#include "collision/spaces/dxSapLists.h"
#include "collision/spaces/dxSapRows.h"
#include "collision/spaces/dxSapWalk.h"
#include "collision/spaces/dxWalking.h"
#include "core/dxSapSort.h"

class dxOrderedSapSpace final : public dxOrderedSpace {
public:
    // `axes`: dSAP_AXES_XYZ and so on, or any number.
    dxOrderedSapSpace(dSpaceID parent, int axes);
    ~dxOrderedSapSpace() override;

    dxGeom *getGeom(int i) override;
    void dirty(dxGeom *geom) override;
    void computeAABB() override {}  // always infinite
    void cleanGeoms() override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;
    bool makeReady() override;

private:
    enum class Part : std::uint8_t { absent, swept, infinite };

    struct State {
        dxSapBox box;          // as of the last cleaning
        std::uint32_t position;  // among those swept
        Part part;
    };

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;
    bool mayKeep() const override { return m_axes.areAll(); }  // or else upstream's sweep meets pairs that do not overlap
    void deliverAnew(void *data, dNearCallback *callback) override;
    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override;
    void deliver(void *data, dNearCallback *callback) override;
    bool mayCome(const dxGeom *geom) const override;
    void reserveMemory(Slot slots) override;
    void comes(dxGeom *geom, Slot slot) override;
    void goes(dxGeom *geom, Slot slot) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;
    bool hasStrayMembers() const override;
    void takeBoxAgain(dxGeom *geom) override;
    void enabledChanges(dxGeom *geom) override;

    void chooseToWalk();
    void stopWalking();
    void cleanAndRank();
    bool isServedBySweep(int moved) const;
    void findPairsOf(dxSapWalk &sweep);
    dxBounds boundsOf(const dxGeom *geom, const dxSapBox &box) const;
    void takeBox(dxGeom *geom, dxRank rank);
    void rankSuccessor(Slot slot, std::size_t place);
    bool hasUncleanBox() const;
    void takeParts();
    void sortSwept();
    void deliverBehind(const dxOrderedPair &after, unsigned fills, void *data, dNearCallback *callback);
    void fillTemporary(const dxSapWalk &walk);
    std::vector<dxGeom *> geomsIn(const std::vector<Slot> &slots) const;
    void pairInfinite(std::vector<dxOrderedPair> &pairs) const;
    void pairIfMayMeet(Slot a, Slot b, std::vector<dxOrderedPair> &pairs) const;
    void collideFrom(std::size_t place, void *data, dxGeom *geom, dNearCallback *callback);

    dxSapAxes m_axes;
    dxSapLists m_lists;
    std::vector<State> m_states;            // by slot
    std::vector<dxGeom *> m_toClean;
    std::vector<Slot> m_swept, m_infinite;  // in the order of the list
    std::vector<float> m_keys;              // of m_swept
    std::vector<Slot> m_inOrder;            // m_swept, sorted
    dxSapSort m_sort;
    bool m_isSorted = false;    // since m_swept was taken
    bool m_hasNaN = false;
    bool m_isMessedUp = false;  // as in upstream's assertion: a cleaning was nested in a cleaning, or left

    dxWalking m_walking;       // there are no boxes of members, either
    dxSapWalk m_sweep;         // of the outermost call
    bool m_isSweepCurrent = false;  // no member has come, gone, moved, or been enabled or disabled since
    bool m_isSweepDelivered = false;  // by the outermost call
    bool m_hasWalked = false;  // since pairs() was brought up to date
    dxSapTemporaryLists m_temporary;
    dxSapRows m_rows;
    std::vector<std::uint32_t> m_places;  // by place in m_swept: that in m_inOrder
    std::vector<dxSlotPair> m_again;
    std::size_t m_sweptPairs = 0;   // of pairs(), those in front
    std::size_t m_comparisons = 0;  // number of those of the last sweep of all geoms
};
