#include "threading/managers/dxThreadManagerFactory.h"

#include "core/dxLog.h"
#include "threading/managers/dxThreadManagerOpenMP.h"
#include "threading/managers/dxThreadManagerPthread.h"

namespace {

struct Kind {
    const char *name;
    bool (*present)();
    std::unique_ptr<dxThreadManager> (*make)();
};

constexpr Kind kinds[] = {
    {"pthread", [] { return true; },
     []() -> std::unique_ptr<dxThreadManager> { return std::make_unique<dxThreadManagerPthread>(); }},
    {"openmp", [] { return dxThreadManagerOpenMP::present(); },
     []() -> std::unique_ptr<dxThreadManager> { return dxThreadManagerOpenMP::make(); }},
};

std::string knownNames() {
    std::string list;
    for (const char *name : dxThreadManagerFactory::names())
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

}  // namespace

namespace dxThreadManagerFactory {

const char *defaultName() { return kinds[0].name; }

std::vector<const char *> names() {
    std::vector<const char *> list;
    for (const Kind &kind : kinds) {
        if (kind.present()) list.push_back(kind.name);
    }
    return list;
}

std::unique_ptr<dxThreadManager> create(const std::string &name) {
    for (const Kind &kind : kinds) {
        if (name != kind.name) continue;
        if (kind.present()) return kind.make();
        dxLog(dxLogLevel::error, "thread manager '%s' is not in this build; known: %s", kind.name,
              knownNames().c_str());
        return nullptr;
    }
    dxLog(dxLogLevel::error, "unknown thread manager '%s'; known: %s", name.c_str(), knownNames().c_str());
    return nullptr;
}

}  // namespace dxThreadManagerFactory
