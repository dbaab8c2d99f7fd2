#include "dynamics/quick_step/fast/dxPackOrder.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace {

using Manifolds = dxArenaArray<dxContactManifold>;
using Flags = dxArenaArray<const std::uint8_t>;

constexpr unsigned kMaxContacts = dxContactPack::kMaxContacts;
constexpr unsigned kUnreached = ~0u;

class PackOrder {
public:
    PackOrder(Manifolds manifolds, Flags moves, dxStepArena &arena) : m_manifolds(manifolds), m_moves(moves), m_arena(arena) {}

    dxPackCount place(Flags goesDown) {
        linkBodies();
        findDepths();
        sortByLevel(findLevels(goesDown));
        return fillPacks();
    }

private:
    // The packs that act on a body: those before `end`, and from `base` on those whose bits are set in `used`, which are of the current level.
    struct Body {
        unsigned end, level, base;
        std::uint64_t used;

        void enter(unsigned newLevel, unsigned firstOpen) {
            if (level == newLevel) return;
            if (used != 0) end = std::max(end, base + 64 - static_cast<unsigned>(__builtin_clzll(used)));
            level = newLevel;
            base = std::max(end, firstOpen);
            used = 0;
        }
        bool isUsed(unsigned pack) const { return pack < end || (pack - base < 64 && (used >> (pack - base) & 1) != 0); }
        // A pack that is too far away for a bit becomes the end of the body's packs.
        void use(unsigned pack) {
            if (pack - base < 64)
                used |= std::uint64_t(1) << (pack - base);
            else
                end = pack + 1;
        }
    };

    template <class Visit>
    void forMoving(const dxContactManifold &manifold, const Visit &visit) const {
        for (const int body : manifold.body)
            if (dxDoesMove(body, m_moves)) visit(static_cast<unsigned>(body));
    }
    bool areBothMoving(const dxContactManifold &manifold) const {
        return dxDoesMove(manifold.body[0], m_moves) && dxDoesMove(manifold.body[1], m_moves);
    }
    template <class Visit>
    void forManifolds(const Visit &visit) const {
        for (std::size_t i = 0; i < m_manifolds.size(); ++i)
            if (!m_manifolds[i].isInRows()) visit(i, m_manifolds[i]);
    }

    void linkBodies();
    void findDepths();
    void spreadFrom(unsigned body);
    unsigned findLevels(Flags goesDown);
    void sortByLevel(unsigned levels);
    dxPackCount fillPacks();
    template <class IsUsed>
    unsigned findPack(unsigned firstOpen, const IsUsed &isUsed);

    const Manifolds m_manifolds;
    const Flags m_moves;
    dxStepArena &m_arena;
    dxArenaArray<unsigned> m_firstLink, m_links;  // by body, and the end; bodies that touch it
    dxArenaArray<unsigned> m_depth, m_reached;    // by body; bodies in the order in which they were found
    dxArenaArray<unsigned> m_level;               // by manifold
    dxArenaArray<unsigned> m_sequence;            // manifolds by level
    dxArenaArray<std::uint8_t> m_lanes;           // by pack: the number of lanes that are taken
};

void PackOrder::linkBodies() {
    m_firstLink = m_arena.takeFilled(m_moves.size() + 1, 0u);
    const auto forPairs = [&](const auto &visit) {
        forManifolds([&](std::size_t, const dxContactManifold &manifold) {
            if (!areBothMoving(manifold)) return;
            visit(static_cast<unsigned>(manifold.body[0]), static_cast<unsigned>(manifold.body[1]));
            visit(static_cast<unsigned>(manifold.body[1]), static_cast<unsigned>(manifold.body[0]));
        });
    };
    forPairs([&](unsigned from, unsigned) { ++m_firstLink[from]; });
    std::partial_sum(m_firstLink.begin(), m_firstLink.end(), m_firstLink.begin());
    m_links = m_arena.take<unsigned>(m_firstLink.back());
    forPairs([&](unsigned from, unsigned to) { m_links[--m_firstLink[from]] = to; });
}

// Breadth-first search. What touches the ground, or another body that does not move, is at depth 0. Where nothing does, the first body is.
void PackOrder::findDepths() {
    m_depth = m_arena.takeFilled(m_moves.size(), kUnreached);
    m_reached = m_arena.takeList<unsigned>(m_moves.size());
    forManifolds([&](std::size_t, const dxContactManifold &manifold) {
        if (areBothMoving(manifold)) return;
        forMoving(manifold, [&](unsigned body) {
            if (std::exchange(m_depth[body], 0) == kUnreached) m_reached.push(body);
        });
    });
    std::size_t next = 0;
    const auto spread = [&] {
        for (; next < m_reached.size(); ++next) spreadFrom(m_reached[next]);
    };
    spread();
    for (unsigned body = 0; body < m_moves.size(); ++body) {
        if (m_depth[body] != kUnreached || m_firstLink[body] == m_firstLink[body + 1]) continue;
        m_depth[body] = 0;
        m_reached.push(body);
        spread();
    }
}

void PackOrder::spreadFrom(unsigned body) {
    for (unsigned i = m_firstLink[body]; i < m_firstLink[body + 1]; ++i) {
        unsigned &depth = m_depth[m_links[i]];
        if (depth != kUnreached) continue;
        depth = m_depth[body] + 1;
        m_reached.push(m_links[i]);
    }
}

// Returns the number of levels. Contacts with the ground are at level 0, contacts between bodies of depth 0 at level 1, those with the bodies
// above them at level 2, and so on.
unsigned PackOrder::findLevels(Flags goesDown) {
    m_level = m_arena.take<unsigned>(m_manifolds.size());
    unsigned top = 0;
    forManifolds([&](std::size_t i, const dxContactManifold &manifold) {
        m_level[i] = 0;
        if (areBothMoving(manifold))
            m_level[i] = m_depth[static_cast<unsigned>(manifold.body[0])] + m_depth[static_cast<unsigned>(manifold.body[1])] + 1;
        top = std::max(top, m_level[i]);
    });
    forManifolds([&](std::size_t i, const dxContactManifold &manifold) {
        if (goesDown[static_cast<unsigned>(manifold.body[0])] != 0) m_level[i] = top - m_level[i];
    });
    return top + 1;
}

// Manifolds of a level that have many contacts come first, so that the lanes of a pack have similar numbers of contacts.
void PackOrder::sortByLevel(unsigned levels) {
    const dxArenaArray<unsigned> place = m_arena.takeFilled(std::size_t(levels) * kMaxContacts, 0u);
    const auto placeOf = [&](std::size_t i, const dxContactManifold &manifold) -> unsigned & {
        return place[m_level[i] * kMaxContacts + (kMaxContacts - manifold.contactCount)];
    };
    forManifolds([&](std::size_t i, const dxContactManifold &manifold) { ++placeOf(i, manifold); });
    unsigned count = 0;
    for (unsigned &first : place) count += std::exchange(first, count);
    m_sequence = m_arena.take<unsigned>(count);
    forManifolds([&](std::size_t i, const dxContactManifold &manifold) { m_sequence[placeOf(i, manifold)++] = static_cast<unsigned>(i); });
}

dxPackCount PackOrder::fillPacks() {
    const dxArenaArray<Body> bodies = m_arena.takeFilled(m_moves.size(), Body{0, ~0u, 0, 0});
    m_lanes = m_arena.takeList<std::uint8_t>(m_sequence.size());
    const dxArenaArray<std::uint8_t> contacts = m_arena.takeFilled(m_sequence.size(), std::uint8_t(0));  // by pack
    unsigned firstOpen = 0;
    for (const unsigned index : m_sequence) {
        dxContactManifold &manifold = m_manifolds[index];
        forMoving(manifold, [&](unsigned body) { bodies[body].enter(m_level[index], firstOpen); });
        manifold.pack = findPack(firstOpen, [&](unsigned pack) {
            bool isUsed = false;
            forMoving(manifold, [&](unsigned body) { isUsed |= bodies[body].isUsed(pack); });
            return isUsed;
        });
        manifold.lane = m_lanes[manifold.pack]++;
        contacts[manifold.pack] = std::max(contacts[manifold.pack], manifold.contactCount);
        forMoving(manifold, [&](unsigned body) { bodies[body].use(manifold.pack); });
        while (firstOpen < m_lanes.size() && m_lanes[firstOpen] == dxLanes::kCount) ++firstOpen;
    }
    return {m_lanes.size(), std::accumulate(contacts.begin(), contacts.end(), std::size_t(0))};
}

// Returns the first pack with a free lane that is not used, which may be a new one.
template <class IsUsed>
unsigned PackOrder::findPack(unsigned firstOpen, const IsUsed &isUsed) {
    unsigned pack = firstOpen;
    while ((pack < m_lanes.size() && m_lanes[pack] == dxLanes::kCount) || isUsed(pack)) ++pack;
    while (pack >= m_lanes.size()) m_lanes.push(0);
    return pack;
}

}  // namespace

dxPackCount dxOrderPacks(Manifolds manifolds, Flags moves, Flags goesDown, dxStepArena &arena) {
    return PackOrder(manifolds, moves, arena).place(goesDown);
}
