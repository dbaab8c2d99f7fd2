// What dCreateConvex asks of its arrays.
#include "scenes/polyhedron.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using scenes::Polyhedron;
using scenes::Vector3;

namespace {

// Each with its numbers of corners, edges and faces.
struct Solid {
    const char *name;
    Polyhedron polyhedron;
    std::size_t corners, edges, faces;
};

std::vector<Vector3> cornersOfBox() {
    std::vector<Vector3> corners;
    for (const dReal x : {-1, 1})
        for (const dReal y : {-2, 2})
            for (const dReal z : {-3, 3}) corners.push_back({x, y, z});
    return corners;
}

std::vector<Solid> solids() {
    return {{"octahedron", Polyhedron::octahedron({1, 2, 3}), 6, 12, 8},
            {"prism", Polyhedron::hexagonalPrism(2, 3), 12, 18, 8},
            {"cut cube", Polyhedron::cutCube(2), 12, 24, 14},
            {"hull of a box", Polyhedron::hullOf(cornersOfBox()), 8, 12, 6},
            {"hull of a cut cube", Polyhedron::hullOf(Polyhedron::cutCube(2).corners()), 12, 24, 14}};
}

std::vector<Polyhedron::Face> facesOf(const Polyhedron &solid) {
    std::vector<Polyhedron::Face> faces;
    const std::vector<unsigned> &numbers = solid.polygons();
    for (std::size_t i = 0; i < numbers.size(); i += numbers[i] + 1)
        faces.emplace_back(numbers.begin() + static_cast<long>(i) + 1,
                           numbers.begin() + static_cast<long>(i + 1 + numbers[i]));
    return faces;
}

// Returns the distance of a corner from the plane of a face: positive outside.
dReal distance(const Polyhedron &solid, std::size_t face, const Vector3 &corner) {
    const dReal *plane = &solid.planes()[4 * face];
    return plane[0] * corner.x + plane[1] * corner.y + plane[2] * corner.z - plane[3];
}

}  // namespace

TEST(Polyhedron, PlanesHoldTheirOwnCornersAndHaveAllOthersBehindThem) {
    for (const Solid &solid : solids()) {
        const auto faces = facesOf(solid.polyhedron);
        ASSERT_EQ(faces.size(), solid.faces) << solid.name;
        ASSERT_EQ(solid.polyhedron.planes().size(), 4 * faces.size()) << solid.name;
        ASSERT_EQ(solid.polyhedron.corners().size(), solid.corners) << solid.name;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            const std::set<unsigned> own(faces[face].begin(), faces[face].end());
            EXPECT_GT(solid.polyhedron.planes()[4 * face + 3], 0) << solid.name << ": origin outside";
            for (unsigned corner = 0; corner < solid.corners; ++corner) {
                const dReal off = distance(solid.polyhedron, face, solid.polyhedron.corners()[corner]);
                if (own.count(corner))
                    EXPECT_NEAR(off, 0, 1e-5) << solid.name;
                else
                    EXPECT_LT(off, -0.1) << solid.name;
            }
        }
    }
}

// So all faces have the same orientation, and none is missing.
TEST(Polyhedron, EveryEdgeIsWalkedOnceEachWay) {
    for (const Solid &solid : solids()) {
        std::set<std::pair<unsigned, unsigned>> edges;
        for (const Polyhedron::Face &face : facesOf(solid.polyhedron))
            for (std::size_t i = 0; i < face.size(); ++i)
                EXPECT_TRUE(edges.insert({face[i], face[(i + 1) % face.size()]}).second) << solid.name;
        EXPECT_EQ(edges.size(), 2 * solid.edges) << solid.name;
        for (const auto &[from, to] : edges) EXPECT_TRUE(edges.count({to, from})) << solid.name;
    }
}

TEST(Polyhedron, HaveTheSizesAskedFor) {
    EXPECT_NEAR(Polyhedron::octahedron({1, 2, 3}).meanRadius(), 2, 1e-6);
    EXPECT_NEAR(Polyhedron::hexagonalPrism(2, 3).meanRadius(), 2.5, 1e-6);
    EXPECT_NEAR(Polyhedron::cutCube(2).meanRadius(), std::sqrt(2.0), 1e-6);
}

TEST(Polyhedron, VolumesAreThoseOfTheSolids) {
    EXPECT_NEAR(Polyhedron::hullOf(cornersOfBox()).volume(), 48, 1e-4);
    EXPECT_NEAR(Polyhedron::octahedron({1, 2, 3}).volume(), 8, 1e-5);       // 4/3 of the product of its half axes
    EXPECT_NEAR(Polyhedron::cutCube(2).volume(), 8 * 5.0 / 6, 1e-5);        // a cube without eight corners of 1/48 each
}
