#include "dynamics/iterative/dxPackOrder.h"

#include <algorithm>
#include <utility>

#include "dynamics/iterative/dxContactPack.h"

namespace {

constexpr unsigned kMost = dxContactPack::kMaxContacts;

// The bodies of a manifold that wait for it. forMoving(manifold, moves, visit(body))
template <class Visit>
void forMoving(const dxContactManifold &manifold, const std::vector<std::uint8_t> &moves, const Visit &visit) {
    for (const int body : manifold.body)
        if (body != dxContactPack::kNoBody && moves[static_cast<unsigned>(body)] != 0) visit(static_cast<unsigned>(body));
}

}  // namespace

unsigned dxPackOrder::place(std::vector<dxContactManifold> &manifolds, const std::vector<unsigned> &turns,
                            const std::vector<std::uint8_t> &moves) {
    sortByLevel(manifolds, findLevels(manifolds, turns, moves));
    m_end.assign(moves.size(), 0);
    m_lanes.clear();
    unsigned firstOpen = 0;
    for (const unsigned index : m_sequence) {
        dxContactManifold &manifold = manifolds[index];
        unsigned pack = firstOpen;
        forMoving(manifold, moves, [&](unsigned body) { pack = std::max(pack, m_end[body]); });
        while (pack < m_lanes.size() && m_lanes[pack] == dxLanes::kCount) ++pack;
        if (pack == m_lanes.size()) m_lanes.push_back(0);
        manifold.pack = pack;
        manifold.lane = m_lanes[pack]++;
        forMoving(manifold, moves, [&](unsigned body) { m_end[body] = pack + 1; });
        while (firstOpen < m_lanes.size() && m_lanes[firstOpen] == dxLanes::kCount) ++firstOpen;
    }
    return static_cast<unsigned>(m_lanes.size());
}

void dxPackOrder::reserveAs(const dxPackOrder &other) {
    m_end.reserve(other.m_end.capacity());
    m_level.reserve(other.m_level.capacity());
    m_firstOf.reserve(other.m_firstOf.capacity());
    m_sequence.reserve(other.m_sequence.capacity());
    m_lanes.reserve(other.m_lanes.capacity());
}

// Returns their number.
unsigned dxPackOrder::findLevels(const std::vector<dxContactManifold> &manifolds, const std::vector<unsigned> &turns,
                                 const std::vector<std::uint8_t> &moves) {
    m_end.assign(moves.size(), 0);
    m_level.resize(manifolds.size());
    unsigned levels = 0;
    for (const unsigned i : turns) {
        unsigned level = 0;
        forMoving(manifolds[i], moves, [&](unsigned body) { level = std::max(level, m_end[body]); });
        forMoving(manifolds[i], moves, [&](unsigned body) { m_end[body] = level + 1; });
        m_level[i] = level;
        levels = std::max(levels, level + 1);
    }
    return levels;
}

// Of a level those with many contacts first, so that packs have little to fill up.
void dxPackOrder::sortByLevel(const std::vector<dxContactManifold> &manifolds, unsigned levels) {
    const auto placeOf = [&](std::size_t i) -> unsigned & {
        return m_firstOf[m_level[i] * kMost + (kMost - manifolds[i].contactCount)];
    };
    m_firstOf.assign(std::size_t(levels) * kMost, 0);
    for (std::size_t i = 0; i < manifolds.size(); ++i) ++placeOf(i);
    unsigned count = 0;
    for (unsigned &first : m_firstOf) count += std::exchange(first, count);
    m_sequence.resize(manifolds.size());
    for (std::size_t i = 0; i < manifolds.size(); ++i) m_sequence[placeOf(i)++] = static_cast<unsigned>(i);
}
