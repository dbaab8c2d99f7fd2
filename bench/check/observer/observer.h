// What the observer knows of this process: its worlds, the bodies of each by order of creation, and how many steps each has made.
//
// Threads may step worlds of their own at the same time. The lock is held while the list of worlds is searched or changed and while
// a step is written, not while states are read: during a call that changes a world nobody else may use it (ODE's own rule).
#pragma once

#include <pthread.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "ode_library.h"
#include "record_file.h"

namespace observer {

class Observer {
public:
    void worldCreated(const OdeLibrary &library, dxWorld *world);
    void worldDestroyed(dxWorld *world);
    void bodyCreated(const OdeLibrary &library, dxWorld *world, dxBody *body);
    void bodyDestroyed(dxWorld *world, dxBody *body);

    struct StepCall {
        bool isQuickStep;
        int result;
        double stepSize;
    };
    void stepped(const OdeLibrary &library, dxWorld *world, const StepCall &call, std::chrono::nanoseconds duration);

    // fork: a child has the worlds of its parent, and a record of its own.
    void beforeFork() { m_mutex.lock(); }
    void afterForkInParent() { m_mutex.unlock(); }
    void afterForkInChild();
    // The end of the process.
    void ending();

private:
    struct Body {
        dxBody *id;  // null: destroyed
        std::uint64_t number;
    };
    struct World {
        std::uint32_t number = 0;
        std::uint64_t steps = 0, bodiesCreated = 0;
        std::vector<Body> bodies;
        std::unordered_map<dxBody *, std::size_t> places;  // in `bodies`, of those that are not destroyed
    };

    void openFile(const OdeLibrary &library);
    World &add(const OdeLibrary &library, dxWorld *world);
    World &find(const OdeLibrary &library, dxWorld *world);
    void record(const OdeLibrary &library, World &world, const StepCall &call);
    static void leaveOutDestroyed(World &world);

    std::mutex m_mutex;
    std::unordered_map<dxWorld *, std::unique_ptr<World>> m_worlds;
    std::uint32_t m_worldsCreated = 0;
    pthread_t m_maker{};  // of the first world
    bool m_hasOneMaker = true;
    RecordFile m_file;
};

// Lives as long as the process.
Observer &theObserver();

}  // namespace observer
