#include "dynamics/quick_step/fast/dxConstraintPlan.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/step/islands/dxIslandPrefetch.h"

namespace {

// Some ten microseconds of a sweep.
constexpr unsigned kPacksPerChunk = 16, kOthersPerChunk = 64;

// Up to so many are solved by one thread, before contacts.
constexpr std::size_t kMaxSerial = 1000;

// So many manifolds are one thread's, too: their sweep takes some twenty microseconds.
constexpr std::size_t kMaxSequence = 1024;

// A pack takes as long for one manifold as for eight: about as long as the rows of four, with vectors of 256 bits of five.
constexpr unsigned kLeastLanes = 4;

bool isContact(const dxJoint &joint) { return joint.type() == dJointTypeContact; }

bool isRolling(const dxJoint &contact) {
    return (static_cast<const dxJointContact &>(contact).contact.surface.mode & dContactRolling) != 0;
}

std::size_t contactsOf(const std::vector<dxContactManifold> &manifolds) {
    std::size_t count = 0;
    for (const dxContactManifold &manifold : manifolds) count += manifold.contactCount;
    return count;
}

// Drawn anew in each step, as long as the body moves.
bool goesDown(const dxBody &body) { return (dxStateNumbers::bitsOf(body.posr.pos) & 2) != 0; }

int tagOf(const dxBody *body) { return body != nullptr ? body->tag : dxConstraintPlan::kNoBody; }

}  // namespace

void dxConstraintPlan::make(const dxIsland &group) {
    m_joints = group.joints;
    m_moves.resize(group.bodyCount);
    for (unsigned i = 0; i < group.bodyCount; ++i) m_moves[i] = group.bodies[i]->invMass > 0;
    m_reach.resize(group.bodyCount);
    std::iota(m_reach.begin(), m_reach.end(), 0u);
    readJoints(group);
    findIslands(group.bodyCount);
    placeManifolds(group);
    placeOthers();
    cutChunks();
}

void dxConstraintPlan::reserveAs(const dxConstraintPlan &other) {
    m_colors.reserveAs(other.m_colors);
    m_moves.reserve(other.m_moves.capacity());
    m_reach.reserve(other.m_reach.capacity());
    m_islands.reserve(other.m_islands.capacity());
    m_islandOfBody.reserve(other.m_islandOfBody.capacity());
    m_manifolds.reserve(other.m_manifolds.capacity());
    m_rowManifolds.reserve(other.m_rowManifolds.capacity());
    m_others.reserve(other.m_others.capacity());
    m_othersInOrder.reserve(other.m_othersInOrder.capacity());
    m_goesDown.reserve(other.m_goesDown.capacity());
    m_packOrder.reserveAs(other.m_packOrder);
    m_packs.reserve(other.m_packs.capacity());
    m_chunks.reserve(other.m_chunks.capacity());
    m_phases.reserve(other.m_phases.capacity());
}

// Contacts of two bodies follow one another, since they were attached one after the other. `last`: the list that the joint before
// this one has gone to, if that is a contact.
void dxConstraintPlan::addContact(unsigned joint, const int (&body)[2], bool isPacked, std::vector<Manifold> *&last) {
    const auto continues = [&](const Manifold &manifold) {
        return manifold.body[0] == body[0] && manifold.body[1] == body[1] &&
               manifold.contactCount < dxContactPack::kMaxContacts;
    };
    if (last != nullptr && (isPacked || last == &m_rowManifolds) && continues(last->back())) {
        ++last->back().contactCount;
    } else {
        connect(body);
        last = isPacked ? &m_manifolds : &m_rowManifolds;
        last->push_back({joint, 1, dxEdgeColors::kLeftOver, 0, false, static_cast<unsigned>(m_others.size()), {body[0], body[1]}});
    }
    if (last == &m_rowManifolds) m_others.push_back({joint, body[0], dxEdgeColors::kLeftOver});
}

void dxConstraintPlan::readJoints(const dxIsland &group) {
    m_manifolds.clear();
    m_rowManifolds.clear();
    m_others.clear();
    std::vector<Manifold> *last = nullptr;
    const auto read = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const dxJoint &joint = *group.joints[i];
            const int body[2] = {tagOf(joint.node[0].body), tagOf(joint.node[1].body)};
            if (isContact(joint)) {
                addContact(static_cast<unsigned>(i), body, !isRolling(joint), last);
                continue;
            }
            last = nullptr;
            connect(body);
            m_others.push_back({static_cast<unsigned>(i), body[0] != kNoBody ? body[0] : body[1], dxEdgeColors::kLeftOver});
        }
    };
    if (group.bodyCount < dxIslandPrefetch::kMinBodies) return read(0, group.jointCount);
    dxIslandPrefetch::forChunks(
        0, group.jointCount, group.jointCount, [&group](std::size_t i) { dxIslandPrefetch::joint(group.joints[i]); }, read);
}

void dxConstraintPlan::connect(const int (&body)[2]) {
    if (body[0] == kNoBody || body[1] == kNoBody) return;
    const auto [first, last] = std::minmax(body[0], body[1]);
    unsigned &reach = m_reach[static_cast<unsigned>(first)];
    reach = std::max(reach, static_cast<unsigned>(last));
}

// Islands follow one another in the group.
void dxConstraintPlan::findIslands(unsigned bodyCount) {
    m_islands.clear();
    m_islandOfBody.resize(bodyCount);
    unsigned first = 0, last = 0;
    for (unsigned i = 0; i < bodyCount; ++i) {
        m_islandOfBody[i] = static_cast<unsigned>(m_islands.size());
        last = std::max(last, m_reach[i]);
        if (last != i) continue;
        m_islands.push_back({first, i + 1});
        first = last = i + 1;
    }
}

void dxConstraintPlan::placeManifolds(const dxIsland &group) {
    m_colors.begin(m_moves);
    if (m_manifolds.size() > kMaxSequence || !placeInSequence(group)) placeByColor();
    m_packColors = m_colors.count();
}

// Returns whether that is done: vectors are filled, or so few contacts remain that they are rows. Beside joints contacts are rows in any case:
// swept after all joints, what those have not found would tilt columns that stand on both.
bool dxConstraintPlan::placeInSequence(const dxIsland &group) {
    const bool haveJoints = m_others.size() != contactsOf(m_rowManifolds);
    const bool mayBeRows = contactsOf(m_manifolds) + m_others.size() <= kMaxSerial;
    if (!haveJoints || !mayBeRows) {
        drawDirections(group);
        makePacks(m_packOrder.place(m_manifolds, m_moves, m_goesDown));
        if (fillsLanes()) return true;
        if (!mayBeRows) return false;
    }
    moveToRows([](const Manifold &) { return true; });
    return true;
}

// An island is solved from the ground up, or down. Up alone, columns of eight or ten boxes lean further with each step until they fall; down
// alone, they move more and fall sooner.
void dxConstraintPlan::drawDirections(const dxIsland &group) {
    m_goesDown.resize(group.bodyCount);
    for (const Island &island : m_islands)
        std::fill(m_goesDown.begin() + island.firstBody, m_goesDown.begin() + island.endBody, goesDown(*group.bodies[island.firstBody]));
}

void dxConstraintPlan::placeByColor() {
    for (Manifold &manifold : m_manifolds) manifold.color = static_cast<std::uint8_t>(m_colors.take(manifold.body));
    moveToRows([](const Manifold &manifold) { return manifold.color == dxEdgeColors::kLeftOver; });
    sortByColor();
    if (fillsLanes()) return;
    m_colors.begin(m_moves);
    moveToRows([](const Manifold &) { return true; });
}

// Those with many contacts first, so that packs have little to fill up.
void dxConstraintPlan::sortByColor() {
    constexpr unsigned kMost = dxContactPack::kMaxContacts, kLanes = dxLanes::kCount;
    const unsigned colors = m_colors.count();
    unsigned place[dxEdgeColors::kMost * kMost];
    std::fill_n(place, colors * kMost, 0u);
    const auto placeOf = [&place](const Manifold &manifold) -> unsigned & {
        return place[manifold.color * kMost + (kMost - manifold.contactCount)];
    };
    for (const Manifold &manifold : m_manifolds) ++placeOf(manifold);
    unsigned packs = 0;
    for (unsigned color = 0; color < colors; ++color) {
        m_firstPack[color] = packs;
        unsigned count = 0;
        for (unsigned i = 0; i < kMost; ++i) count += std::exchange(place[color * kMost + i], packs * kLanes + count);
        packs += (count + kLanes - 1) / kLanes;
    }
    m_firstPack[colors] = packs;
    for (Manifold &manifold : m_manifolds) {
        const unsigned number = placeOf(manifold)++;
        manifold.pack = number / kLanes;
        manifold.lane = static_cast<std::uint8_t>(number % kLanes);
    }
    makePacks(packs);
}

void dxConstraintPlan::makePacks(unsigned count) {
    m_packs.clear();
    m_packs.resize(count);
    for (const Manifold &manifold : m_manifolds) {
        dxContactPack &pack = m_packs[manifold.pack];
        pack.contactCount = std::max<unsigned>(pack.contactCount, manifold.contactCount);
    }
    m_packedContacts = 0;
    for (dxContactPack &pack : m_packs) {
        pack.firstContact = m_packedContacts;
        m_packedContacts += pack.contactCount;
    }
}

bool dxConstraintPlan::fillsLanes() const {
    const std::size_t contacts = contactsOf(m_manifolds);
    return contacts == 0 || contacts > std::size_t(kLeastLanes) * m_packedContacts;
}

// All lists are in the order of the group: they are merged from the back. If no manifold remains, neither does a pack.
template <class IsRow>
void dxConstraintPlan::moveToRows(const IsRow &isRow) {
    std::size_t moved = 0, contacts = 0, manifolds = m_rowManifolds.size(), others = m_others.size();
    for (const Manifold &manifold : m_manifolds) {
        if (!isRow(manifold)) continue;
        ++moved;
        contacts += manifold.contactCount;
    }
    if (moved == 0) return;
    m_rowManifolds.resize(manifolds + moved);
    m_others.resize(others + contacts);
    auto rowManifold = m_rowManifolds.rbegin();
    auto other = m_others.rbegin();
    for (auto manifold = m_manifolds.rbegin(); manifold != m_manifolds.rend(); ++manifold) {
        if (!isRow(*manifold)) continue;
        const unsigned first = manifold->firstJoint;
        while (manifolds > 0 && m_rowManifolds[manifolds - 1].firstJoint > first) *rowManifold++ = m_rowManifolds[--manifolds];
        *rowManifold++ = *manifold;
        while (others > 0 && m_others[others - 1].joint > first) *other++ = m_others[--others];
        for (unsigned i = manifold->contactCount; i > 0; --i) *other++ = {first + i - 1, manifold->body[0], dxEdgeColors::kLeftOver};
    }
    m_manifolds.erase(std::remove_if(m_manifolds.begin(), m_manifolds.end(), isRow), m_manifolds.end());
    if (m_manifolds.empty()) makePacks(0);
    unsigned next = 0;
    for (Manifold &manifold : m_rowManifolds) {
        while (m_others[next].joint != manifold.firstJoint) ++next;
        manifold.pack = next;
    }
}

void dxConstraintPlan::placeOthers() {
    m_hasContactsOnly = contactsOf(m_rowManifolds) == m_others.size();
    m_isSerial = m_others.size() <= kMaxSerial;
    m_othersInOrder.resize(m_others.size());
    if (m_isSerial) return std::iota(m_othersInOrder.begin(), m_othersInOrder.end(), 0u);
    for (OtherJoint &other : m_others) {
        const dxJoint &joint = *jointOf(other);
        other.color = static_cast<std::uint8_t>(m_colors.take({tagOf(joint.node[0].body), tagOf(joint.node[1].body)}));
    }
    const unsigned colors = m_colors.count();
    const auto placeOf = [colors](unsigned color) { return std::min(color, colors); };
    std::fill_n(m_firstOther, colors + 2, 0u);
    for (const OtherJoint &other : m_others) ++m_firstOther[placeOf(other.color) + 1];
    for (unsigned place = 0; place <= colors; ++place) m_firstOther[place + 1] += m_firstOther[place];
    unsigned next[dxEdgeColors::kMost + 1];
    std::copy_n(m_firstOther, colors + 1, next);
    for (unsigned i = 0; i < m_others.size(); ++i) m_othersInOrder[next[placeOf(m_others[i].color)]++] = i;
}

void dxConstraintPlan::cutChunks() {
    m_chunks.clear();
    m_phases.clear();
    const auto count = static_cast<unsigned>(m_others.size());
    if (m_isSerial && count != 0) addPhase([&] { m_chunks.push_back({0, 0, 0, count}); });
    for (unsigned color = 0; color < m_colors.count(); ++color)
        addPhase([&] {
            if (color < m_packColors) cutPacks(m_firstPack[color], m_firstPack[color + 1]);
            if (!m_isSerial) cutOthers(m_firstOther[color], m_firstOther[color + 1]);
        });
    const unsigned packs = m_packColors == 0 ? static_cast<unsigned>(m_packs.size()) : 0;
    for (unsigned i = 0; i < packs; i += kPacksPerChunk) addPhase([&] { cutPacks(i, std::min(i + kPacksPerChunk, packs)); });
    const unsigned leftOver = m_isSerial ? count : m_firstOther[m_colors.count()];
    if (leftOver != count) addPhase([&] { m_chunks.push_back({0, 0, leftOver, count}); });
}

template <class AddChunks>
void dxConstraintPlan::addPhase(const AddChunks &addChunks) {
    const auto first = static_cast<unsigned>(m_chunks.size());
    addChunks();
    const auto end = static_cast<unsigned>(m_chunks.size());
    if (end != first) m_phases.push_back({first, end});
}

void dxConstraintPlan::cutPacks(unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; i += kPacksPerChunk) m_chunks.push_back({i, std::min(i + kPacksPerChunk, end), 0, 0});
}

void dxConstraintPlan::cutOthers(unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; i += kOthersPerChunk) m_chunks.push_back({0, 0, i, std::min(i + kOthersPerChunk, end)});
}
