#include "dynamics/dxRowMemory.h"

#include <new>

#include "threading/dxProcessObject.h"

namespace {

dxProcessObject<dxIdlePool<std::vector<dxSweepRow>>> pool;

}  // namespace

dxSweepRow *dxRowMemory::take(std::size_t rows) {
    try {
        std::vector<dxSweepRow> &memory = *m_rows.emplace(*pool);
        if (memory.size() < rows) {
            memory.clear();  // what is in there need not be moved
            memory.resize(rows + rows / 5);
        }
    } catch (const std::bad_alloc &) {
        m_rows.reset();
    }
    return get();
}

void dxRowMemory::forget() {
    pool->clear([](std::vector<dxSweepRow> *rows) { delete rows; });
}
