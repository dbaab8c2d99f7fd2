#include "collision/spaces/sweep_and_prune/dxSapCleaner.h"

#include <algorithm>
#include <utility>

#include "collision/spaces/dxWalking.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"

namespace {

// Number of geoms that are cleaned between two reads of boxes.
constexpr std::size_t kBoxesAtOnce = 8;

// Rank of the first clean member. Ranks fall from there on.
constexpr dxRank kFirstRank = dxRank{1} << 40;

dxRank rankAt(std::size_t place) { return kFirstRank - place; }

}  // namespace

// ---- Lists -----------------------------------------------------------------------------------------------------------------------------

void dxSapLists::reserveMemory(Slot slots) {
    dxReserveCapacity(m_dirty, slots);
    dxReserveCapacity(m_clean, slots);
    dxReserveCapacity(m_places, slots);
}

void dxSapLists::add(Slot slot, dxGeom *geom) { append({geom, slot}, true); }

void dxSapLists::append(const Entry &entry, bool isDirty) {
    std::vector<Entry> &list = isDirty ? m_dirty : m_clean;
    if (entry.slot >= m_places.size()) m_places.resize(entry.slot + 1);
    m_places[entry.slot] = {static_cast<std::uint32_t>(list.size()), isDirty};
    list.push_back(entry);
}

void dxSapLists::remove(Slot slot) {
    std::vector<Entry> &list = m_places[slot].isDirty ? m_dirty : m_clean;
    const std::uint32_t index = m_places[slot].index;
    list[index] = list.back();
    m_places[list[index].slot].index = index;
    list.pop_back();
}

void dxSapLists::makeDirty(Slot slot) {
    const Entry entry = m_clean[m_places[slot].index];
    remove(slot);
    append(entry, true);
}

void dxSapLists::cleanAll() {
    for (const Entry &entry : m_dirty) append(entry, false);
    m_dirty.clear();
}

// ---- Cleaning --------------------------------------------------------------------------------------------------------------------------

void dxSapCleaner::reserveMemory(Slot slots) {
    m_lists.reserveMemory(slots);
    dxReserveCapacity(m_state.members, slots);
    dxReserveCapacity(m_toClean, slots);
}

void dxSapCleaner::onAdded(dxGeom *geom, Slot slot) {
    m_lists.add(slot, geom);
    if (slot >= m_state.members.size()) m_state.members.resize(slot + 1);
    m_state.members[slot].part = dxSapPart::absent;
    m_lastWalk.invalidate();
}

void dxSapCleaner::onRemoved(Slot slot) {
    const bool wasDirty = m_lists.isDirty(slot);
    const std::size_t place = m_lists.placeOf(slot);
    m_lists.remove(slot);
    if (!wasDirty) rankSuccessor(slot, place);
    m_state.members[slot].part = dxSapPart::absent;
    m_lastWalk.invalidate();
}

// Ranks the member that has taken the place of this one. If this one is absent, nothing else marks the change of the order.
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

// If a bounding-box function has the space cleaned, or leaves the cleaning by a jump, upstream enters geoms twice, and its next collide() fails.
void dxSapCleaner::clean() {
    if (m_lists.dirty().empty()) return;
    m_lastWalk.invalidate();
    m_geoms.space().lock_count++;
    m_toClean.clear();
    for (const dxSapLists::Entry &entry : m_lists.dirty()) m_toClean.push_back(entry.geom);
    const bool wasMessedUp = std::exchange(m_isMessedUp, true);  // until this cleaning has ended
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

// A box is read some geoms after it was computed: earlier, its loads would wait for the stores, which are narrower.
void dxSapCleaner::cleanAndRank() {
    m_geoms.computeBoxes(m_toClean);
    const std::size_t cleanOnes = m_lists.clean().size();
    std::size_t next = 0;
    const auto setUpTo = [&](std::size_t end) {
        for (; next < std::min(end, m_toClean.size()); ++next) setBoxAndRank(m_toClean[next], rankAt(cleanOnes + next));
    };
    for (std::size_t i = 0; i < m_toClean.size(); ++i) {
        m_geoms.clean(m_toClean, i);
        if ((i + 1) % kBoxesAtOnce == 0) setUpTo(i + 1 - kBoxesAtOnce / 2);
    }
    setUpTo(m_toClean.size());
}

void dxSapCleaner::setBoxAndRank(dxGeom *geom, dxRank rank) {
    const dxSapBox box = m_state.axes.boxOf(geom);
    m_state.members[dxSpaceGeoms::slotOf(geom)].box = box;
    m_geoms.rank(geom, rank, boundsOf(geom, box));
}

// Returns bounds that contain the rounded box and are not inverted, so that all of upstream's pairs overlap.
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
        m_lastWalk.invalidate();
        setBoxAndRank(geom, m_geoms.members()[dxSpaceGeoms::slotOf(geom)].rank);
    }
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    return std::any_of(list.begin(), list.end(), [](const dxSapLists::Entry &entry) { return (entry.geom->gflags & GEOM_DIRTY) != 0; });
}

// Where a box is not up to date, upstream's assertion fails at its first pair, so the call walks.
bool dxSapCleaner::cleanToCollide() {
    m_geoms.walking().noteCollided();
    if (m_geoms.isOutermostCall()) {
        m_lastWalk.beginCall();
        chooseToWalk();
    }
    clean();
    if (m_geoms.isOutermostCall()) m_geoms.walking().takeMoved();  // they have counted in chooseToWalk()
    if (m_isMessedUp) dDebug(d_ERR_UASSERT, "geom counts messed up in %s()", "collide");
    m_geoms.mayHaveStaleGeoms();  // reads boxes of stale geoms again
    if (m_geoms.walking() || (!m_geoms.isSure() && hasUncleanBox())) return false;
    if (m_geoms.isOutermostCall() && m_lastWalk.takeSorted()) m_pairs.startAnew();
    return true;
}

void dxSapCleaner::chooseToWalk() {
    dxWalking &walking = m_geoms.walking();
    const int moved = std::min(walking.takeMoved() + static_cast<int>(m_lists.dirty().size()), m_geoms.count());
    const bool hasRested =
        walking && !isServedByLastWalk(moved) && walking.hasRested(moved, dxMinMovedToWalk(m_geoms.pairOrder(), m_geoms.count()));
    const bool isWalked = !hasRested && m_geoms.isWorthWalking(moved, m_state.comparisons);
    if (walking && !isWalked) {
        stopWalking();
        m_lastWalk.discard();
    }
    walking.set(isWalked);
}

// For a small space at rest whose geoms may move again, nothing is faster than to deliver its last walk again.
bool dxSapCleaner::isServedByLastWalk(int moved) const {
    return moved == 0 && m_lastWalk.isCurrent(m_geoms) && m_lastWalk.walk().areMostWanted() &&
           m_geoms.count() <= dxBroadphaseThresholds::kMaxAlwaysSwept;
}

void dxSapCleaner::stopWalking() {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t place = 0; place < list.size(); ++place) setBoxAndRank(list[place].geom, rankAt(place));
    m_geoms.walking().set(false);
}

// Returns whether a box of an enabled clean member is not up to date.
bool dxSapCleaner::hasUncleanBox() const {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + kSapPrefetchDistance < list.size()) dxPrefetch::line(&list[i + kSapPrefetchDistance].geom->gflags);
        if (dxGeomIsEnabled(list[i].geom) && (list[i].geom->gflags & GEOM_AABB_BAD) != 0) return true;
    }
    return false;
}
