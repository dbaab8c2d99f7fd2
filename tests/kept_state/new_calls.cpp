// Recipes for the functions that came with ODE 0.16.6.
#include "call_recipes.h"

namespace kept_state {

namespace {

constexpr unsigned kAll = dWSTP_WorldIslandsIterationMaxThreads | dWSTP_IslandSteppingMaxThreads | dWSTP_LCPSolvingMaxThreads;

void limit(dWorldID world, unsigned islands, unsigned stepping, unsigned solving) {
    const dWorldSteppingThreadingParameters parameters = {kAll, islands, stepping, solving};
    dWorldSetSteppingThreadingParameters(world, &parameters);
}

}  // namespace

void addNewCalls(CallRecipes &r) {
    r.push_back({"dJointAddPUTorques", [](CallScene &s) { dJointAddPUTorques(s.joints[dJointTypePU], 2, 3); }});
    r.back().anySpace = true;
    r.push_back({"dWorldSetSteppingThreadingParameters", [](CallScene &s) { limit(s.world, 1, 1, 1); },
                 [](CallScene &s) { limit(s.world, dWORLDSTEP_THREADCOUNT_UNLIMITED, dWORLDSTEP_THREADCOUNT_UNLIMITED, 1); }});
    r.push_back({"dWorldGetSteppingThreadingParameters",
                 [](CallScene &s) {
                     dWorldSteppingThreadingParameters parameters = {kAll, 101, 102, 103};
                     dWorldGetSteppingThreadingParameters(s.world, &parameters);
                     s.tell(parameters.world_islands_iteration_max_threads);
                     s.tell(parameters.island_stepping_max_threads);
                     s.tell(parameters.lcp_solving_max_threads);
                 },
                 nullptr, true});
}

}  // namespace kept_state
