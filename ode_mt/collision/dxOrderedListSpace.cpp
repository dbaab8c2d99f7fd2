#include "collision/dxOrderedListSpace.h"

#include <algorithm>

#include "util.h"
#include "collision_space_internal.h"

namespace {

// Geoms against a space that is walked, between two moves, after which an index pays for the ranks that it needs.
constexpr int kMostWalks = 8;

// Geoms between asking the memory for one and looking at it.
constexpr std::size_t kGeomsAhead = 8;

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

// As upstream's collide2.
void collideFrom(dxGeom *member, void *data, dxGeom *geom, dNearCallback *callback) {
    for (; member != nullptr; member = member->next)
        if (dxGeomIsEnabled(member)) collideAABBs(member, geom, data, callback);
}

}  // namespace

// Upstream stops at the first geom that is clean, and so do we. Ranks are given from the front downwards, at
// once, because a user's bounding-box function may leave by an exception.
void dxOrderedListSpace::cleanGeoms() {
    lock_count++;
    gatherDirty();
    chooseToWalk();
    if (m_isWalked)
        for (std::size_t i = 0; i < m_dirty.size(); ++i) clean(m_dirty, i);
    else
        cleanAndRank();
    lock_count--;
}

void dxOrderedListSpace::cleanAndRank() {
    dxRank next = members().firstOf(count);
    computeBoxes(m_dirty);
    for (std::size_t i = 0; i < m_dirty.size(); ++i) {
        if (i + kGeomsAhead < m_dirty.size()) members().expect(slotOf(m_dirty[i + kGeomsAhead]));
        clean(m_dirty, i);
        rank(m_dirty[i], next--);
    }
    dxGeom *const clean = m_dirty.empty() ? first : m_dirty.back()->next;
    if (members().unranked() != 0 || m_irregular) rankBehindClean(clean, next);
}

// Workers, and a search that was asked for, need all pairs.
int dxOrderedListSpace::leastMovedToWalk() const {
    return isShared() || hasSearch() ? INT_MAX : leastToWalk();
}

void dxOrderedListSpace::chooseToWalk() {
    const auto moved = static_cast<int>(m_dirty.size());
    m_moved = std::min(m_moved + moved, count);
    if (moved != 0) m_walks = 0;
    const int least = leastMovedToWalk();
    m_isWalked = moved >= least || (m_isWalked && least != INT_MAX);
    m_irregular = m_irregular || m_isWalked;
}

// Until many move again.
void dxOrderedListSpace::stopWalking() {
    m_isWalked = false;
    rankBehindClean(first, members().firstOf(count));
}

// The list is walked until fewer than half as many move as it takes to begin with that.
bool dxOrderedListSpace::requireRanks() {
    if (m_isWalked && 2 * m_moved < leastMovedToWalk()) stopWalking();
    m_moved = 0;
    return !m_irregular;
}

void dxOrderedListSpace::gatherDirty() {
    m_dirty.clear();
    for (dxGeom *geom = first; geom != nullptr && isDirty(geom); geom = geom->next) m_dirty.push_back(geom);
}

// A geom that was clean when it was added stands, clean, before the dirty ones, and upstream never gets to
// those: they keep their old boxes, and an assertion fails where they meet. While there are such geoms, all
// ranks are given anew.
void dxOrderedListSpace::rankBehindClean(dxGeom *geom, dxRank next) {
    const bool wasIrregular = m_irregular;
    m_irregular = false;
    for (; geom != nullptr && (wasIrregular || members().unranked() != 0 || isDirty(geom)); geom = geom->next) {
        m_irregular = m_irregular || isDirty(geom);
        rank(geom, next--);
    }
}

void dxOrderedListSpace::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    if (m_isWalked && isWorthAnIndex() && ++m_walks > kMostWalks) stopWalking();
    if (m_irregular || !isWorthAnIndex())
        collideFrom(first, data, geom, callback);
    else if (const dxGeom *const last = collideRegion(data, geom, callback))
        collideFrom(last->next, data, geom, callback);
}
