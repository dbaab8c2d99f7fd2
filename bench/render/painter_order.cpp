#include "render/painter_order.h"

#include "render/area.h"

#include <algorithm>

namespace render {

namespace {

constexpr double kTouching = 1e-6;  // m: boxes that touch are parted

std::vector<Point> projected(const std::vector<Vector> &corners, const Camera &camera) {
    std::vector<Point> points;
    for (const Vector &corner : corners) points.push_back(camera.project(corner));
    return points;
}

// 1: a face of `box` shows that the corners lie in front of it; -1: behind; 0: no face parts them.
int sideOf(const OrientedBox &box, const std::vector<Vector> &corners, const Camera &camera) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const Vector normal = sign * box.axes[axis];
            const double face = dot(normal, box.centre) + box.half[axis],
                         facing = dot(normal, camera.toViewer());
            const bool isBeyond = std::all_of(corners.begin(), corners.end(), [&](const Vector &corner) {
                return dot(normal, corner) >= face - kTouching;
            });
            if (isBeyond && facing != 0) return facing > 0 ? 1 : -1;
        }
    }
    return 0;
}

class Sorter {
public:
    Sorter(const std::vector<OrientedBox> &boxes, const Camera &camera)
        : m_boxes(boxes), m_camera(camera), m_covers(boxes.size()), m_waitsFor(boxes.size(), 0) {
        for (const OrientedBox &box : boxes) {
            m_corners.push_back(box.corners());
            m_areas.push_back(areaOf(projected(m_corners.back(), camera)));
        }
        for (std::size_t a = 0; a < boxes.size(); ++a)
            for (std::size_t b = a + 1; b < boxes.size(); ++b) compare(a, b);
    }

    std::vector<std::size_t> order() {
        std::vector<std::size_t> waiting(m_boxes.size()), order;
        for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = i;
        while (!waiting.empty()) {
            const auto next =
                std::min_element(waiting.begin(), waiting.end(),
                                 [this](std::size_t a, std::size_t b) { return comesFirst(a, b); });
            order.push_back(*next);
            for (std::size_t above : m_covers[*next]) --m_waitsFor[above];
            waiting.erase(next);
        }
        return order;
    }

private:
    double nearness(std::size_t i) const { return m_camera.nearness(m_boxes[i].centre); }

    bool isBehind(std::size_t a, std::size_t b) const {
        if (const int side = sideOf(m_boxes[a], m_corners[b], m_camera)) return side > 0;
        if (const int side = sideOf(m_boxes[b], m_corners[a], m_camera)) return side < 0;
        return nearness(a) <= nearness(b);
    }

    void compare(std::size_t a, std::size_t b) {
        if (!m_areas[a].overlaps(m_areas[b])) return;
        const bool firstIsBehind = isBehind(a, b);
        m_covers[firstIsBehind ? a : b].push_back(firstIsBehind ? b : a);
        ++m_waitsFor[firstIsBehind ? b : a];
    }

    // In a cycle somebody has to begin: who waits for the fewest, then who is farthest.
    bool comesFirst(std::size_t a, std::size_t b) const {
        if (m_waitsFor[a] != m_waitsFor[b]) return m_waitsFor[a] < m_waitsFor[b];
        return nearness(a) < nearness(b);
    }

    const std::vector<OrientedBox> &m_boxes;
    const Camera &m_camera;
    std::vector<std::vector<Vector>> m_corners;
    std::vector<Area> m_areas;
    std::vector<std::vector<std::size_t>> m_covers;  // what is drawn after it
    std::vector<int> m_waitsFor;
};

}  // namespace

std::vector<std::size_t> painterOrder(const std::vector<OrientedBox> &boxes, const Camera &camera) {
    return Sorter(boxes, camera).order();
}

}  // namespace render
