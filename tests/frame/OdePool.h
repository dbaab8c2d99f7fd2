// ODE's own thread pool, which serves a threading implementation, as its demos set it up. Given back in parts, since the order in
// which a program does that is its own.
#pragma once

#include <ode/ode.h>

class OdePool {
public:
    explicit OdePool(unsigned threads = 3)
        : m_threading(dThreadingAllocateMultiThreadedImplementation()),
          m_pool(dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr)) {
        dThreadingThreadPoolServeMultiThreadedImplementation(m_pool, m_threading);
    }

    void lendTo(dWorldID world) const {
        dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(m_threading), m_threading);
    }
    static void takeFrom(dWorldID world) { dWorldSetStepThreadingImplementation(world, nullptr, nullptr); }

    dThreadingImplementationID threading() const { return m_threading; }

    void shutDown() const { dThreadingImplementationShutdownProcessing(m_threading); }
    void freePool() const { dThreadingFreeThreadPool(m_pool); }
    void freeThreading() const { dThreadingFreeImplementation(m_threading); }

private:
    dThreadingImplementationID m_threading;
    dThreadingThreadPoolID m_pool;
};
