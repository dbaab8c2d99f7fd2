// Upstream's own thread pool, lent to all worlds of a scene while this object lives.
#pragma once

#include "scenes/scene.h"

namespace bench {

class StockPool {
public:
    // Throws std::runtime_error if the library was built without threads.
    StockPool(const scenes::Inventory &inventory, unsigned threads);
    ~StockPool();
    StockPool(const StockPool &) = delete;
    StockPool &operator=(const StockPool &) = delete;

private:
    std::vector<dWorldID> m_worlds;
    dThreadingImplementationID m_threading;
    dThreadingThreadPoolID m_pool;
};

}  // namespace bench
