// Cuts the pairs of a space into tasks whose callbacks may run at the same time: no two tasks share a body, unless the
// program says that its callbacks write to none.
//
// Two pairs belong together if they share such a body, or one that a collider writes to (a nested space stands for all
// bodies of the geoms in it, since its callback goes on to them), or a geom that a collider writes to or that leads to code
// of the user's (a nested space, a geom of a class of the user's, a geom transform, a mesh that
// remembers its last contacts, a mesh or height field with callbacks and all that meets it:
// collision/narrowphase/dxConcurrentColliders.h), or other memory of a collider's (collision/callbacks/dxColliderMemory.h). Static geoms of
// other kinds are only read and may be in many tasks. Groups of the space's search, where it has them, are kept whole.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/callbacks/dxColliderMemory.h"
#include "collision/pairs/dxPair.h"
#include "core/dxDisjointSets.h"

class dxPairTasks {
public:
    struct Task {
        std::uint32_t begin, end;  // in order()
    };

    // About `wanted` tasks of like size, fewer if pairs hang together. `search`: the one that groups members, or null.
    void cut(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *search, unsigned wanted, bool sharingBodies);

    const std::vector<Task> &tasks() const { return m_tasks; }
    // Numbers of pairs, task by task, rising within a task.
    const std::vector<std::uint32_t> &order() const { return m_order; }

private:
    using Slot = dxMembers::Slot;

    void cutAnywhere(unsigned wanted, std::uint32_t pairs);
    void cutBetweenSets(const std::vector<dxOrderedPair> &pairs, const dxBroadphase *search, unsigned wanted,
                        bool sharingBodies);
    void markWritten(const dxOrderedPair &pair);
    void tieBody(const dxGeom *geom, Slot slot);
    void tieNested(const dxGeom *space, Slot slot);
    void uniteGeomsOf(dBodyID body, Slot slot);
    void uniteSharedMemory();
    void uniteExclusive(const std::vector<dxOrderedPair> &pairs);
    void uniteGroups(const std::vector<dxOrderedPair> &pairs, const dxBroadphase &search);
    void sizeSets(const std::vector<dxOrderedPair> &pairs);
    void shareOut(unsigned wanted, std::size_t pairs);
    void addToTask(std::uint32_t set, bool isFirst);
    void sortIntoTasks(std::size_t pairs);
    Slot ownerOf(const dxOrderedPair &pair) const;

    dxColliderMemory m_memory;
    dxDisjointSets m_sets;                   // of slots
    std::vector<std::uint8_t> m_exclusive;   // by slot
    std::vector<std::uint8_t> m_isTied;      // by slot: all pairs of its bodies belong together
    const dxSpace *m_space = nullptr;        // whose pairs they are
    bool m_isSharingBodies = false;          // callbacks write to no body
    std::vector<std::uint32_t> m_setOfPair;  // root of its set
    std::vector<std::uint32_t> m_sizeOfSet, m_taskOfSet, m_usedSets;  // by root; roots
    std::vector<std::uint32_t> m_largeSets;                           // roots
    std::vector<std::uint32_t> m_order, m_fill;
    std::vector<Task> m_tasks;
};
