#include "collision/dxOrderedQuadTreeSpace.h"

#include <algorithm>

#include "util.h"
#include "collision_space_internal.h"

namespace {

// A callback whose arguments come in the other order.
struct Swapped {
    void *data;
    dNearCallback *callback;

    static void call(void *self, dxGeom *a, dxGeom *b) {
        const Swapped &swapped = *static_cast<Swapped *>(self);
        swapped.callback(swapped.data, b, a);
    }
};

}  // namespace

dxOrderedQuadTreeSpace::dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth)
    : dxOrderedSpace(parent, dQuadTreeSpaceClass), m_tree(centre, extents, depth), m_ranks(m_tree.size()) {
    for (int axis = 0; axis < 3; ++axis) {
        aabb[2 * axis] = -dInfinity;
        aabb[2 * axis + 1] = dInfinity;
    }
}

// As upstream, which has none.
dxGeom *dxOrderedQuadTreeSpace::getGeom(int index) {
    dUASSERT(index >= 0 && index < count, "index out of range");
    dDebug(0, "dxQuadTreeSpace::getGeom() not yet implemented");
    return nullptr;
}

// A geom comes into the block of the box that it had last, until it is cleaned.
void dxOrderedQuadTreeSpace::add(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(geom->tome_ex == nullptr && geom->next_ex == nullptr, "geom is already in a space");
    dxOrderedSpace::add(geom);
    const Slot slot = slotOf(geom);
    members().setRank(slot, nextRank(m_tree.find(geom->aabb, dxQuadTree::kRoot)));
    m_dirty.push(geom, slot);
}

void dxOrderedQuadTreeSpace::remove(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(geom->parent_space == this, "object is not in this space");
    m_dirty.drop(slotOf(geom));
    dxOrderedSpace::remove(geom);
}

void dxOrderedQuadTreeSpace::dirty(dxGeom *geom) { m_dirty.push(geom, slotOf(geom)); }

// The queue is emptied last: a user's bounding-box function may leave by an exception.
void dxOrderedQuadTreeSpace::cleanGeoms() {
    lock_count++;
    const std::vector<dxGeom *> &geoms = m_dirty.geoms();
    computeBoxes(geoms);
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        clean(geoms, i);
        const dxRank before = members()[slotOf(geoms[i])].rank;
        const Block from = m_ranks.blockOf(before), to = m_tree.find(geoms[i]->aabb, from);
        rank(geoms[i], to == from ? before : nextRank(to));
    }
    m_dirty.clear();
    lock_count--;
}

dxRank dxOrderedQuadTreeSpace::nextRank(Block block) {
    if (m_ranks.isExhausted()) rankAnew();
    return m_ranks.next(block);
}

// In the order in which they are.
void dxOrderedQuadTreeSpace::rankAnew() {
    std::vector<Slot> slots;
    for (Slot slot = 0; slot < members().end(); ++slot)
        if (members()[slot].geom != nullptr && members()[slot].rank != 0) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(), [this](Slot a, Slot b) { return members()[a].rank < members()[b].rank; });
    m_ranks.startAgain();
    for (const Slot slot : slots) members().setRank(slot, m_ranks.next(blockOf(slot)));
    startAnew();
}

void dxOrderedQuadTreeSpace::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    if (geom->parent_space == this)
        collideMember(data, geom, callback);
    else
        collideOther(data, geom, callback);
}

// With what is in its own block, which is itself too, and in those within; then with what is in the blocks around, from
// the nearest outwards. In other blocks nothing meets it.
void dxOrderedQuadTreeSpace::collideMember(void *data, dxGeom *geom, dNearCallback *callback) {
    const std::vector<Slot> &region = findRegion(dxBounds(geom->aabb));
    const Block home = blockOf(slotOf(geom));
    const auto inner =
        std::find_if(region.begin(), region.end(), [&](Slot slot) { return blockOf(slot) >= home; });
    Swapped swapped{data, callback};
    for (auto slot = inner; slot != region.end(); ++slot) {
        dxGeom *const member = members()[*slot].geom;
        if (dxGeomIsEnabled(member)) collideAABBs(geom, member, &swapped, Swapped::call);
    }
    for (auto end = inner; end != region.begin();) {
        auto begin = end;
        while (begin != region.begin() && blockOf(begin[-1]) == blockOf(end[-1])) --begin;
        for (auto slot = begin; slot != end; ++slot) {
            dxGeom *const member = members()[*slot].geom;
            if (dxGeomIsEnabled(member)) collideAABBs(member, geom, data, callback);
        }
        end = begin;
    }
}

// What is left of upstream's way from the root on, once a geom that is not in the space has moved in a callback. Blocks
// that its box, as it is by then, does not meet are passed over, unless they hold only one geom.
struct dxOrderedQuadTreeSpace::Rest {
    const dxOrderedQuadTreeSpace &space;
    dxGeom *geom;
    Swapped &swapped;
    std::vector<Slot> order;  // all members, as upstream comes to them
    std::size_t next = 0;     // the first whose turn has not been

    void startAfter(Slot last) {
        const dxMembers &members = space.members();
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members[slot].geom != nullptr) order.push_back(slot);
        std::sort(order.begin(), order.end(), [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
        next = static_cast<std::size_t>(std::find(order.begin(), order.end(), last) - order.begin()) + 1;
    }

    // The members in the block and those within stand in [at, end).
    void visit(Block block, std::size_t at, std::size_t end) {
        for (; at != end && space.blockOf(order[at]) == block; ++at)
            if (at >= next) meet(space.members()[order[at]].geom);
        const dxQuadTree &tree = space.m_tree;
        for (Block quarter = block + 1; at != end; quarter = tree.endOf(quarter)) {
            std::size_t last = at;
            while (last != end && space.blockOf(order[last]) < tree.endOf(quarter)) ++last;
            const bool isUnderWay = at < next && next < last;
            const bool isToCome = at >= next && at != last;
            if (isUnderWay || (isToCome && (last - at == 1 || tree.mayMeet(quarter, geom->aabb))))
                visit(quarter, at, last);
            at = last;
        }
    }

    void meet(dxGeom *member) const {
        if (dxGeomIsEnabled(member)) collideAABBs(geom, member, &swapped, Swapped::call);
    }
};

void dxOrderedQuadTreeSpace::collideOther(void *data, dxGeom *geom, dNearCallback *callback) {
    const dxBounds box(geom->aabb);
    Swapped swapped{data, callback};
    for (const Slot slot : findRegion(box)) {
        dxGeom *const member = members()[slot].geom;
        if (!dxGeomIsEnabled(member)) continue;
        collideAABBs(geom, member, &swapped, Swapped::call);
        if (isStill(geom, box)) continue;
        Rest rest{*this, geom, swapped, {}};
        rest.startAfter(slot);
        return rest.visit(dxQuadTree::kRoot, 0, rest.order.size());
    }
}
