// Functions that scripts call: ODE_MT's own. Debian's library has none of them and nothing to change; results must be the same.
#include "by_hand.h"
#include "only_ours.h"

namespace fuzz {

namespace {

void addChoice(std::vector<Function> &all, const char *name, std::vector<std::string> words) {
    const std::string function = name;
    byHand(all, name, {word(std::move(words))}, [function](Player &, const Arguments &arguments, Reference &) {
        callIfThere(function.c_str(), arguments[0].word.c_str());
        return true;
    }, 2);
}

// A setting of the solver "fast", which all its runs have alike.
template <class Value>
void addSolverSetting(std::vector<Function> &all, const char *name, Value value) {
    byHand(all, name, {object(ObjectKind::world)}, [name, value](Player &player, const Arguments &arguments, Reference &) {
        const auto world = get<dWorldID>(player, arguments[0]);
        if (world == nullptr) return false;
        if (!playedAs.isFast)
            callIfThere(name, world, value);
        else if (!player.isInCallback())
            callOnFast(name, world, value);
        return true;
    }, 1);
}

// They look and change nothing.
void addGetters(std::vector<Function> &all) {
    for (const char *const name : {"dODE_MT_GetAlgorithm", "dODE_MT_GetCallbackPolicy", "dODE_MT_GetContactsAhead",
                                   "dODE_MT_GetContactsAheadUnused", "dODE_MT_GetDirectFallbacks",
                                   "dODE_MT_GetDirectIslands", "dODE_MT_GetGridCells", "dODE_MT_GetHeuristics",
                                   "dODE_MT_GetMaxWorkersUsed", "dODE_MT_GetParallelCollisions", "dODE_MT_GetParallelIslands",
                                   "dODE_MT_GetParallelSteps", "dODE_MT_GetSharedCollisions", "dODE_MT_GetTeamSteps",
                                   "dODE_MT_GetThreadManager", "dODE_MT_GetThreads", "dODE_MT_GetUpstreamVersion",
                                   "dODE_MT_GetVersion", "dODE_MT_GetWorkerIndex"})
        byHand(all, name, {}, [name](Player &, const Arguments &, Reference &) {
            callIfThere(name);
            return true;
        }, 1);
    for (const char *const name : {"dODE_MT_GetSolver", "dODE_MT_GetSolverTolerance", "dODE_MT_GetWarmStart", "dODE_MT_GetWorldThreads",
                                   "dWorldRefreshParameters"})
        byHand(all, name, {object(ObjectKind::world)}, [name](Player &player, const Arguments &arguments, Reference &) {
            const auto world = get<dWorldID>(player, arguments[0]);
            if (world == nullptr) return false;
            callIfThere(name, world);
            return true;
        }, 1);
    for (const char *const name : {"dODE_MT_GetSpaceThreads", "dODE_MT_GetWorkerCount"})
        byHand(all, name, {object(ObjectKind::space)}, [name](Player &player, const Arguments &arguments, Reference &) {
            const auto space = get<dSpaceID>(player, arguments[0]);
            if (space == nullptr) return false;
            callIfThere(name, space);
            return true;
        }, 1);
    for (const char *const name : {"dClusterGetCount", "dClusterGetGridCells", "dClusterGetGridStep"})
        byHand(all, name, {object(ObjectKind::world), object(ObjectKind::space)}, [name](Player &player, const Arguments &arguments, Reference &) {
            const auto world = get<dWorldID>(player, arguments[0]);
            const auto space = get<dSpaceID>(player, arguments[1]);
            if (world == nullptr || space == nullptr) return false;
            callIfThere(name, world, space);
            return true;
        }, 1);
    for (const char *const name : {"dClusterGetOfGeom", "dClusterGetStaticOfGeom", "dGeomSetDynamicFlag"})
        byHand(all, name, {object(ObjectKind::geom)}, [name](Player &player, const Arguments &arguments, Reference &) {
            const auto geom = get<dGeomID>(player, arguments[0]);
            if (geom == nullptr) return false;
            callIfThere(name, geom);
            return true;
        }, 1);
    byHand(all, "dClusterGetOfBody", {object(ObjectKind::body)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto body = get<dBodyID>(player, arguments[0]);
        if (body == nullptr) return false;
        callIfThere("dClusterGetOfBody", body);
        return true;
    }, 1);
}

// Numbers of threads that worlds and spaces have of their own.
template <class Object>
void addOwnThreads(std::vector<Function> &all, const char *name, ObjectKind kind) {
    byHand(all, name, {object(kind), number(Meaning::choice)}, [name](Player &player, const Arguments &arguments, Reference &) {
        const auto owner = get<Object>(player, arguments[0]);
        if (owner == nullptr) return false;
        if (!player.isInCallback()) callIfThere(name, owner, whole(arguments[1]));
        return true;
    }, 2);
}

// On the other library they are replaced by the calls that they stand for.
void addFrames(std::vector<Function> &all) {
    byHand(all, "dODE_MT_StepWorlds",
           {object(ObjectKind::world), object(ObjectKind::world), number(Meaning::time), number(Meaning::flag)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto first = get<dWorldID>(player, arguments[0]), second = get<dWorldID>(player, arguments[1]);
               if (first == nullptr || second == nullptr || first == second) return false;
               player.stepTogether(first, second, real(arguments[2]), whole(arguments[3]) != 0);
               return true;
           }, 4);
    for (const bool stepsFirst : {false, true})
        byHand(all, stepsFirst ? "dWorldStepAndSpaceCollide" : "dSpaceCollideAndWorldStep",
               {object(ObjectKind::space), object(ObjectKind::world), number(Meaning::time), number(Meaning::flag)},
               [stepsFirst](Player &player, const Arguments &arguments, Reference &) {
                   const auto space = get<dSpaceID>(player, arguments[0]);
                   const auto world = get<dWorldID>(player, arguments[1]);
                   if (space == nullptr || world == nullptr) return false;
                   player.playFrame(space, world, real(arguments[2]), whole(arguments[3]) != 0, stepsFirst);
                   return true;
               }, 4);
}

}  // namespace

void addSettingFunctions(std::vector<Function> &all) {
    byHand(all, "dToggleODE_MT", {number(Meaning::choice)}, [](Player &, const Arguments &arguments, Reference &) {
        callIfThere("dToggleODE_MT", whole(arguments[0]));
        return true;
    }, 3);
    addOwnThreads<dWorldID>(all, "dODE_MT_SetWorldThreads", ObjectKind::world);
    addOwnThreads<dSpaceID>(all, "dODE_MT_SetSpaceThreads", ObjectKind::space);
    byHand(all, "dODE_MT_SetGridCells", {number(Meaning::choice)}, [](Player &, const Arguments &arguments, Reference &) {
        const int cells = whole(arguments[0]);
        callIfThere("dODE_MT_SetGridCells", cells >= 1 && cells <= 7 ? 4 + 2 * cells : 0);
        return true;
    }, 2);
    addChoice(all, "dODE_MT_SetAlgorithm",
              {"auto", "lcp", "serial", "original", "static", "static-unmerged", "duplication", "decluster"});
    addChoice(all, "dODE_MT_SetHeuristics",
              {"default", "none", "cells", "centre", "crossover", "declustering", "threads", "cells,centre,crossover,declustering,threads"});
    addChoice(all, "dODE_MT_SetThreadManager", {"pthread", "openmp"});
    // The bits of "fast" are its own, and so are all its runs changed alike.
    byHand(all, "dODE_MT_SetSolver", {object(ObjectKind::world)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto world = get<dWorldID>(player, arguments[0]);
        if (world == nullptr) return false;
        if (!playedAs.isFast)
            callIfThere("dODE_MT_SetSolver", world, "exact");
        else if (!player.isInCallback())
            player.changeSolver(world);
        return true;
    }, 1);
    // Of no effect on an exact world.
    addSolverSetting(all, "dODE_MT_SetSolverTolerance", 0.5);
    addSolverSetting(all, "dODE_MT_SetWarmStart", 0);
    // The player then does what such callbacks may do, on both libraries.
    byHand(all, "dODE_MT_SetCallbackPolicy", {word({"serial", "concurrent", "independent"})},
           [](Player &player, const Arguments &arguments, Reference &) {
               callIfThere("dODE_MT_SetCallbackPolicy", arguments[0].word.c_str());
               player.setCallbackPolicy(arguments[0].word);
               return true;
           }, 2);
    addGetters(all);
    addFrames(all);
}

}  // namespace fuzz
