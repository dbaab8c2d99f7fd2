// What is kept beside worlds, since a world is upstream's structure: a value for each of those that have one.
//
// Threading: any thread may call; no two visits run at the same time. Survives fork.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "threading/process/dxForkLocks.h"

struct dxWorld;

template <class Value>
class dxPerWorld {
public:
    // Without a lock: most processes have none.
    bool isEmpty() const { return m_size.load(std::memory_order_acquire) == 0; }

    // Calls visit(value) if the world has one.
    template <class Visit>
    void visit(const dxWorld *world, const Visit &visit) {
        if (isEmpty()) return;
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(world);
        if (found != m_list.end()) visit(found->second);
    }

    // The same, with the value make() if the world has none. Throws std::bad_alloc, and changes nothing then.
    template <class Make, class Visit>
    void visitOrMake(const dxWorld *world, const Make &make, const Visit &visit) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        auto found = find(world);
        if (found == m_list.end()) {
            m_list.emplace_back(world, make());
            found = m_list.end() - 1;
            count();
        }
        visit(found->second);
    }

    // The world is about to be destroyed.
    void forget(const dxWorld *world) {
        forget(world, [](const Value &) {});
    }

    // The same, with visit(value) before if the world has one.
    template <class Visit>
    void forget(const dxWorld *world, const Visit &visit) {
        if (isEmpty()) return;
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(world);
        if (found == m_list.end()) return;
        visit(found->second);
        m_list.erase(found);
        count();
    }

    void clear() {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        m_list.clear();
        count();
    }

private:
    using Entry = std::pair<const dxWorld *, Value>;

    typename std::vector<Entry>::iterator find(const dxWorld *world) {
        return std::find_if(m_list.begin(), m_list.end(), [world](const Entry &entry) { return entry.first == world; });
    }

    void count() {
        if (m_list.empty()) m_list.shrink_to_fit();  // what is kept would be lost with an unloading
        m_size.store(m_list.size(), std::memory_order_release);
    }

    dxForkSafeMutex m_mutex;
    std::vector<Entry> m_list;
    std::atomic<std::size_t> m_size{0};
};
