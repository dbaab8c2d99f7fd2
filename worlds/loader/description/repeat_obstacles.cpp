#include "loader/description/repeat_obstacles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace worlds {

namespace {

using ignition::math::Pose3d;
using ignition::math::Vector3d;

constexpr double touching = 1e-3;  // m, from the border

struct Rectangle {  // along x and y
    Vector3d least{HUGE_VAL, HUGE_VAL, 0}, most{-HUGE_VAL, -HUGE_VAL, 0};

    double width() const { return most.X() - least.X(); }
    double depth() const { return most.Y() - least.Y(); }

    void include(const Rectangle &other) {
        least.Min(other.least);
        most.Max(other.most);
    }
};

// Half the sides of the box around a shape; none for infinite shapes and for surfaces of triangles.
std::optional<Vector3d> halfSize(const Shape &shape) {
    if (const Box *box = std::get_if<Box>(&shape)) return box->size / 2;
    if (const Sphere *sphere = std::get_if<Sphere>(&shape))
        return Vector3d(sphere->radius, sphere->radius, sphere->radius);
    if (const Cylinder *cylinder = std::get_if<Cylinder>(&shape))
        return Vector3d(cylinder->radius, cylinder->radius, cylinder->length / 2);
    if (const Capsule *capsule = std::get_if<Capsule>(&shape))
        return Vector3d(capsule->radius, capsule->radius, capsule->length / 2 + capsule->radius);
    return std::nullopt;
}

struct Obstacle {
    Collision collision;  // its pose is the one in the world
    Rectangle extent;
};

Rectangle extent(const Vector3d &half, const Pose3d &pose) {
    const ignition::math::Matrix3d turn(pose.Rot());
    const auto reach = [&](int row) {
        return std::fabs(turn(row, 0)) * half.X() + std::fabs(turn(row, 1)) * half.Y() +
               std::fabs(turn(row, 2)) * half.Z();
    };
    const Vector3d sides(reach(0), reach(1), 0), center(pose.Pos().X(), pose.Pos().Y(), 0);
    return {center - sides, center + sides};
}

std::vector<Obstacle> boundedStaticShapes(const WorldDescription &world) {
    std::vector<Obstacle> found;
    for (const Link &link : world.links) {
        if (!link.isStatic) continue;
        for (const Collision &collision : link.collisions) {
            const std::optional<Vector3d> half = halfSize(collision.shape);
            if (!half) continue;
            Obstacle obstacle{collision, extent(*half, link.pose * collision.pose)};
            obstacle.collision.name = link.name + "::" + collision.name;
            obstacle.collision.pose = link.pose * collision.pose;
            found.push_back(std::move(obstacle));
        }
    }
    return found;
}

bool isOuterWall(const Rectangle &shape, const Rectangle &area) {
    const bool alongY = shape.depth() > area.depth() / 2 && (shape.least.X() - area.least.X() < touching ||
                                                             area.most.X() - shape.most.X() < touching);
    const bool alongX = shape.width() > area.width() / 2 && (shape.least.Y() - area.least.Y() < touching ||
                                                             area.most.Y() - shape.most.Y() < touching);
    return alongX || alongY;
}

std::size_t countStaticShapes(const WorldDescription &world) {
    std::size_t count = 0;
    for (const Link &link : world.links)
        if (link.isStatic) count += link.collisions.size();
    return count;
}

Link copyAt(const Vector3d &shift, const std::vector<Obstacle> &obstacles, std::size_t count, int number) {
    Link copy;
    copy.name = "repeated::copy_" + std::to_string(number);
    copy.isStatic = true;
    copy.pose.Pos() = shift;
    for (std::size_t i = 0; i < count; ++i) copy.collisions.push_back(obstacles[i].collision);
    return copy;
}

}  // namespace

void repeatObstacles(WorldDescription &world, std::size_t staticShapes, const Place &place) {
    const auto fail = [&](const std::string &what) { throw LoadError(LoadError::Kind::Value, place, what); };
    const std::size_t own = countStaticShapes(world);
    if (staticShapes < own)
        fail("has " + std::to_string(own) + " static shapes and cannot have " + std::to_string(staticShapes));

    std::vector<Obstacle> obstacles = boundedStaticShapes(world);
    Rectangle area;
    for (const Obstacle &obstacle : obstacles) area.include(obstacle.extent);
    obstacles.erase(std::remove_if(obstacles.begin(), obstacles.end(),
                                   [&](const Obstacle &o) { return isOuterWall(o.extent, area); }),
                    obstacles.end());
    if (staticShapes > own && obstacles.empty()) fail("has no static obstacles that could be repeated");

    std::size_t missing = staticShapes - own;
    int number = 0;
    for (int ring = 1; missing > 0; ++ring)
        for (int row = -ring; row <= ring; ++row)
            for (int column = -ring; column <= ring && missing > 0; ++column) {
                if (std::max(std::abs(row), std::abs(column)) < ring) continue;
                const std::size_t count = std::min(missing, obstacles.size());
                const Vector3d shift(column * area.width(), row * area.depth(), 0);
                world.links.push_back(copyAt(shift, obstacles, count, ++number));
                missing -= count;
            }
}

}  // namespace worlds
