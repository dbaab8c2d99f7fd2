#include "dynamics/quick_step/fast/dxConstraintPlan.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxPackOrder.h"
#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

// A chunk takes some ten microseconds of a sweep.
constexpr unsigned kPacksPerChunk = 16, kRowJointsPerChunk = 64;

// Up to this number, one thread solves all joints in rows, before contacts in lanes.
constexpr std::size_t kMaxSerial = 1000;

// Up to this number, one thread solves all manifolds: their sweep takes some twenty microseconds.
constexpr std::size_t kMaxSequence = 1024;

// Lanes of a pack, on average, up to which its contacts are solved faster in rows: a pack takes about as long as the rows of four manifolds, with
// vectors of 256 bits of five.
constexpr unsigned kMinLanes = 4;

// Time of a sweep over a pack of joints, for each pack and for each of its rows, in units of the time that a row takes by itself: 8 and 6 with
// vectors of 512 bits, more with shorter ones.
constexpr std::size_t kPackTime = 10, kPackRowTime = 8;

constexpr unsigned kMaxContacts = dxContactPack::kMaxContacts;

bool isContact(const dxJoint &joint) { return joint.type() == dJointTypeContact; }

bool isRolling(const dxJoint &contact) {
    return (static_cast<const dxJointContact &>(contact).contact.surface.mode & dContactRolling) != 0;
}

// Returns the largest number of rows that a joint may have as a lane; 0: it is none. The forces on the two bodies of a transmission are not
// opposite.
unsigned laneRowsOf(dxJoint &joint) {
    if (joint.type() == dJointTypeTransmission) return 0;
    dxJoint::SureMaxInfo info;
    joint.getSureMaxInfo(&info);
    return info.max_m;
}

// Whether a joint has no motor, which may push the bodies at its stop while it says its rows.
bool isPassive(const dxJoint &joint) {
    const dJointType type = joint.type();
    return type == dJointTypeBall || type == dJointTypeFixed || type == dJointTypeDBall || type == dJointTypeDHinge;
}

// Drawn anew in each step, as long as the body moves.
bool goesDown(const dxBody &body) { return (dxStateNumbers::bitsOf(body.posr.pos) & 2) != 0; }

int tagOf(const dxBody *body) { return body != nullptr ? body->tag : dxConstraintPlan::kNoBody; }

// A greedy colouring of edges between bodies: edges of one colour share no moving body.
//
// Source of the method: Saad, "Iterative Methods for Sparse Linear Systems", 12.4 (multicolour orderings).
class EdgeColors {
public:
    static constexpr unsigned kMaxColors = 63, kOverflowColor = kMaxColors;

    // `moves`: by body.
    EdgeColors(dxArenaArray<const std::uint8_t> moves, dxStepArena &arena) : m_moves(moves), m_used(arena.take<std::uint64_t>(moves.size())) {
        begin();
    }

    void begin() {
        std::fill(m_used.begin(), m_used.end(), 0);
        m_count = 0;
    }

    // Takes the first colour that is free on both bodies; kOverflowColor where none is.
    unsigned take(const int (&body)[2]) {
        std::uint64_t used = 0;
        for (const int end : body)
            if (dxDoesMove(end, m_moves)) used |= m_used[static_cast<unsigned>(end)];
        const auto color = static_cast<unsigned>(__builtin_ctzll(~used | std::uint64_t(1) << kOverflowColor));
        if (color == kOverflowColor) return color;
        m_count = std::max(m_count, color + 1);
        for (const int end : body)
            if (dxDoesMove(end, m_moves)) m_used[static_cast<unsigned>(end)] |= std::uint64_t(1) << color;
        return color;
    }

    unsigned count() const { return m_count; }

private:
    const dxArenaArray<const std::uint8_t> m_moves;
    const dxArenaArray<std::uint64_t> m_used;  // by body: a bit for each colour
    unsigned m_count = 0;
};

// Places constraints in packs, a colour after the other. In a colour those with many contacts or rows come first, so that the lanes of a
// pack have similar numbers of them.
class PackPlaces {
public:
    static constexpr unsigned kMaxSize = std::max(dxContactPack::kMaxContacts, dxConstraintRow::kMaxOfJoint);

    struct Place {
        unsigned pack, lane;
    };

    // A constraint has a colour and `size` contacts or rows.
    void count(unsigned color, unsigned size) { ++placeOf(color, size); }

    // Writes the first pack of each colour, and the end. Returns the number of packs, and of their contacts or rows.
    dxPackCount makePacks(unsigned colors, unsigned *firstPack) {
        dxPackCount packs = {0, 0};
        for (unsigned color = 0; color < colors; ++color) {
            firstPack[color] = static_cast<unsigned>(packs.packs);
            unsigned count = 0;
            for (unsigned size = kMaxSize; size > 0; --size) {
                const unsigned own = std::exchange(placeOf(color, size), firstPack[color] * dxLanes::kCount + count);
                packs.contacts += (dxLanes::packsOf(count + own) - dxLanes::packsOf(count)) * size;
                count += own;
            }
            packs.packs += dxLanes::packsOf(count);
        }
        firstPack[colors] = static_cast<unsigned>(packs.packs);
        return packs;
    }

    // Requires makePacks(). Once for each constraint that was counted.
    Place take(unsigned color, unsigned size) {
        const unsigned number = placeOf(color, size)++;
        return {number / dxLanes::kCount, number % dxLanes::kCount};
    }

private:
    unsigned &placeOf(unsigned color, unsigned size) { return m_places[color * kMaxSize + size - 1]; }

    unsigned m_places[EdgeColors::kMaxColors * kMaxSize] = {};  // the number of constraints; then the place of the next one
};

}  // namespace

class dxConstraintPlan::Maker {
public:
    Maker(dxConstraintPlan &plan, const dxIsland &group, dxStepArena &arena)
        : m_plan(plan), m_group(group), m_arena(arena), m_moves(findMoving(group, arena)), m_reach(arena.take<unsigned>(group.bodyCount)),
          m_colors(m_moves, arena) {}

    void make() {
        readJoints();
        findIslands();
        placeContacts();
        placeJoints();
        listRowJoints();
        colorRowJoints();
        cutChunks();
    }

private:
    static dxArenaArray<const std::uint8_t> findMoving(const dxIsland &group, dxStepArena &arena) {
        const dxArenaArray<std::uint8_t> moves = arena.take<std::uint8_t>(group.bodyCount);
        for (unsigned i = 0; i < group.bodyCount; ++i) moves[i] = group.bodies[i]->invMass > 0;
        return moves;
    }

    void readJoints();
    void addContact(unsigned joint, const int (&body)[2], bool mayBeLane, bool continuesLast);
    void connect(const int (&body)[2]);
    void findIslands();

    void placeContacts();
    bool placeInSequence(std::size_t contacts);
    bool placeByColor();
    void placeInRows();
    std::size_t contactsOfBusiestBody() const;
    void makePacks(const dxPackCount &count);

    void placeJoints();
    void makeJointPacks(std::size_t count, PackPlaces &places);

    void listRowJoints();
    void colorRowJoints();
    void cutChunks();
    template <class AddChunks>
    void addPhase(const AddChunks &addChunks);
    void cut(unsigned begin, unsigned end, unsigned size, unsigned Chunk::*chunkBegin, unsigned Chunk::*chunkEnd);
    void cutPacks(unsigned begin, unsigned end) { cut(begin, end, kPacksPerChunk, &Chunk::firstPack, &Chunk::endPack); }
    void cutJointPacks(unsigned begin, unsigned end) { cut(begin, end, kPacksPerChunk, &Chunk::firstJointPack, &Chunk::endJointPack); }
    void cutRowJoints(unsigned begin, unsigned end, unsigned size) { cut(begin, end, size, &Chunk::firstRowJoint, &Chunk::endRowJoint); }

    static bool fillsLanes(std::size_t contacts, std::size_t packedContacts) { return contacts > kMinLanes * packedContacts; }

    dxConstraintPlan &m_plan;
    const dxIsland &m_group;
    dxStepArena &m_arena;
    const dxArenaArray<const std::uint8_t> m_moves;  // by body
    const dxArenaArray<unsigned> m_reach;            // by body: the last one that is connected with it, or with one before it
    EdgeColors m_colors;
    // Joints that are no contacts.
    struct OtherJoint {
        unsigned joint;
        int body[2];
        std::uint8_t color, laneRows;  // laneRows: 0: in rows
    };
    dxArenaArray<OtherJoint> m_otherJoints;
    std::size_t m_laneContacts = 0, m_rowContacts = 0;  // in manifolds that may be lanes, and in others
    std::size_t m_laneManifolds = 0;
    unsigned m_packColors = 0, m_jointPackColors = 0;  // without colours, packs follow one another, and there are no packs of joints
    // By colour, and the end; of row joints, the overflow comes last.
    unsigned m_firstPack[EdgeColors::kMaxColors + 1], m_firstJointPack[EdgeColors::kMaxColors + 1];
    unsigned m_firstRowJoint[EdgeColors::kMaxColors + 2];
};

void dxConstraintPlan::make(const dxIsland &group, dxStepArena &arena) {
    m_joints = group.joints;
    Maker(*this, group, arena).make();
}

void dxConstraintPlan::Maker::readJoints() {
    m_plan.m_manifolds = m_arena.takeList<Manifold>(m_group.jointCount);
    m_otherJoints = m_arena.takeList<OtherJoint>(m_group.jointCount);
    std::iota(m_reach.begin(), m_reach.end(), 0u);
    bool isAfterContact = false;
    const auto read = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const dxJoint &joint = *m_group.joints[i];
            const int body[2] = {tagOf(joint.node[0].body), tagOf(joint.node[1].body)};
            if (isContact(joint)) {
                addContact(static_cast<unsigned>(i), body, !isRolling(joint), std::exchange(isAfterContact, true));
                continue;
            }
            isAfterContact = false;
            connect(body);
            m_otherJoints.push({static_cast<unsigned>(i), {body[0], body[1]}, EdgeColors::kOverflowColor, 0});
        }
    };
    if (m_group.bodyCount < dxIslandPrefetch::kMinBodies) return read(0, m_group.jointCount);
    dxIslandPrefetch::forChunks(
        0, m_group.jointCount, m_group.jointCount, [this](std::size_t i) { dxIslandPrefetch::joint(m_group.joints[i]); }, read);
}

// Contacts of two bodies follow one another, since they were attached one after the other. `continuesLast`: the joint before this one is a
// contact, too.
void dxConstraintPlan::Maker::addContact(unsigned joint, const int (&body)[2], bool mayBeLane, bool continuesLast) {
    const dxArenaArray<Manifold> &manifolds = m_plan.m_manifolds;
    const auto continues = [&](const Manifold &manifold) {
        return (mayBeLane || manifold.isInRows()) && manifold.body[0] == body[0] && manifold.body[1] == body[1] &&
               manifold.contactCount < kMaxContacts;
    };
    if (continuesLast && continues(manifolds.back())) {
        ++manifolds.back().contactCount;
    } else {
        connect(body);
        const auto lane = mayBeLane ? std::uint8_t(0) : Manifold::kNoLane;
        m_plan.m_manifolds.push({joint, 1, EdgeColors::kOverflowColor, lane, false, 0, {body[0], body[1]}});
        m_laneManifolds += mayBeLane;
    }
    ++(manifolds.back().isInRows() ? m_rowContacts : m_laneContacts);
}

void dxConstraintPlan::Maker::connect(const int (&body)[2]) {
    if (body[0] == kNoBody || body[1] == kNoBody) return;
    const auto [first, last] = std::minmax(body[0], body[1]);
    unsigned &reach = m_reach[static_cast<unsigned>(first)];
    reach = std::max(reach, static_cast<unsigned>(last));
}

// Islands follow one another in the group.
void dxConstraintPlan::Maker::findIslands() {
    m_plan.m_islands = m_arena.takeList<Island>(m_group.bodyCount);
    m_plan.m_islandOfBody = m_arena.take<unsigned>(m_group.bodyCount);
    unsigned first = 0, last = 0;
    for (unsigned i = 0; i < m_group.bodyCount; ++i) {
        m_plan.m_islandOfBody[i] = static_cast<unsigned>(m_plan.m_islands.size());
        last = std::max(last, m_reach[i]);
        if (last != i) continue;
        m_plan.m_islands.push({first, i + 1});
        first = last = i + 1;
    }
}

// Beside other joints, few contacts are rows: swept in lanes after all joints, the error that those leave would tilt columns that stand on both.
void dxConstraintPlan::Maker::placeContacts() {
    m_plan.m_packs = {};
    m_plan.m_packedContacts = 0;
    if (m_laneManifolds == 0) return;
    const bool mayBeRows = m_laneContacts + m_rowContacts + m_otherJoints.size() <= kMaxSerial;
    if (mayBeRows && !m_otherJoints.empty()) return placeInRows();
    if (m_laneManifolds <= kMaxSequence && placeInSequence(m_laneContacts)) return;
    if (mayBeRows || !placeByColor()) placeInRows();
}

// An island is solved upwards or downwards. Only upwards, columns of eight or ten boxes lean further with each step until they fall; only downwards,
// they move more and fall sooner. Returns whether lanes are filled.
bool dxConstraintPlan::Maker::placeInSequence(std::size_t contacts) {
    if (!fillsLanes(contacts, contactsOfBusiestBody())) return false;
    const dxArenaArray<std::uint8_t> isDown = m_arena.take<std::uint8_t>(m_group.bodyCount);
    for (const Island &island : m_plan.m_islands)
        std::fill(isDown.begin() + island.firstBody, isDown.begin() + island.endBody, goesDown(*m_group.bodies[island.firstBody]));
    const dxPackCount count = dxOrderPacks(m_plan.m_manifolds, m_moves, isDown, m_arena);
    if (!fillsLanes(contacts, count.contacts)) return false;
    makePacks(count);
    return true;
}

// The manifolds of a body are in different packs, which have at least their contacts.
std::size_t dxConstraintPlan::Maker::contactsOfBusiestBody() const {
    const dxArenaArray<unsigned> contacts = m_arena.takeFilled(m_group.bodyCount, 0u);
    m_plan.forLaneManifolds([&](const Manifold &manifold) {
        for (const int body : manifold.body)
            if (dxDoesMove(body, m_moves)) contacts[static_cast<unsigned>(body)] += manifold.contactCount;
    });
    return *std::max_element(contacts.begin(), contacts.end());
}

// Returns whether lanes are filled; the overflow is in rows then.
bool dxConstraintPlan::Maker::placeByColor() {
    std::size_t contacts = 0;
    PackPlaces places;
    m_plan.forLaneManifolds([&](Manifold &manifold) {
        manifold.color = static_cast<std::uint8_t>(m_colors.take(manifold.body));
        if (manifold.color == EdgeColors::kOverflowColor) return;
        contacts += manifold.contactCount;
        places.count(manifold.color, manifold.contactCount);
    });
    const dxPackCount packs = places.makePacks(m_colors.count(), m_firstPack);
    if (contacts != 0 && !fillsLanes(contacts, packs.contacts)) {
        m_colors.begin();
        return false;
    }
    m_packColors = m_colors.count();
    m_plan.forLaneManifolds([&](Manifold &manifold) {
        if (manifold.color == EdgeColors::kOverflowColor) {
            manifold.lane = Manifold::kNoLane;
            --m_laneManifolds;
            return;
        }
        const PackPlaces::Place place = places.take(manifold.color, manifold.contactCount);
        manifold.pack = place.pack;
        manifold.lane = static_cast<std::uint8_t>(place.lane);
    });
    m_rowContacts += m_laneContacts - contacts;
    m_laneContacts = contacts;
    makePacks(packs);
    return true;
}

void dxConstraintPlan::Maker::placeInRows() {
    for (Manifold &manifold : m_plan.m_manifolds) manifold.lane = Manifold::kNoLane;
    m_rowContacts += std::exchange(m_laneContacts, 0);
    m_laneManifolds = 0;
}

void dxConstraintPlan::Maker::makePacks(const dxPackCount &count) {
    m_plan.m_packs = m_arena.take<dxContactPack>(count.packs);
    std::memset(m_plan.m_packs.data(), 0, count.packs * sizeof(dxContactPack));
    m_plan.forLaneManifolds([this](const Manifold &manifold) {
        dxContactPack &pack = m_plan.m_packs[manifold.pack];
        pack.contactCount = std::max<unsigned>(pack.contactCount, manifold.contactCount);
    });
    for (dxContactPack &pack : m_plan.m_packs) {
        pack.firstContact = m_plan.m_packedContacts;
        m_plan.m_packedContacts += pack.contactCount;
    }
}

// Joints of large groups are coloured after the contacts. In small groups with contacts all constraints are rows (placeContacts).
void dxConstraintPlan::Maker::placeJoints() {
    m_plan.m_jointPacks = {};
    m_plan.m_laneJoints = {};
    m_plan.m_feedbackLanes = {};
    m_plan.m_packedRows = 0;
    const bool hasContacts = m_laneContacts + m_rowContacts != 0;
    if (hasContacts && m_rowContacts + m_otherJoints.size() <= kMaxSerial) return;
    if (m_otherJoints.size() <= kPackRowTime) return;  // however few packs they are, rows take less time
    std::size_t rows = 0;
    PackPlaces places;
    for (OtherJoint &other : m_otherJoints) {
        const unsigned laneRows = laneRowsOf(*m_group.joints[other.joint]);
        if (laneRows == 0) continue;
        other.color = static_cast<std::uint8_t>(m_colors.take(other.body));
        if (other.color == EdgeColors::kOverflowColor) continue;
        other.laneRows = static_cast<std::uint8_t>(laneRows);
        rows += laneRows;
        places.count(other.color, laneRows);
    }
    const dxPackCount packs = places.makePacks(m_colors.count(), m_firstJointPack);
    if (rows > kPackTime * packs.packs + kPackRowTime * packs.contacts) return makeJointPacks(packs.packs, places);
    for (OtherJoint &other : m_otherJoints) other.laneRows = 0;
}

void dxConstraintPlan::Maker::makeJointPacks(std::size_t count, PackPlaces &places) {
    m_jointPackColors = m_colors.count();
    m_plan.m_jointPacks = m_arena.take<dxJointPack>(count);
    std::memset(m_plan.m_jointPacks.data(), 0, count * sizeof(dxJointPack));
    m_plan.m_laneJoints = m_arena.takeFilled(count * dxLanes::kCount, LaneJoint{LaneJoint::kNone, {kNoBody, kNoBody}, 0});
    m_plan.m_feedbackLanes = m_arena.takeList<unsigned>(m_otherJoints.size());
    m_plan.m_hasPassiveLaneJoints = true;
    for (const OtherJoint &other : m_otherJoints) {
        if (other.laneRows == 0) continue;
        const dxJoint &joint = *m_group.joints[other.joint];
        const PackPlaces::Place place = places.take(other.color, other.laneRows);
        const unsigned lane = place.pack * dxLanes::kCount + place.lane;
        m_plan.m_laneJoints[lane] = {other.joint, {other.body[0], other.body[1]}, 0};
        if (joint.feedback != nullptr) m_plan.m_feedbackLanes.push(lane);
        m_plan.m_hasPassiveLaneJoints &= isPassive(joint);
        dxJointPack &pack = m_plan.m_jointPacks[place.pack];
        pack.rowCount = std::max<unsigned>(pack.rowCount, other.laneRows);
    }
    for (dxJointPack &pack : m_plan.m_jointPacks) pack.firstRow = std::exchange(m_plan.m_packedRows, m_plan.m_packedRows + pack.rowCount);
}

// Merges contacts and other joints in the order of the group.
void dxConstraintPlan::Maker::listRowJoints() {
    m_plan.m_rowManifolds = m_plan.m_manifolds.size() - m_laneManifolds;
    m_plan.m_laneContacts = static_cast<unsigned>(m_laneContacts);
    m_plan.m_hasContactsOnly = m_otherJoints.empty();
    m_plan.m_rowJoints = m_arena.takeList<RowJoint>(m_rowContacts + m_otherJoints.size());
    std::size_t next = 0;
    const auto listOthersBefore = [&](unsigned joint) {
        for (; next < m_otherJoints.size() && m_otherJoints[next].joint < joint; ++next) {
            const OtherJoint &other = m_otherJoints[next];
            if (other.laneRows != 0) continue;
            m_plan.m_rowJoints.push({other.joint, other.body[0] != kNoBody ? other.body[0] : other.body[1], other.color});
        }
    };
    m_plan.forRowManifolds([&](Manifold &manifold) {
        listOthersBefore(manifold.firstJoint);
        manifold.pack = static_cast<unsigned>(m_plan.m_rowJoints.size());
        for (unsigned i = 0; i < manifold.contactCount; ++i)
            m_plan.m_rowJoints.push({manifold.firstJoint + i, manifold.body[0], EdgeColors::kOverflowColor});
    });
    listOthersBefore(m_group.jointCount);
}

void dxConstraintPlan::Maker::colorRowJoints() {
    const dxArenaArray<RowJoint> &joints = m_plan.m_rowJoints;
    m_plan.m_hasSerialRows = joints.size() <= kMaxSerial;
    m_plan.m_rowJointsInOrder = m_arena.take<unsigned>(joints.size());
    if (m_plan.m_hasSerialRows) return std::iota(m_plan.m_rowJointsInOrder.begin(), m_plan.m_rowJointsInOrder.end(), 0u);
    for (RowJoint &row : joints) {
        if (row.color != EdgeColors::kOverflowColor) continue;  // it has one already
        const dxJoint &joint = *m_plan.jointOf(row);
        row.color = static_cast<std::uint8_t>(m_colors.take({tagOf(joint.node[0].body), tagOf(joint.node[1].body)}));
    }
    const unsigned colors = m_colors.count();
    const auto placeOf = [colors](unsigned color) { return std::min(color, colors); };
    std::fill_n(m_firstRowJoint, colors + 2, 0u);
    for (const RowJoint &row : joints) ++m_firstRowJoint[placeOf(row.color) + 1];
    for (unsigned place = 0; place <= colors; ++place) m_firstRowJoint[place + 1] += m_firstRowJoint[place];
    unsigned next[EdgeColors::kMaxColors + 1];
    std::copy_n(m_firstRowJoint, colors + 1, next);
    for (unsigned i = 0; i < joints.size(); ++i) m_plan.m_rowJointsInOrder[next[placeOf(joints[i].color)]++] = i;
}

void dxConstraintPlan::Maker::cutChunks() {
    const auto rows = static_cast<unsigned>(m_plan.m_rowJoints.size()), colors = m_colors.count();
    const auto allPacks = static_cast<unsigned>(m_plan.m_packs.size());
    const unsigned maxPhases = 3 + colors + allPacks / kPacksPerChunk;
    m_plan.m_phases = m_arena.takeList<Phase>(maxPhases);
    const std::size_t full = (allPacks + m_plan.m_jointPacks.size()) / kPacksPerChunk + rows / kRowJointsPerChunk;
    m_plan.m_chunks = m_arena.takeList<Chunk>(3 * maxPhases + full);
    const bool isSerial = m_plan.m_hasSerialRows;
    if (isSerial) addPhase([&] { cutRowJoints(0, rows, rows); });
    for (unsigned color = 0; color < colors; ++color)
        addPhase([&] {
            if (color < m_packColors) cutPacks(m_firstPack[color], m_firstPack[color + 1]);
            if (color < m_jointPackColors) cutJointPacks(m_firstJointPack[color], m_firstJointPack[color + 1]);
            if (!isSerial) cutRowJoints(m_firstRowJoint[color], m_firstRowJoint[color + 1], kRowJointsPerChunk);
        });
    const unsigned packs = m_packColors == 0 ? allPacks : 0;
    for (unsigned i = 0; i < packs; i += kPacksPerChunk) addPhase([&] { cutPacks(i, std::min(i + kPacksPerChunk, packs)); });
    const unsigned overflow = isSerial ? rows : m_firstRowJoint[colors];
    addPhase([&] { cutRowJoints(overflow, rows, rows); });
}

template <class AddChunks>
void dxConstraintPlan::Maker::addPhase(const AddChunks &addChunks) {
    const auto first = static_cast<unsigned>(m_plan.m_chunks.size());
    addChunks();
    const auto end = static_cast<unsigned>(m_plan.m_chunks.size());
    if (end != first) m_plan.m_phases.push({first, end});
}

// Makes chunks of at most `size`, of the kind that the members name.
void dxConstraintPlan::Maker::cut(unsigned begin, unsigned end, unsigned size, unsigned Chunk::*chunkBegin, unsigned Chunk::*chunkEnd) {
    for (; begin < end; begin += size) {
        Chunk chunk = {};
        chunk.*chunkBegin = begin;
        chunk.*chunkEnd = std::min(begin + size, end);
        m_plan.m_chunks.push(chunk);
    }
}
