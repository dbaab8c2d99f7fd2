#include "settings/dxWorkers.h"

#include <ode/error.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>

#include "core/dxEnvironment.h"
#include "core/dxLog.h"
#include "settings/dxSettings.h"
#include "threading/managers/dxThreadManagerFactory.h"
#include "threading/pool/dxJobBoard.h"

namespace {

dxProcessObject<dxWorkers> workers;

// The factory's own text for the name, which lives as long as the library; null: unknown.
const char *findName(const std::string &name) {
    const std::vector<const char *> names = dxThreadManagerFactory::names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? *found : nullptr;
}

std::string knownNames() {
    std::string list;
    for (const char *name : dxThreadManagerFactory::names())
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

unsigned wantedSize() { return std::max(dxSettings::instance().threads(), 1u); }

// The default manager, and its name, where the one asked for cannot be made.
std::unique_ptr<dxThreadManager> make(const char *&name) {
    std::unique_ptr<dxThreadManager> manager = dxThreadManagerFactory::create(name);
    if (manager == nullptr) {
        name = dxThreadManagerFactory::defaultName();
        manager = dxThreadManagerFactory::create(name);
    }
    manager->resize(wantedSize());
    dxLog(dxLogLevel::info, "thread manager %s: up to %u threads, the caller included", name, wantedSize());
    return manager;
}

}  // namespace

dxWorkers &dxWorkers::instance() { return *workers; }

// A library that the manager needs is loaded when the first workers are needed: not under the lock that is held here.
dxWorkers::dxWorkers() : m_name(dxThreadManagerFactory::defaultName()) {
    const char *name = dxEnvironment(dxVariable::ThreadManager);
    if (name == nullptr) return;
    if (const char *known = findName(name)) {
        m_name = known;
        return;
    }
    dxLog(dxLogLevel::warning, "ODE_MT_THREAD_MANAGER is '%.100s'; known: %s; %s is taken", name, knownNames().c_str(),
          m_name);
}

// Without memory for a manager the caller works alone.
void dxWorkers::run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context) {
    Manager manager;
    try {
        manager = current();
    } catch (const std::bad_alloc &) {
        return dxRunAlone(blocks, task, context);
    }
    manager->run(blocks, workers, task, context);
}

// Of two threads that make a manager at the same time one has its own for this run alone.
dxWorkers::Manager dxWorkers::current() {
    const char *wanted;
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (m_manager != nullptr) return m_manager;
        wanted = m_name;
    }
    const char *name = wanted;
    Manager made = make(name);
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (m_manager != nullptr || m_name != wanted) return made;
        m_name = name;
        m_manager = made;
    }
    resize();  // the size may have been set while it was made
    return made;
}

// The next run makes a manager of the new size. One that has it already only asks the system anew for threads
// that were refused.
void dxWorkers::resize() {
    Manager now;
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        now = m_manager;
    }
    if (now == nullptr) return;
    if (now->workers() == wantedSize())
        now->resize(now->workers());
    else
        stop();
}

bool dxWorkers::choose(const std::string &name) {
    const char *const known = findName(name);
    if (known == nullptr) {
        dMessage(0, "ODE_MT: no thread manager '%s'; known: %s", name.c_str(), knownNames().c_str());
        return false;
    }
    if (const char *const missing = dxThreadManagerFactory::missingLibrary(name)) {
        dMessage(0, "ODE_MT: thread manager '%s' needs %s, which cannot be loaded", known, missing);
        return false;
    }
    Manager before;  // ends after the lock
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    m_name = known;
    m_manager.swap(before);
    return true;
}

const char *dxWorkers::name() {
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    return m_name;
}

void dxWorkers::stop() {
    Manager before;  // ends after the lock
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    m_manager.swap(before);
}
