// Lets others have a lock in between, however that ends.
#pragma once

#include <mutex>

template <typename Mutex>
class dxUnlocked {
public:
    explicit dxUnlocked(std::unique_lock<Mutex> &lock) : m_lock(lock) { m_lock.unlock(); }
    ~dxUnlocked() { m_lock.lock(); }
    dxUnlocked(const dxUnlocked &) = delete;
    dxUnlocked &operator=(const dxUnlocked &) = delete;

private:
    std::unique_lock<Mutex> &m_lock;
};
