#include "render/picture.h"

#include "render/cluster_paint.h"
#include "render/render_options.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

using namespace render;

namespace {

// A ball on a floor, in a grid of five cells.
class PictureTest : public testing::Test {
protected:
    PictureTest() {
        header.world = "a & b";
        header.algorithm = "decluster";
        header.geoms = {{{"plane", {0, 0, 1, 0}, {}}}, {{"sphere", {1}, {}}, 0}};
        frame.number = 40;
        frame.clusters = 1;
        frame.grid = {5, 1, {0, 0, 0}};
        frame.cells = {{2, 2, 2, 7}, {2, 2, 3, 7}};
        frame.geoms = {{}, {{0, 0, 1}, {1, 0, 0, 0}}};
        frame.memberships = {{0, 0, {7}}, {7, 0, {7}}};
    }

    std::string draw() const { return drawFrame(header, frame, view); }

    record::Header header;
    record::Frame frame;
    View view;
};

int count(const std::string &text, const std::string &what) {
    int found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_F(PictureTest, IsXmlWithFloorColumnGridAndBall) {
    const std::string svg = draw();
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << svg;
    EXPECT_STREQ(document.RootElement()->Name(), "svg");
    EXPECT_EQ(count(svg, "<path"), 4) << "the two cells are one column\n" << svg;
}

TEST_F(PictureTest, CountsClustersInItsCaption) {
    EXPECT_NE(draw().find(">a &amp; b, decluster: 1 cluster<"), std::string::npos) << draw();
    frame.clusters = 2;
    frame.memberships[0].staticCluster = 1;
    EXPECT_NE(draw().find("2 clusters, 1 static cluster<"), std::string::npos) << draw();
}

TEST_F(PictureTest, WithoutAGridHasNone) {
    frame.grid = {};
    frame.cells = {};
    EXPECT_EQ(count(draw(), "<path"), 2);
}

TEST_F(PictureTest, StripesWhatSeveralClustersList) {
    header.geoms.push_back({{"box", {4, 0.1, 1}, {}}});
    frame.geoms.push_back({{0, 3, 0.5}, {1, 0, 0, 0}});
    frame.memberships.push_back({0, 0, {7, 9}});
    const std::string svg = draw();
    EXPECT_GE(count(svg, "<pattern"), 1);
    EXPECT_GE(count(svg, "fill=\"url(#p"), 1);
}

TEST_F(PictureTest, DashesTheOutlineOfWhatSeveralClustersAreTestedWith) {
    header.geoms.push_back({{"box", {4, 0.1, 1}, {}}});
    frame.geoms.push_back({{0, 3, 0.5}, {1, 0, 0, 0}});
    frame.memberships.push_back({0, 1, {7}});
    EXPECT_EQ(count(draw(), "stroke-dasharray"), 0);
    frame.memberships.back().testedWith.push_back(9);
    EXPECT_EQ(count(draw(), "stroke-dasharray"), 3) << "the three faces of the box";
}

TEST_F(PictureTest, RingsWhatIsTooSmallToBeSeen) {
    EXPECT_EQ(count(draw(), "<circle"), 0);
    header.geoms.push_back({{"box", {500, 500, 1}, {}}});
    frame.geoms.push_back({});
    frame.memberships.push_back({});
    EXPECT_EQ(count(draw(), "<circle"), 1);
}

TEST_F(PictureTest, ShowsOnlyWhatIsWithinTheRadiusOfWhatMoves) {
    header.geoms.push_back({{"box", {1, 1, 1}, {}}});
    frame.geoms.push_back({{100, 0, 0}, {1, 0, 0, 0}});
    frame.memberships.push_back({});
    const int everything = count(draw(), "<path");
    view.radius = 5;
    EXPECT_EQ(count(draw(), "<path"), everything - 3) << "the three faces of the box";
}

TEST_F(PictureTest, OfAnEmptyWorldIsDrawnToo) {
    header.geoms.clear();
    frame.geoms.clear();
    frame.memberships.clear();
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(draw().c_str()), tinyxml2::XML_SUCCESS);
}

TEST_F(PictureTest, FramesAreChosenByNumberAndOthersNamed) {
    record::Recording recording{header, {frame, frame}};
    recording.frames[1].number = 80;
    EXPECT_EQ(chooseFrame(recording, "40").number, 40);
    EXPECT_EQ(chooseFrame(recording, "last").number, 80);
    try {
        chooseFrame(recording, "41");
        FAIL() << "took a frame that is not there";
    } catch (const std::invalid_argument &error) {
        EXPECT_NE(std::string(error.what()).find("'41'"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("40, 80, last"), std::string::npos);
    }
    recording.frames.clear();
    EXPECT_THROW(chooseFrame(recording, "last"), std::invalid_argument);
}
