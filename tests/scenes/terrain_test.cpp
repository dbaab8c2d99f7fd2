#include "scenes/terrain.h"

#include <gtest/gtest.h>

namespace {

using scenes::Terrain;

class EmptyScene final : public scenes::WorldScene {
public:
    EmptyScene() : WorldScene({}, REAL(0.01)) {}
};

// Returns where a vertical ray from above hits the geom.
dReal heightAt(dGeomID geom, dReal x, dReal y) {
    const dGeomID ray = dCreateRay(nullptr, 10);
    dGeomRaySet(ray, x, y, 5, 0, 0, -1);
    dContactGeom contact{};
    EXPECT_EQ(dCollide(ray, geom, 1, &contact, sizeof contact), 1) << x << ", " << y;
    dGeomDestroy(ray);
    return contact.pos[2];
}

}  // namespace

TEST(Terrain, IsAtLeastAsWideAsAskedFor) {
    EXPECT_EQ(Terrain(REAL(3.2)).width(), 4);
    EXPECT_EQ(Terrain(REAL(3.2), REAL(0.5)).width(), REAL(3.5));
}

TEST(Terrain, MeshAndHeightFieldAreAsHighAsTheFunction) {
    dInitODE2(0);
    {
        EmptyScene scene;
        for (const dReal pitch : {REAL(1.0), REAL(0.5)}) {
            const Terrain terrain(12, pitch);
            for (const dGeomID geom : {terrain.addMesh(scene), terrain.addHeightField(scene)})
                for (const dReal x : {REAL(2.0), REAL(5.0), REAL(7.0)})
                    for (const dReal y : {REAL(3.0), REAL(8.0)}) {
                        // Beside the sample: a ray through a corner of triangles may slip between them.
                        const dReal beside = REAL(1e-3);
                        EXPECT_NEAR(heightAt(geom, x + beside, y + beside / 2), Terrain::height(x, y), 1e-2);
                    }
        }
    }
    dCloseODE();
}
