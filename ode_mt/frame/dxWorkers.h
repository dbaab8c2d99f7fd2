// The process's thread manager: resized by dToggleODE_MT, exchanged by name, its threads ended by dCloseODE
// and when the library is unloaded. A manager starts threads only for runs that use them.
//
// Process-wide, because threads are a property of the process: steps of several worlds at the same time
// borrow the same workers.
#pragma once

#include <memory>
#include <shared_mutex>
#include <string>

#include "threading/dxForkListener.h"
#include "threading/dxProcessObject.h"
#include "threading/dxThreadManager.h"

class dxWorkers final : private dxForkListener {
public:
    static dxWorkers &instance();

    void run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

    // Makes the pool as large as dxSettings says. Waits for runs in progress.
    void resize();

    bool choose(const std::string &name);  // false: unknown, reported with dMessage
    const char *name();

    // Ends all threads; the next run starts them again.
    void stop();

private:
    friend class dxProcessObject<dxWorkers>;
    dxWorkers();
    ~dxWorkers() = default;
    void inForkedChild() override;

    std::shared_mutex m_mutex;  // shared: runs; exclusive: everything that changes the manager
    std::unique_ptr<dxThreadManager> m_manager;
};
