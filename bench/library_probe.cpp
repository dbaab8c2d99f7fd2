#include "library_probe.h"

#include <dlfcn.h>

#include <climits>
#include <cstdlib>

#include "library_release.h"

namespace bench {

namespace {

template <class Result>
Result call(const char *name) {
    void *address = dlsym(RTLD_DEFAULT, name);
    return address ? reinterpret_cast<Result (*)()>(address)() : Result{};
}

std::string callText(const char *name) {
    const char *text = call<const char *>(name);
    return text ? text : "";
}

std::string resolved(const char *file) {
    char path[PATH_MAX];
    return realpath(file, path) ? path : file;
}

}  // namespace

std::string LibraryProbe::release() const {
    const std::string said = callText("dODE_MT_GetUpstreamVersion");
    return said.empty() ? releaseByName(file) : said;
}

int LibraryProbe::threads() const { return call<int>("dODE_MT_GetThreads"); }
std::string LibraryProbe::manager() const { return callText("dODE_MT_GetThreadManager"); }
std::string LibraryProbe::algorithm() const { return callText("dODE_MT_GetAlgorithm"); }
std::string LibraryProbe::callbacks() const { return callText("dODE_MT_GetCallbackPolicy"); }
int LibraryProbe::gridCells() const { return call<int>("dODE_MT_GetGridCells"); }
unsigned LibraryProbe::sharedSteps() const {
    return call<unsigned>("dODE_MT_GetParallelSteps") + call<unsigned>("dODE_MT_GetTeamSteps");
}

LibraryProbe probeLibrary() {
    Dl_info info{};
    const void *stepper = dlsym(RTLD_DEFAULT, "dWorldStep");
    const bool found = stepper && dladdr(stepper, &info) != 0;
    return {found ? resolved(info.dli_fname) : "", dlsym(RTLD_DEFAULT, "dToggleODE_MT") != nullptr};
}

}  // namespace bench
