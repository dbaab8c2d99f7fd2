// Cuts the pairs of a space into tasks whose callbacks may run at the same time: no two tasks share a body, unless the
// program promises that its callbacks write to none.
//
// Two pairs belong together if they share
//   - such a body, or one that a collider writes to; a nested space represents all bodies of the geoms in it, since its callback continues with them;
//   - a geom that a collider writes to or that leads to the user's code: a nested space, a geom of a class of the user's, a geom transform, a mesh
//     that remembers its last contacts, a mesh or height field with callbacks and all that it meets (narrowphase/dxConcurrentColliders.h);
//   - other memory of a collider's (dxColliderMemory).
// Static geoms of other kinds are only read and may be in many tasks. If the broad phase groups members, its groups are kept whole.
//
// Threading: one thread at a time, while no other changes the space.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "core/dxDisjointSets.h"

// What colliders of a space's pairs write to, besides geoms of the pair itself: scratch memory in the data of height fields, and geoms in geom
// transforms, which get the transform's pose for a while. Several members of the space may share them. A nested space represents everything in it.
class dxColliderMemory {
public:
    using Slot = dxMembers::Slot;
    struct Use {
        const void *memory;
        Slot slot;  // of the member that has it
    };

    void reset(Slot end);
    // Does nothing for a member that was added before.
    void add(const dxGeom *member, Slot slot);
    // Requires a call after the last add().
    void sort();

    // Returns whether the member is or contains a height field, which transforms the geom that it meets into its own frame.
    bool hasHeights(Slot slot) const { return (m_members[slot] & kHasHeights) != 0; }
    // Returns the uses; those of the same memory are neighbours.
    const std::vector<Use> &uses() const { return m_uses; }

private:
    void addUses(const dxGeom *geom, Slot slot);

    static constexpr std::uint8_t kAdded = 1, kHasHeights = 2;
    std::vector<std::uint8_t> m_members;  // by slot
    std::vector<Use> m_uses;
};

class dxPairTasks {
public:
    struct Task {
        std::uint32_t begin, end;  // in order()
    };

    // Makes about `wanted` tasks of similar size, fewer if many pairs belong together. `broadphase` groups members, or is null.
    // `sharingBodies`: callbacks write to no body.
    void cut(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *broadphase, unsigned wanted, bool sharingBodies);

    const std::vector<Task> &tasks() const { return m_tasks; }
    // Returns the numbers of the pairs, task by task, rising within a task.
    const std::vector<std::uint32_t> &order() const { return m_order; }

private:
    using Slot = dxMembers::Slot;

    void cutInOrder(unsigned wanted, std::uint32_t pairs);
    void cutBetweenSets(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *broadphase, unsigned wanted,
                        bool sharingBodies);
    void markWritten(const dxOrderedPair &pair);
    void tieBody(const dxGeom *geom, Slot slot);
    void tieNested(const dxGeom *space, Slot slot);
    void uniteGeomsOf(dBodyID body, Slot slot);
    void uniteSharedMemory();
    void uniteExclusive(const std::vector<dxOrderedPair> &pairs);
    void uniteGroups(const std::vector<dxOrderedPair> &pairs, const dxBroadphase &broadphase);
    void sizeSets(const std::vector<dxOrderedPair> &pairs);
    void assignTasks(unsigned wanted, std::size_t pairs);
    void addToTask(std::uint32_t set, bool isFirst);
    void sortIntoTasks(std::size_t pairs);
    Slot ownerOf(const dxOrderedPair &pair) const;

    dxColliderMemory m_memory;
    dxDisjointSets m_sets;                   // of slots
    std::vector<std::uint8_t> m_exclusive;   // by slot: all pairs of the member belong together
    std::vector<std::uint8_t> m_isTied;      // by slot: the member's bodies have been united
    const dxSpace *m_space = nullptr;        // whose pairs they are
    bool m_isSharingBodies = false;
    std::vector<std::uint32_t> m_setOfPair;  // root of its set
    std::vector<std::uint32_t> m_sizeOfSet, m_taskOfSet, m_usedSets;  // by root; roots
    std::vector<std::uint32_t> m_largeSets;                           // roots
    std::vector<std::uint32_t> m_order, m_fill;
    std::vector<Task> m_tasks;
};
