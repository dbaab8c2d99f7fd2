// How the constraints of a group of islands are solved: which contacts are a manifold, which manifolds are lanes of a vector, and which
// of them may be solved by several threads at the same time.
//
// Manifolds and joints are edges between bodies. Eight manifolds without a common moving body are a pack (dxPackPlaces). The packs of most
// groups are solved one after the other; of large ones by colour: those of one colour share no moving body, so that they may be
// solved in any order, by any threads. Bodies with more edges than there are colours have some left over, which are solved one by
// one at the end of a sweep.
//
// Contacts become lanes where that fills vectors. Those left over, those with rolling friction, and all of a group whose
// vectors would be nearly empty are solved as rows, like other joints.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/quick_step/fast/dxContactManifold.h"
#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/quick_step/fast/dxEdgeColors.h"
#include "dynamics/quick_step/fast/dxPackOrder.h"
#include "dynamics/step/islands/dxIsland.h"

class dxConstraintPlan {
public:
    static constexpr int kNoBody = dxContactPack::kNoBody;

    using Manifold = dxContactManifold;

    // A joint that is not solved as a lane: its rows are generic.
    struct OtherJoint {
        unsigned joint;
        int body;  // the tag of one of its bodies
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
    unsigned islandOf(const OtherJoint &other) const { return m_islandOfBody[static_cast<unsigned>(other.body)]; }
    // In the order of the group.
    const std::vector<OtherJoint> &otherJoints() const { return m_others; }
    const dxJoint *jointOf(const OtherJoint &other) const { return m_joints[other.joint]; }
    // Indices of otherJoints(), in the order in which they are solved first: that of the group, or, if several threads solve them, by colour.
    const std::vector<unsigned> &othersInOrder() const { return m_othersInOrder; }
    bool hasContactsOnly() const { return m_hasContactsOnly; }
    bool hasSerialRows() const { return m_isSerial; }  // one chunk
    const std::vector<Chunk> &chunks() const { return m_chunks; }
    const std::vector<Phase> &phases() const { return m_phases; }

    std::vector<dxContactPack> &packs() { return m_packs; }
    unsigned packedContacts() const { return m_packedContacts; }  // elements of the array of dxContactLanes

private:
    void readJoints(const dxIsland &group);
    void addContact(unsigned joint, const int (&body)[2], bool isPacked, std::vector<Manifold> *&last);
    void connect(const int (&body)[2]);
    void findIslands(unsigned bodyCount);
    void placeManifolds(const dxIsland &group);
    bool placeInSequence(const dxIsland &group);
    void drawDirections(const dxIsland &group);
    void placeByColor();
    void sortByColor();
    void makePacks(unsigned count);
    bool fillsLanes() const;
    template <class IsRow>
    void moveToRows(const IsRow &isRow);
    void placeOthers();
    void cutChunks();
    template <class AddChunks>
    void addPhase(const AddChunks &addChunks);
    void cutPacks(unsigned begin, unsigned end);
    void cutOthers(unsigned begin, unsigned end);

    dxJoint *const *m_joints = nullptr;
    std::vector<std::uint8_t> m_moves;  // by body
    std::vector<unsigned> m_reach;  // by body: the last one that is connected with it, or with one before it
    std::vector<Island> m_islands;
    std::vector<unsigned> m_islandOfBody;
    std::vector<Manifold> m_manifolds, m_rowManifolds;
    std::vector<OtherJoint> m_others;
    std::vector<unsigned> m_othersInOrder;
    std::vector<std::uint8_t> m_goesDown;  // by body
    dxPackOrder m_packOrder;
    dxEdgeColors m_colors;
    std::vector<dxContactPack> m_packs;
    std::vector<Chunk> m_chunks;
    std::vector<Phase> m_phases;
    unsigned m_packedContacts = 0, m_packColors = 0;  // without colours, packs follow one another
    bool m_isSerial = false;  // other joints
    bool m_hasContactsOnly = true;
    // By colour, and the end; of other joints, those left over come last.
    unsigned m_firstPack[dxEdgeColors::kMost + 1], m_firstOther[dxEdgeColors::kMost + 2];
};
