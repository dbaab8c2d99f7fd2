#include "platform.h"

#include <dlfcn.h>
#include <ode/ode_MT.h>

#include <climits>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "library_releases.h"
#include "support/text_file.h"

namespace bench {

std::string readProcessor(std::istream &cpuinfo) {
    for (std::string line; std::getline(cpuinfo, line);) {
        if (line.compare(0, 10, "model name") != 0) continue;
        const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
        return value == std::string::npos ? "" : line.substr(value);
    }
    return "";
}

Machine thisMachine() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    return {readProcessor(cpuinfo), std::thread::hardware_concurrency()};
}

namespace {

// In each build of ours, in front of the release: the first line of its log (ode_mt/settings/dxSettings.cpp).
const std::string kMark = ", made of ODE ";

bool isOurText(const std::string &text) { return text.find("dToggleODE_MT") != std::string::npos; }

// Returns "" if the text does not say it.
std::string releaseInText(const std::string &text) {
    const std::size_t at = text.find(kMark);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + kMark.size();
    return text.substr(begin, text.find_first_not_of("0123456789.", begin) - begin);
}

}  // namespace

std::string releaseByName(const std::string &file) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(file, error);
    const std::string name = (error ? std::filesystem::path(file) : real).filename();
    for (const NumberedRelease &known : kNumberedReleases)
        if (name == std::string("libode.so.") + known.number) return known.release;
    return kUnknownRelease;
}

std::string releaseOfLibrary(const std::string &file) {
    const std::string text = support::readWhatIsThere(file);
    const std::string said = isOurText(text) ? releaseInText(text) : "";
    return said.empty() ? releaseByName(file) : said;
}

bool isOurLibrary(const std::string &file) { return isOurText(support::readWhatIsThere(file)); }

bool areOtherReleases(const std::string &one, const std::string &other) {
    return one != kUnknownRelease && other != kUnknownRelease && one != other;
}

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

SerialWork LibraryProbe::workOf(dWorldID world) const {
    void *const address = dlsym(RTLD_DEFAULT, "dODE_MT_GetWorldStatistics");
    if (address == nullptr) return {};
    dODE_MT_WorldStatistics last{};
    last.size = sizeof last;
    if (reinterpret_cast<decltype(&dODE_MT_GetWorldStatistics)>(address)(world, &last) == 0) return {};
    return {last.collisionTime + last.stepTime - last.sharedTime, last.workTime};
}

LibraryProbe probeLibrary() {
    Dl_info info{};
    const void *stepper = dlsym(RTLD_DEFAULT, "dWorldStep");
    const bool found = stepper && dladdr(stepper, &info) != 0;
    return {found ? resolved(info.dli_fname) : "", dlsym(RTLD_DEFAULT, "dToggleODE_MT") != nullptr};
}

}  // namespace bench
