#include "render/painter_order.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace render;

namespace {

OrientedBox box(const Vector &centre, const Vector &half) {
    return {centre, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, half};
}

using Order = std::vector<std::size_t>;

// The viewer is where y is small.
const Camera kFront(-90, 30);

}  // namespace

TEST(PainterOrder, WhatIsInFrontComesLast) {
    const OrientedBox near = box({0, -2, 0}, {1, 1, 1}), middle = box({0, 0, 0}, {1, 1, 1}),
                      far = box({0, 2, 0}, {1, 1, 1});
    EXPECT_EQ(painterOrder({near, far, middle}, kFront), (Order{1, 2, 0}));
    EXPECT_EQ(painterOrder({near, far, middle}, Camera(90, 30)), (Order{0, 2, 1}));
}

TEST(PainterOrder, ABoxOnAnotherComesAfterIt) {
    EXPECT_EQ(painterOrder({box({0, 0, 2}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})}, kFront), (Order{1, 0}));
}

// If the distance of its centre decided, the wall would be in front of the box.
TEST(PainterOrder, ALongWallIsBehindASmallBoxInFrontOfItsFarEnd) {
    const Camera camera(-45, 20);
    const OrientedBox wall = box({0, 0, 0}, {10, 0.1, 1}), small = box({-8, -1, 0}, {0.2, 0.2, 0.9});
    ASSERT_GT(camera.nearness(wall.centre), camera.nearness(small.centre));
    EXPECT_EQ(painterOrder({small, wall}, camera), (Order{1, 0}));
    EXPECT_EQ(painterOrder({wall, small}, camera), (Order{0, 1}));
}

TEST(PainterOrder, BoxesThatReachIntoOneAnotherGoByDistance) {
    EXPECT_EQ(painterOrder({box({0, -0.5, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})}, kFront), (Order{1, 0}));
}

// Three beams, each over the end of the next: whatever comes first, each is drawn once.
TEST(PainterOrder, ACycleLosesNobody) {
    const Camera above(-90, 89);
    const auto beam = [](double angle) {
        const Vector along = {std::cos(angle), std::sin(angle), 0},
                     across = {-std::sin(angle), std::cos(angle), 0};
        const Vector tilted = normalised(along + Vector{0, 0, 0.2});
        return OrientedBox{across, {tilted, across, cross(tilted, across)}, {3, 0.2, 0.05}};
    };
    Order order = painterOrder({beam(0), beam(2.0944), beam(4.1888)}, above);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (Order{0, 1, 2}));
}

TEST(PainterOrder, OfNothing) { EXPECT_TRUE(painterOrder({}, kFront).empty()); }
