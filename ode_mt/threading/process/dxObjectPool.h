// A pool of objects that no step uses at the moment. Taking may throw std::bad_alloc. Giving back needs no memory: there is room for all objects that
// exist.
//
// It holds only pointers. The object used last is taken first, since its memory is likely to be in a cache. It is taken and given back without the
// mutex, which is all that a step on one thread needs. A pool survives fork. dxProcess clears those of dxProcessObjects.
//
// Threading: any thread may take and give back.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "threading/process/dxFork.h"

template <class Object, class Destroy = std::default_delete<Object>>
class dxObjectPool {
public:
    // Returns null if there is none; the caller then makes one, or calls lose().
    Object *take() {
        if (Object *const object = m_last.exchange(nullptr, std::memory_order_acq_rel)) return object;
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (!m_idle.empty()) {
            Object *const object = m_idle.back();
            m_idle.pop_back();
            return object;
        }
        if (m_idle.capacity() <= m_count) m_idle.reserve(2 * (m_count + 1));
        ++m_count;
        return nullptr;
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
        --m_count;
    }

    void giveBack(Object *object) noexcept {
        Object *const before = m_last.exchange(object, std::memory_order_acq_rel);
        if (before == nullptr) return;
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        m_idle.push_back(before);
    }

    // Destroys all that no step uses.
    void clear() {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (Object *const last = m_last.exchange(nullptr, std::memory_order_acq_rel)) m_idle.push_back(last);
        m_count -= m_idle.size();
        for (Object *object : m_idle) Destroy()(object);
        m_idle.clear();
        if (m_count == 0) m_idle.shrink_to_fit();
    }
    void atClose() { clear(); }
    void atUnload() { clear(); }

private:
    std::atomic<Object *> m_last{nullptr};  // the one given back last
    dxForkSafeMutex m_mutex;
    std::vector<Object *> m_idle;  // the others
    std::size_t m_count = 0;  // objects that exist, or are being made
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
