// How the constraints of a group of islands are solved: which contacts are a manifold, which manifolds are lanes of a vector and which are rows, and
// which of them several threads may solve at the same time.
//
// Manifolds and joints are edges between bodies. Sixteen manifolds without a common moving body are a pack. The packs of most groups are solved one
// after the other (dxPackOrder). Those of large groups are coloured: manifolds of one colour share no moving body, so that any threads may solve
// them in any order. A body with more edges than there are colours has an overflow, which is solved in rows at the end of a sweep.
//
// Lanes or rows: a pack takes as long for one manifold as for sixteen, so contacts become lanes only where they fill them. Contacts with rolling
// friction, those of the overflow, and all contacts of a group whose lanes would be nearly empty are solved in rows. Joints other than contacts are
// solved in rows, too, but for those of large groups, which are coloured and become packs of joints where they fill their lanes. Numbers
// of contacts per body, per pack or per colour decide that before any pack is made.
//
// The plan is in an arena and lives until that is reset.
#pragma once

#include <cstdint>

#include "core/dxStepArena.h"
#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/quick_step/fast/dxJointPack.h"
#include "dynamics/step/islands/dxIsland.h"

class dxConstraintPlan {
public:
    static constexpr int kNoBody = dxContactPack::kNoBody;

    using Manifold = dxContactManifold;

    // A joint that is solved in rows.
    struct RowJoint {
        unsigned joint;
        int body;  // the tag of one of its bodies
        std::uint8_t color;
    };

    // A joint that is a lane.
    struct LaneJoint {
        static constexpr unsigned kNone = ~0u;

        unsigned joint;         // kNone: the lane is empty
        int body[2];            // tags, or kNoBody
        std::uint8_t rowCount;  // in this step: of dxJointReader

        bool isEmpty() const { return joint == kNone; }
    };

    // What one thread takes at once.
    struct Chunk {
        unsigned firstPack, endPack;
        unsigned firstJointPack, endJointPack;
        unsigned firstRowJoint, endRowJoint;  // of rowJointsInOrder()
    };

    // Chunks that may be solved at the same time.
    struct Phase {
        unsigned firstChunk, endChunk;
    };

    // Bodies [firstBody, endBody) that the joints of the group connect with no others.
    struct Island {
        unsigned firstBody, endBody;
    };

    // Requires bodies with tags. Throws std::bad_alloc.
    void make(const dxIsland &group, dxStepArena &arena);

    // Call visit(manifold) for manifolds in lanes, or in rows, in the order of the group.
    template <class Visit>
    void forLaneManifolds(const Visit &visit) const {
        for (Manifold &manifold : m_manifolds)
            if (!manifold.isInRows()) visit(manifold);
    }
    template <class Visit>
    void forRowManifolds(const Visit &visit) const {
        if (m_rowManifolds == 0) return;
        for (Manifold &manifold : m_manifolds)
            if (manifold.isInRows()) visit(manifold);
    }
    // Calls visit(joint, pack, lane) for joints in lanes.
    template <class Visit>
    void forLaneJoints(const Visit &visit) const {
        for (unsigned i = 0; i < m_laneJoints.size(); ++i)
            if (!m_laneJoints[i].isEmpty()) visit(m_laneJoints[i], i / dxLanes::kCount, i % dxLanes::kCount);
    }
    bool hasContactLanes() const { return m_rowManifolds != m_manifolds.size(); }
    unsigned laneContacts() const { return m_laneContacts; }
    bool hasLanes() const { return hasContactLanes() || !m_laneJoints.empty(); }

    // At least one.
    dxArenaArray<const Island> islands() const { return m_islands; }
    unsigned islandOf(const Manifold &manifold) const { return m_islandOfBody[static_cast<unsigned>(manifold.body[0])]; }
    unsigned islandOf(const LaneJoint &joint) const { return m_islandOfBody[static_cast<unsigned>(joint.body[0])]; }
    unsigned islandOf(const RowJoint &joint) const { return m_islandOfBody[static_cast<unsigned>(joint.body)]; }

    // In the order of the group.
    dxArenaArray<const RowJoint> rowJoints() const { return m_rowJoints; }
    const dxJoint *jointOf(const RowJoint &joint) const { return m_joints[joint.joint]; }
    // Indices of rowJoints(), in the order in which they are solved first: that of the group, or, if several threads solve them, by colour.
    dxArenaArray<const unsigned> rowJointsInOrder() const { return m_rowJointsInOrder; }
    bool hasContactsOnly() const { return m_hasContactsOnly; }  // no other joints
    bool hasSerialRows() const { return m_hasSerialRows; }  // all in one chunk

    dxArenaArray<const Chunk> chunks() const { return m_chunks; }
    dxArenaArray<const Phase> phases() const { return m_phases; }

    dxArenaArray<dxContactPack> packs() const { return m_packs; }
    unsigned packedContacts() const { return m_packedContacts; }  // elements of the array of dxContactLanes

    // With the largest number of rows that their joints may have.
    dxArenaArray<dxJointPack> jointPacks() const { return m_jointPacks; }
    unsigned packedRows() const { return m_packedRows; }  // elements of the array of dxJointLanes
    dxArenaArray<LaneJoint> laneJoints() const { return m_laneJoints; }  // by pack and lane
    dxArenaArray<const unsigned> feedbackLanes() const { return m_feedbackLanes; }  // of laneJoints(), those with feedback, in the order of the group
    bool hasPassiveLaneJoints() const { return m_hasPassiveLaneJoints; }       // none of them pushes its bodies when it is asked for its rows

private:
    class Maker;

    dxJoint *const *m_joints = nullptr;
    dxArenaArray<Island> m_islands;
    dxArenaArray<unsigned> m_islandOfBody;
    dxArenaArray<Manifold> m_manifolds;
    dxArenaArray<RowJoint> m_rowJoints;
    dxArenaArray<unsigned> m_rowJointsInOrder;
    dxArenaArray<dxContactPack> m_packs;
    dxArenaArray<dxJointPack> m_jointPacks;
    dxArenaArray<LaneJoint> m_laneJoints;
    dxArenaArray<unsigned> m_feedbackLanes;
    dxArenaArray<Chunk> m_chunks;
    dxArenaArray<Phase> m_phases;
    std::size_t m_rowManifolds = 0;
    unsigned m_laneContacts = 0, m_packedContacts = 0, m_packedRows = 0;
    bool m_hasSerialRows = false, m_hasContactsOnly = true, m_hasPassiveLaneJoints = true;
};
