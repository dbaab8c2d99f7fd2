#include "collision/broadphase/dxRegionIndex.h"

#include <algorithm>
#include <mutex>
#include <new>

namespace {

// Number of cells on an axis of the curve along which boxes are sorted into the tree.
constexpr int kCurveBits = 16;
constexpr double kCurveCells = 1 << kCurveBits;

// Number of loose boxes that count as one comparison.
constexpr std::size_t kComparedAtOnce = 4;

// Number of loose boxes that are compared before their results are appended.
constexpr std::size_t kRowsInPart = 256;

// Returns the bits of a number with two zeros between each two of them.
std::uint64_t spread(std::uint64_t bits) {
    std::uint64_t spread = 0;
    for (int i = 0; i < kCurveBits; ++i) spread |= (bits >> i & 1) << (3 * i);
    return spread;
}

double middleOf(const dxBounds &box, int axis) {
    return 0.5 * static_cast<double>(box.low(axis)) + 0.5 * static_cast<double>(box.high(axis));
}

// Morton order: neighbours along the curve are near in space.
std::uint64_t placeOnCurve(const dxBounds &middles, const dxBounds &box) {
    std::uint64_t place = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = middles.high(axis) - middles.low(axis);
        const double share = extent > 0 ? (middleOf(box, axis) - middles.low(axis)) / extent : 0;
        const double cell = std::min(share * kCurveCells, kCurveCells - 1);
        place |= spread(static_cast<std::uint64_t>(cell)) << axis;
    }
    return place;
}

}  // namespace

dxRegionIndex::Place &dxRegionIndex::placeOf(Slot slot) {
    if (slot >= m_places.size()) m_places.resize(slot + 1);
    return m_places[slot];
}

void dxRegionIndex::loosen(Slot slot, const dxBounds &box) noexcept {
    if (!m_isInUse) return;
    try {
        Place &place = placeOf(slot);
        if (place.loose != kNoIndex) return m_looseBoxes.set(place.loose, box);
        if (place.row != kNoIndex) m_tree.erase(place.row);
        place.row = kNoIndex;
        joinLoose(slot, box);
    } catch (const std::bad_alloc &) {
        m_isInUse = false;
    }
}

void dxRegionIndex::joinLoose(Slot slot, const dxBounds &box) {
    placeOf(slot).loose = static_cast<std::uint32_t>(m_loose.size());
    m_loose.push_back(slot);
    m_looseBoxes.push(box);
}

void dxRegionIndex::drop(Slot slot) {
    if (!m_isInUse) return;
    Place &place = placeOf(slot);
    if (place.row != kNoIndex) m_tree.erase(place.row);
    place.row = kNoIndex;
    leaveLoose(place);
}

void dxRegionIndex::leaveLoose(Place &place) {
    if (place.loose == kNoIndex) return;
    m_loose[place.loose] = m_loose.back();
    m_looseBoxes.set(place.loose, m_looseBoxes.row(m_loose.size() - 1));
    m_places[m_loose.back()].loose = place.loose;
    m_loose.pop_back();
    m_looseBoxes.pop();
    place.loose = kNoIndex;
}

void dxRegionIndex::find(const dxMembers &members, const dxBounds &box, std::pmr::vector<Slot> &found) {
    found.clear();
    if (!query(box, found) && !(begin(members) && query(box, found))) {
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members.geomIn(slot) != nullptr && members[slot].bounds.overlaps(box)) found.push_back(slot);
        m_debt.fetch_add(members.end(), std::memory_order_relaxed);
    }
    std::sort(found.begin(), found.end(), [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
    buildIfDue(members);
}

// Returns false if the tree is not in use yet, or being built.
bool dxRegionIndex::query(const dxBounds &box, std::pmr::vector<Slot> &found) {
    const std::shared_lock<std::shared_mutex> reading(m_mutex, std::try_to_lock);
    if (!reading || !m_isInUse) return false;
    m_tree.query(box, found);
    for (std::uint32_t &row : found) row = m_slotOfRow[row];
    appendLoose(box, found);
    if (!m_loose.empty()) m_debt.fetch_add(1 + m_loose.size() / kComparedAtOnce, std::memory_order_relaxed);
    return true;
}

// Compares a part at a time, whose results fit on the stack.
void dxRegionIndex::appendLoose(const dxBounds &box, std::pmr::vector<Slot> &found) const {
    std::uint32_t rows[kRowsInPart];
    for (std::size_t begin = 0; begin < m_loose.size(); begin += kRowsInPart) {
        const std::size_t end = std::min(begin + kRowsInPart, m_loose.size());
        const std::size_t count = dxOverlappingRows(m_looseBoxes, box, begin, end, rows);
        for (std::size_t i = 0; i < count; ++i) found.push_back(m_loose[rows[i]]);
    }
}

// Requires a call at the first query. Returns false if another thread is in it, or without memory.
bool dxRegionIndex::begin(const dxMembers &members) {
    const std::unique_lock<std::shared_mutex> building(m_mutex, std::try_to_lock);
    if (!building) return false;
    if (m_isInUse) return true;
    try {
        m_places.assign(members.end(), Place());
        m_loose.clear();
        m_looseBoxes.clear();
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members.geomIn(slot) != nullptr) joinLoose(slot, members[slot].bounds);
    } catch (const std::bad_alloc &) {
        return false;
    }
    m_isInUse = true;
    return true;
}

void dxRegionIndex::buildIfDue(const dxMembers &members) {
    const std::size_t due = dxBroadphaseThresholds::kComparisonsPerRow * members.end();
    if (m_debt.load(std::memory_order_relaxed) <= due) return;
    const std::unique_lock<std::shared_mutex> building(m_mutex, std::try_to_lock);
    if (!building || m_debt.load(std::memory_order_relaxed) <= due) return;
    try {
        build(members);
    } catch (const std::bad_alloc &) {  // boxes are compared one by one, until it is due again
    }
}

void dxRegionIndex::build(const dxMembers &members) {
    m_debt.store(0, std::memory_order_relaxed);
    m_isInUse = false;  // if memory runs out half way
    m_places.resize(members.end());
    sortAlongCurve(members);
    m_slotOfRow.clear();
    m_loose.clear();
    m_looseBoxes.clear();
    m_tree.begin();
    for (Place &place : m_places) place = Place();
    for (const dxSortItem &item : m_items) {
        const Slot slot = item.index;
        m_places[slot].row = static_cast<std::uint32_t>(m_slotOfRow.size());
        m_slotOfRow.push_back(slot);
        m_tree.push(members[slot].bounds);
    }
    m_tree.finish();
    for (Slot slot = 0; slot < members.end(); ++slot)
        if (members.geomIn(slot) != nullptr && placeOf(slot).row == kNoIndex) joinLoose(slot, members[slot].bounds);
    m_isInUse = true;
}

void dxRegionIndex::sortAlongCurve(const dxMembers &members) {
    dxBounds middles = dxBounds::nothing();
    m_items.clear();
    for (Slot slot = 0; slot < members.end(); ++slot) {
        const dxBounds &box = members[slot].bounds;
        if (members.geomIn(slot) == nullptr || !box.isModerate()) continue;
        for (int axis = 0; axis < 3; ++axis) middles.includeOn(axis, middleOf(box, axis), middleOf(box, axis));
        m_items.push_back({0, slot});
    }
    for (dxSortItem &item : m_items) item.key = placeOnCurve(middles, members[item.index].bounds);
    dxRadixSort(m_items, m_spare);
}
