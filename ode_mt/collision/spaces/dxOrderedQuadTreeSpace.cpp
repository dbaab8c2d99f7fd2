#include "collision/spaces/dxOrderedQuadTreeSpace.h"

#include <algorithm>

#include "collision/pairs/dxMissedNotifications.h"

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

// If each geom is compared with no more than so many, a copy of their boxes does not pay.
constexpr std::size_t kMostPerGeomInPlace = 5;

}  // namespace

dxOrderedQuadTreeSpace::dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents,
                                               int depth)
    : dxOrderedSpace(parent, dQuadTreeSpaceClass, dxPairOrder::Blocks), m_tree(centre, extents, depth), m_ranks(m_tree.size()), m_rows(m_tree) {
    for (int axis = 0; axis < 3; ++axis) {
        aabb[2 * axis] = -dInfinity;
        aabb[2 * axis + 1] = dInfinity;
    }
}

// Upstream frees its blocks and leaves the geoms pointing to them: they cannot come into another space of the
// kinds that look at that. Here the other of the two fields that such spaces look at tells it.
dxOrderedQuadTreeSpace::~dxOrderedQuadTreeSpace() {
    for (dxGeom *geom = dxSpace::first; geom != nullptr; geom = geom->next) geom->next_ex = geom;
}

// As upstream, which has none.
dxGeom *dxOrderedQuadTreeSpace::getGeom(int index) {
    dUASSERT(index >= 0 && index < count, "index out of range");
    dDebug(0, "dxQuadTreeSpace::getGeom() not yet implemented");
    return nullptr;
}

bool dxOrderedQuadTreeSpace::mayCome(const dxGeom *geom) const {
    return geom->tome_ex == nullptr && geom->next_ex == nullptr && dxOrderedSpace::mayCome(geom);
}

void dxOrderedQuadTreeSpace::reserveMemory(Slot slots) { m_dirty.reserveMemory(slots); }

// A geom comes into the block of the box that it had last, until it is cleaned.
void dxOrderedQuadTreeSpace::comes(dxGeom *geom, Slot slot) {
    members().setRank(slot, nextRank(m_tree.find(geom->aabb, dxQuadTree::kRoot)));
    m_dirty.push(geom, slot);
}

void dxOrderedQuadTreeSpace::goes(dxGeom * /*geom*/, Slot slot) { m_dirty.drop(slot); }

void dxOrderedQuadTreeSpace::dirty(dxGeom *geom) { m_dirty.push(geom, slotOf(geom)); }

// The queue is emptied last: a user's bounding-box function may leave by an exception or a jump. One that has
// the space cleaned empties it at once.
void dxOrderedQuadTreeSpace::cleanGeoms() {
    mayHaveStrays();
    if (m_dirty.isEmpty()) return;
    lock_count++;
    const std::vector<dxGeom *> &geoms = m_dirty.geoms();
    computeBoxes(geoms);
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        dxGeom *const geom = geoms[i];
        clean(geoms, i);
        const dxRank before = members()[slotOf(geom)].rank;
        const Block from = m_ranks.blockOf(before), to = m_tree.find(geom->aabb, from);
        rank(geom, to == from ? before : nextRank(to));
    }
    m_dirty.clear();
    lock_count--;
}

// Also one that has another box, but not the block of that, in which upstream would not look for it.
bool dxOrderedQuadTreeSpace::hasStrayMembers() const {
    for (const dxGeom *geom = dxSpace::first; geom != nullptr; geom = geom->next) {
        if (m_dirty.has(slotOf(geom))) continue;
        const Block block = blockOf(slotOf(geom));
        if ((geom->gflags & GEOM_DIRTY) != 0 || m_tree.find(geom->aabb, block) != block) return true;
    }
    return false;
}

// The block of a stray does not follow from its box.
bool dxOrderedQuadTreeSpace::requireRanks() { return isSureOfMembers(); }

dxRank dxOrderedQuadTreeSpace::nextRank(Block block) {
    if (m_ranks.isExhausted()) rankAnew();
    return m_ranks.next(block);
}

// In the order in which they are.
void dxOrderedQuadTreeSpace::rankAnew() {
    std::vector<Slot> slots;
    for (Slot slot = 0; slot < members().end(); ++slot)
        if (members().geomIn(slot) != nullptr && members()[slot].rank != 0) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(),
              [this](Slot a, Slot b) { return members()[a].rank < members()[b].rank; });
    m_ranks.startAgain();
    for (const Slot slot : slots) members().setRank(slot, m_ranks.next(blockOf(slot)));
    startAnew();
}

// Upstream's way through the tree, block by block, as far as the order of members and their number tell it:
// with one geom from a block on, or with all.
struct dxOrderedQuadTreeSpace::Visit {
    const dxOrderedQuadTreeSpace &space;
    void *data;
    dNearCallback *callback;
    std::vector<Slot> order;  // all members, in upstream's order
    std::size_t next = 0;     // the first that is not processed

    Visit(const dxOrderedQuadTreeSpace &of, void *itsData, dNearCallback *itsCallback)
        : space(of), data(itsData), callback(itsCallback) {
        const dxMembers &members = space.members();
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members.geomIn(slot) != nullptr) order.push_back(slot);
        std::sort(order.begin(), order.end(),
                  [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
    }

    std::size_t placeOf(Slot slot) const {
        return static_cast<std::size_t>(std::find(order.begin(), order.end(), slot) - order.begin());
    }
    dxGeom *geomAt(std::size_t place) const { return space.members().geomIn(order[place]); }
    Block blockAt(std::size_t place) const { return space.blockOf(order[place]); }

    std::size_t endOfBlock(Block block, std::size_t at, std::size_t end) const {
        while (at != end && blockAt(at) == block) ++at;
        return at;
    }

    // Calls visit(quarter, begin, end) for the quarters of a block whose members stand in [at, end), where
    // any are.
    template <class VisitQuarter>
    void forQuarters(Block block, std::size_t at, std::size_t end, const VisitQuarter &visit) const {
        for (Block quarter = block + 1; at != end; quarter = space.m_tree.endOf(quarter)) {
            std::size_t last = at;
            while (last != end && blockAt(last) < space.m_tree.endOf(quarter)) ++last;
            if (last != at) visit(quarter, at, last);
            at = last;
        }
    }

    // Nothing is done up to this pair, and with it.
    const dxOrderedPair *after = nullptr;

    // The geom with the members in the block and those within, which stand in [at, end), as far as their turn
    // is to come. Blocks that its box, as it is by then, does not meet are passed over, unless they hold only
    // one geom.
    void meetFrom(dxGeom *geom, Block block, std::size_t at, std::size_t end) {
        for (; at != end && blockAt(at) == block; ++at)
            if (at >= next) meet(geom, geomAt(at));
        forQuarters(block, at, end, [&](Block quarter, std::size_t begin, std::size_t last) {
            const bool isUnderWay = begin < next && next < last;
            const bool isToCome = begin >= next;
            const bool mayMeet =
                after != nullptr || last - begin == 1 || space.m_tree.mayMeet(quarter, geom->aabb);
            if (isUnderWay || (isToCome && mayMeet)) meetFrom(geom, quarter, begin, last);
        });
    }

    // Each member of the block, then of its quarters, with those behind it.
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

// How many boxes a call compares that finds all pairs anew follows from how geoms lie in the tree. The rows tell it; they are gathered for that where
// there are none, or those of another number of geoms.
void dxOrderedQuadTreeSpace::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    if (m_rows.geoms() > 2 * work.geoms || work.geoms > 2 * m_rows.geoms()) gatherRows();
    work.comparisons = m_rows.candidates();
    dxOrderedSpace::update(pairs, work);
}

dxPairRows &dxOrderedQuadTreeSpace::gatherRows() {
    const std::vector<dxSortItem> &order = m_order.update(members());
    m_rows.clear(order.size());
    for (const dxSortItem &item : order) {
        const dxMembers::Member &member = members()[item.index];
        m_rows.push(member.geom, item.index, member.filter, member.bounds, m_ranks.blockOf(member.rank));
    }
    m_rows.finish();
    return m_rows;
}

void dxOrderedQuadTreeSpace::deliverAnew(void *data, dNearCallback *callback) {
    if (count <= Threshold::kMaxAlwaysWalked || m_comparisons <= kMostPerGeomInPlace * static_cast<std::size_t>(count))
        return deliverInPlace(data, callback);
    beforeCallbacks([this] { gatherRows(); });
    m_comparisons = m_rows.candidates();
    deliverRows(m_rows, data, callback);
}

// The same as deliverRows(), but that members are compared where they stand. To copy so few takes longer.
void dxOrderedQuadTreeSpace::deliverInPlace(void *data, dNearCallback *callback) {
    const std::vector<dxSortItem> &order = *beforeCallbacks([this] { return &m_order.update(members()); });
    const std::uint64_t missed = dxMissedNotifications.count(), before = comebacks();
    const dxMembers::Member *const members = this->members().data();
    const dxSortItem *const end = order.data() + order.size();
    dxPairWork work;
    work.geoms = order.size();
    for (const dxSortItem *item = order.data(); item != end; ++item) {
        const dxMembers::Member &first = members[item->index];
        if (!dxGeomIsEnabled(first.geom)) continue;
        const dxRank lowest = m_ranks.lowestBefore(m_tree.endOf(m_ranks.blockOf(first.rank)));
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
            if (dxMissedNotifications.count() != missed || comebacks() != before) return walk(data, callback, &pair);
        }
        work.comparisons += static_cast<std::size_t>(other - item - 1);
    }
    m_comparisons = work.comparisons;
    noteAnew(work);
}

void dxOrderedQuadTreeSpace::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    Visit visit = beforeCallbacks([&] { return Visit(*this, data, callback); });
    visit.after = after;
    visit.meetAll(dxQuadTree::kRoot, 0, visit.order.size());
}

void dxOrderedQuadTreeSpace::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    const bool isMember = geom->parent_space == this;
    if (!isSureOfMembers())
        isMember ? walkMember(data, geom, callback, nullptr) : walkOther(data, geom, callback, nullptr);
    else if (isMember)
        collideMember(data, geom, callback);
    else
        collideOther(data, geom, callback);
}

// Calls meet(begin, end) with the slots of the members whose boxes overlap this one, in upstream's order. Those that are enabled since may be missing.
template <class Meet>
void dxOrderedQuadTreeSpace::withOverlapping(const dxBounds &box, const Meet &meet) {
    dxOrderedBoxes::Found found;
    const bool isInOrder = members().switched().empty() && !isWorthAnIndexByVectors() &&
                           beforeCallbacks([&] { return m_order.find(members(), box, isWorthAnIndex(), found); });
    if (isInOrder) {
        noteMet(found.count);
        return meet(found.slots, found.slots + found.count);
    }
    const Region region = beforeCallbacks([&] { return Region(*this, box); });
    meet(region.slots().data(), region.slots().data() + region.slots().size());
}

// With what is in its own block, which is itself too, and in those within; then with what is in the blocks
// around, from the nearest outwards. In other blocks nothing meets it.
void dxOrderedQuadTreeSpace::collideMember(void *data, dxGeom *geom, dNearCallback *callback) {
    const Block home = blockOf(slotOf(geom));
    const std::uint64_t missed = dxMissedNotifications.count();
    const std::size_t switched = members().switched().size();
    Swapped swapped{data, callback};
    // Returns false if it has done the rest, too.
    const auto meet = [&](Slot slot, bool isInner) {
        dxGeom *const member = members().geomIn(slot);
        if (!dxGeomIsEnabled(member)) return true;
        isInner ? dxDeliverIfAgreed(geom, member, &swapped, Swapped::call) : dxDeliverIfAgreed(member, geom, data, callback);
        if (dxMissedNotifications.count() == missed && members().switched().size() == switched) return true;
        walkMember(data, geom, callback, member);
        return false;
    };
    withOverlapping(dxBounds(geom->aabb), [&](const Slot *first, const Slot *last) {
        const Slot *const inner = std::find_if(first, last, [&](Slot slot) { return blockOf(slot) >= home; });
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

// The same without regard to where boxes are; `after`: only what comes after this member.
void dxOrderedQuadTreeSpace::walkMember(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after) {
    Swapped swapped{data, callback};
    Visit visit = beforeCallbacks([&] { return Visit(*this, &swapped, Swapped::call); });
    Block block = blockOf(slotOf(geom));
    const Block last = after != nullptr ? blockOf(slotOf(after)) : m_tree.endOf(block);
    const auto placeFrom = [&](Block first) {
        std::size_t place = 0;
        while (place != visit.order.size() && visit.blockAt(place) < first) ++place;
        return place;
    };
    const std::size_t next = after != nullptr ? visit.placeOf(slotOf(after)) + 1 : 0;
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

void dxOrderedQuadTreeSpace::collideOther(void *data, dxGeom *geom, dNearCallback *callback) {
    const dxBounds box(geom->aabb);
    const std::uint64_t missed = dxMissedNotifications.count();
    const std::size_t switched = members().switched().size();
    Swapped swapped{data, callback};
    withOverlapping(box, [&](const Slot *first, const Slot *last) {
        for (const Slot *slot = first; slot != last; ++slot) {
            dxGeom *const member = members().geomIn(*slot);
            if (!dxGeomIsEnabled(member)) continue;
            dxDeliverIfAgreed(geom, member, &swapped, Swapped::call);
            if (isStill(geom, box) && dxMissedNotifications.count() == missed && members().switched().size() == switched) continue;
            return walkOther(data, geom, callback, member);
        }
    });
}

// From the root on; `after`: only what comes after this member.
void dxOrderedQuadTreeSpace::walkOther(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after) {
    Swapped swapped{data, callback};
    Visit visit = beforeCallbacks([&] { return Visit(*this, &swapped, Swapped::call); });
    if (after != nullptr) visit.next = visit.placeOf(slotOf(after)) + 1;
    visit.meetFrom(geom, dxQuadTree::kRoot, 0, visit.order.size());
}
