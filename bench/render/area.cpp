#include "render/area.h"

#include <algorithm>

namespace render {

void Area::include(const Point &p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
}

Area areaOf(const std::vector<Point> &points) {
    const Point &first = points.front();
    Area area = {first.x, first.x, first.y, first.y};
    for (const Point &point : points) area.include(point);
    return area;
}

}  // namespace render
