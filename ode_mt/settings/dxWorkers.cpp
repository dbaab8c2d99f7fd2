#include "settings/dxWorkers.h"

#include <ode/error.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include "core/dxEnvironment.h"
#include "core/dxLog.h"
#include "settings/dxLentThreads.h"
#include "settings/dxOwnThreads.h"
#include "settings/dxSettings.h"
#include "threading/managers/dxThreadManagerFactory.h"
#include "threading/pool/dxJobBoard.h"

namespace {

dxProcessObject<dxWorkers> workers;

constexpr const char *kLentName = "user";  // while threads are lent

// The factory's own text for the name, which lives as long as the library; null: unknown.
const char *findName(const std::string &name) {
    const std::vector<const char *> names = dxThreadManagerFactory::names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? *found : nullptr;
}

unsigned wantedSize() { return std::max({dxSettings::instance().threads(), dxOwnThreads::largest(), 1u}); }

// The default manager, and its name, where the one asked for cannot be made.
std::unique_ptr<dxThreadManager> make(const char *&name, const dxWorkerOptions &options) {
    std::unique_ptr<dxThreadManager> manager = dxThreadManagerFactory::create(name, options);
    if (manager == nullptr) {
        name = dxThreadManagerFactory::defaultName();
        manager = dxThreadManagerFactory::create(name, options);
    }
    manager->resize(wantedSize());
    dxLog(dxLogLevel::Info, "thread manager %s: up to %u threads, the caller included", name, wantedSize());
    return manager;
}

// An executor lends as many threads as are wanted; an implementation has a number of its own.
std::shared_ptr<dxThreadManager> makeLent(const dxThreadLender &lender) {
    const std::shared_ptr<dxThreadManagerUser> manager = dxLentThreads::managerOf(lender);
    if (lender.executor != nullptr && manager->limit() != wantedSize()) manager->resize(wantedSize());
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
    dxLog(dxLogLevel::Warning, "ODE_MT_THREAD_MANAGER is '%.100s'; known: %s; %s is taken", name, dxThreadManagerFactory::knownNames().c_str(),
          m_name);
}

// Without memory for a manager the caller works alone, and so does a worker in its hook.
void dxWorkers::run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context) {
    if (dxWorkerHooks::isInside()) return dxRunAlone(blocks, task, context);
    Manager manager;
    try {
        manager = current();
    } catch (const std::bad_alloc &) {
        return dxRunAlone(blocks, task, context);
    }
    manager->run(blocks, workers, task, context);
}

dxWorkers::Manager dxWorkers::current() {
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (m_manager != nullptr) return m_manager;
    }
    return makeCurrent();
}

// Of two threads that make a manager at the same time one has its own for this run alone.
dxWorkers::Manager dxWorkers::makeCurrent() {
    const char *name;
    dxThreadLender lender;
    dxWorkerOptions options;
    unsigned choice;
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        name = m_name;
        lender = m_lender;
        options = m_options;
        choice = m_choice;
    }
    if (!lender.isNone()) {
        Manager lent = makeLent(lender);
        if (m_choice != choice) dxLentThreads::giveBack(lender);  // it was taken back before its manager was made
        return lent;
    }
    Manager made = make(name, options);
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (m_manager != nullptr || m_choice != choice) return made;
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
    if (now->workers() == wantedSize()) {
        if (!dxWorkerHooks::isInside()) now->resize(now->workers());
    } else if (mayEndWorkers()) {
        stop();
    }
}

bool dxWorkers::choose(const std::string &name) {
    const char *const known = findName(name);
    if (known == nullptr) {
        dMessage(0, "ODE_MT: no thread manager '%s'; known: %s", name.c_str(), dxThreadManagerFactory::knownNames().c_str());
        return false;
    }
    if (const char *const missing = dxThreadManagerFactory::missingLibrary(name)) {
        dMessage(0, "ODE_MT: thread manager '%s' needs %s, which cannot be loaded", known, missing);
        return false;
    }
    if (!mayEndWorkers()) return false;
    if (!dxThreadManagerFactory::takesOptions(known) && hasOptions()) {
        dMessage(0, "ODE_MT: thread manager '%s' has threads of its runtime, which start in its own way: options of workers are set", known);
        return false;
    }
    exchange([this, known] {
        m_name = known;
        m_lender = {};
    });
    return true;
}

bool dxWorkers::hasOptions() {
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    return !m_options.areDefault();
}

bool dxWorkers::lend(const dxThreadLender &lender) {
    if (!mayEndWorkers()) return false;
    if (!lender.isNone()) dxLentThreads::lend(lender);
    exchange([this, &lender] { m_lender = lender; });
    return true;
}

bool dxWorkers::changeOptions(const char *what, const std::function<void(dxWorkerOptions &)> &change) {
    if (!mayEndWorkers()) return false;
    dxWorkerOptions wanted;
    const char *name;
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        wanted = m_options;
        name = m_name;
    }
    if (!dxThreadManagerFactory::takesOptions(name)) {
        dMessage(0, "ODE_MT: %s cannot be set: thread manager '%s' has threads of its runtime, which start in its own way", what, name);
        return false;
    }
    change(wanted);
    if (const int refusal = dxTryWorker(wanted)) {
        dMessage(0, "ODE_MT: %s cannot be set: %s", what, std::strerror(refusal));
        return false;
    }
    exchange([this, &change] { change(m_options); });
    return true;
}

std::string dxWorkers::threadName() {
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    return m_options.name;
}

const char *dxWorkers::name() {
    const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
    return m_lender.isNone() ? m_name : kLentName;
}

void dxWorkers::stop() {
    if (!mayEndWorkers()) return;
    exchange([] {});
}

// What is given up ends after the lock.
void dxWorkers::exchange(const std::function<void()> &change) {
    Manager before;
    dxThreadLender lender;
    {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        lender = m_lender;
        change();
        ++m_choice;
        m_manager.swap(before);
    }
    before.reset();
    if (!lender.isNone()) dxLentThreads::giveBack(lender);
}

bool dxWorkers::mayEndWorkers() const {
    if (!dxWorkerHooks::isInside()) return true;
    dMessage(0, "ODE_MT: a hook of a worker cannot end workers; they go on as they are");
    return false;
}
