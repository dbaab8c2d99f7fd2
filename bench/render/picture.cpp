#include "render/picture.h"

#include "render/cluster_paint.h"
#include "render/painter_order.h"
#include "render/svg_canvas.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace render {

namespace {

constexpr double kMargin = 0.03;    // of the width
constexpr double kOverlooked = 14;  // px
constexpr Colour kFloor = {0.98, 0.98, 0.98}, kBig = {0.13, 0.13, 0.13};
const SvgCanvas::Stroke kFloorEdge = {{{0.5, 0.5, 0.5}}, 1.2}, kGridLine = {{{0.6, 0.6, 0.6}}, 0.4},
                        kNoStroke = {{}, 0};

bool isPlane(const record::Geom &geom) { return geom.shape.kind == "plane"; }

std::vector<Point> project(const std::vector<Vector> &points, const Camera &camera) {
    std::vector<Point> result;
    for (const Vector &point : points) result.push_back(camera.project(point));
    return result;
}

class Picture {
public:
    Picture(const record::Header &header, const record::Frame &frame, const View &view)
        : m_header(header),
          m_frame(frame),
          m_view(view),
          m_camera(view.azimuth, view.elevation),
          m_paint(header, frame) {
        for (std::size_t geom = 0; geom < header.geoms.size(); ++geom) {
            if (isPlane(header.geoms[geom])) continue;
            m_solids.push_back(geom);
            m_boxes.push_back(boxAround(header.geoms[geom].shape, frame.geoms[geom]));
        }
        measure();
    }

    std::string draw() {
        SvgCanvas canvas(shown(), m_view.width);
        canvas.caption(caption());
        drawPlanes(canvas);
        drawCells(canvas);
        drawGrid(canvas);
        drawSolids(canvas);
        drawRings(canvas);
        return canvas.document();
    }

private:
    // Where everything but planes is.
    void measure() {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        m_low = {kInfinity, kInfinity, kInfinity};
        m_high = {-kInfinity, -kInfinity, -kInfinity};
        for (const OrientedBox &box : m_boxes) {
            for (const Vector &corner : box.corners()) {
                for (std::size_t i = 0; i < 3; ++i) {
                    m_low[i] = std::min(m_low[i], corner[i]);
                    m_high[i] = std::max(m_high[i], corner[i]);
                }
            }
        }
        if (m_boxes.empty()) m_low = m_high = {};
    }

    bool moves(std::size_t solid) const {
        return m_header.geoms[m_solids[solid]].body != record::Geom::kStatic;
    }

    Area shown() const {
        std::vector<Point> points;
        for (std::size_t i = 0; i < m_boxes.size(); ++i) {
            if (m_view.radius > 0 && !moves(i)) continue;
            const std::vector<Point> corners = project(m_boxes[i].corners(), m_camera);
            points.insert(points.end(), corners.begin(), corners.end());
        }
        if (points.empty()) points = {{-1, -1}, {1, 1}};
        Area area = areaOf(points);
        const double margin = m_view.radius > 0 ? m_view.radius : kMargin * (area.right - area.left);
        return {area.left - margin, area.right + margin, area.top - margin, area.bottom + margin};
    }

    std::string caption() const {
        std::set<unsigned> statics;
        for (const record::Membership &membership : m_frame.memberships)
            if (membership.staticCluster != 0) statics.insert(membership.staticCluster);
        const auto count = [](std::size_t n, const char *what) {
            return std::to_string(n) + " " + what + "cluster" + (n == 1 ? "" : "s");
        };
        return m_header.world + ", " + m_header.algorithm + ": " +
               count(static_cast<std::size_t>(m_frame.clusters), "") +
               (statics.empty() ? "" : ", " + count(statics.size(), "static "));
    }

    // Draws the part of each plane that lies below the scene, if the viewer is in front of it.
    void drawPlanes(SvgCanvas &canvas) const {
        const Vector middle = 0.5 * (m_low + m_high);
        const double reach =
            0.52 * std::max({m_high[0] - m_low[0], m_high[1] - m_low[1], m_high[2] - m_low[2]});
        for (const record::Geom &geom : m_header.geoms) {
            if (!isPlane(geom)) continue;
            const std::vector<double> &s = geom.shape.size;
            const Vector normal = {s[0], s[1], s[2]};
            if (dot(normal, m_camera.toViewer()) <= 0) continue;
            const Vector foot = middle + (s[3] - dot(normal, middle)) * normal;
            const Vector axis = std::abs(normal[0]) < 0.9 ? Vector{1, 0, 0} : Vector{0, 1, 0};
            const Vector u = reach * normalised(axis - dot(axis, normal) * normal), v = cross(normal, u);
            canvas.polygon(project({foot + u + v, foot + v - u, foot - u - v, foot + u - v}, m_camera),
                           {kFloor}, kFloorEdge);
        }
    }

    double gridLow(std::size_t axis) const {
        return m_frame.grid.centre[axis] - m_frame.grid.edge * m_frame.grid.cells / 2;
    }

    // On the height of what lies lowest.
    Point onFloor(double column, double row) const {
        const double edge = m_frame.grid.edge;
        return m_camera.project({gridLow(0) + column * edge, gridLow(1) + row * edge, m_low[2]});
    }

    void drawGrid(SvgCanvas &canvas) const {
        const int cells = m_frame.grid.cells;
        if (cells == 0) return;
        std::vector<std::array<Point, 2>> lines;
        for (int i = 0; i <= cells; ++i) {
            lines.push_back({onFloor(i, 0), onFloor(i, cells)});
            lines.push_back({onFloor(0, i), onFloor(cells, i)});
        }
        canvas.lines(lines, kGridLine);
    }

    // The columns of cells in which a cluster is.
    void drawCells(SvgCanvas &canvas) const {
        std::set<std::tuple<int, int, unsigned>> columns;
        for (const record::Cell &cell : m_frame.cells) columns.insert({cell.x, cell.y, cell.cluster});
        for (const auto &[x, y, cluster] : columns)
            canvas.polygon({onFloor(x, y), onFloor(x + 1, y), onFloor(x + 1, y + 1), onFloor(x, y + 1)},
                           {m_paint.ofCluster(cluster)}, kNoStroke, 0.3);
    }

    void drawSolids(SvgCanvas &canvas) const {
        const Area area = shown();
        for (const std::size_t solid : painterOrder(m_boxes, m_camera)) {
            if (!areaOf(project(m_boxes[solid].corners(), m_camera)).overlaps(area)) continue;
            const std::size_t geom = m_solids[solid];
            const Paint paint = m_paint.of(geom);
            for (const Patch &patch : patchesOf(m_header.geoms[geom].shape, m_frame.geoms[geom], m_camera)) {
                std::vector<Colour> fills;
                for (const Colour &fill : paint.fills) fills.push_back(shaded(fill, patch.light));
                canvas.polygon(patch.corners, fills, {paint.outlines, paint.outlineWidth});
            }
        }
    }

    // Around clusters that one would overlook.
    void drawRings(SvgCanvas &canvas) const {
        for (const auto &[cluster, area] : areasOfClusters()) {
            const double size = std::max(area.right - area.left, area.bottom - area.top);
            if (canvas.pixels(size) >= kOverlooked) continue;
            canvas.ring({(area.left + area.right) / 2, (area.top + area.bottom) / 2}, kOverlooked,
                        {{cluster == 0 ? kBig : m_paint.ofCluster(cluster)}, 2.5});
        }
    }

    // On the screen, by name; 0: all that moves and is in none.
    std::map<unsigned, Area> areasOfClusters() const {
        std::map<unsigned, Area> areas;
        for (std::size_t i = 0; i < m_boxes.size(); ++i) {
            if (!moves(i)) continue;
            const Area area = areaOf(project(m_boxes[i].corners(), m_camera));
            const auto [known, isNew] = areas.insert({m_frame.memberships[m_solids[i]].cluster, area});
            known->second.include({area.left, area.top});
            known->second.include({area.right, area.bottom});
        }
        return areas;
    }

    const record::Header &m_header;
    const record::Frame &m_frame;
    const View &m_view;
    Camera m_camera;
    ClusterPaint m_paint;
    std::vector<std::size_t> m_solids;  // geoms that are no planes
    std::vector<OrientedBox> m_boxes;   // of the solids
    Vector m_low{}, m_high{};
};

}  // namespace

std::string drawFrame(const record::Header &header, const record::Frame &frame, const View &view) {
    return Picture(header, frame, view).draw();
}

}  // namespace render
