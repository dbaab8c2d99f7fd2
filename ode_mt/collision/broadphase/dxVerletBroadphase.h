// Broad phase by a Verlet list, which is valid for many calls: for spaces in which most members move, a little at a
// time.
//
// Source: the neighbour list with a skin of molecular dynamics (Verlet, Physical Review 159, 1967; Allen and Tildesley,
// Computer Simulation of Liquids, 5.3). Each box is stored enlarged, by a skin on all sides and by its motion of some
// calls on the side to which it moves. While boxes lie within their stored boxes, they overlap only if those do,
// so a call compares only the candidates.
//
// Invariant: the candidates are, each once, the pairs of slots whose stored boxes overlap. All are found at once when a
// list is made (dxGridBroadphase). Until the next list stored boxes only grow: when a box leaves its stored box, that is
// grown to hold it and compared with all others; those that it meets anew become candidates. A slot
// keeps its stored box when its member is removed. A list is rebuilt when growing has cost about as much, or has made the
// list long. Where boxes move so fast that lists serve few calls, pairs are found by the cell grid for some calls.
#pragma once

#include <vector>

#include "collision/broadphase/dxGridBroadphase.h"
#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/broadphase/overlap/dxPackedBoxes.h"

class dxVerletBroadphase final : public dxBroadphase {
public:
    // `maxPairs` is as in dxGridBroadphase.
    explicit dxVerletBroadphase(dxPairLimit maxPairs = dxUnlimitedPairs) : m_maxPairs(maxPairs), m_cellGrid(maxPairs) {}

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Return the number of lists built so far, and of candidates in the current one.
    std::size_t lists() const { return m_lists; }
    std::size_t candidates() const { return m_candidates.size(); }

private:
    using Slot = dxMembers::Slot;

    // A member when the list was built.
    struct Start {
        const dxGeom *geom = nullptr;
        dxBounds box;
    };

    struct alignas(kCacheLine) Found {
        std::vector<Match> matches;  // the first `count` of them
        std::size_t count;
    };

    void countShortList(bool hadList);
    void makeList(const dxMembers &members, dxTaskRunner &runner);
    void takeMember(const dxMembers &members, Slot slot);
    void resize(std::size_t slots);
    dxBounds boxToStore(const dxMembers &members, Slot slot) const;
    void store(Slot slot, const dxBounds &box);
    // Returns false if a new list is due.
    bool noteChanges(const dxMembers &members, dxTaskRunner &runner);
    void prefetch(const dxMembers &members, Slot slot) const;
    void noteBox(const dxMembers &members, Slot slot);
    void grow(const dxMembers &members, Slot slot);
    void compareCandidates(dxTaskRunner &runner, std::vector<Match> &matches);
    void forgetChanges(const dxMembers &members);

    const dxPairLimit m_maxPairs;
    dxPackedBoxes m_boxes;           // as they are, by slot
    std::vector<dxBounds> m_stored;  // by slot
    dxBoxColumns m_storedColumns;    // the same in columns
    std::vector<Start> m_starts;     // by slot
    std::vector<Match> m_candidates;
    std::vector<Slot> m_escaped;     // from their stored boxes, in this call
    std::vector<std::uint32_t> m_met;
    dxGridBroadphase m_cellGrid;
    dxMembers m_grown;               // for the cell grid: the members with their stored boxes
    std::vector<Found> m_found;      // by worker
    bool m_hasList = false;
    std::size_t m_lists = 0;
    std::size_t m_calls = 0, m_growths = 0;  // since the list was made
    std::size_t m_freshCandidates = 0;
    unsigned m_shortLists = 0;       // in a row
    unsigned m_callsWithout = 0;     // to come
};
