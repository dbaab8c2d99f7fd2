// A pool of objects that no step uses at the moment. Threading: any thread may take and give back. Taking may throw
// std::bad_alloc, giving back needs no memory: capacity is reserved for all taken objects.
//
// Holds only pointers. The one used last is taken first, since its memory is likely to be in a cache.
// Survives fork.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "threading/process/dxForkLocks.h"

template <class Object>
class dxObjectPool {
public:
    // Null if there is none.
    Object *take() {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const std::size_t all = m_idle.size() + m_taken + 1;
        if (m_idle.capacity() < all) m_idle.reserve(2 * all);
        ++m_taken;
        if (m_idle.empty()) return nullptr;
        Object *object = m_idle.back();
        m_idle.pop_back();
        return object;
    }

    Object *takeOrMake() {
        if (Object *const object = take()) return object;
        try {
            return new Object;
        } catch (...) {
            lose();
            throw;
        }
    }

    // Records that a taken object was destroyed or never constructed.
    void lose() {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        --m_taken;
    }

    void giveBack(Object *object) noexcept {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        --m_taken;
        m_idle.push_back(object);
    }

    template <class Destroy>
    void clear(Destroy destroy) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        for (Object *object : m_idle) destroy(object);
        m_idle.clear();
        if (m_taken == 0) m_idle.shrink_to_fit();
    }

private:
    dxForkSafeMutex m_mutex;
    std::vector<Object *> m_idle;
    std::size_t m_taken = 0;
};

// An object of a pool until the end of the scope. It has the state in which its last user left it.
template <class Object>
class dxPooledObject {
public:
    explicit dxPooledObject(dxObjectPool<Object> &pool) : m_pool(pool), m_object(pool.takeOrMake()) {}
    ~dxPooledObject() { m_pool.giveBack(m_object); }
    dxPooledObject(const dxPooledObject &) = delete;
    dxPooledObject &operator=(const dxPooledObject &) = delete;

    Object &operator*() const { return *m_object; }
    Object *operator->() const { return m_object; }

private:
    dxObjectPool<Object> &m_pool;
    Object *const m_object;
};
