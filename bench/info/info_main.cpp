// odemt_info: prints which libode.so.8 a program that is started here gets, and with which settings.
#include <dlfcn.h>
#include <ode/ode.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tool_output.h"
#include "info/vector_width.h"
#include "platform.h"

namespace {

using Facts = nlohmann::ordered_json;

// Calls a function of ours by its name: the program also runs on upstream's library.
template <class Result, class... Arguments>
Result call(const char *name, Arguments... arguments) {
    const auto function = reinterpret_cast<Result (*)(Arguments...)>(dlsym(RTLD_DEFAULT, name));
    return function != nullptr ? function(arguments...) : Result();
}

std::string text(const char *name) {
    const char *const value = call<const char *>(name);
    return value != nullptr ? value : "";
}

// The variables that the library reads, as this process has them.
Facts variables() {
    Facts found = Facts::object();
    for (char **entry = environ; *entry != nullptr; ++entry) {
        const char *const end = std::strchr(*entry, '=');
        if (end != nullptr && std::strncmp(*entry, "ODE_MT_", 7) == 0)
            found[std::string(static_cast<const char *>(*entry), end)] = std::string(end + 1);
    }
    return found;
}

// Settings in force, by the world's where each world has its own: those of a new one.
Facts settings() {
    Facts facts;
    facts["threads"] = call<int>("dODE_MT_GetThreads");
    facts["thread manager"] = text("dODE_MT_GetThreadManager");
    facts["algorithm"] = text("dODE_MT_GetAlgorithm");
    facts["callbacks"] = text("dODE_MT_GetCallbackPolicy");
    facts["heuristics"] = text("dODE_MT_GetHeuristics");
    facts["grid cells"] = call<int>("dODE_MT_GetGridCells");
    const dWorldID world = dWorldCreate();
    const char *const solver = call<const char *>("dODE_MT_GetSolver", world);
    facts["solver"] = solver != nullptr ? solver : "";
    dWorldDestroy(world);
    return facts;
}

int coresOfAuto() {
    const int before = call<int>("dODE_MT_GetThreads");
    call<void>("dToggleODE_MT", static_cast<int>(dODE_MT_AUTO));
    const int cores = call<int>("dODE_MT_GetThreads");
    call<void>("dToggleODE_MT", before);
    return cores;
}

Facts gather() {
    const bench::LibraryProbe library = bench::probeLibrary();
    const bench::Machine machine = bench::thisMachine();
    Facts facts;
    facts["library"] = library.file;
    facts["ODE_MT"] = library.isOurs ? text("dODE_MT_GetVersion") : "no: another libode";
    facts["ODE"] = library.release();
    facts["precision"] = dCheckConfiguration("ODE_double_precision") != 0 ? "double" : "single";
    facts["processor"] = machine.processor;
    facts["cores"] = machine.cores;
    if (!library.isOurs) return facts;
    // What this program's build was made of; the library that it finds may be another build's.
    if (library.release() == ODEMT_UPSTREAM) {
        facts["upstream"] = ODEMT_UPSTREAM_ARCHIVE;
        facts["upstream sha256"] = ODEMT_UPSTREAM_SHA256;
    }
    const info::VectorWidth vectors = info::vectorWidth();
    facts["vectors"] = std::string(vectors.instructionSet) + ", " + std::to_string(vectors.bits) + " bits";
    facts["threads of auto"] = coresOfAuto();
    facts.update(settings());
    facts["environment"] = variables();
    return facts;
}

std::string shown(const Facts &value) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_object()) return value.dump();
    std::string words;
    for (const auto &[name, content] : value.items()) words += (words.empty() ? "" : " ") + name + '=' + content.get<std::string>();
    return words.empty() ? "nothing set" : words;
}

}  // namespace

int main(int argc, char **argv) {
    CLI::App app("Prints which libode.so.8 programs get that are started as this one, and how it is set up.", "odemt_info");
    bool isJson = false;
    app.add_flag("--json", isJson, "as a JSON object");
    int exitCode = 0;
    if (!bench::readCommandLine(app, [&] { app.parse(argc, argv); }, exitCode)) return exitCode;

    dInitODE2(0);
    const Facts facts = gather();
    dCloseODE();
    if (isJson)
        std::cout << facts.dump(2) << '\n';
    else
        for (const auto &[name, value] : facts.items()) std::cout << std::left << std::setw(18) << name << shown(value) << '\n';
    std::cout.flush();
    return std::cout.good() ? 0 : 1;
}
