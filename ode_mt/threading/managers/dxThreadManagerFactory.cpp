#include "threading/managers/dxThreadManagerFactory.h"

#include "core/dxLog.h"
#include "threading/managers/dxOpenMPRuntime.h"
#include "threading/managers/dxThreadManagerOpenMP.h"
#include "threading/managers/dxThreadManagerPthread.h"

namespace {

struct Kind {
    const char *name;
    const char *library;  // file name of the one that make() loads; null: none
    bool takesOptions;
    std::unique_ptr<dxThreadManager> (*make)(const dxWorkerOptions &options);
};

const Kind kKinds[] = {
    {"pthread", nullptr, true,
     [](const dxWorkerOptions &options) -> std::unique_ptr<dxThreadManager> {
         return std::make_unique<dxThreadManagerPthread>(pthread_create, options);
     }},
    {"openmp", dxOpenMPRuntime::fileName(), false,
     [](const dxWorkerOptions &) -> std::unique_ptr<dxThreadManager> { return dxThreadManagerOpenMP::make(); }},
};

}  // namespace

namespace dxThreadManagerFactory {

const char *defaultName() { return kKinds[0].name; }

std::vector<const char *> names() {
    std::vector<const char *> list;
    for (const Kind &kind : kKinds) list.push_back(kind.name);
    return list;
}

std::string knownNames() {
    std::string list;
    for (const char *name : names()) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

const char *missingLibrary(const std::string &name) {
    for (const Kind &kind : kKinds) {
        if (name == kind.name && kind.library != nullptr && !dxOpenMPRuntime::load()) return kind.library;
    }
    return nullptr;
}

bool takesOptions(const std::string &name) {
    for (const Kind &kind : kKinds) {
        if (name == kind.name) return kind.takesOptions;
    }
    return false;
}

std::unique_ptr<dxThreadManager> create(const std::string &name, const dxWorkerOptions &options) {
    for (const Kind &kind : kKinds) {
        if (name != kind.name) continue;
        std::unique_ptr<dxThreadManager> manager = kind.make(options);
        if (manager == nullptr)
            dxLog(dxLogLevel::Warning, "thread manager '%s' needs %s, which cannot be loaded", kind.name, kind.library);
        return manager;
    }
    dxLog(dxLogLevel::Error, "unknown thread manager '%s'; known: %s", name.c_str(), knownNames().c_str());
    return nullptr;
}

}  // namespace dxThreadManagerFactory
