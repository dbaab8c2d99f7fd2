// How the constraints of a group of islands are solved in parallel: which contacts are a manifold, and which manifolds and joints
// may be solved at the same time (graph colouring).
//
// Manifolds and joints are edges between bodies. Edges of one colour share no moving body, so that they may be solved in any
// order, by lanes of a vector or by threads; colours are solved one after the other. Each edge takes the first colour that is
// free on both of its bodies. Bodies with more edges than there are colours have some left over, which are solved one by one at
// the end of a sweep.
//
// Contacts become lanes where that fills vectors. Those left over, those with rolling friction, and all of a group whose
// vectors would be nearly empty are solved as rows, like other joints.
//
// Source of the method: Saad, "Iterative Methods for Sparse Linear Systems", 12.4 (multicolour orderings).
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/islands/dxIsland.h"
#include "dynamics/iterative/dxContactPack.h"

class dxConstraintPlan {
public:
    static constexpr int kNoBody = dxContactPack::kNoBody;

    // Contact joints [firstJoint, firstJoint + contactCount) of the group, between bodies with these tags.
    struct Manifold {
        unsigned firstJoint;
        std::uint8_t contactCount, color;
        std::uint8_t lane;
        bool firstOwns;  // of dxContactForces: the first body keeps the forces for the next step
        unsigned pack;   // of a manifold in rows: its first one of otherJoints(); its contacts follow one another there
        int body[2];

        unsigned firstOther() const { return pack; }
    };

    // A joint that is not solved as a lane: its rows are generic.
    struct OtherJoint {
        unsigned joint;
        std::uint8_t color;
    };

    // What one thread takes at once of a colour.
    struct Chunk {
        unsigned firstPack, endPack;
        unsigned firstOther, endOther;  // of othersInOrder()
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
    void make(const dxIsland &group);

    // Takes as much memory as another plan has. Throws std::bad_alloc.
    void reserveAs(const dxConstraintPlan &other);

    const std::vector<Manifold> &manifolds() const { return m_manifolds; }
    std::vector<Manifold> &manifolds() { return m_manifolds; }
    const std::vector<Manifold> &rowManifolds() const { return m_rowManifolds; }
    std::vector<Manifold> &rowManifolds() { return m_rowManifolds; }
    // At least one.
    const std::vector<Island> &islands() const { return m_islands; }
    unsigned islandOf(const Manifold &manifold) const { return m_islandOfBody[static_cast<unsigned>(manifold.body[0])]; }
    unsigned islandOf(const OtherJoint &other) const;
    // In the order of the group.
    const std::vector<OtherJoint> &otherJoints() const { return m_others; }
    const dxJoint *jointOf(const OtherJoint &other) const { return m_joints[other.joint]; }
    // Indices of otherJoints(), in the order in which they are solved first: by colour, so that neighbours need not wait for one another, or,
    // if one thread solves them and they are not contacts alone, that of the group.
    const std::vector<unsigned> &othersInOrder() const { return m_othersInOrder; }
    bool hasContactsOnly() const { return m_hasContactsOnly; }
    bool hasSerialRows() const { return m_isSerial; }  // one chunk
    const std::vector<Chunk> &chunks() const { return m_chunks; }
    const std::vector<Phase> &phases() const { return m_phases; }

    std::vector<dxContactPack> &packs() { return m_packs; }
    unsigned packedContacts() const { return m_packedContacts; }  // elements of the array of dxContactLanes

private:
    static constexpr unsigned kColors = 63, kLeftOver = kColors;

    unsigned colorOf(const int (&body)[2]);
    void findManifolds(const dxIsland &group, bool packsContacts);
    void addContact(unsigned joint, const int (&body)[2], bool isPacked, std::vector<Manifold> *&last);
    void addOther(unsigned joint, const int (&body)[2]);
    bool fillsLanes() const;
    void connect(const int (&body)[2]);
    void findIslands(unsigned bodyCount);
    void placeManifolds();
    void placeOthers();
    void cutChunks();

    dxJoint *const *m_joints = nullptr;
    std::vector<std::uint64_t> m_used;  // by body: a bit for each colour
    std::vector<std::uint8_t> m_moves;
    std::vector<unsigned> m_reach;  // by body: the last one that is connected with it, or with one before it
    std::vector<Island> m_islands;
    std::vector<unsigned> m_islandOfBody;
    std::vector<Manifold> m_manifolds, m_rowManifolds;
    std::vector<OtherJoint> m_others;
    std::vector<unsigned> m_othersInOrder;
    std::vector<dxContactPack> m_packs;
    std::vector<Chunk> m_chunks;
    std::vector<Phase> m_phases;
    unsigned m_packedContacts = 0, m_colorCount = 0;
    bool m_isSerial = false;  // other joints
    bool m_hasContactsOnly = true;
    // By colour, and the end; of other joints, those left over come last.
    unsigned m_firstPack[kColors + 1], m_firstOther[kColors + 2];
};
