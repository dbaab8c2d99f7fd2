#include "dynamics/dxRowMemory.h"

#include "dynamics/dxIdlePool.h"
#include "threading/dxProcessObject.h"

namespace {

dxProcessObject<dxIdlePool<std::vector<dxSweepRow>>> pool;

}  // namespace

dxSweepRow *dxRowMemory::take(std::size_t rows) {
    giveBack();
    m_borrowed = pool->takeOrMake();
    if (m_borrowed->size() < rows) {
        m_borrowed->clear();  // what is in there need not be moved
        m_borrowed->resize(rows + rows / 5);
    }
    return m_borrowed->data();
}

void dxRowMemory::giveBack() {
    if (m_borrowed != nullptr) pool->giveBack(m_borrowed);
    m_borrowed = nullptr;
}

void dxRowMemory::forget() {
    pool->clear([](std::vector<dxSweepRow> *rows) { delete rows; });
}
