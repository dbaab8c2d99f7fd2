#include "dynamics/quick_step/fast/dxPackOrder.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/dxReserve.h"
#include "dynamics/quick_step/fast/dxContactPack.h"

namespace {

constexpr unsigned kMost = dxContactPack::kMaxContacts;
constexpr unsigned kUnreached = ~0u;

template <class Visit>
void forMoving(const dxContactManifold &manifold, const std::vector<std::uint8_t> &moves, const Visit &visit) {
    for (const int body : manifold.body)
        if (dxDoesMove(body, moves)) visit(static_cast<unsigned>(body));
}

bool areBothMoving(const dxContactManifold &manifold, const std::vector<std::uint8_t> &moves) {
    return dxDoesMove(manifold.body[0], moves) && dxDoesMove(manifold.body[1], moves);
}

}  // namespace

void dxPackOrder::Body::enter(unsigned newLevel, unsigned firstOpen) {
    if (level == newLevel) return;
    if (used != 0) end = std::max(end, base + 64 - static_cast<unsigned>(__builtin_clzll(used)));
    level = newLevel;
    base = std::max(end, firstOpen);
    used = 0;
}

// What is too far away for a bit ends the body's packs so far.
void dxPackOrder::Body::use(unsigned pack) {
    if (pack - base < 64)
        used |= std::uint64_t(1) << (pack - base);
    else
        end = pack + 1;
}

unsigned dxPackOrder::place(std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves,
                            const std::vector<std::uint8_t> &goesDown) {
    linkBodies(manifolds, moves);
    findDepths(manifolds, moves);
    sortByLevel(manifolds, findLevels(manifolds, moves, goesDown));
    dxFill(m_bodies, moves.size(), Body{0, ~0u, 0, 0});
    m_lanes.clear();
    unsigned firstOpen = 0;
    for (const unsigned index : m_sequence) {
        dxContactManifold &manifold = manifolds[index];
        forMoving(manifold, moves, [&](unsigned body) { m_bodies[body].enter(m_level[index], firstOpen); });
        manifold.pack = findPack(firstOpen, [&](unsigned pack) {
            bool isUsed = false;
            forMoving(manifold, moves, [&](unsigned body) { isUsed |= m_bodies[body].isUsed(pack); });
            return isUsed;
        });
        manifold.lane = m_lanes[manifold.pack]++;
        forMoving(manifold, moves, [&](unsigned body) { m_bodies[body].use(manifold.pack); });
        while (firstOpen < m_lanes.size() && m_lanes[firstOpen] == dxLanes::kCount) ++firstOpen;
    }
    return static_cast<unsigned>(m_lanes.size());
}

void dxPackOrder::reserveAs(const dxPackOrder &other) {
    m_firstLink.reserve(other.m_firstLink.capacity());
    m_links.reserve(other.m_links.capacity());
    m_depth.reserve(other.m_depth.capacity());
    m_reached.reserve(other.m_reached.capacity());
    m_level.reserve(other.m_level.capacity());
    m_firstOf.reserve(other.m_firstOf.capacity());
    m_sequence.reserve(other.m_sequence.capacity());
    m_bodies.reserve(other.m_bodies.capacity());
    m_lanes.reserve(other.m_lanes.capacity());
}

// The first one with a free lane; a new one if need be.
template <class IsUsed>
unsigned dxPackOrder::findPack(unsigned firstOpen, const IsUsed &isUsed) {
    unsigned pack = firstOpen;
    while ((pack < m_lanes.size() && m_lanes[pack] == dxLanes::kCount) || isUsed(pack)) ++pack;
    if (pack >= m_lanes.size()) m_lanes.resize(pack + 1, 0);
    return pack;
}

void dxPackOrder::linkBodies(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves) {
    dxFill(m_firstLink, moves.size() + 1, 0);
    const auto forPairs = [&](const auto &visit) {
        for (const dxContactManifold &manifold : manifolds) {
            if (!areBothMoving(manifold, moves)) continue;
            visit(static_cast<unsigned>(manifold.body[0]), static_cast<unsigned>(manifold.body[1]));
            visit(static_cast<unsigned>(manifold.body[1]), static_cast<unsigned>(manifold.body[0]));
        }
    };
    forPairs([&](unsigned from, unsigned) { ++m_firstLink[from]; });
    std::partial_sum(m_firstLink.begin(), m_firstLink.end(), m_firstLink.begin());
    m_links.resize(m_firstLink.back());
    forPairs([&](unsigned from, unsigned to) { m_links[--m_firstLink[from]] = to; });
}

// What touches the ground, or another body that does not move, is at 0. Where nothing does, the first body is.
void dxPackOrder::findDepths(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves) {
    dxFill(m_depth, moves.size(), kUnreached);
    m_reached.clear();
    for (const dxContactManifold &manifold : manifolds)
        if (!areBothMoving(manifold, moves)) forMoving(manifold, moves, [&](unsigned body) {
            if (std::exchange(m_depth[body], 0) == kUnreached) m_reached.push_back(body);
        });
    std::size_t next = 0;
    const auto spread = [&] {
        for (; next < m_reached.size(); ++next) spreadFrom(m_reached[next]);
    };
    spread();
    for (unsigned body = 0; body < moves.size(); ++body) {
        if (m_depth[body] != kUnreached || m_firstLink[body] == m_firstLink[body + 1]) continue;
        m_depth[body] = 0;
        m_reached.push_back(body);
        spread();
    }
}

void dxPackOrder::spreadFrom(unsigned body) {
    for (unsigned i = m_firstLink[body]; i < m_firstLink[body + 1]; ++i) {
        unsigned &depth = m_depth[m_links[i]];
        if (depth != kUnreached) continue;
        depth = m_depth[body] + 1;
        m_reached.push_back(m_links[i]);
    }
}

// Returns their number. What stands on the ground is at level 0, contacts between bodies at depth 0 at 1, with those above them at 2, and so on.
unsigned dxPackOrder::findLevels(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves,
                                 const std::vector<std::uint8_t> &goesDown) {
    m_level.resize(manifolds.size());
    unsigned top = 0;
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
        const dxContactManifold &manifold = manifolds[i];
        m_level[i] = 0;
        if (areBothMoving(manifold, moves))
            m_level[i] = m_depth[static_cast<unsigned>(manifold.body[0])] + m_depth[static_cast<unsigned>(manifold.body[1])] + 1;
        top = std::max(top, m_level[i]);
    }
    for (std::size_t i = 0; i < manifolds.size(); ++i)
        if (goesDown[static_cast<unsigned>(manifolds[i].body[0])] != 0) m_level[i] = top - m_level[i];
    return top + 1;
}

// Of a level those with many contacts first, so that packs have little to fill up.
void dxPackOrder::sortByLevel(const std::vector<dxContactManifold> &manifolds, unsigned levels) {
    const auto placeOf = [&](std::size_t i) -> unsigned & {
        return m_firstOf[m_level[i] * kMost + (kMost - manifolds[i].contactCount)];
    };
    dxReserveCapacity(m_firstOf, manifolds.capacity());  // a heap that gets higher has more levels of as many manifolds
    dxFill(m_firstOf, std::size_t(levels) * kMost, 0);
    for (std::size_t i = 0; i < manifolds.size(); ++i) ++placeOf(i);
    unsigned count = 0;
    for (unsigned &first : m_firstOf) count += std::exchange(first, count);
    m_sequence.resize(manifolds.size());
    for (std::size_t i = 0; i < manifolds.size(); ++i) m_sequence[placeOf(i)++] = static_cast<unsigned>(i);
}
