// Geoms that all lie in one place: there a space keeps no pairs, or some kinds of geoms' alone (dxPairKeeping). The callbacks are Debian's.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "support/child_run.h"
#include "numbered_spaces.h"

namespace {

std::string run(const char *libraryFolder, int kind, const char *scene, const char *threads) {
    const auto child = support::runProgram({ODE_MT_ONE_PLACE_PROGRAM, std::to_string(kind), scene},
                                           {{"LD_LIBRARY_PATH", libraryFolder}, {"ODE_MT_THREADS", threads}, {"ODE_MT_ALGORITHM", "lcp"}});
    return child.text() + "\n" + child.output;
}

class OnePlace : public testing::TestWithParam<std::tuple<int, const char *>> {};

TEST_P(OnePlace, IsCollidedAsByLibode8) {
    const auto [kind, scene] = GetParam();
    const std::string stock = run(ODE_MT_STOCK_LIBRARY_DIR, kind, scene, "");
    ASSERT_EQ(stock.find("exit code 0\n"), 0u) << stock;
    ASSERT_GT(stock.size(), 600u) << "callbacks of all calls";
    for (const char *const threads : {"0", "2", "3"}) EXPECT_EQ(run(ODE_MT_LIBRARY_DIR, kind, scene, threads), stock) << threads << " threads";
}

INSTANTIATE_TEST_SUITE_P(KindsAndScenes, OnePlace,
                         testing::Combine(testing::Range(0, 4),
                                          testing::Values("spaces", "spaces_met", "boxes", "disabled", "destroyed", "lidar", "lidar_bits")),
                         [](const auto &info) { return std::string(kKinds[std::get<0>(info.param)]) + "_" + std::get<1>(info.param); });

}  // namespace
