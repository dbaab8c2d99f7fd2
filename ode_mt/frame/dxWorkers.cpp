#include "frame/dxWorkers.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>

#include "frame/dxSettings.h"
#include "threading/dxThreadManagerFactory.h"

namespace {

std::unique_ptr<dxThreadManager> make(const std::string &name) {
    std::unique_ptr<dxThreadManager> manager = dxThreadManagerFactory::create(name);
    if (manager) manager->resize(std::max(dxSettings::instance().threads(), 1u));
    return manager;
}

}  // namespace

dxWorkers &dxWorkers::instance() {
    static dxWorkers *const workers = new dxWorkers;  // never destroyed: steps may run while the process ends
    return *workers;
}

dxWorkers::dxWorkers() {
    if (const char *name = std::getenv("ODE_MT_THREAD_MANAGER")) m_manager = make(name);
    if (!m_manager) m_manager = make(dxThreadManagerFactory::defaultName());
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
    std::unique_lock<std::shared_mutex> lock(m_mutex);
    std::unique_ptr<dxThreadManager> manager = make(name);
    if (!manager) return false;
    m_manager = std::move(manager);
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
