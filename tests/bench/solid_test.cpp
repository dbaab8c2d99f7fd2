#include "render/solid.h"

#include "render/area.h"
#include "render/convex_hull.h"

#include <gtest/gtest.h>

using namespace render;

namespace {

const Camera kFront(-90, 0.001);  // x to the right, z up

Area areaOfAll(const std::vector<Patch> &patches) {
    std::vector<Point> all;
    for (const Patch &patch : patches) all.insert(all.end(), patch.corners.begin(), patch.corners.end());
    return areaOf(all);
}

void expectArea(const std::vector<Patch> &patches, double width, double height) {
    const Area area = areaOfAll(patches);
    EXPECT_NEAR(area.right - area.left, width, 0.05);
    EXPECT_NEAR(area.bottom - area.top, height, 0.05);
}

record::Pose at(const Vector &position) { return {position, {1, 0, 0, 0}}; }

}  // namespace

TEST(Solid, HasTheSizeOfItsShape) {
    expectArea(patchesOf({"box", {2, 1, 3}, {}}, {}, kFront), 2, 3);
    expectArea(patchesOf({"bounds", {2, 1, 3}, {}}, {}, kFront), 2, 3);
    expectArea(patchesOf({"sphere", {2}, {}}, {}, kFront), 4, 4);
    expectArea(patchesOf({"capsule", {1, 3}, {}}, {}, kFront), 2, 5);
    expectArea(patchesOf({"cylinder", {1, 3}, {}}, {}, kFront), 2, 3);
    expectArea(patchesOf({"mesh", {-1, -1, 0, 2, 1, 1}, {}}, {}, kFront), 3, 1);
}

TEST(Solid, IsWhereItsPoseIs) {
    const Area area = areaOfAll(patchesOf({"box", {2, 2, 2}, {}}, at({5, 0, 7}), kFront));
    EXPECT_NEAR((area.left + area.right) / 2, 5, 0.01);
    EXPECT_NEAR((area.top + area.bottom) / 2, -7, 0.01) << "down is positive";
}

TEST(Solid, IsTurnedByItsPose) {
    const double half = std::sqrt(0.5);  // a quarter turn around y: z becomes x
    expectArea(patchesOf({"cylinder", {1, 6}, {}}, {{0, 0, 0}, {half, 0, half, 0}}, kFront), 6, 2);
}

TEST(Solid, OfAMeshOnlyTrianglesThatFaceTheViewerAreSeen) {
    const record::Triangle front = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                           back = {{{0, 1, 0}, {0, 1, 1}, {1, 1, 0}}};
    EXPECT_EQ(patchesOf({"mesh", {0, 0, 0, 1, 1, 1}, {front, back}}, {}, kFront).size(), 1u);
    EXPECT_EQ(patchesOf({"mesh", {0, 0, 0, 1, 1, 1}, {front, back}}, {}, Camera(90, 0.001)).size(), 1u);
}

TEST(Solid, TheBoxAroundHoldsTheShape) {
    for (const record::Shape &shape :
         {record::Shape{"box", {2, 1, 3}, {}}, record::Shape{"sphere", {2}, {}},
          record::Shape{"capsule", {1, 3}, {}}, record::Shape{"cylinder", {1, 3}, {}},
          record::Shape{"mesh", {-1, -1, 0, 2, 1, 1}, {}}}) {
        const record::Pose pose = {{1, 2, 3}, {0.5, 0.5, 0.5, 0.5}};
        std::vector<Point> corners;
        for (const Vector &corner : boxAround(shape, pose).corners())
            corners.push_back(Camera(20, 30).project(corner));
        const Area around = areaOf(corners), seen = areaOfAll(patchesOf(shape, pose, Camera(20, 30)));
        EXPECT_LE(around.left, seen.left + 1e-9) << shape.kind;
        EXPECT_GE(around.right, seen.right - 1e-9) << shape.kind;
        EXPECT_LE(around.top, seen.top + 1e-9) << shape.kind;
        EXPECT_GE(around.bottom, seen.bottom - 1e-9) << shape.kind;
    }
}

TEST(ConvexHull, LeavesInnerPointsOut) {
    EXPECT_EQ(convexHull({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}}).size(), 4u);
    EXPECT_EQ(convexHull({{0, 0}, {1, 1}}).size(), 2u);
    EXPECT_TRUE(convexHull({}).empty());
}
