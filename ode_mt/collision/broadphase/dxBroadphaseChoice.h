// Which broad phase a space uses now, and why: every threshold between one broad phase and another stands here.
//
//   broad phase     what a call does                                       done by
//   ListWalk        walks the geoms as upstream does, keeps nothing        dxOrderedSimpleSpace, dxSapWalk; for queries alone
//                                                                          dxListCleaner
//   OrderedTable    compares changed boxes with all; pairs come in order   dxBruteForcePairs
//   SlotTable       compares changed boxes with all; pairs are sorted      dxBruteForceBroadphase
//   NeighbourList   compares the candidates of a list; pairs are sorted    dxVerletBroadphase
//   NeighbourSets   compares changed boxes with their neighbours; sorted   dxNeighbourBroadphase
//
// Where keeping pairs costs more than finding all, none is kept (dxPairKeeping). A neighbour list that serves too few calls gives way to a cell
// grid over all members (dxGridBroadphase) for a while. Rays and other single geoms against a space (dSpaceCollide2) walk
// its list or ask its tree (dxRegionIndex).
//
// The choice shows in the time that a call takes, never in the pairs that it finds. Everything here is a pure
// function of its arguments; what is remembered from call to call is the caller's. Figures: docs/collision.md.
// What tunes one broad phase within itself (skin, edge of cells, rows that a worker takes at once) stands with it.
#pragma once

#include <cstddef>
#include <cstdint>

enum class dxBroadphaseKind { None, ListWalk, OrderedTable, SlotTable, NeighbourList, NeighbourSets };

// What the order of a space's pairs follows from, which is given by the kind of the space.
enum class dxPairOrder {
    List,    // simple space: the places of both geoms in its list
    Blocks,  // quad tree: the places of both geoms in its blocks
    Axis,    // sweep and prune: the places of both geoms along the axis
    Cells    // hash space: the cells of both geoms. No broad phase finds pairs in this order.
};

// Units are geoms, members, calls or pairs.
struct dxBroadphaseThresholds {
    // A simple space of up to so many geoms is walked if any geom moves, and a quad tree keeps none of its pairs: nothing pays for keeping them.
    static constexpr int kMaxAlwaysWalked = 12;
    // And of up to so many if none moves.
    static constexpr int kMaxNeverKept = 6;
    // A simple space of up to so many geoms is walked if three quarters of them move.
    static constexpr int kMaxWalked = 512;
    // A sweep-and-prune space of up to so many geoms is walked if any geom moves, a larger one if one of sixteen does: the places of all its
    // pairs change with each geom that moves.
    static constexpr int kMaxAlwaysSwept = 256;
    // But not if the extent of each geom is compared with more others than these; it is walked on up to twice as many.
    static constexpr std::size_t kMaxComparisonsWalked = 48;
    // Calls in a row in which few geoms move, after which ranks and kept pairs pay for what it takes to make them.
    static constexpr int kMinCallsRested = 4;
    // From so many geoms on a walk compares boxes by vectors; below, filling the table costs more than it saves.
    static constexpr int kMinWalkedByVectors = 20;
    // If there are more pairs than these they are found row by row as they are delivered, else all at once before.
    static constexpr std::size_t kMaxListedPerGeom = 3;

    // Up to so many geoms comparing boxes by vectors is faster than neighbours and sorting, whatever share of them
    // moves. A space that has grown beyond comes back at half of it (hysteresis).
    static constexpr int kMaxOrderedTable = 512;
    // As kMaxOrderedTable, where the pairs have to be sorted anyway. Slots of members.
    static constexpr std::size_t kMaxSlotTable = 128;

    // Looking a box up among neighbours costs about as much as making a list does for so many boxes.
    static constexpr std::size_t kListedPerLookUp = 10;
    // Comparing the neighbours of a box that moves costs about as much as comparing the candidates of so many.
    static constexpr std::size_t kListedPerMove = 5;
    // Fewer look-ups than this take no time to speak of.
    static constexpr std::size_t kMinLookUps = 32;
    // So many calls in a row with few changes must come before neighbours are built up, which costs a look-up for each
    // member; and so many with many changes before a list is made instead.
    static constexpr int kMinMismatchStreak = 8;

    // A neighbour list pays if it serves so many calls; after so many lists in a row that did not, none is made for so
    // many calls.
    static constexpr std::size_t kMinCallsPerList = 4;
    static constexpr unsigned kMaxShortLists = 3, kCallsWithoutList = 32;

    // Pairs are kept no more after what finding all anew would have saved comes to so many calls of that.
    static constexpr double kCallsSavedBeforeAnew = 4;

    // From so many geoms on a tree may answer what a geom meets in a space; a smaller space is walked as fast.
    static constexpr int kMinIndexed = 64;
    // Nor may it where one geom meets more than one of so many: to put those in order takes longer than the comparisons that it saves.
    static constexpr std::size_t kMinUnmetPerMet = 8;
    // The same where all boxes are compared by vectors.
    static constexpr int kMinIndexedByVectors = 320;
    static constexpr std::size_t kMinUnmetPerMetByVectors = 48;
    // A space that is asked for what single geoms meet, and not collided itself, is walked if so many of four geoms move.
    static constexpr int kMovedOfFourQueried = 2;
    // Geoms against a walked space, between two moves, after which a tree pays for the ranks that it needs.
    static constexpr int kMaxWalksUnranked = 8;
    // Putting a box into the tree costs as much as so many comparisons with a box.
    static constexpr std::size_t kComparisonsPerRow = 32;
};

// Facts that the order of the pairs makes irrelevant may be left as they are.
struct dxBroadphaseFacts {
    dxPairOrder order = dxPairOrder::Cells;
    dxBroadphaseKind current = dxBroadphaseKind::None;  // what the space has used so far
    bool mayWalk = false;         // ranks are not given yet, and neither workers nor a broad phase that was set need them
    int geoms = 0;
    int moved = 0;                // geoms that are to be cleaned
    std::size_t comparisons = 0;  // Axis: of the last sweep
    std::size_t slots = 0;        // of members
    std::size_t changed = 0;      // members, since pairs were last found
    std::size_t lookedUp = 0;     // boxes that left their neighbours at this call, in NeighbourSets
    int mismatchStreak = 0;       // calls in a row, this one included, for which dxPrefersOtherBroadphase() was true
};

dxBroadphaseKind dxChooseBroadphase(const dxBroadphaseFacts &facts);

// Whether the changes of this call would have been cheaper to follow the other way: by neighbours instead of a list,
// or by a list instead of neighbours.
bool dxPrefersOtherBroadphase(const dxBroadphaseFacts &facts);

// Geoms that must move for a space to be walked; INT_MAX: it is never walked for that.
int dxMinMovedToWalk(dxPairOrder order, int geoms);

// A walked space is walked on until fewer than half as many geoms move as it took to begin (hysteresis), for kMinCallsRested.
inline bool dxHaveFewMoved(int moved, int minMovedToWalk) { return 2 * moved < minMovedToWalk; }

// Comparing every two boxes is then faster than comparing each changed one with all.
inline bool dxHaveMostChanged(std::size_t changed, std::size_t members) { return 2 * changed > members; }

// What a call did, or has to do, to find its pairs.
struct dxPairWork {
    std::size_t geoms = 0;
    std::size_t changed = 0;   // geoms, since pairs were last found
    std::size_t comparisons = 0;  // of boxes, where all pairs are found anew
    std::size_t overlaps = 0;  // overlapping boxes of all geoms, whether or not their filters exclude each other
    std::size_t found = 0;     // of these, those of changed geoms
    std::size_t pairs = 0;     // of all, those of geoms whose filters do not exclude each other
};

// Estimates in nanoseconds of what it takes to bring kept pairs up to date, and to find all pairs anew, beside what callbacks take.
double dxCostOfKeeping(dxPairOrder order, const dxPairWork &work);
double dxCostOfFindingAnew(dxPairOrder order, const dxPairWork &work);

// The most pairs that are kept for so many geoms.
using dxPairLimit = std::size_t (*)(std::size_t geoms);
std::size_t dxUnlimitedPairs(std::size_t geoms);
// Where a walk tests every two boxes. Testing two boxes takes about a twentieth of the time that finding, sorting and
// keeping a pair does; and a pair takes some hundred bytes while it is found.
std::size_t dxMaxPairsOfWalk(std::size_t geoms);
// Where a walk goes from cell to cell (dxHashWalk), which takes as long for a pair as finding and sorting it: the limit
// is for memory, half a GB while pairs are found.
std::size_t dxMaxPairsOfCells(std::size_t geoms);
dxPairLimit dxPairLimitOf(dxPairOrder order);
