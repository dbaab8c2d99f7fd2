#include "collision/spaces/dxSapCleaner.h"

#include <algorithm>
#include <utility>

#include "core/dxPrefetch.h"
#include "core/dxReserve.h"

namespace {

// Geoms that are cleaned before their boxes are taken.
constexpr std::size_t kBoxesAtOnce = 8;

// Of the first of the clean members. Ranks fall from there on.
constexpr dxRank kFirstRank = dxRank{1} << 40;

dxRank rankAt(std::size_t place) { return kFirstRank - place; }

}  // namespace

void dxSapCleaner::reserveMemory(Slot slots) {
    m_lists.reserveMemory(slots);
    dxReserveCapacity(m_state.members, slots);
    dxReserveCapacity(m_toClean, slots);
}

void dxSapCleaner::onAdded(dxGeom *geom, Slot slot) {
    m_lists.add(slot, geom);
    if (slot >= m_state.members.size()) m_state.members.resize(slot + 1);
    m_state.members[slot].part = dxSapPart::absent;
    m_state.invalidateSweep();
}

void dxSapCleaner::onRemoved(Slot slot) {
    const bool wasDirty = m_lists.isDirty(slot);
    const std::size_t place = m_lists.placeOf(slot);
    m_lists.remove(slot);
    if (!wasDirty) rankSuccessor(slot, place);
    m_state.members[slot].part = dxSapPart::absent;
    m_state.invalidateSweep();
}

// The member that has taken the place of this one. If this one is absent, no other notification shows that the order
// has changed.
void dxSapCleaner::rankSuccessor(Slot slot, std::size_t place) {
    if (m_geoms.walking() || place >= m_lists.clean().size()) return;
    const Slot successor = m_lists.clean()[place].slot;
    m_geoms.members().setRank(successor, rankAt(place));
    if (!m_geoms.members().isPresent(slot)) m_geoms.members().markChanged(successor);
}

void dxSapCleaner::makeDirty(dxGeom *geom) {
    const Slot slot = dxSpaceGeoms::slotOf(geom);
    if (m_lists.isDirty(slot)) return;
    const std::size_t place = m_lists.placeOf(slot);
    m_lists.makeDirty(slot);
    rankSuccessor(slot, place);
}

// Where a bounding-box function has the space cleaned, or leaves its cleaning, upstream enters geoms twice, and its next collide() fails.
void dxSapCleaner::clean() {
    if (m_lists.dirty().empty()) return;
    m_state.invalidateSweep();
    m_geoms.space().lock_count++;
    m_toClean.clear();
    for (const dxSapLists::Entry &entry : m_lists.dirty()) m_toClean.push_back(entry.geom);
    const bool wasMessedUp = std::exchange(m_isMessedUp, true);  // where this is left, or nested
    dxWalking &walking = m_geoms.walking();
    walking.noteMoved(static_cast<int>(m_toClean.size()), m_geoms.count());
    if (walking.isForQuery(static_cast<int>(m_toClean.size()), m_geoms.count()) && m_geoms.mayWalk()) walking.set(true);
    if (walking)
        for (std::size_t i = 0; i < m_toClean.size(); ++i) m_geoms.clean(m_toClean, i);
    else
        cleanAndRank();
    m_isMessedUp = wasMessedUp || m_lists.dirty().empty();
    m_lists.cleanAll();
    m_geoms.space().lock_count--;
}

// A box is read some geoms later than it is computed: at once its loads would wait for the stores, which are narrower.
void dxSapCleaner::cleanAndRank() {
    m_geoms.computeBoxes(m_toClean);
    const std::size_t cleanOnes = m_lists.clean().size();
    std::size_t taken = 0;
    const auto takeUpTo = [&](std::size_t end) {
        for (; taken < std::min(end, m_toClean.size()); ++taken) takeBox(m_toClean[taken], rankAt(cleanOnes + taken));
    };
    for (std::size_t i = 0; i < m_toClean.size(); ++i) {
        m_geoms.clean(m_toClean, i);
        if ((i + 1) % kBoxesAtOnce == 0) takeUpTo(i + 1 - kBoxesAtOnce / 2);
    }
    takeUpTo(m_toClean.size());
}

void dxSapCleaner::takeBox(dxGeom *geom, dxRank itsRank) {
    const dxSapBox box = m_state.axes.boxOf(geom);
    m_state.members[dxSpaceGeoms::slotOf(geom)].box = box;
    m_geoms.rank(geom, itsRank, boundsOf(geom, box));
}

// The bounds contain the rounded box, and are not inverted, so that all pairs of upstream overlap.
dxBounds dxSapCleaner::boundsOf(const dxGeom *geom, const dxSapBox &box) const {
    dxBounds bounds(geom->aabb);
    if (!m_state.axes.areAll()) return bounds;
    dReal &low = bounds.v[2 * m_state.axes.first()], &high = bounds.v[2 * m_state.axes.first() + 1];
    if (box.low < low) low = box.low;
    if (box.high > high) high = box.high;
    if (box.low > high) high = box.low;
    return bounds;
}

bool dxSapCleaner::readAgain() {
    for (dxGeom *geom = m_geoms.space().first; geom != nullptr; geom = geom->next) {
        m_state.invalidateSweep();
        takeBox(geom, m_geoms.members()[dxSpaceGeoms::slotOf(geom)].rank);
    }
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    return std::any_of(list.begin(), list.end(), [](const dxSapLists::Entry &entry) { return (entry.geom->gflags & GEOM_DIRTY) != 0; });
}

// Ranks do not represent upstream's order where a box is not up to date, at which upstream fails an assertion.
bool dxSapCleaner::cleanToCollide() {
    m_geoms.walking().noteCollided();
    if (m_geoms.isOutermostCall()) {
        m_state.beginCall();
        chooseToWalk();
    }
    clean();
    if (m_geoms.isOutermostCall()) m_geoms.walking().takeMoved();  // has been chosen by
    if (m_isMessedUp) dDebug(d_ERR_UASSERT, "geom counts messed up in %s()", "collide");
    m_geoms.mayHaveStaleGeoms();  // a stale geom has the box of its last query, which is used again
    if (m_geoms.walking() || (!m_geoms.isSure() && hasUncleanBox())) return false;
    if (m_state.hasWalked && m_geoms.isOutermostCall()) {  // the sort continues the history of the walk's: equal keys may have another order
        m_state.hasWalked = false;
        m_pairs.startAnew();
    }
    return true;
}

void dxSapCleaner::chooseToWalk() {
    dxWalking &walking = m_geoms.walking();
    const int moved = std::min(walking.takeMoved() + static_cast<int>(m_lists.dirty().size()), m_geoms.count());
    const bool hasRested =
        walking && !isServedBySweep(moved) && walking.hasRested(moved, dxMinMovedToWalk(m_geoms.pairOrder(), m_geoms.count()));
    const bool isWalked = !hasRested && m_geoms.isWorthWalking(moved, m_state.comparisons);
    if (walking && !isWalked) {
        stopWalking();
        m_state.discardSweep();
    }
    walking.set(isWalked);
}

// Nothing is faster for a small space at rest, whose geoms may move again, than the pairs of its last walk.
bool dxSapCleaner::isServedBySweep(int moved) const {
    return moved == 0 && m_state.isSweepCurrent(m_geoms) && m_state.sweep().areMostWanted() &&
           m_geoms.count() <= dxBroadphaseThresholds::kMaxAlwaysSwept;
}

void dxSapCleaner::stopWalking() {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t place = 0; place < list.size(); ++place) takeBox(list[place].geom, rankAt(place));
    m_geoms.walking().set(false);
}

bool dxSapCleaner::hasUncleanBox() const {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + kSapPrefetchDistance < list.size()) dxPrefetch::line(&list[i + kSapPrefetchDistance].geom->gflags);
        if (dxGeomIsEnabled(list[i].geom) && (list[i].geom->gflags & GEOM_AABB_BAD) != 0) return true;
    }
    return false;
}
