#include "frame/dxWorkers.h"

#include <ode/error.h>

#include <algorithm>
#include <mutex>
#include <new>

#include "frame/dxSettings.h"
#include "threading/dxThreadManagerFactory.h"
#include "trace/dxEnvironment.h"
#include "trace/dxLog.h"

namespace {

dxProcessObject<dxWorkers> workers;

bool isKnown(const std::string &name) {
    const std::vector<const char *> names = dxThreadManagerFactory::names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string knownNames() {
    std::string list;
    for (const char *name : dxThreadManagerFactory::names())
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

std::unique_ptr<dxThreadManager> make(const std::string &name) {
    std::unique_ptr<dxThreadManager> manager = dxThreadManagerFactory::create(name);
    manager->resize(std::max(dxSettings::instance().threads(), 1u));
    return manager;
}

}  // namespace

dxWorkers &dxWorkers::instance() { return *workers; }

dxWorkers::dxWorkers() {
    const char *name = dxEnvironment(dxVariable::ThreadManager);
    if (name != nullptr && !isKnown(name)) {
        dxLog(dxLogLevel::warning, "ODE_MT_THREAD_MANAGER is '%s'; known: %s; %s is taken", name,
              knownNames().c_str(), dxThreadManagerFactory::defaultName());
        name = nullptr;
    }
    m_manager = make(name != nullptr ? name : dxThreadManagerFactory::defaultName());
    listenToForks();
}

// A step of another thread may have held the lock when this one forked; that thread does not exist here.
void dxWorkers::inForkedChild() { new (&m_mutex) std::shared_mutex; }

void dxWorkers::run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context) {
    std::shared_lock<std::shared_mutex> lock(m_mutex);
    m_manager->run(blocks, workers, task, context);
}

void dxWorkers::resize() {
    std::unique_lock<std::shared_mutex> lock(m_mutex);
    m_manager->resize(std::max(dxSettings::instance().threads(), 1u));
}

bool dxWorkers::choose(const std::string &name) {
    if (!isKnown(name)) {
        dMessage(0, "ODE_MT: no thread manager '%s'; known: %s", name.c_str(), knownNames().c_str());
        return false;
    }
    std::unique_lock<std::shared_mutex> lock(m_mutex);
    m_manager = make(name);
    return true;
}

const char *dxWorkers::name() {
    std::shared_lock<std::shared_mutex> lock(m_mutex);
    return m_manager->name();
}

void dxWorkers::stop() {
    std::unique_lock<std::shared_mutex> lock(m_mutex);
    m_manager->stop();
}
