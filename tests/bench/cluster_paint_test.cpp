#include "render/cluster_paint.h"

#include <gtest/gtest.h>

using namespace render;

namespace {

// Two robots, a wall and a post.
class ClusterPaintTest : public testing::Test {
protected:
    ClusterPaintTest() {
        const record::Shape box = {"box", {1, 1, 1}, {}};
        header.geoms = {{box, 0}, {box, 1}, {box}, {box}};
        frame.geoms.resize(4);
        frame.memberships = {{7, 0, {7}}, {3, 0, {3}}, {}, {}};
    }

    enum Geom { kRobot, kOther, kWall, kPost };

    std::vector<std::string> fills(Geom geom, const std::string &algorithm) {
        header.algorithm = algorithm;
        std::vector<std::string> texts;
        for (const Colour &fill : ClusterPaint(header, frame).of(geom).fills) texts.push_back(fill.text());
        return texts;
    }

    std::string outline(Geom geom) { return ClusterPaint(header, frame).of(geom).outlines.at(0).text(); }

    record::Header header;
    record::Frame frame;
};

}  // namespace

TEST_F(ClusterPaintTest, ClustersHaveColoursOfTheirOwnByTheirFirstGeoms) {
    EXPECT_EQ(fills(kRobot, "original"), (std::vector<std::string>{clusterColour(0).text()}));
    EXPECT_EQ(fills(kOther, "original"), (std::vector<std::string>{clusterColour(1).text()}));
    EXPECT_NE(clusterColour(0).text(), clusterColour(1).text());
}

TEST_F(ClusterPaintTest, WhatMovesAndIsInNoClusterIsOutlined) {
    frame.memberships[kRobot].cluster = 0;
    EXPECT_EQ(fills(kRobot, "original"), (std::vector<std::string>{"#ffffff"}));
    EXPECT_GT(ClusterPaint(header, frame).of(kRobot).outlineWidth,
              ClusterPaint(header, frame).of(kOther).outlineWidth);
}

TEST_F(ClusterPaintTest, StaticsApartAreGrey) {
    frame.memberships[kWall].testedWith = {7, 3};
    const std::string grey = fills(kWall, "original").at(0);
    EXPECT_EQ(grey.substr(1, 2), grey.substr(3, 2));
    EXPECT_EQ(grey.substr(3, 2), grey.substr(5, 2));
    EXPECT_EQ(fills(kPost, "original").at(0), grey);
}

TEST_F(ClusterPaintTest, StaticClustersHaveColoursAndTheOutlineOfWhoIsTestedWithThem) {
    frame.memberships[kWall] = {0, 1, {3}};
    frame.memberships[kPost] = {0, 2, {}};
    EXPECT_EQ(fills(kWall, "static"), (std::vector<std::string>{staticClusterColour(0).text()}));
    EXPECT_EQ(fills(kPost, "static"), (std::vector<std::string>{staticClusterColour(1).text()}));
    EXPECT_EQ(outline(kWall), clusterColour(1).text());
    EXPECT_NE(outline(kPost), clusterColour(1).text());
    frame.memberships[kWall].testedWith = {3, 7};
    EXPECT_EQ(ClusterPaint(header, frame).of(kWall).outlines.size(), 2u);
}

TEST_F(ClusterPaintTest, WhatIsListedHasATintOfEachClusterThatListsIt) {
    frame.memberships[kWall].testedWith = {7, 3};
    frame.memberships[kPost].testedWith = {3};
    EXPECT_EQ(fills(kWall, "duplication").size(), 2u);
    EXPECT_EQ(fills(kPost, "decluster"), (std::vector<std::string>{fills(kWall, "decluster").at(1)}));
    frame.memberships[kPost].testedWith = {};
    EXPECT_EQ(fills(kPost, "decluster").size(), 1u);
    EXPECT_NE(fills(kPost, "decluster").at(0), fills(kWall, "decluster").at(1));
}

TEST(Colour, IsWrittenAsHexadecimal) {
    EXPECT_EQ((Colour{1, 0, 0.5}).text(), "#ff0080");
    EXPECT_EQ((Colour{2, -1, 0}).text(), "#ff0000");
    EXPECT_EQ(mixed({0, 0, 0}, {1, 1, 1}, 1).text(), "#ffffff");
    EXPECT_EQ(shaded({1, 1, 1}, 0).text(), "#000000");
}

TEST(Colour, NeighbouringStaticClustersDiffer) {
    for (int number = 0; number < 60; ++number)
        EXPECT_NE(staticClusterColour(number).text(), staticClusterColour(number + 1).text());
}
