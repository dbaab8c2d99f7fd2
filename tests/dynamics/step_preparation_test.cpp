// What comes before a step asks for the memory that upstream asks for, in the same order.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "config.h"
#include "quickstep.h"
#include "step.h"
#include "util.h"

#include "dynamics/islands/dxStepPreparation.h"
#include "random_world.h"

namespace {

std::vector<std::size_t> requests;

void *take(dsizeint size) {
    requests.push_back(size);
    return std::malloc(size);
}

void *shrink(void *block, dsizeint size, dsizeint smaller) {
    requests.insert(requests.end(), {size, smaller});
    return block;
}

void giveBack(void *block, dsizeint size) {
    requests.push_back(size);
    std::free(block);
}

using Preparation = decltype(&dxPrepareStep);

std::vector<std::size_t> requestsOf(Preparation prepare, dmemestimate_fn_t estimate, unsigned seed) {
    requests.clear();
    RandomWorld scene({seed % 17 + 1, seed % 29}, seed);
    const dWorldStepMemoryFunctionsInfo functions = {sizeof functions, take, shrink, giveBack};
    dWorldSetStepMemoryManager(scene.world(), &functions);
    if (seed % 2 == 0) dWorldSetStepMemoryReservationPolicy(scene.world(), nullptr);
    for (int i = 0; i < 3; ++i) {
        dxWorldProcessIslandsInfo info;
        EXPECT_TRUE(prepare(scene.world(), info, dReal(0.01), estimate));
        for (unsigned k = 0; k < 20; ++k) dBodyCreate(scene.world());
    }
    return requests;
}

}  // namespace

TEST(StepPreparation, AsksForUpstreamsMemory) {
    dInitODE2(0);
    for (const dmemestimate_fn_t estimate : {&dxEstimateStepMemoryRequirements, &dxEstimateQuickStepMemoryRequirements}) {
        for (unsigned seed = 0; seed < 50; ++seed) {
            const std::vector<std::size_t> upstreams = requestsOf(&dxReallocateWorldProcessContext, estimate, seed);
            EXPECT_FALSE(upstreams.empty());
            EXPECT_EQ(upstreams, requestsOf(&dxPrepareStep, estimate, seed)) << "seed " << seed;
        }
    }
    dCloseODE();
}
