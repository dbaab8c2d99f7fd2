#include "collision/spaces/quad_tree/dxOrderedQuadTreeSpace.h"

#include <algorithm>
#include <vector>

#include "collision/spaces/dxGeomQuery.h"
#include "collision/spaces/dxPairDelivery.h"

#include "util.h"

namespace {

// A callback with swapped arguments.
struct Swapped {
    void *data;
    dNearCallback *callback;

    static void call(void *self, dxGeom *a, dxGeom *b) {
        const Swapped &swapped = *static_cast<Swapped *>(self);
        swapped.callback(swapped.data, b, a);
    }
};

using Threshold = dxBroadphaseThresholds;

// Comparisons per geom, up to which a copy of the boxes does not pay.
constexpr std::size_t kMaxPerGeomInPlace = 5;

}  // namespace

dxOrderedQuadTreeSpace::dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth)
    : dxOrderedSpace(parent, dQuadTreeSpaceClass, dxPairOrder::Blocks, m_cleaner, m_order, m_walker), m_tree(centre, extents, depth),
      m_cleaner(geoms(), foundPairs(), m_tree), m_order(geoms(), foundPairs(), m_tree, m_cleaner.ranks()),
      m_walker(*this, m_tree, m_cleaner, m_order) {
    dInfiniteAABB(this, aabb);
}

// Upstream frees its blocks and leaves geoms that point to them (tome_ex), so spaces that read this field refuse to add these geoms from then on.
// They refuse geoms with next_ex set, too: that field is left set here, because tome_ex is cleared.
dxOrderedQuadTreeSpace::~dxOrderedQuadTreeSpace() {
    for (dxGeom *geom = dxSpace::first; geom != nullptr; geom = geom->next) geom->next_ex = geom;
}

// Upstream does not implement this function either.
dxGeom *dxOrderedQuadTreeSpace::getGeom(int index) {
    dUASSERT(index >= 0 && index < count, "index out of range");
    dDebug(0, "dxQuadTreeSpace::getGeom() not yet implemented");
    return nullptr;
}

// ---- Callbacks -----------------------------------------------------------------------------------------------------------------------

// Upstream's way through the tree, block by block, of one geom from a block on, or of all geoms. It follows from the order of members and the number
// of geoms in each block.
struct dxQuadTreeWalker::Visit {
    const dxQuadTreeWalker &walker;
    void *data;
    dNearCallback *callback;
    std::vector<Slot> order;  // all members, in upstream's order
    std::size_t next = 0;     // place of the first member that the visit has not passed
    // No callback is called up to this pair and for it; NULL: it has been passed.
    const dxOrderedPair *after = nullptr;

    Visit(const dxQuadTreeWalker &quadTreeWalker, void *callbackData, dNearCallback *nearCallback)
        : walker(quadTreeWalker), data(callbackData), callback(nearCallback) {
        const dxMembers &members = walker.m_space.members();
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members.geomIn(slot) != nullptr) order.push_back(slot);
        std::sort(order.begin(), order.end(), [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
    }

    std::size_t placeOf(Slot slot) const {
        return static_cast<std::size_t>(std::find(order.begin(), order.end(), slot) - order.begin());
    }
    dxGeom *geomAt(std::size_t place) const { return walker.m_space.members().geomIn(order[place]); }
    Block blockAt(std::size_t place) const { return walker.blockOf(order[place]); }

    std::size_t endOfBlock(Block block, std::size_t at, std::size_t end) const {
        while (at != end && blockAt(at) == block) ++at;
        return at;
    }

    // Calls visit(quarter, begin, end) for each quarter of a block that has members. Those of all quarters are in [at, end).
    template <class VisitQuarter>
    void forQuarters(Block block, std::size_t at, std::size_t end, const VisitQuarter &visit) const {
        for (Block quarter = block + 1; at != end; quarter = walker.m_tree.endOf(quarter)) {
            std::size_t last = at;
            while (last != end && blockAt(last) < walker.m_tree.endOf(quarter)) ++last;
            if (last != at) visit(quarter, at, last);
            at = last;
        }
    }

    // Tests the geom against the members in the block and in the blocks within, which are in [at, end), from `next` on. As upstream, it skips blocks
    // that the geom's box does not meet, unless they have only one member. (The box may change during the visit.)
    void meetFrom(dxGeom *geom, Block block, std::size_t at, std::size_t end) {
        for (; at != end && blockAt(at) == block; ++at)
            if (at >= next) meet(geom, geomAt(at));
        forQuarters(block, at, end, [&](Block quarter, std::size_t begin, std::size_t last) {
            const bool hasBegun = begin < next && next < last;
            const bool isNew = begin >= next;
            const bool mayMeet = after != nullptr || last - begin == 1 || walker.m_tree.mayMeet(quarter, geom->aabb);
            if (hasBegun || (isNew && mayMeet)) meetFrom(geom, quarter, begin, last);
        });
    }

    // Tests each member of the block against those behind it, then those of its quarters.
    void meetAll(Block block, std::size_t at, std::size_t end) {
        for (; at != end && blockAt(at) == block; ++at)
            if (after != nullptr || dxGeomIsEnabled(geomAt(at))) meetFrom(geomAt(at), block, at + 1, end);
        forQuarters(block, at, end, [&](Block quarter, std::size_t begin, std::size_t last) {
            if (last - begin > 1) meetAll(quarter, begin, last);
        });
    }

    void meet(dxGeom *geom, dxGeom *member) {
        if (after != nullptr) {
            if (after->first == geom && after->second == member) after = nullptr;
        } else if (dxGeomIsEnabled(member)) {
            dxCollideBoxes(geom, member, data, callback);
        }
    }
};

void dxQuadTreeWalker::deliver(void *data, dNearCallback *callback) { dxDeliverInOrder(m_space, *this, m_space.pairs(), data, callback); }

void dxQuadTreeWalker::deliverAnew(void *data, dNearCallback *callback) {
    if (m_space.count <= Threshold::kMaxAlwaysWalked || m_comparisons <= kMaxPerGeomInPlace * static_cast<std::size_t>(m_space.count))
        return deliverInPlace(data, callback);
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    m_comparisons = m_order.rows().candidates();
    dxDeliverRows(m_order.rows(), m_space, *this, data, callback);
}

// Like dxDeliverRows(), but compares the members in place: for few comparisons a copy of the boxes would take longer.
void dxQuadTreeWalker::deliverInPlace(void *data, dNearCallback *callback) {
    const std::vector<dxSortItem> &order = *m_space.geoms().beforeCallbacks([this] { return &m_order.boxes().update(m_space.members()); });
    const dxPairsStillHold stillHold(m_space.geoms());
    const dxMembers::Member *const members = m_space.members().data();
    const dxSortItem *const end = order.data() + order.size();
    dxPairWork work;
    work.geoms = order.size();
    for (const dxSortItem *item = order.data(); item != end; ++item) {
        const dxMembers::Member &first = members[item->index];
        if (!dxGeomIsEnabled(first.geom)) continue;
        const dxRank lowest = m_cleaner.ranks().lowestBefore(m_tree.endOf(m_cleaner.ranks().blockOf(first.rank)));
        const dxSortItem *other = item + 1;
        for (; other != end; ++other) {
            const dxMembers::Member &second = members[other->index];
            if (second.rank < lowest) break;
            if (!dxOverlapInTurn(first.bounds.v, second.bounds.v)) continue;
            ++work.overlaps;
            if (!dxFiltersAgree(first.filter, second.filter)) continue;
            ++work.pairs;
            if (!dxGeomIsEnabled(second.geom)) continue;
            const dxOrderedPair pair{first.geom, second.geom, {}};
            dxDeliver(pair, data, callback);
            if (!stillHold) return walk(data, callback, &pair);
        }
        work.comparisons += static_cast<std::size_t>(other - item - 1);
    }
    m_comparisons = work.comparisons;
    m_space.foundPairs().noteAnew(work);
}

void dxQuadTreeWalker::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    Visit visit = m_space.geoms().beforeCallbacks([&] { return Visit(*this, data, callback); });
    visit.after = after;
    visit.meetAll(dxQuadTree::kRoot, 0, visit.order.size());
}

void dxQuadTreeWalker::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    const bool isMember = geom->parent_space == &m_space;
    if (!m_space.geoms().isSure())
        isMember ? walkMember(data, geom, callback, nullptr) : walkOther(data, geom, callback, nullptr);
    else if (isMember)
        collideMember(data, geom, callback);
    else
        collideOther(data, geom, callback);
}

// Calls meet(begin, end) with the slots of the members whose boxes overlap this one, in upstream's order. Members that callbacks have enabled may be
// missing.
template <class Meet>
void dxQuadTreeWalker::withOverlapping(const dxBounds &box, const Meet &meet) {
    dxOrderedBoxes::Found found;
    dxSpaceGeoms &geoms = m_space.geoms();
    const bool isInOrder =
        geoms.members().switched().empty() && !geoms.isWorthAnIndexWithSimd() &&
        geoms.beforeCallbacks([&] { return m_order.boxes().find(geoms.members(), box, geoms.isWorthAnIndex(), found); });
    if (isInOrder) {
        m_space.geoms().noteMet(found.count);
        return meet(found.slots, found.slots + found.count);
    }
    const dxSpaceRegion region = m_space.geoms().beforeCallbacks([&] { return dxSpaceRegion(m_space.geoms(), box); });
    meet(region.slots().data(), region.slots().data() + region.slots().size());
}

// A member meets what is in its own block (upstream reports the geom with itself, too) and in the blocks within; then what is in the blocks around,
// from the innermost outwards. Members of other blocks do not meet it.
void dxQuadTreeWalker::collideMember(void *data, dxGeom *geom, dNearCallback *callback) {
    const Block own = blockOf(dxSpaceGeoms::slotOf(geom));
    const std::uint64_t missed = dxMissedNotifications.count();
    const std::size_t switched = m_space.members().switched().size();
    Swapped swapped{data, callback};
    // Returns false if the rest of the query is done, too.
    const auto meet = [&](Slot slot, bool isInner) {
        dxGeom *const member = m_space.members().geomIn(slot);
        if (!dxGeomIsEnabled(member)) return true;
        isInner ? dxDeliverIfAgreed(geom, member, &swapped, Swapped::call) : dxDeliverIfAgreed(member, geom, data, callback);
        if (dxMissedNotifications.count() == missed && m_space.members().switched().size() == switched) return true;
        walkMember(data, geom, callback, member);
        return false;
    };
    withOverlapping(dxBounds(geom->aabb), [&](const Slot *first, const Slot *last) {
        const Slot *const inner = std::find_if(first, last, [&](Slot slot) { return blockOf(slot) >= own; });
        for (const Slot *slot = inner; slot != last; ++slot)
            if (!meet(*slot, true)) return;
        for (const Slot *end = inner; end != first;) {
            const Slot *begin = end;
            while (begin != first && blockOf(begin[-1]) == blockOf(end[-1])) --begin;
            for (const Slot *slot = begin; slot != end; ++slot)
                if (!meet(*slot, false)) return;
            end = begin;
        }
    });
}

// Executes upstream's tests one by one, for boxes that may not be up to date. `after`: begins behind this member; NULL: with the first.
void dxQuadTreeWalker::walkMember(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after) {
    Swapped swapped{data, callback};
    Visit visit = m_space.geoms().beforeCallbacks([&] { return Visit(*this, &swapped, Swapped::call); });
    Block block = blockOf(dxSpaceGeoms::slotOf(geom));
    const Block last = after != nullptr ? blockOf(dxSpaceGeoms::slotOf(after)) : m_tree.endOf(block);
    const auto placeFrom = [&](Block first) {
        std::size_t place = 0;
        while (place != visit.order.size() && visit.blockAt(place) < first) ++place;
        return place;
    };
    const std::size_t next = after != nullptr ? visit.placeOf(dxSpaceGeoms::slotOf(after)) + 1 : 0;
    if (last >= block) {
        visit.next = next;
        visit.meetFrom(geom, block, placeFrom(block), placeFrom(m_tree.endOf(block)));
    }
    while (block != dxQuadTree::kRoot) {
        block = m_tree.parentOf(block);
        if (block > last) continue;
        const std::size_t begin = placeFrom(block), end = visit.endOfBlock(block, begin, visit.order.size());
        for (std::size_t place = block == last ? next : begin; place != end; ++place) {
            dxGeom *const member = visit.geomAt(place);
            if (dxGeomIsEnabled(member)) dxCollideBoxes(member, geom, data, callback);
        }
    }
}

void dxQuadTreeWalker::collideOther(void *data, dxGeom *geom, dNearCallback *callback) {
    const dxBounds box(geom->aabb);
    const std::uint64_t missed = dxMissedNotifications.count();
    const std::size_t switched = m_space.members().switched().size();
    Swapped swapped{data, callback};
    withOverlapping(box, [&](const Slot *first, const Slot *last) {
        for (const Slot *slot = first; slot != last; ++slot) {
            dxGeom *const member = m_space.members().geomIn(*slot);
            if (!dxGeomIsEnabled(member)) continue;
            dxDeliverIfAgreed(geom, member, &swapped, Swapped::call);
            if (dxHasKeptBox(geom, box) && dxMissedNotifications.count() == missed && m_space.members().switched().size() == switched) continue;
            return walkOther(data, geom, callback, member);
        }
    });
}

// As walkMember(), from the root on.
void dxQuadTreeWalker::walkOther(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after) {
    Swapped swapped{data, callback};
    Visit visit = m_space.geoms().beforeCallbacks([&] { return Visit(*this, &swapped, Swapped::call); });
    if (after != nullptr) visit.next = visit.placeOf(dxSpaceGeoms::slotOf(after)) + 1;
    visit.meetFrom(geom, dxQuadTree::kRoot, 0, visit.order.size());
}
