#include "engine_statistics.h"

#include "instruction_set.h"

#include <cstdlib>

#include <dlfcn.h>

namespace exactness {

namespace {

std::string libraryOf(const char *function) {
    Dl_info info;
    if (dladdr(dlsym(RTLD_DEFAULT, function), &info) == 0) return "";
    char *path = realpath(info.dli_fname, nullptr);
    const std::string library = path == nullptr ? info.dli_fname : path;
    std::free(path);
    return library;
}

unsigned statistic(const char *function) {
    const auto get = reinterpret_cast<unsigned (*)()>(dlsym(RTLD_DEFAULT, function));
    return get == nullptr ? 0 : get();
}

}  // namespace

Engine runningEngine() {
    Engine engine;
    engine.library = libraryOf("dWorldStep");
    engine.isOdeMt = dlsym(RTLD_DEFAULT, "dToggleODE_MT") != nullptr;
    engine.parallelSteps = statistic("dODE_MT_GetParallelSteps");
    engine.parallelIslands = statistic("dODE_MT_GetParallelIslands");
    engine.teamSteps = statistic("dODE_MT_GetTeamSteps");
    engine.parallelCollisions = statistic("dODE_MT_GetParallelCollisions");
    engine.maxWorkers = statistic("dODE_MT_GetMaxWorkersUsed");
    engine.instructionSet = instructionSetInUse();
    return engine;
}

}  // namespace exactness
