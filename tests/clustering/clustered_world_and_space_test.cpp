// dxClusteredWorldAndSpace::search with boxes that no space would give it: NaN, inverted, sizes over six decades,
// members that are added and removed. It reports each pair once, and the pairs of brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"
#include "bounds.h"

namespace {

using Slot = dxMembers::Slot;

class ClusterBroadphase : public testing::TestWithParam<const char *> {
protected:
    ~ClusterBroadphase() override {
        dSpaceDestroy(owner);
        dWorldDestroy(world);
    }

    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(random); }

    dxBounds randomBox() {
        const dReal reach = std::pow(dReal(10), uniform(0, 2)), edge = std::pow(dReal(10), uniform(-4, 2));
        dxBounds box = cubeAt(uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach), edge);
        if (random() % 30 == 0) box.v[random() % 6] = random() % 2 == 0 ? kInfinite : -kInfinite;
        if (random() % 30 == 0) box.v[random() % 6] = kNaN;
        if (random() % 30 == 0) std::swap(box.v[0], box.v[1]);
        return box;
    }

    void add() {
        const dGeomID geom = dCreateSphere(owner, 1);
        if (random() % 3 != 0) dGeomSetBody(geom, dBodyCreate(world));
        change(members.add(geom));
    }
    void change(Slot slot) {
        members.markChanged(slot);
        members.setBounds(slot, randomBox());
    }
    void remove(Slot slot) {
        dGeomDestroy(members[slot].geom);
        members.remove(slot);
    }
    void changeSome() {
        for (int i = static_cast<int>(random() % 6); i >= 0; --i) {
            const Slot slot = random() % members.end();
            if (members[slot].geom == nullptr || random() % 5 == 0) add();
            else if (random() % 5 == 0) remove(slot);
            else change(slot);
        }
    }

    std::vector<std::pair<Slot, Slot>> findOverlaps(dxClusteredWorldAndSpace &clustered) {
        std::vector<dxBroadphase::Match> matches;
        clustered.findOverlaps(members, dxTaskRunner::alone(), matches);
        std::vector<std::pair<Slot, Slot>> found;
        for (const dxBroadphase::Match &match : matches) found.emplace_back(std::minmax(match.a, match.b));
        std::sort(found.begin(), found.end());
        return found;
    }
    std::vector<std::pair<Slot, Slot>> bruteForce() const {
        std::vector<std::pair<Slot, Slot>> pairs;
        for (Slot a = 0; a < members.end(); ++a)
            for (Slot b = a + 1; b < members.end(); ++b)
                if (members[a].geom != nullptr && members[b].geom != nullptr &&
                    (members.isChanged(a) || members.isChanged(b)) &&
                    members[a].bounds.overlaps(members[b].bounds))
                    pairs.emplace_back(a, b);
        return pairs;
    }

    std::mt19937 random{5};
    OdeSession session;
    dSpaceID owner = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);  // destroys what is left in it
    dWorldID world = dWorldCreate();
    dxMembers members;
};

TEST_P(ClusterBroadphase, FindsThePairsOfBruteForceWhateverTheBoxes) {
    std::size_t pairs = 0;
    for (int seed = 0; seed < 60; ++seed) {
        dxClusteredWorldAndSpace clustered(dxMakeCrossoverPass(GetParam()));
        clustered.setCells(5 + static_cast<int>(random() % 16));
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members[slot].geom != nullptr) remove(slot);
        members.forgetChanges();
        for (int i = 0; i < 40; ++i) add();
        for (int frame = 0; frame < 60; ++frame) {
            if (frame == 30) clustered.setCells(5 + static_cast<int>(random() % 16));
            const auto found = findOverlaps(clustered);
            ASSERT_EQ(found, bruteForce()) << "seed " << seed << ", frame " << frame;
            pairs += found.size();
            members.forgetChanges();
            changeSome();
        }
    }
    EXPECT_GT(pairs, 10000u);
}

TEST_P(ClusterBroadphase, CellsAnAxisChangeAtTheNextSearch) {
    dxClusteredWorldAndSpace clustered(dxMakeCrossoverPass(GetParam()));
    for (int i = 0; i < 10; ++i) add();
    findOverlaps(clustered);
    EXPECT_EQ(clustered.scene().grid().cells(), 5);
    clustered.setCells(17);
    EXPECT_EQ(clustered.scene().grid().cells(), 5);
    findOverlaps(clustered);
    EXPECT_EQ(clustered.scene().grid().cells(), 17);
}

INSTANTIATE_TEST_SUITE_P(Passes, ClusterBroadphase, testing::ValuesIn(kPasses), nameOfPass);

}  // namespace
