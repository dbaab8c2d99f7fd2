#include "dynamics/iterative/dxConstraintPlan.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "joints/contact.h"

#include "dynamics/islands/dxIslandPrefetch.h"

namespace {

// Some ten microseconds of a sweep.
constexpr unsigned kPacksPerChunk = 16, kOthersPerChunk = 64;

// Up to so many are solved by one thread, before contacts.
constexpr std::size_t kMaxSerial = 1000;

// A pack takes as long for one manifold as for eight, about four times as long as their rows.
constexpr unsigned kLeastLanes = 2;

bool isContact(const dxJoint &joint) { return joint.type() == dJointTypeContact; }

bool isRolling(const dxJoint &contact) {
    return (static_cast<const dxJointContact &>(contact).contact.surface.mode & dContactRolling) != 0;
}

int tagOf(const dxBody *body) { return body != nullptr ? body->tag : dxConstraintPlan::kNoBody; }

}  // namespace

void dxConstraintPlan::make(const dxIsland &group) {
    m_joints = group.joints;
    m_used.assign(group.bodyCount, 0);
    m_moves.resize(group.bodyCount);
    for (unsigned i = 0; i < group.bodyCount; ++i) m_moves[i] = group.bodies[i]->invMass > 0;
    m_reach.resize(group.bodyCount);
    std::iota(m_reach.begin(), m_reach.end(), 0u);
    findManifolds(group, true);
    findIslands(group.bodyCount);
    placeManifolds();
    if (!fillsLanes()) {
        std::fill(m_used.begin(), m_used.end(), 0);
        findManifolds(group, false);
        placeManifolds();
    }
    placeOthers();
    cutChunks();
}

void dxConstraintPlan::reserveAs(const dxConstraintPlan &other) {
    m_used.reserve(other.m_used.capacity());
    m_moves.reserve(other.m_moves.capacity());
    m_reach.reserve(other.m_reach.capacity());
    m_islands.reserve(other.m_islands.capacity());
    m_islandOfBody.reserve(other.m_islandOfBody.capacity());
    m_manifolds.reserve(other.m_manifolds.capacity());
    m_rowManifolds.reserve(other.m_rowManifolds.capacity());
    m_others.reserve(other.m_others.capacity());
    m_othersInOrder.reserve(other.m_othersInOrder.capacity());
    m_packs.reserve(other.m_packs.capacity());
    m_chunks.reserve(other.m_chunks.capacity());
    m_phases.reserve(other.m_phases.capacity());
}

unsigned dxConstraintPlan::colorOf(const int (&body)[2]) {
    std::uint64_t used = 0;
    for (const int end : body)
        if (end != kNoBody && m_moves[static_cast<unsigned>(end)]) used |= m_used[static_cast<unsigned>(end)];
    const std::uint64_t free = ~used;
    const unsigned color = std::min(static_cast<unsigned>(__builtin_ctzll(free | std::uint64_t(1) << kLeftOver)), kLeftOver);
    if (color == kLeftOver) return color;
    m_colorCount = std::max(m_colorCount, color + 1);
    for (const int end : body)
        if (end != kNoBody) m_used[static_cast<unsigned>(end)] |= std::uint64_t(1) << color;
    return color;
}

void dxConstraintPlan::addOther(unsigned joint, const int (&body)[2]) {
    m_others.push_back({joint, static_cast<std::uint8_t>(colorOf(body))});
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
        const unsigned color = isPacked ? colorOf(body) : kLeftOver;
        last = color == kLeftOver ? &m_rowManifolds : &m_manifolds;
        last->push_back({joint, 1, static_cast<std::uint8_t>(color), 0, false, static_cast<unsigned>(m_others.size()), {body[0], body[1]}});
    }
    if (last == &m_rowManifolds) addOther(joint, body);
}

void dxConstraintPlan::findManifolds(const dxIsland &group, bool packsContacts) {
    m_manifolds.clear();
    m_rowManifolds.clear();
    m_others.clear();
    m_colorCount = 0;
    std::vector<Manifold> *last = nullptr;
    const auto read = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const dxJoint &joint = *group.joints[i];
            const int body[2] = {tagOf(joint.node[0].body), tagOf(joint.node[1].body)};
            if (isContact(joint)) {
                addContact(static_cast<unsigned>(i), body, packsContacts && !isRolling(joint), last);
                continue;
            }
            last = nullptr;
            connect(body);
            addOther(static_cast<unsigned>(i), body);
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

unsigned dxConstraintPlan::islandOf(const OtherJoint &other) const {
    const dxJoint &joint = *jointOf(other);
    const dxBody *const body = joint.node[0].body != nullptr ? joint.node[0].body : joint.node[1].body;
    return m_islandOfBody[static_cast<unsigned>(body->tag)];
}

bool dxConstraintPlan::fillsLanes() const {
    std::size_t contacts = 0;
    for (const Manifold &manifold : m_manifolds) contacts += manifold.contactCount;
    return contacts == 0 || contacts > std::size_t(kLeastLanes) * m_packedContacts;
}

// By colour, those with many contacts first, so that packs have little to fill up.
void dxConstraintPlan::placeManifolds() {
    constexpr unsigned kMost = dxContactPack::kMaxContacts;
    unsigned place[kColors * kMost];
    std::fill_n(place, m_colorCount * kMost, 0u);
    const auto placeOf = [&place](const Manifold &manifold) -> unsigned & {
        return place[manifold.color * kMost + (kMost - manifold.contactCount)];
    };
    for (const Manifold &manifold : m_manifolds) ++placeOf(manifold);
    unsigned packs = 0;
    constexpr unsigned kLanes = dxLanes::kCount;
    for (unsigned color = 0; color < m_colorCount; ++color) {
        m_firstPack[color] = packs;
        unsigned count = 0;
        for (unsigned i = 0; i < kMost; ++i) count += std::exchange(place[color * kMost + i], packs * kLanes + count);
        packs += (count + kLanes - 1) / kLanes;
    }
    m_firstPack[m_colorCount] = packs;
    m_packs.clear();
    m_packs.resize(packs);
    for (Manifold &manifold : m_manifolds) {
        const unsigned number = placeOf(manifold)++;
        manifold.pack = number / kLanes;
        manifold.lane = static_cast<std::uint8_t>(number % kLanes);
        dxContactPack &pack = m_packs[manifold.pack];
        pack.contactCount = std::max<unsigned>(pack.contactCount, manifold.contactCount);
    }
    m_packedContacts = 0;
    for (dxContactPack &pack : m_packs) {
        pack.firstContact = m_packedContacts;
        m_packedContacts += pack.contactCount;
    }
}

void dxConstraintPlan::placeOthers() {
    std::size_t contacts = 0;
    for (const Manifold &manifold : m_rowManifolds) contacts += manifold.contactCount;
    m_hasContactsOnly = contacts == m_others.size();
    m_isSerial = m_others.size() <= kMaxSerial;
    m_othersInOrder.resize(m_others.size());
    const auto placeOf = [this](unsigned color) { return color == kLeftOver ? m_colorCount : color; };
    std::fill_n(m_firstOther, m_colorCount + 2, 0u);
    for (const OtherJoint &other : m_others) ++m_firstOther[placeOf(other.color) + 1];
    for (unsigned place = 0; place <= m_colorCount; ++place) m_firstOther[place + 1] += m_firstOther[place];
    if (m_isSerial && !m_hasContactsOnly) return std::iota(m_othersInOrder.begin(), m_othersInOrder.end(), 0u);
    unsigned next[kColors + 1];
    std::copy_n(m_firstOther, m_colorCount + 1, next);
    for (unsigned i = 0; i < m_others.size(); ++i) m_othersInOrder[next[placeOf(m_others[i].color)]++] = i;
}

void dxConstraintPlan::cutChunks() {
    m_chunks.clear();
    m_phases.clear();
    if (m_isSerial && !m_others.empty()) {
        m_chunks.push_back({0, 0, 0, static_cast<unsigned>(m_others.size())});
        m_phases.push_back({0, 1});
    }
    for (unsigned color = 0; color < m_colorCount; ++color) {
        const unsigned firstChunk = static_cast<unsigned>(m_chunks.size()), pack = m_firstPack[color],
                       endPack = m_firstPack[color + 1], endOther = m_isSerial ? 0 : m_firstOther[color + 1];
        for (unsigned i = pack; i < endPack; i += kPacksPerChunk)
            m_chunks.push_back({i, std::min(i + kPacksPerChunk, endPack), 0, 0});
        for (unsigned i = m_firstOther[color]; i < endOther; i += kOthersPerChunk)
            m_chunks.push_back({0, 0, i, std::min(i + kOthersPerChunk, endOther)});
        if (m_chunks.size() != firstChunk) m_phases.push_back({firstChunk, static_cast<unsigned>(m_chunks.size())});
    }
    const unsigned leftOver = m_firstOther[m_colorCount], count = static_cast<unsigned>(m_others.size());
    if (m_isSerial || leftOver == count) return;
    m_phases.push_back({static_cast<unsigned>(m_chunks.size()), static_cast<unsigned>(m_chunks.size()) + 1});
    m_chunks.push_back({0, 0, leftOver, count});
}
