// Which broad phase a space uses now, and why: this file has all thresholds between one broad phase and another.
//
//   broad phase         what a call does                                              class
//   ListWalk            walks the geoms as upstream does, keeps nothing               dxOrderedSimpleSpace, dxSapWalk; for queries alone
//                                                                                     dxListCleaner
//   OrderedBruteForce   compares changed boxes with all; pairs are found in order     dxBruteForcePairs
//   BruteForce          compares changed boxes with all; pairs are sorted             dxBruteForceBroadphase
//   VerletList          compares the candidates of a list; pairs are sorted           dxVerletBroadphase
//   Neighbours          compares changed boxes with their neighbours; pairs are       dxNeighbourBroadphase
//                       sorted
//
// Where keeping pairs costs more than finding all, none is kept (dxPairKeeping). A Verlet list that serves too few calls is replaced by a cell
// grid over all members (dxGridBroadphase) for some calls. Rays and other single geoms against a space (dSpaceCollide2) walk
// its list or query its tree (dxRegionIndex).
//
// The choice affects the time that a call takes, never the pairs that it finds. Everything here is a pure
// function of its arguments; the caller keeps the state from call to call. Figures: docs/collision.md.
// Parameters of a single broad phase (skin, edge of cells, rows in a chunk) are in its own file.
#pragma once

#include <cstddef>
#include <cstdint>

enum class dxBroadphaseKind { None, ListWalk, OrderedBruteForce, BruteForce, VerletList, Neighbours };

// What determines the order of a space's pairs; the kind of the space decides it.
enum class dxPairOrder {
    List,    // simple space: the places of both geoms in its list
    Blocks,  // quad tree: the places of both geoms in its blocks
    Axis,    // sweep and prune: the places of both geoms along the axis
    Cells    // hash space: the cells of both geoms. No broad phase finds pairs in this order.
};

// Units are geoms, members, calls or pairs. "Walked" means ListWalk.
struct dxBroadphaseThresholds {
    // Up to this size a simple space is walked if any geom moves. A quad tree in which a geom has moved keeps no pairs until it has rested for
    // kMinCallsRested calls.
    static constexpr int kMaxAlwaysWalked = 12;
    // Up to this size a simple space that is walked is also walked in calls in which no geom moves, however many these are.
    static constexpr int kMaxNeverKept = 6;
    // Up to this size a simple space is walked if three quarters of its geoms move.
    static constexpr int kMaxWalked = 512;
    // Up to this size a sweep-and-prune space is walked if any geom moves, a larger one if one of sixteen does: each geom that moves changes the
    // places of all pairs.
    static constexpr int kMaxAlwaysSwept = 256;
    // It is not walked if the extent of each geom is compared with more others than this; twice as many to stop walking (hysteresis).
    static constexpr std::size_t kMaxComparisonsWalked = 48;
    // Number of calls in a row in which few geoms move, after which ranks and kept pairs pay for making them.
    static constexpr int kMinCallsRested = 4;
    // From this size on a walk compares boxes with SIMD; below, filling the columns costs more than it saves.
    static constexpr int kMinWalkedWithSimd = 20;
    // If the last walk with SIMD found more overlaps per geom than this, pairs are found row by row as they are delivered, else all at once before.
    static constexpr std::size_t kMaxListedPerGeom = 3;

    // Up to this size brute force with SIMD is faster than neighbours and sorting, whatever share of the geoms
    // moves. A space that was larger returns to it at half the size (hysteresis).
    static constexpr int kMaxOrderedBruteForce = 512;
    // The same where the pairs have to be sorted anyway, in slots of members.
    static constexpr std::size_t kMaxBruteForce = 128;

    // Looking a box up among neighbours costs about as much as making a list of this many boxes.
    static constexpr std::size_t kListedPerLookUp = 10;
    // Comparing the neighbours of a box that moves costs about as much as comparing the candidates of this many boxes of a list.
    static constexpr std::size_t kListedPerMove = 5;
    // Fewer look-ups than this take negligible time.
    static constexpr std::size_t kMinLookUps = 32;
    // Number of calls in a row with few changes before neighbours are built up, which costs a look-up for each
    // member; and with many changes before a list is made instead.
    static constexpr int kMinMismatchStreak = 8;

    // A Verlet list pays if it serves kMinCallsPerList calls. After kMaxShortLists in a row that did not, none is made for kCallsWithoutList calls.
    static constexpr std::size_t kMinCallsPerList = 4;
    static constexpr unsigned kMaxShortLists = 3, kCallsWithoutList = 32;

    // Pairs are no longer kept once finding all anew would have saved as much as it costs in this many calls.
    static constexpr double kCallsSavedBeforeAnew = 4;

    // From this size on a tree may answer which geoms of a space a geom meets; a smaller space is walked as fast.
    static constexpr int kMinIndexed = 64;
    // The tree does not pay where a geom meets more than one of this many: sorting those takes longer than the comparisons that it saves.
    static constexpr std::size_t kMinUnmetPerMet = 8;
    // The same two thresholds where all boxes are compared with SIMD.
    static constexpr int kMinIndexedWithSimd = 320;
    static constexpr std::size_t kMinUnmetPerMetWithSimd = 48;
    // A space that is queried with single geoms, and not collided itself, is walked if this many of four geoms move.
    static constexpr int kMovedOfFourQueried = 2;
    // Number of queries of a walked space, between two moves, after which a tree pays for the ranks that it needs.
    static constexpr int kMaxWalksUnranked = 8;
    // Putting a box into the tree costs as much as this many comparisons of boxes.
    static constexpr std::size_t kComparisonsPerRow = 32;
};

// What the choice depends on. Members that do not matter for the order of the pairs may keep their defaults.
struct dxBroadphaseFacts {
    dxPairOrder order = dxPairOrder::Cells;
    dxBroadphaseKind current = dxBroadphaseKind::None;  // at the last call
    bool mayWalk = false;         // no ranks are given yet, and neither workers nor a broad phase that was set need them
    int geoms = 0;
    int moved = 0;                // number of geoms to be cleaned
    std::size_t comparisons = 0;  // Axis: of the last sweep
    std::size_t slots = 0;        // of members
    std::size_t changed = 0;      // number of members that changed since pairs were last found
    std::size_t lookedUp = 0;     // Neighbours: number of boxes that left their margin at this call
    int mismatchStreak = 0;       // number of calls in a row, this one included, for which dxPrefersOtherBroadphase() was true
};

dxBroadphaseKind dxChooseBroadphase(const dxBroadphaseFacts &facts);

// Returns whether neighbours would have been cheaper in this call than the current Verlet list, or a list cheaper than the current neighbours.
bool dxPrefersOtherBroadphase(const dxBroadphaseFacts &facts);

// Returns the number of geoms that must move for a space to be walked; INT_MAX: it is never walked because of motion.
int dxMinMovedToWalk(dxPairOrder order, int geoms);

// Returns whether fewer than half as many geoms moved as it takes to begin walking. A walked space is walked until this holds in kMinCallsRested
// calls in a row (hysteresis).
inline bool dxHaveFewMoved(int moved, int minMovedToWalk) { return 2 * moved < minMovedToWalk; }

// Returns whether comparing every two boxes is faster than comparing each changed one with all.
inline bool dxHaveMostChanged(std::size_t changed, std::size_t members) { return 2 * changed > members; }

// The work of a call that finds pairs.
struct dxPairWork {
    std::size_t geoms = 0;
    std::size_t changed = 0;      // number of geoms that changed since pairs were last found
    std::size_t comparisons = 0;  // of boxes, where all pairs are found anew
    std::size_t overlaps = 0;     // number of overlapping boxes of all geoms, whether or not their filters exclude each other
    std::size_t found = 0;        // of these, those of changed geoms
    std::size_t pairs = 0;        // of the overlaps, those of geoms whose filters do not exclude each other
};

// Return estimates in nanoseconds of the time to update kept pairs, and to find all pairs anew, without the callbacks.
double dxCostOfKeeping(dxPairOrder order, const dxPairWork &work);
double dxCostOfFindingAnew(dxPairOrder order, const dxPairWork &work);

// The maximum number of pairs that are kept in a space of this many geoms.
using dxPairLimit = std::size_t (*)(std::size_t geoms);
std::size_t dxUnlimitedPairs(std::size_t geoms);
// For spaces whose walk tests every two boxes. Testing two boxes takes about a twentieth of the time of finding, sorting and
// keeping a pair; and a pair takes about a hundred bytes while it is found.
std::size_t dxMaxPairsOfWalk(std::size_t geoms);
dxPairLimit dxPairLimitOf(dxPairOrder order);
