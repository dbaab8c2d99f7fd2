#include "collision/narrowphase/dxConvexArrays.h"

#include <atomic>
#include <cstring>
#include <new>

#include "config.h"
#include "collision_kernel.h"
#include "collision_std.h"

namespace {

std::uint64_t nextNumber() {
    static std::atomic<std::uint64_t> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

std::size_t planeNumbers(const dxConvex &convex) { return std::size_t{4} * convex.planecount; }
std::size_t pointNumbers(const dxConvex &convex) { return std::size_t{3} * convex.pointcount; }

template <class Number>
bool areEqual(const std::vector<Number> &copy, const Number *array, std::size_t count) {
    return copy.size() == count && (count == 0 || std::memcmp(copy.data(), array, count * sizeof(Number)) == 0);
}

template <class Number>
void copy(std::vector<Number> &to, const Number *from, std::size_t count) {
    if (count != 0) to.assign(from, from + count);
}

}  // namespace

dxConvexArrays::Copy::Copy(const dxConvex &convex) : m_number(nextNumber()) {
    copy(m_planes, convex.planes, planeNumbers(convex));
    copy(m_points, convex.points, pointNumbers(convex));
    const unsigned *polygon = convex.polygons;
    if (polygon == nullptr) return;
    for (unsigned i = 0; i < convex.planecount; ++i) polygon += *polygon + std::size_t{1};
    copy(m_polygons, convex.polygons, static_cast<std::size_t>(polygon - convex.polygons));
}

// A polygon begins with the number of its points: it is read only if everything before it was equal.
bool dxConvexArrays::Copy::equals(const dxConvex &convex) const {
    if (!areEqual(m_planes, convex.planes, planeNumbers(convex))) return false;
    if (!areEqual(m_points, convex.points, pointNumbers(convex))) return false;
    if (convex.polygons == nullptr) return m_polygons.empty();
    for (std::size_t at = 0; at < m_polygons.size();) {
        const std::size_t length = m_polygons[at] + std::size_t{1};
        if (convex.polygons[at] != m_polygons[at]) return false;
        if (std::memcmp(&m_polygons[at], convex.polygons + at, length * sizeof(unsigned)) != 0) return false;
        at += length;
    }
    return !m_polygons.empty() || convex.planecount == 0;
}

void dxConvexArrays::Copy::giveTo(dxConvex &convex) const {
    convex.planes = m_planes.data();
    convex.planecount = static_cast<unsigned>(m_planes.size() / 4);
    convex.points = m_points.data();
    convex.pointcount = static_cast<unsigned>(m_points.size() / 3);
    convex.polygons = m_polygons.empty() ? nullptr : m_polygons.data();
}

void dxConvexArrays::read(Slot slot, const dxConvex &convex) {
    if (slot < m_copies.size() && m_copies[slot] != nullptr && m_copies[slot]->equals(convex)) return;
    try {
        if (m_copies.size() <= slot) m_copies.resize(slot + std::size_t{1});
        m_copies[slot] = copyOf(convex);
    } catch (const std::bad_alloc &) {
        forget(slot);
    }
}

void dxConvexArrays::forget(Slot slot) {
    if (slot < m_copies.size()) m_copies[slot].reset();
}

std::shared_ptr<const dxConvexArrays::Copy> dxConvexArrays::copyOf(const dxConvex &convex) {
    if (m_byPlace.size() >= m_maxPlaces) dropUnused();
    std::weak_ptr<const Copy> &known =
        m_byPlace[{convex.planes, convex.points, convex.polygons, convex.planecount, convex.pointcount}];
    std::shared_ptr<const Copy> found = known.lock();
    if (found == nullptr || !found->equals(convex)) known = found = std::make_shared<const Copy>(convex);
    return found;
}

void dxConvexArrays::dropUnused() {
    for (auto place = m_byPlace.begin(); place != m_byPlace.end();)
        place = place->second.expired() ? m_byPlace.erase(place) : std::next(place);
    m_maxPlaces = 2 * m_byPlace.size() + 64;
}
