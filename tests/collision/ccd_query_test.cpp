// The support function of convex geoms returns the first of the furthest points, as a plain loop finds it. libccd's queries answer the same with a
// limit, and end at it.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "collision/narrowphase/dxCcdQuery.h"
#include "threading/dxUpstreamScope.h"

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

struct Ball {
    ccd_vec3_t centre;
    mutable ccd_real_t radius;
    ccd_real_t growth;  // at each call of its support function
};

void supportBall(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *point) {
    const Ball &ball = *static_cast<const Ball *>(object);
    *point = *direction;
    ccdVec3Normalize(point);
    ccdVec3Scale(point, ball.radius);
    ccdVec3Add(point, &ball.centre);
    ball.radius += ball.growth;
}

// Any point inside would do. With the true centres libccd ends before it iterates.
void pointInBall(const void *object, ccd_vec3_t *point) {
    const Ball &ball = *static_cast<const Ball *>(object);
    *point = ball.centre;
    point->v[2] += ball.radius / 4;
}

class CcdQuery : public testing::Test {
protected:
    CcdQuery() {
        CCD_INIT(&search);
        search.support1 = search.support2 = supportBall;
        search.center1 = pointInBall;
        search.center2 = [](const void *object, ccd_vec3_t *centre) { *centre = static_cast<const Ball *>(object)->centre; };
        search.mpr_tolerance = 1e-6;
    }
    Ball fixed{{{0, 0, 0}}, 1, 0}, near{{{1.5, 0.25, 0}}, 1, 0}, far{{{2.5, 0, 0}}, 1, 0}, growing{{{0.5, 0.25, 0.125}}, 1, 1};
    ccd_t search;
};

TEST_F(CcdQuery, AnswersTheSameWithALimit) {
    const dxCcdQuery::Limit limit;
    EXPECT_EQ(dxCcdQuery::intersect(&fixed, &near, &search), 1);
    EXPECT_EQ(dxCcdQuery::intersect(&fixed, &far, &search), 0);
    ccd_real_t depth = 0, expectedDepth = 0;
    ccd_vec3_t direction, position, expectedDirection, expectedPosition;
    ASSERT_EQ(dxCcdQuery::penetration(&fixed, &near, &search, &depth, &direction, &position), 0);
    ASSERT_EQ(ccdMPRPenetration(&fixed, &near, &search, &expectedDepth, &expectedDirection, &expectedPosition), 0);
    EXPECT_EQ(depth, expectedDepth);
    EXPECT_TRUE(ccdVec3Eq(&direction, &expectedDirection));
    EXPECT_TRUE(ccdVec3Eq(&position, &expectedPosition));
}

// A shape that grows is never reached within the tolerance.
TEST_F(CcdQuery, EndsAtTheLimit) {
    ccd_real_t depth;
    ccd_vec3_t direction, position;
    {
        const dxCcdQuery::Limit limit;
        EXPECT_THROW(dxCcdQuery::penetration(&growing, &fixed, &search, &depth, &direction, &position), dxUpstreamInterrupted);
    }
    const ccd_real_t atLimit = growing.radius;
    growing.radius = 1;
    search.max_iterations = 3 * static_cast<unsigned long>(atLimit);
    dxCcdQuery::penetration(&growing, &fixed, &search, &depth, &direction, &position);
    EXPECT_GT(growing.radius, atLimit) << "without a limit the iteration goes on";
}

}  // namespace
