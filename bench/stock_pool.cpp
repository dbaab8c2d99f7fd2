#include "stock_pool.h"

#include <stdexcept>

namespace bench {

StockPool::StockPool(const scenes::Inventory &inventory, unsigned threads)
    : m_worlds(inventory.worlds),
      m_threading(dThreadingAllocateMultiThreadedImplementation()),
      m_pool(dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr)) {
    if (!m_threading || !m_pool) throw std::runtime_error("this libode.so.8 has no thread pool");
    dThreadingThreadPoolServeMultiThreadedImplementation(m_pool, m_threading);
    for (dWorldID world : m_worlds)
        dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(m_threading),
                                             m_threading);
}

StockPool::~StockPool() {
    dThreadingImplementationShutdownProcessing(m_threading);
    dThreadingFreeThreadPool(m_pool);
    for (dWorldID world : m_worlds) dWorldSetStepThreadingImplementation(world, nullptr, nullptr);
    dThreadingFreeImplementation(m_threading);
}

}  // namespace bench
