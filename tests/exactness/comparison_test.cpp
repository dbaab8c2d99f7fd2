// The suite must be able to fail: a difference of one bit, of one event or of one object is found and
// named.
#include "comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

using namespace exactness;

Value value(const std::string &object, const std::string &field, const Reading &reading) {
    return {"step", object, field, reading.words(), reading.text()};
}

Reading reals(std::initializer_list<double> values) {
    Reading reading;
    for (double value : values) reading.real(value);
    return reading;
}

Record runOf(const Reading &velocity) {
    Record record;
    record.stages = {{0, "start", 11}, {1, "collide", 12}, {1, "step", 13}};
    record.values = {value("body 0", "position", reals({1, 2, 3})),
                     value("body 0", "linear velocity", velocity)};
    return record;
}

TEST(Comparison, EqualRecordsDoNotDiffer) {
    const Record record = runOf(reals({0, 0, -9.81}));
    EXPECT_FALSE(firstDivergence(record, record));
    EXPECT_FALSE(firstDifference(1, record, record));
}

TEST(Comparison, FirstStageWithAnotherHashIsNamed) {
    const Record expected = runOf(reals({0}));
    Record actual = expected;
    actual.stages[1].hash ^= 1;
    actual.stages[2].hash ^= 1;
    const auto divergence = firstDivergence(expected, actual);
    ASSERT_TRUE(divergence);
    EXPECT_EQ(divergence->step, 1);
    EXPECT_EQ(divergence->stage, "collide");
}

TEST(Comparison, RunThatEndsEarlyDiffers) {
    const Record expected = runOf(reals({0}));
    Record actual = expected;
    actual.stages.pop_back();
    const auto divergence = firstDivergence(expected, actual);
    ASSERT_TRUE(divergence);
    EXPECT_EQ(divergence->stage, "step");
}

TEST(Comparison, OneBitIsFoundAndNamed) {
    const double last = std::nextafter(-9.81, 0.0);
    const auto difference = firstDifference(7, runOf(reals({0, 0, -9.81})), runOf(reals({0, 0, last})));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->step, 7);
    EXPECT_EQ(difference->stage, "step");
    EXPECT_EQ(difference->object, "body 0");
    EXPECT_EQ(difference->field, "linear velocity[2]");
    EXPECT_NE(difference->expected, difference->actual);
}

TEST(Comparison, SignOfZeroIsADifference) {
    EXPECT_TRUE(firstDifference(1, runOf(reals({0.0})), runOf(reals({-0.0}))));
}

TEST(Comparison, AllNaNsAreEqual) {
    double other = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t bits;
    std::memcpy(&bits, &other, sizeof(bits));
    bits ^= 0x8000000000000123;
    std::memcpy(&other, &bits, sizeof(bits));
    ASSERT_TRUE(std::isnan(other));
    EXPECT_FALSE(firstDifference(1, runOf(reals({std::nan("")})), runOf(reals({other}))));
}

TEST(Comparison, TextIsCompared) {
    Reading first, second;
    first.text("LCP internal error, s <= 0 (s=0)");
    second.text("LCP internal error, s <= 0 (s=1)");
    const auto difference = firstDifference(1, runOf(first), runOf(second));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->expected, "\"LCP internal error, s <= 0 (s=0)\"");
}

TEST(Comparison, MissingEventIsNamed) {
    const Record expected = runOf(reals({0}));
    Record actual = expected;
    actual.values.push_back(value("event 3", "near pair", reals({4, 5})));
    const auto difference = firstDifference(1, expected, actual);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->object, "event 3");
    EXPECT_EQ(difference->expected, "nothing");
}

TEST(Comparison, RecordsSurviveTheirFile) {
    const std::string path = testing::TempDir() + "/odemt_record.json";
    Record record = runOf(reals({std::nan(""), -0.0, 1e-320, INFINITY}));
    record.values.back().words.push_back({Word::Kind::Integer, static_cast<std::uint64_t>(-2)});
    record.write(path);
    const Record again = Record::read(path);
    EXPECT_FALSE(firstDivergence(record, again));
    EXPECT_FALSE(firstDifference(1, record, again));
    ASSERT_EQ(again.values.size(), record.values.size());
}

}  // namespace
