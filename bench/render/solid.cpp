#include "render/solid.h"

#include "render/convex_hull.h"

#include <algorithm>

namespace render {

namespace {

constexpr int kRoundCorners = 16;  // of a circle
constexpr double kFullTurn = 6.28318530717958647692;

double light(const Vector &normal) {
    static const Vector kSun = normalised({0.35, -0.45, 1});
    return 0.76 + 0.24 * std::max(0.0, dot(normal, kSun));
}

OrientedBox boxOf(const record::Pose &pose, const Vector &middle, const Vector &half) {
    return {toWorld(pose, middle),
            {rotate(pose, {1, 0, 0}), rotate(pose, {0, 1, 0}), rotate(pose, {0, 0, 1})},
            half};
}

// A circle around a point in the world, in the plane of two vectors whose length is the radius.
std::vector<Point> circle(const Camera &camera, const Vector &centre, const Vector &u, const Vector &v) {
    std::vector<Point> points;
    for (int i = 0; i < kRoundCorners; ++i) {
        const double angle = kFullTurn * i / kRoundCorners;
        points.push_back(camera.project(centre + std::cos(angle) * u + std::sin(angle) * v));
    }
    return points;
}

std::vector<Point> disc(const Camera &camera, const Vector &centre, double radius) {
    return circle(camera, centre, radius * camera.right(), radius * camera.up());
}

std::vector<Point> hullOf(std::vector<Point> a, const std::vector<Point> &b) {
    a.insert(a.end(), b.begin(), b.end());
    return convexHull(std::move(a));
}

Patch faceOf(const OrientedBox &box, std::size_t axis, double sign, const Camera &camera) {
    const Vector normal = sign * box.axes[axis];
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Vector middle = box.centre + box.half[axis] * normal;
    const Vector u = box.half[i] * box.axes[i], v = box.half[j] * box.axes[j];
    Patch patch{{}, light(normal)};
    for (const Vector &corner : {u + v, v - u, Vector{} - u - v, u - v})
        patch.corners.push_back(camera.project(middle + corner));
    return patch;
}

std::vector<Patch> boxPatches(const OrientedBox &box, const Camera &camera) {
    std::vector<Patch> patches;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double facing = dot(box.axes[axis], camera.toViewer());
        if (facing != 0) patches.push_back(faceOf(box, axis, facing > 0 ? 1 : -1, camera));
    }
    return patches;
}

std::vector<Patch> cylinderPatches(const record::Shape &shape, const record::Pose &pose,
                                   const Camera &camera) {
    const double radius = shape.size[0], half = shape.size[1] / 2;
    const Vector axis = rotate(pose, {0, 0, 1});
    const Vector u = radius * rotate(pose, {1, 0, 0}), v = radius * rotate(pose, {0, 1, 0});
    const double sign = dot(axis, camera.toViewer()) > 0 ? 1 : -1;
    const std::vector<Point> front = circle(camera, pose.position + sign * half * axis, u, v),
                             back = circle(camera, pose.position - sign * half * axis, u, v);
    return {{hullOf(front, back), 0.85}, {front, light(sign * axis)}};
}

std::vector<Patch> capsulePatches(const record::Shape &shape, const record::Pose &pose,
                                  const Camera &camera) {
    const Vector end = (shape.size[1] / 2) * rotate(pose, {0, 0, 1});
    const double radius = shape.size[0];
    return {
        {hullOf(disc(camera, pose.position + end, radius), disc(camera, pose.position - end, radius)), 0.9}};
}

std::vector<Patch> trianglePatches(const record::Shape &shape, const record::Pose &pose,
                                   const Camera &camera) {
    std::vector<std::pair<double, Patch>> byNearness;
    for (const record::Triangle &triangle : shape.triangles) {
        const Vector a = toWorld(pose, triangle[0]), b = toWorld(pose, triangle[1]),
                     c = toWorld(pose, triangle[2]);
        const Vector normal = normalised(cross(b - a, c - a));
        if (dot(normal, camera.toViewer()) <= 0) continue;
        byNearness.push_back({camera.nearness(a + b + c),
                              {{camera.project(a), camera.project(b), camera.project(c)}, light(normal)}});
    }
    std::stable_sort(byNearness.begin(), byNearness.end(),
                     [](const auto &first, const auto &second) { return first.first < second.first; });
    std::vector<Patch> patches;
    for (auto &entry : byNearness) patches.push_back(std::move(entry.second));
    return patches;
}

Vector lower(const record::Shape &mesh) { return {mesh.size[0], mesh.size[1], mesh.size[2]}; }
Vector upper(const record::Shape &mesh) { return {mesh.size[3], mesh.size[4], mesh.size[5]}; }

}  // namespace

std::vector<Vector> OrientedBox::corners() const {
    std::vector<Vector> corners;
    for (int i = 0; i < 8; ++i) {
        Vector corner = centre;
        for (std::size_t axis = 0; axis < 3; ++axis)
            corner = corner + ((i >> axis & 1 ? 1 : -1) * half[axis]) * axes[axis];
        corners.push_back(corner);
    }
    return corners;
}

OrientedBox boxAround(const record::Shape &shape, const record::Pose &pose) {
    const std::vector<double> &s = shape.size;
    if (shape.kind == "sphere") return boxOf(pose, {}, {s[0], s[0], s[0]});
    if (shape.kind == "capsule") return boxOf(pose, {}, {s[0], s[0], s[1] / 2 + s[0]});
    if (shape.kind == "cylinder") return boxOf(pose, {}, {s[0], s[0], s[1] / 2});
    if (shape.kind == "mesh")
        return boxOf(pose, 0.5 * (lower(shape) + upper(shape)), 0.5 * (upper(shape) - lower(shape)));
    return boxOf(pose, {}, {s[0] / 2, s[1] / 2, s[2] / 2});
}

std::vector<Patch> patchesOf(const record::Shape &shape, const record::Pose &pose, const Camera &camera) {
    if (shape.kind == "sphere") return {{disc(camera, pose.position, shape.size[0]), 0.95}};
    if (shape.kind == "capsule") return capsulePatches(shape, pose, camera);
    if (shape.kind == "cylinder") return cylinderPatches(shape, pose, camera);
    if (!shape.triangles.empty()) return trianglePatches(shape, pose, camera);
    return boxPatches(boxAround(shape, pose), camera);
}

}  // namespace render
