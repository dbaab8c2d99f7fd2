#include "collision/broadphase/dxNeighbourBroadphase.h"

namespace {

// Margin of a box as a share of its longest edge. A wider one means fewer queries and more
// candidates that do not touch; between 5 and 20 % the time of a frame is the same within its noise.
constexpr dReal kMargin = 0.1;

// A box that moves gets room for this many moves of the same length, but not more than its longest edge.
constexpr dReal kPredictedMoves = 8;

dReal marginOf(dReal edge, dReal distance) {
    return std::fmax(kMargin * edge, std::fmin(edge, kPredictedMoves * distance));
}

dReal distanceBetween(const dxBounds &a, const dxBounds &b) {
    dReal distance = 0;
    for (int i = 0; i < 6; ++i) distance = std::fmax(distance, std::fabs(a.v[i] - b.v[i]));
    return distance;
}

}  // namespace

void dxNeighbours::insert(Slot slot, const dxBounds &box) {
    if (slot >= m_nodes.size()) m_nodes.resize(slot + 1);
    // Most boxes that are added never move: they get no margin until they do.
    m_nodes[slot].last = box;
    store(slot, box);
}

bool dxNeighbours::move(Slot slot, const dxBounds &box) {
    Node &node = m_nodes[slot];
    const dReal distance = distanceBetween(node.last, box);
    node.last = box;
    if (node.stored.contains(box)) return false;
    remove(slot);
    store(slot, box.isProper() ? box.grown(marginOf(box.longestEdge(), distance)) : box);
    return true;
}

void dxNeighbours::store(Slot slot, const dxBounds &stored) {
    Node &node = m_nodes[slot];
    node.stored = stored;
    m_grid.query(node.stored, [&](Slot other) {
        if (node.stored.overlaps(m_nodes[other].stored)) link(slot, other);
    });
    m_grid.insert(slot, node.stored);
}

void dxNeighbours::remove(Slot slot) {
    m_grid.remove(slot);
    unlinkAll(slot);
}

void dxNeighbours::link(Slot a, Slot b) {
    std::vector<Candidate> &ofA = m_nodes[a].candidates, &ofB = m_nodes[b].candidates;
    const auto atA = static_cast<std::uint32_t>(ofA.size()), atB = static_cast<std::uint32_t>(ofB.size());
    ofA.push_back({b, atB});
    ofB.push_back({a, atA});
}

void dxNeighbours::unlinkAll(Slot slot) {
    for (const Candidate &candidate : m_nodes[slot].candidates) {
        std::vector<Candidate> &others = m_nodes[candidate.slot].candidates;
        const Candidate moved = others.back();
        others[candidate.back] = moved;
        m_nodes[moved.slot].candidates[moved.back].back = candidate.back;
        others.pop_back();
    }
    m_nodes[slot].candidates.clear();
}

void dxNeighbourBroadphase::adopt(const dxMembers &members) {
    m_isKnown.resize(members.end());
    for (dxMembers::Slot slot = 0; slot < members.end(); ++slot) {
        if (members[slot].geom == nullptr || members.isChanged(slot)) continue;
        m_neighbours.insert(slot, members[slot].bounds);
        m_isKnown[slot] = 1;
    }
}

void dxNeighbourBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &, std::vector<Match> &matches) {
    updateNeighbours(members);
    for (const dxMembers::Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) continue;
        for (const dxNeighbours::Candidate &candidate : m_neighbours.of(slot)) {
            const dxMembers::Slot other = candidate.slot;
            if (members.isChanged(other) && other < slot) continue;  // found from the other one
            if (members[slot].bounds.overlaps(members[other].bounds)) matches.push_back({slot, other});
        }
    }
}

void dxNeighbourBroadphase::updateNeighbours(const dxMembers &members) {
    m_isKnown.resize(members.end());
    m_lookedUp = 0;
    for (const dxMembers::Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) {
            if (m_isKnown[slot]) m_neighbours.remove(slot);
            m_isKnown[slot] = 0;
        } else if (m_isKnown[slot]) {
            m_lookedUp += m_neighbours.move(slot, members[slot].bounds);
        } else {
            m_neighbours.insert(slot, members[slot].bounds);
            m_isKnown[slot] = 1;
            ++m_lookedUp;
        }
    }
}
