// dxClusters and dxClusterHistory: names stay with clusters; merges and splits are reported.
#include <gtest/gtest.h>

#include <vector>

#include "clusters/dxClusters.h"

namespace {

using Slot = dxClusters::Slot;
using Change = dxClusterChange;
using Sets = std::vector<std::vector<Slot>>;

class ClusterHistory : public testing::Test {
protected:
    // A frame with these dynamic clusters; their names in the same order.
    std::vector<unsigned> follow(const Sets &dynamics, const Sets &statics = {}) {
        std::swap(before, now);
        now.clear(kSlots);
        for (const auto &members : dynamics) add(true, members);
        for (const auto &members : statics) add(false, members);
        history.follow(before, now);
        std::vector<unsigned> names;
        for (int cluster = 0; cluster < now.dynamicCount(); ++cluster) names.push_back(now[cluster].name);
        return names;
    }

    void expectOneChange(Change::Kind kind, unsigned from, unsigned into) {
        ASSERT_EQ(history.changes().size(), 1u);
        EXPECT_EQ(history.changes()[0].kind, kind);
        EXPECT_EQ(history.changes()[0].from, from);
        EXPECT_EQ(history.changes()[0].into, into);
    }

    static constexpr std::size_t kSlots = 100;
    dxClusters before, now;
    dxClusterHistory history;

private:
    void add(bool isDynamic, const std::vector<Slot> &members) {
        const int cluster = now.addCluster(isDynamic);
        for (const Slot slot : members) now.addMember(cluster, slot);
    }
};

TEST_F(ClusterHistory, NamesStayWhateverTheNumber) {
    const auto names = follow({{0, 1}, {2}, {3, 4}});
    EXPECT_NE(names[0], names[1]);
    EXPECT_NE(names[1], names[2]);
    EXPECT_EQ(follow({{3, 4}, {0, 1}, {2}}), (std::vector<unsigned>{names[2], names[0], names[1]}));
    EXPECT_TRUE(history.changes().empty());
}

TEST_F(ClusterHistory, AMergedClusterHasTheNameOfTheLargerPart) {
    const auto names = follow({{0}, {1, 2, 3}});
    const auto merged = follow({{0, 1, 2, 3}});
    EXPECT_EQ(merged[0], names[1]);
    expectOneChange(Change::Kind::merge, names[0], names[1]);
    EXPECT_EQ(history.merges(), 1u);
}

TEST_F(ClusterHistory, TheLargerPartOfASplitClusterKeepsTheName) {
    const auto names = follow({{0, 1, 2}});
    const auto split = follow({{2}, {0, 1}});
    EXPECT_EQ(split[1], names[0]);
    EXPECT_NE(split[0], names[0]);
    expectOneChange(Change::Kind::split, names[0], split[0]);
    EXPECT_EQ(history.splits(), 1u);
}

TEST_F(ClusterHistory, AMemberThatChangesSidesIsASplitOffItsOldCluster) {
    const auto names = follow({{0, 1, 2}, {3, 4}});
    EXPECT_EQ(follow({{0, 1}, {2, 3, 4}}), names);
    expectOneChange(Change::Kind::split, names[0], names[1]);
}

TEST_F(ClusterHistory, NamesAreNotGivenAgain) {
    const auto names = follow({{0}, {1}});
    follow({{0}});
    const auto later = follow({{0}, {1}});
    EXPECT_EQ(later[0], names[0]);
    EXPECT_GT(later[1], names[1]);
    EXPECT_TRUE(history.changes().empty()) << "no member of the new cluster was in another";
}

TEST_F(ClusterHistory, NewMembersDoNotChangeTheName) {
    const auto names = follow({{7}});
    EXPECT_EQ(follow({{5, 6, 7, 8, 9}}), names);
    EXPECT_TRUE(history.changes().empty());
}

TEST_F(ClusterHistory, ThreeBecomeOneAndOneBecomesThree) {
    const auto names = follow({{0}, {1}, {2}});
    const auto one = follow({{0, 1, 2}});
    EXPECT_EQ(one[0], names[0]) << "on equal parts the first";
    EXPECT_EQ(history.merges(), 2u);
    const auto three = follow({{0}, {1}, {2}});
    EXPECT_EQ(three[0], names[0]);
    EXPECT_EQ(history.splits(), 2u);
    EXPECT_EQ(history.changes().size(), 2u) << "changes are of the last time";
}

// A geom that got a body was in a static cluster before: that cluster is no part of the story.
TEST_F(ClusterHistory, StaticClustersHaveNoNamesAndNoChanges) {
    follow({{0}}, {{5, 6}});
    follow({{0}, {5}}, {{6}});
    EXPECT_TRUE(history.changes().empty());
    follow({}, {{0, 5}, {6}});
    EXPECT_TRUE(history.changes().empty());
    for (int cluster = 0; cluster < now.count(); ++cluster) EXPECT_EQ(now[cluster].name, 0u);
}

}  // namespace
