#include "loader/description/repeat_obstacles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace worlds {

namespace {

constexpr double touching = 1e-3;  // m, from the border

struct Rectangle {  // along x and y
    Vector3 least{HUGE_VAL, HUGE_VAL, 0}, most{-HUGE_VAL, -HUGE_VAL, 0};

    double width() const { return most.x - least.x; }
    double depth() const { return most.y - least.y; }

    void include(const Rectangle &other) {
        least = minOf(least, other.least);
        most = maxOf(most, other.most);
    }
};

// Half the sides of the box around a shape; none for infinite shapes and for surfaces of triangles.
std::optional<Vector3> halfSize(const Shape &shape) {
    if (const Box *box = std::get_if<Box>(&shape)) return box->size / 2;
    if (const Sphere *sphere = std::get_if<Sphere>(&shape))
        return Vector3{sphere->radius, sphere->radius, sphere->radius};
    if (const Cylinder *cylinder = std::get_if<Cylinder>(&shape))
        return Vector3{cylinder->radius, cylinder->radius, cylinder->length / 2};
    if (const Capsule *capsule = std::get_if<Capsule>(&shape))
        return Vector3{capsule->radius, capsule->radius, capsule->length / 2 + capsule->radius};
    return std::nullopt;
}

struct Obstacle {
    Collision collision;  // its pose is the one in the world
    Rectangle extent;
};

Rectangle extent(const Vector3 &half, const Pose &pose) {
    const Matrix3 turn = Matrix3::rotation(pose.rotation);
    const auto reach = [&](int row) {
        return std::fabs(turn(row, 0)) * half.x + std::fabs(turn(row, 1)) * half.y +
               std::fabs(turn(row, 2)) * half.z;
    };
    const Vector3 sides{reach(0), reach(1), 0}, center{pose.position.x, pose.position.y, 0};
    return {center - sides, center + sides};
}

std::vector<Obstacle> boundedStaticShapes(const WorldDescription &world) {
    std::vector<Obstacle> found;
    for (const Link &link : world.links) {
        if (!link.isStatic) continue;
        for (const Collision &collision : link.collisions) {
            const std::optional<Vector3> half = halfSize(collision.shape);
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
    const bool alongY = shape.depth() > area.depth() / 2 && (shape.least.x - area.least.x < touching ||
                                                             area.most.x - shape.most.x < touching);
    const bool alongX = shape.width() > area.width() / 2 && (shape.least.y - area.least.y < touching ||
                                                             area.most.y - shape.most.y < touching);
    return alongX || alongY;
}

std::size_t countStaticShapes(const WorldDescription &world) {
    std::size_t count = 0;
    for (const Link &link : world.links)
        if (link.isStatic) count += link.collisions.size();
    return count;
}

Link copyAt(const Vector3 &shift, const std::vector<Obstacle> &obstacles, std::size_t count, int number) {
    Link copy;
    copy.name = "repeated::copy_" + std::to_string(number);
    copy.isStatic = true;
    copy.pose.position = shift;
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
                const Vector3 shift{column * area.width(), row * area.depth(), 0};
                world.links.push_back(copyAt(shift, obstacles, count, ++number));
                missing -= count;
            }
}

}  // namespace worlds
