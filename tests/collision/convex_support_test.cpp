// The furthest point of a convex geom: the first of those that lie furthest, as a plain loop finds it.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "collision/narrowphase/dxConvexSupport.h"

namespace {

class ConvexSupport : public testing::Test {
protected:
    void SetUp() override { dInitODE2(0); }
    void TearDown() override {
        if (m_geom != nullptr) dGeomDestroy(m_geom);
        dCloseODE();
    }

    // The points are read, not copied.
    dxCcdConvex convexOf(const std::vector<dReal> &points) {
        if (m_geom != nullptr) dGeomDestroy(m_geom);
        m_geom = dCreateConvex(nullptr, &m_plane, 0, points.data(), static_cast<unsigned>(points.size() / 3), &m_noPolygon);
        dxCcdConvex convex{};
        convex.convex = static_cast<const dxConvex *>(m_geom);
        ccdVec3Set(&convex.position, 1, 2, 3);
        ccdQuatSet(&convex.rotation, 0, 0, std::sqrt(0.5), std::sqrt(0.5));
        ccdQuatInvert2(&convex.inverseRotation, &convex.rotation);
        return convex;
    }

    static ccd_vec3_t placed(const dxCcdConvex &convex, ccd_vec3_t local) {
        ccdQuatRotVec(&local, &convex.rotation);
        ccdVec3Add(&local, &convex.position);
        return local;
    }

    dReal m_plane = 0;
    unsigned m_noPolygon = 0;
    dGeomID m_geom = nullptr;
};

// Coordinates are small whole numbers, so that many points lie equally far.
TEST_F(ConvexSupport, IsTheFirstOfTheFurthestPoints) {
    std::mt19937 random(3);
    const auto number = [&] { return dReal(static_cast<int>(random() % 5) - 2); };
    unsigned ties = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<dReal> points(3 * (1 + random() % 20));
        for (dReal &coordinate : points) coordinate = number();
        const dxCcdConvex convex = convexOf(points);
        ccd_vec3_t direction, local;
        ccdVec3Set(&direction, number(), number(), number());
        local = direction;
        ccdQuatRotVec(&local, &convex.inverseRotation);

        ccd_vec3_t expected{}, support{};
        ccd_real_t most = -CCD_REAL_MAX;
        for (std::size_t i = 0; i < points.size(); i += 3) {
            ccd_vec3_t point;
            ccdVec3Set(&point, points[i], points[i + 1], points[i + 2]);
            const ccd_real_t distance = ccdVec3Dot(&local, &point);
            ties += distance == most;
            if (distance > most) {
                expected = point;
                most = distance;
            }
        }
        expected = placed(convex, expected);
        dxSupportConvex(convex, direction, support);
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(support.v[axis], expected.v[axis]) << round;
    }
    EXPECT_GT(ties, 500u);
}

TEST_F(ConvexSupport, StaysWhereNoPointHasADistance) {
    const std::vector<dReal> points = {1, 2, 3, 4, 5, 6};
    const dxCcdConvex convex = convexOf(points);
    ccd_vec3_t direction, support;
    ccdVec3Set(&direction, std::numeric_limits<ccd_real_t>::quiet_NaN(), 0, 0);
    ccdVec3Set(&support, 7, 8, 9);
    const ccd_vec3_t expected = placed(convex, support);
    dxSupportConvex(convex, direction, support);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(support.v[axis], expected.v[axis]);
}

}  // namespace
