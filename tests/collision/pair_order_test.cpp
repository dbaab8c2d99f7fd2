// Pairs and their order in random spaces, against Debian's libode8: docs/collision.md.
//
// Covers api/collision.cpp, api/collision_space.cpp, dxListCleaner.cpp, dxOrderedHashSpace.cpp, dxOrderedQuadTreeSpace.cpp, dxOrderedSapSpace.cpp,
// dxOrderedSimpleSpace.cpp, dxOrderedSpace.cpp, dxQuadTreeCleaner.cpp, dxSapPairOrder.cpp, dxSapWalk.cpp, dxSpaceGeoms.cpp, dxSpacePairs.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "support/child_run.h"

namespace {

struct Kind {
    std::string name, space;
    int geoms, frames, seeds;
    bool breathes;
    std::string algorithm = "auto";
    int threads = 0;
};
void PrintTo(const Kind &kind, std::ostream *out) { *out << kind.name; }

class PairOrder : public testing::TestWithParam<Kind> {};

support::Ending run(const char *libraryFolder, unsigned seed, const Kind &kind) {
    return support::runProgram({ODE_MT_PAIR_SEQUENCE_PROGRAM, std::to_string(seed), kind.space,
                                std::to_string(kind.geoms), std::to_string(kind.frames), kind.breathes ? "1" : "0"},
                               {{"LD_LIBRARY_PATH", libraryFolder}, {"ODE_MT_ALGORITHM", kind.algorithm},
                                {"ODE_MT_THREADS", std::to_string(kind.threads)}});
}

std::string firstDifference(const std::string &stock, const std::string &ours) {
    std::istringstream stockLines(stock), oursLines(ours);
    std::string a, b;
    while (std::getline(stockLines, a) && std::getline(oursLines, b)) {
        if (a == b) continue;
        std::size_t at = 0;
        while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
        const std::size_t from = at > 60 ? at - 60 : 0;
        return a.substr(0, a.find(':')) + "\n  libode8: ..." + a.substr(from, 120) + "\n  ours:    ..." +
               b.substr(from, 120);
    }
    return "one report is longer";
}

TEST_P(PairOrder, IsThatOfLibode8) {
    const Kind &kind = GetParam();
    std::size_t pairs = 0;
    for (unsigned seed = 1; seed <= static_cast<unsigned>(kind.seeds); ++seed) {
        const auto stock = run(ODE_MT_STOCK_LIBRARY_DIR, seed, kind);
        const auto ours = run(ODE_MT_LIBRARY_DIR, seed, kind);
        ASSERT_TRUE(stock.exitedWith(0)) << "seed " << seed << ": libode8 ended with " << stock.text() << stock.errors;
        ASSERT_TRUE(ours.exitedWith(0)) << "seed " << seed << ": ours ended with " << ours.text() << ours.errors;
        ASSERT_TRUE(stock.output == ours.output)
            << "seed " << seed << ", " << firstDifference(stock.output, ours.output);
        pairs += static_cast<std::size_t>(std::count(stock.output.begin(), stock.output.end(), '-'));
    }
    EXPECT_GT(pairs, static_cast<std::size_t>(kind.geoms) * kind.frames) << "too little met to show an order";
}

INSTANTIATE_TEST_SUITE_P(Spaces, PairOrder,
                         testing::Values(Kind{"simpleFew", "simple", 12, 60, 40, false},
                                         Kind{"simpleMany", "simple", 300, 40, 12, false},
                                         // back and forth between the two ways of finding pairs
                                         Kind{"simpleBreathing", "simple", 300, 40, 12, true},
                                         Kind{"simpleCrowd", "simple", 1500, 10, 3, false},
                                         Kind{"hashFew", "hash", 12, 60, 40, false},
                                         Kind{"hashMany", "hash", 300, 40, 12, false},
                                         Kind{"hashBreathing", "hash", 100, 40, 12, true},
                                         Kind{"hashCrowd", "hash", 1500, 10, 3, false},
                                         Kind{"quadtreeFew", "quadtree", 12, 60, 60, false},
                                         Kind{"quadtreeSome", "quadtree", 80, 60, 30, false},
                                         Kind{"quadtreeMany", "quadtree", 300, 40, 24, false},
                                         Kind{"quadtreeBreathing", "quadtree", 300, 40, 12, true},
                                         Kind{"quadtreeCrowd", "quadtree", 1500, 10, 6, false},
                                         Kind{"sweepFew", "sweep", 12, 60, 80, false},
                                         Kind{"sweepSome", "sweep", 60, 60, 30, false},
                                         Kind{"sweepMany", "sweep", 300, 40, 16, false},
                                         // back and forth between the two ways of finding pairs
                                         Kind{"sweepBreathing", "sweep", 700, 20, 6, true},
                                         Kind{"sweepCrowd", "sweep", 1200, 15, 8, false}),
                         [](const auto &info) { return info.param.name; });

// Boxes, broad phase and sorting run in parallel.
INSTANTIATE_TEST_SUITE_P(Shared, PairOrder,
                         testing::Values(Kind{"simpleFew", "simple", 12, 60, 6, false, "lcp", 3},
                                         Kind{"simpleCrowd", "simple", 1500, 10, 2, false, "lcp", 3},
                                         Kind{"hashFew", "hash", 12, 60, 6, false, "lcp", 3},
                                         Kind{"hashMany", "hash", 300, 40, 4, false, "lcp", 3},
                                         Kind{"hashBreathing", "hash", 100, 40, 4, true, "lcp", 3},
                                         Kind{"hashCrowd", "hash", 1500, 10, 3, false, "lcp", 3},
                                         Kind{"quadtreeFew", "quadtree", 12, 60, 12, false, "lcp", 3},
                                         Kind{"quadtreeMany", "quadtree", 300, 40, 6, false, "lcp", 3},
                                         Kind{"quadtreeBreathing", "quadtree", 300, 40, 4, true, "lcp", 2},
                                         Kind{"quadtreeCrowd", "quadtree", 1500, 10, 4, false, "lcp", 3},
                                         Kind{"sweepFew", "sweep", 12, 60, 12, false, "lcp", 3},
                                         Kind{"sweepBreathing", "sweep", 700, 20, 4, true, "lcp", 3},
                                         Kind{"sweepCrowd", "sweep", 1500, 10, 6, false, "lcp", 3}),
                         [](const auto &info) { return info.param.name; });

// Clusters find the pairs; their order is the same.
std::vector<Kind> clustered() {
    std::vector<Kind> all;
    for (const std::string algorithm : {"original", "static", "static-unmerged", "duplication", "decluster"}) {
        std::string prefix = algorithm + '_';
        std::replace(prefix.begin(), prefix.end(), '-', '_');
        for (const Kind &kind : {Kind{"simpleFew", "simple", 12, 60, 6, false}, Kind{"simpleMany", "simple", 300, 40, 2, false},
                                 Kind{"simpleBreathing", "simple", 300, 40, 1, true}, Kind{"hashFew", "hash", 12, 60, 6, false},
                                 Kind{"hashMany", "hash", 300, 40, 2, false}, Kind{"hashBreathing", "hash", 100, 40, 2, true},
                                 Kind{"quadtreeFew", "quadtree", 12, 60, 6, false},
                                 Kind{"quadtreeMany", "quadtree", 300, 40, 2, false},
                                 Kind{"quadtreeBreathing", "quadtree", 100, 40, 2, true},
                                 Kind{"sweepFew", "sweep", 12, 60, 12, false},
                                 Kind{"sweepMany", "sweep", 300, 40, 4, false}}) {
            all.push_back(kind);
            all.back().name = prefix + kind.name;
            all.back().algorithm = algorithm;
        }
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Clusters, PairOrder, testing::ValuesIn(clustered()),
                         [](const auto &info) { return info.param.name; });

}  // namespace
