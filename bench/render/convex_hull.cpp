#include "render/convex_hull.h"

#include <algorithm>

namespace render {

namespace {

// Above 0: c lies to the left of the way from a to b.
double turn(const Point &a, const Point &b, const Point &c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The lower half of the hull of sorted points, without its last point.
template <class Iterator>
void addHalf(Iterator begin, Iterator end, std::vector<Point> &hull) {
    const std::size_t start = hull.size();
    for (; begin != end; ++begin) {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *begin) <= 0)
            hull.pop_back();
        hull.push_back(*begin);
    }
    hull.pop_back();
}

}  // namespace

std::vector<Point> convexHull(std::vector<Point> points) {
    if (points.size() < 3) return points;
    std::sort(points.begin(), points.end(),
              [](const Point &a, const Point &b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Point> hull;
    addHalf(points.begin(), points.end(), hull);
    addHalf(points.rbegin(), points.rend(), hull);
    return hull;
}

}  // namespace render
