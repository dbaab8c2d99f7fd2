// Functions that scripts call: those that came with ODE 0.16.6.
#include "by_hand.h"

namespace fuzz {

void addNewFunctions(std::vector<Function> &all) {
    FUZZ_TYPED(dJointAddPUTorques);
    byHand(all, "dWorldSetSteppingThreadingParameters",
           {object(ObjectKind::world), number(Meaning::bits), number(Meaning::count), number(Meaning::count), number(Meaning::count)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]);
               if (world == nullptr) return false;
               const auto argument = [&arguments](int place) { return static_cast<unsigned>(whole(arguments[place])); };
               const dWorldSteppingThreadingParameters parameters = {argument(1), argument(2), argument(3), argument(4)};
               dWorldSetSteppingThreadingParameters(world, &parameters);
               return true;
           });
    byHand(all, "dWorldGetSteppingThreadingParameters", {object(ObjectKind::world), number(Meaning::bits)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]);
               if (world == nullptr) return false;
               dWorldSteppingThreadingParameters parameters = {static_cast<unsigned>(whole(arguments[1])), 101, 102, 103};
               dWorldGetSteppingThreadingParameters(world, &parameters);
               const double read[] = {double(parameters.world_islands_iteration_max_threads), double(parameters.island_stepping_max_threads),
                                      double(parameters.lcp_solving_max_threads)};
               player.tell("returns", read, 3);
               return true;
           });
}

}  // namespace fuzz
