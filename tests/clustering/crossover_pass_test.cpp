// Random worlds under each pass: membership is that of ReferenceClusters, no overlapping pair is ever split, and
// the pairs that the search finds are those of brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"
#include "RandomClusterWorld.h"
#include "collision/spaces/dxOrderedSpace.h"

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;

template <class T>
bool contains(const std::vector<T> &values, T value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

std::vector<std::pair<Slot, Slot>> bruteForce(const dxMembers &members) {
    std::vector<std::pair<Slot, Slot>> pairs;
    for (Slot a = 0; a < members.end(); ++a)
        for (Slot b = a + 1; b < members.end(); ++b)
            if (members[a].geom != nullptr && members[b].geom != nullptr &&
                (members.isChanged(a) || members.isChanged(b)) && members[a].bounds.overlaps(members[b].bounds))
                pairs.emplace_back(a, b);
    return pairs;
}

// Stands in the space for the search that it checks.
class CheckedSearch final : public dxBroadphase {
public:
    explicit CheckedSearch(const char *pass) : clustered(dxMakeCrossoverPass(pass)) {}

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override {
        ++searches;
        const std::size_t before = matches.size();
        clustered.findOverlaps(members, runner, matches);
        std::vector<std::pair<Slot, Slot>> found;
        for (std::size_t i = before; i < matches.size(); ++i)
            found.emplace_back(std::minmax(matches[i].a, matches[i].b));
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, bruteForce(members)) << "in search " << searches;
        pairs += found.size();
    }

    dxClusteredWorldAndSpace clustered;
    int searches = 0;
    std::size_t pairs = 0;
};

struct Seen {
    std::size_t pairs = 0;
    unsigned merges = 0, splits = 0, grids = 0, big = 0, outside = 0, listed = 0, sharedTasks = 0;
};

class CrossoverRandom : public testing::TestWithParam<const char *> {
protected:
    std::string pass() const { return GetParam(); }
    void runSeed(unsigned seed);
    void compareInhabitants();
    void comparePair(std::size_t i, std::size_t k);
    void compareDynamicWithStatic(std::size_t i, std::size_t k);
    void compareNames();
    bool isSplit(std::size_t i, std::size_t k) const;
    int clusterOf(std::size_t i) const { return clustered().clusters().of(slots[i]); }
    const dxClusters::Cluster &cluster(std::size_t i) const { return clustered().clusters()[clusterOf(i)]; }
    const dxClusteredWorldAndSpace &clustered() const { return findOverlaps->clustered; }

    OdeSession session{0, "auto"};
    const CheckedSearch *findOverlaps = nullptr;
    std::unique_ptr<ReferenceClusters> reference;
    std::vector<ReferenceInhabitant> inhabitants;
    std::vector<Slot> slots;
    std::map<std::vector<int>, unsigned> names;  // of the last frame, by the ids of the members
    Seen seen;
};

void CrossoverRandom::compareInhabitants() {
    const dxClusterScene &scene = clustered().scene();
    const ReferenceGrid &grid = reference->grid();
    ASSERT_EQ(scene.grid().cells(), grid.cells());
    ASSERT_EQ(scene.grid().edge(), grid.edge());
    for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(scene.grid().centre()[axis], grid.centre(axis));
    for (std::size_t i = 0; i < inhabitants.size(); ++i) {
        ASSERT_EQ(scene[slots[i]].kind, inhabitants[i].isDynamic ? Kind::dynamicGeom : Kind::staticGeom);
        ASSERT_EQ(scene[slots[i]].big, reference->isBig(i));
        ASSERT_EQ(clusterOf(i) != dxClusters::kNone, reference->isClustered(i));
        seen.big += reference->isBig(i);
        seen.outside += scene.grid().isLeftBy(inhabitants[i].box);
    }
    for (std::size_t i = 0; i < inhabitants.size(); ++i)
        for (std::size_t k = 0; k < inhabitants.size(); ++k) {
            if (i != k) comparePair(i, k);
            if (HasFatalFailure()) return;
        }
}

void CrossoverRandom::comparePair(std::size_t i, std::size_t k) {
    const auto names = [&] { return "inhabitants " + std::to_string(i) + " and " + std::to_string(k); };
    if (reference->isClustered(i)) {
        ASSERT_EQ(clusterOf(i) == clusterOf(k), reference->together(i, k)) << names();
        if (inhabitants[i].isDynamic && !inhabitants[k].isDynamic) compareDynamicWithStatic(i, k);
        if (inhabitants[i].isDynamic && inhabitants[k].isDynamic && reference->isClustered(k)) {
            ASSERT_EQ(cluster(i).task == cluster(k).task, reference->oneTask(i, k)) << names();
            seen.sharedTasks += clusterOf(i) != clusterOf(k) && cluster(i).task == cluster(k).task;
        }
    }
    const bool overlap = inhabitants[i].box.overlaps(inhabitants[k].box);
    ASSERT_FALSE(overlap && isSplit(i, k)) << names();
}

void CrossoverRandom::compareDynamicWithStatic(std::size_t i, std::size_t k) {
    const bool duplicated = contains(cluster(i).duplicated, slots[k]);
    ASSERT_EQ(duplicated, reference->duplicates(i, k));
    const bool pseudoMerged = clusterOf(k) != dxClusters::kNone && contains(cluster(i).staticClusters, clusterOf(k));
    ASSERT_EQ(pseudoMerged, reference->pseudoMerges(i, k));
    seen.listed += duplicated || pseudoMerged;
}

// Two boxes overlap, one at least moves, and no cluster has both.
bool CrossoverRandom::isSplit(std::size_t i, std::size_t k) const {
    if (!inhabitants[i].isDynamic) std::swap(i, k);
    if (!inhabitants[i].isDynamic || reference->isBig(i)) return false;  // not clustered: tested with all
    if (inhabitants[k].isDynamic) return !reference->isBig(k) && clusterOf(i) != clusterOf(k);
    if (pass() == "original") return false;  // tested apart
    if (pass() == "duplication" || pass() == "decluster") return !contains(cluster(i).duplicated, slots[k]);
    return !reference->isBig(k) && !contains(cluster(i).staticClusters, clusterOf(k));
}

// A cluster that is what it was has the name that it had, and no two have the same.
void CrossoverRandom::compareNames() {
    std::map<int, std::vector<int>> members;
    for (std::size_t i = 0; i < inhabitants.size(); ++i)
        if (inhabitants[i].isDynamic && reference->isClustered(i)) members[clusterOf(i)].push_back(inhabitants[i].id);
    std::map<std::vector<int>, unsigned> now;
    std::set<unsigned> distinct;
    for (auto &[number, ids] : members) {
        std::sort(ids.begin(), ids.end());
        const unsigned name = clustered().clusters()[number].name;
        ASSERT_NE(name, 0u);
        ASSERT_TRUE(distinct.insert(name).second);
        const auto old = names.find(ids);
        ASSERT_TRUE(old == names.end() || name == old->second);
        now[ids] = name;
    }
    names = now;
}

void CrossoverRandom::runSeed(unsigned seed) {
    RandomClusterWorld world(seed, seed % 2 == 0);
    reference = std::make_unique<ReferenceClusters>(pass());
    names.clear();
    auto owned = std::make_unique<CheckedSearch>(GetParam());
    findOverlaps = owned.get();
    unsigned splits = 0;
    static_cast<dxOrderedSpace *>(world.space())->setBroadphase(std::move(owned));
    for (int frame = 1; frame <= 50; ++frame) {
        world.change();
        world.space()->collide(nullptr, [](void *, dGeomID, dGeomID) {});
        ASSERT_EQ(findOverlaps->searches, frame);
        inhabitants = world.inhabitants();
        slots.clear();
        for (const dGeomID geom : world.geoms()) slots.push_back(slotOf(geom));
        reference->frame(inhabitants);
        seen.grids += reference->gridIsNew();
        compareInhabitants();
        if (!HasFailure()) compareNames();
        ASSERT_TRUE(pass() == "decluster" || reference->gridIsNew() || clustered().history().splits() == splits)
            << "what has merged stays merged";
        splits = clustered().history().splits();
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", frame " << frame;
    }
    seen.pairs += findOverlaps->pairs;
    seen.merges += clustered().history().merges();
    seen.splits += clustered().history().splits();
}

TEST_P(CrossoverRandom, MembershipAndPairsAreThoseOfTheRules) {
    constexpr unsigned kSeeds = 120;
    for (unsigned seed = 1; seed <= kSeeds && !HasFatalFailure(); ++seed) runSeed(seed);
    EXPECT_GT(seen.pairs, 20000u);
    EXPECT_GT(seen.merges, 300u);
    EXPECT_GE(seen.splits, pass() == "decluster" ? 1000u : 0u);
    EXPECT_GT(seen.grids, kSeeds + 50) << "one each, and some placed again";
    EXPECT_GT(seen.big, 1000u);
    EXPECT_GT(seen.outside, 1000u);
    EXPECT_GE(seen.listed, pass() == "original" ? 0u : 10000u);
    EXPECT_GE(seen.sharedTasks, pass() == "static" ? 1000u : 0u);
}

INSTANTIATE_TEST_SUITE_P(Passes, CrossoverRandom, testing::ValuesIn(kPasses), nameOfPass);

}  // namespace
