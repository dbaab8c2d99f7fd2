#include "record/recording.h"

#include "record/recording_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace record;

namespace {

Header header() {
    Header header;
    header.world = "two \"boxes\"";
    header.algorithm = "decluster";
    header.library = "/lib/libode.so.8";
    header.stepSize = 0.008;
    header.bodyNames = {"one \"box\""};
    header.geoms = {{{"box", {1, 2, 3}, {}}, 0},
                    {{"mesh", {0, 0, 0, 1, 1, 1}, {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}}}}}};
    return header;
}

Frame frame() {
    Frame frame;
    frame.number = 70;
    frame.time = 0.56;
    frame.clusters = 2;
    frame.grid = {5, 0.25, {1, -2, 3}};
    frame.cells = {{1, 2, 3, 9}};
    frame.events = {{true, 4, 9}, {false, 9, 4}};
    frame.bodies = {{{1, 2, 3}, {0.5, 0.5, 0.5, 0.5}}};
    frame.bodyClusters = {9};
    frame.geoms = {{{4, 5, 6}, {0, 1, 0, 0}}, {}};
    frame.memberships = {{9, 0, {9}}, {0, 3, {4, 9}}};
    return frame;
}

Recording read(const std::string &text) {
    std::istringstream lines(text);
    return readRecording(lines);
}

std::string complaint(const std::string &text) {
    try {
        read(text);
    } catch (const std::runtime_error &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Recording, DifferentWorldsAreTold) {
    const auto why = [](void (*change)(Header &)) {
        Header other = header();
        change(other);
        return whyOtherWorld(header(), other);
    };
    EXPECT_EQ(why([](Header &same) { same.library = same.algorithm = "another"; }), "");
    EXPECT_EQ(why([](Header &same) { same.world = "folder/" + same.world; }), "") << "the same file";
    for (const auto &[change, word] : std::vector<std::pair<void (*)(Header &), std::string>>{
             {[](Header &other) { other.world = "pile"; }, "'pile'"},
             {[](Header &other) { other.geoms.pop_back(); }, "2 geoms in the first, 1 in the second"},
             {[](Header &other) { other.geoms[1].shape.size[3] = 2; }, "geom 1"},
             {[](Header &other) { other.geoms[1].shape.triangles[0][0][0] = 2; }, "geom 1"},
             {[](Header &other) { other.geoms[0].shape.kind = "sphere"; }, "geom 0"},
             {[](Header &other) { other.geoms[0].body = 1; }, "geom 0"},
             {[](Header &other) { other.bodyNames[0] = "another"; }, "names"},
             {[](Header &other) { other.stepSize = 0.016; }, "8.00 ms in the first, of 16.0 ms in the second"}})
        EXPECT_NE(why(change).find(word), std::string::npos) << why(change);
}

TEST(Recording, TheHeaderIsReadAsItWasWritten) {
    const Header got = read(writeHeader(header())).header;
    EXPECT_EQ(got.world, "two \"boxes\"");
    EXPECT_EQ(got.algorithm, "decluster");
    EXPECT_EQ(got.library, "/lib/libode.so.8");
    EXPECT_EQ(got.stepSize, 0.008);
    EXPECT_EQ(got.bodyNames, header().bodyNames);
    ASSERT_EQ(got.geoms.size(), 2u);
    EXPECT_EQ(got.geoms[0].shape.kind, "box");
    EXPECT_EQ(got.geoms[0].shape.size, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(got.geoms[0].body, 0);
    EXPECT_EQ(got.geoms[1].body, Geom::kStatic);
    ASSERT_EQ(got.geoms[1].shape.triangles.size(), 1u);
    EXPECT_EQ(got.geoms[1].shape.triangles[0][2], (Vector{0, 1, 1}));
}

TEST(Recording, AFrameIsReadAsItWasWritten) {
    const Recording recording = read(writeHeader(header()) + "\n" + writeFrame(frame()) + "\n");
    ASSERT_EQ(recording.frames.size(), 1u);
    const Frame &got = recording.frames[0];
    EXPECT_EQ(got.number, 70);
    EXPECT_EQ(got.time, 0.56);
    EXPECT_EQ(got.clusters, 2);
    EXPECT_EQ(got.grid.cells, 5);
    EXPECT_EQ(got.grid.edge, 0.25);
    EXPECT_EQ(got.grid.centre, (Vector{1, -2, 3}));
    ASSERT_EQ(got.cells.size(), 1u);
    EXPECT_EQ(got.cells[0].z, 3);
    EXPECT_EQ(got.cells[0].cluster, 9u);
    ASSERT_EQ(got.events.size(), 2u);
    EXPECT_TRUE(got.events[0].isSplit);
    EXPECT_FALSE(got.events[1].isSplit);
    EXPECT_EQ(got.events[1].from, 9u);
    EXPECT_EQ(got.events[1].into, 4u);
    EXPECT_EQ(got.bodies[0].position, (Vector{1, 2, 3}));
    EXPECT_EQ(got.bodies[0].quaternion[3], 0.5);
    EXPECT_EQ(got.bodyClusters, (std::vector<unsigned>{9}));
    EXPECT_EQ(got.geoms[0].quaternion[1], 1);
    EXPECT_EQ(got.memberships[0].cluster, 9u);
    EXPECT_EQ(got.memberships[1].staticCluster, 3u);
    EXPECT_EQ(got.memberships[1].testedWith, (std::vector<unsigned>{4, 9}));
}

TEST(Recording, WhatBodiesDoIsReadAsItWasWritten) {
    Frame sent = frame();
    sent.velocities = {{{1.0 / 3, -2, 3}, {0, -0.0, 1e-300}}};
    sent.awake = {false};
    sent.islands = {-1};
    sent.workers = {3};
    sent.contacts = {{1, Contact::kUnknown, {1, 2, 3}, {0, 0, 1}, 0.123456789, {4, 5, 1e-7}}};
    const Recording recording = read(writeHeader(header()) + "\n" + writeFrame(sent));
    const Frame &got = recording.frames.at(0);
    ASSERT_EQ(got.velocities.size(), 1u);
    EXPECT_EQ(got.velocities[0].linear, sent.velocities[0].linear);
    EXPECT_TRUE(std::signbit(got.velocities[0].angular[1]));
    EXPECT_EQ(got.velocities[0].angular[2], 1e-300);
    EXPECT_EQ(got.awake, sent.awake);
    EXPECT_EQ(got.islands, sent.islands);
    EXPECT_EQ(got.workers, sent.workers);
    ASSERT_TRUE(got.contacts && got.contacts->size() == 1);
    EXPECT_EQ(got.contacts->at(0).geom1, 1);
    EXPECT_EQ(got.contacts->at(0).geom2, Contact::kUnknown);
    EXPECT_EQ(got.contacts->at(0).normal, (Vector{0, 0, 1}));
    EXPECT_EQ(got.contacts->at(0).force, (Vector{4, 5, 1e-7}));
    EXPECT_EQ(got.contacts->at(0).depth, 0.123457);
}

TEST(Recording, EarlierVersionsRecordedLess) {
    const Recording recording = read(writeHeader(header()) + "\n" + writeFrame(frame()));
    EXPECT_TRUE(recording.frames.at(0).velocities.empty() && recording.frames[0].awake.empty() && recording.frames[0].islands.empty());
    EXPECT_FALSE(recording.frames[0].contacts);
}

TEST(Recording, WhatBodiesDoMustFitThem) {
    const auto said = [](const std::function<void(Frame &)> &change) {
        Frame wrong = frame();
        change(wrong);
        return complaint(writeHeader(header()) + "\n" + writeFrame(wrong));
    };
    EXPECT_NE(said([](Frame &f) { f.velocities.resize(2); }).find("velocity for each"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.velocities = {{{1e17, 0, 0}, {}}}; }).find("velocity of a body"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.awake.resize(3); }).find("state of sleep"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.islands = {0, 0}; }).find("island"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.islands = {-2}; }).find("island is -2"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.workers = {0, 0}; }).find("worker"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.workers = {-2}; }).find("worker is -2"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.contacts = {{2, 0, {}, {}, 0, {}}}; }).find("no geom 2"), std::string::npos);
    EXPECT_NE(said([](Frame &f) { f.contacts = {{0, 1, {}, {}, 1e17, {}}}; }).find("a contact"), std::string::npos);
}

TEST(Recording, HeaderAndFrameAreOneLineEach) {
    Header odd = header();
    odd.world = "two\nlines";
    EXPECT_EQ(writeHeader(odd).find('\n'), std::string::npos);
    EXPECT_EQ(writeFrame(frame()).find('\n'), std::string::npos);
}

TEST(Recording, ALineThatIsNotUnderstoodIsNamedByItsNumber) {
    const std::string first = writeHeader(header()) + "\n";
    EXPECT_NE(complaint("").find("line 1"), std::string::npos);
    EXPECT_NE(complaint("world,engine\n").find("line 1"), std::string::npos);
    EXPECT_NE(complaint(writeFrame(frame())).find("line 1"), std::string::npos) << "a frame without a header";
    EXPECT_NE(complaint(first + writeFrame(frame()) + "\n{\"frame\":{}}\n").find("line 3"),
              std::string::npos);
}

TEST(Recording, AFrameMustHaveAllGeoms) {
    Frame shorter = frame();
    shorter.geoms.pop_back();
    const std::string said = complaint(writeHeader(header()) + "\n" + writeFrame(shorter));
    EXPECT_NE(said.find("line 2"), std::string::npos) << said;
    EXPECT_NE(said.find("2 geoms"), std::string::npos) << said;
}

TEST(Recording, ASizeWithoutItsNumbersIsNamed) {
    for (const char *kind : {"box", "sphere", "capsule", "cylinder", "plane", "mesh", "bounds"}) {
        Header wrong = header();
        wrong.geoms[1].shape = {kind, {}, {}};
        EXPECT_NE(complaint(writeHeader(wrong)).find("geom 1: the size of a " + std::string(kind)),
                  std::string::npos);
    }
    Header unknown = header();
    unknown.geoms[1].shape.kind = "cone";
    EXPECT_NE(complaint(writeHeader(unknown)).find("unknown shape 'cone'"), std::string::npos);
}

TEST(Recording, NumbersThatCannotBeDrawnAreRefused) {
    Header huge = header();
    huge.geoms[0].shape.size[1] = 1e308;
    EXPECT_NE(complaint(writeHeader(huge)).find("geom 0 holds a number"), std::string::npos);
    huge = header();
    huge.geoms[1].shape.triangles[0][2][1] = -1e17;
    EXPECT_NE(complaint(writeHeader(huge)).find("geom 1 holds a number"), std::string::npos);
    for (int which = 0; which < 4; ++which) {
        Frame wrong = frame();
        (which == 0   ? wrong.grid.edge
         : which == 1 ? wrong.grid.centre[2]
         : which == 2 ? wrong.bodies[0].position[0]
                      : wrong.geoms[1].quaternion[3]) = 1e17;
        EXPECT_NE(complaint(writeHeader(header()) + "\n" + writeFrame(wrong)).find("a number that is not"), std::string::npos)
            << which;
    }
}

TEST(Recording, AGridWithoutBoundsIsRefused) {
    for (const int cells : {-1, 1001, 2147483647}) {
        Frame wrong = frame();
        wrong.grid.cells = cells;
        EXPECT_NE(complaint(writeHeader(header()) + "\n" + writeFrame(wrong))
                      .find(std::to_string(cells) + " cells"),
                  std::string::npos);
    }
}

// Each text of the pair is once in a valid recording.
TEST(Recording, WhatIsNestedDeeplyIsNamedByItsType) {
    constexpr std::size_t kDepth = 200'000;  // more than the stack holds, if each level is one call
    std::string text = writeHeader(header());
    const std::string body = "\"body\":0";
    text.replace(text.find(body), body.size(), "\"body\":" + std::string(kDepth, '[') + std::string(kDepth, ']'));
    EXPECT_EQ(complaint(text), "line 1: an array where a whole number is expected");
}

TEST(Recording, WhatIsNotWholeOrNotThereIsRefused) {
    const std::string right = writeHeader(header()) + "\n" + writeFrame(frame()) + "\n";
    EXPECT_EQ(complaint(right), "");
    EXPECT_EQ(complaint(right + "\n"), "") << "an empty line at the end";
    const struct {
        const char *from, *to, *said;
    } wrong[] = {{"\"body\":0", "\"body\":0.5", "line 1: 0.5 where a whole number"},
                 {"\"body\":0", "\"body\":2147483648", "line 1: 2147483648 where a whole number"},
                 {"\"body\":0", "\"body\":-2", "line 2: it has no body -2"},
                 {"\"body\":0", "\"body\":1", "line 2: it has no body 1"},
                 {"\"body\":0", "\"BODY\":0", "line 1: a member or an element is missing"},
                 {"\"size\":[1.0,", "\"size\":[-1.0,", "line 1: geom 0: a size below 0"},
                 {"\"clusters\":2", "\"clusters\":-1.5", "line 2: -1.5 where a whole number"},
                 {"\"cells\":[[1,2,3,9]]", "\"cells\":[[1,2,5,9]]", "line 2: a cell is not in its grid: 5"},
                 {"\"cells\":[[1,2,3,9]]", "\"cells\":[[1,2,3,-9]]", "line 2: -9 where a whole number"},
                 {"\"bodyClusters\":[9]", "\"bodyClusters\":[]", "line 2: it has not one cluster for each"},
                 {"\"testedWith\":[9]", "\"testedWith\":[1e300]", "line 2: 1e+300 where a whole number"},
                 {"\"time\":0.56", "\"time\":\"now\"", "line 2: a value of another type"},
                 {"\"time\":0.56", "\"time\":0.56,", "line 2: not JSON"}};
    for (const auto &[from, to, said] : wrong) {
        std::string text = right;
        const std::size_t place = text.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        text.replace(place, std::strlen(from), to);
        EXPECT_NE(complaint(text).find(said), std::string::npos) << to << ": " << complaint(text);
    }
}
