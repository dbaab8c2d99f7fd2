// An object of which the process has one, owned by dxProcess: made at its first use, by whichever thread comes first, and never
// destroyed, since other threads may step and collide while the process ends.
//
// Dropped: static variables of functions. While a thread makes one, the compiler's guard is locked; a child
// forked at that moment inherits the locked guard, and its own first use waits for ever. Here a lock that is
// held across fork takes the guard's place.
//
// Usage: at namespace scope, `dxProcessObject<Object> object;` (constant-initialised, so usable before main);
// then `object->` and `*object`. A type may have `void atClose()` and `void atUnload()` (dxProcess). An object may use others while it is made, but
// must not wait for a thread that does.
#pragma once

#include <atomic>
#include <cstddef>
#include <new>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcess.h"

template <class Object>
class dxProcessObject {
public:
    constexpr dxProcessObject() = default;

    Object &operator*() {
        Object *object = m_object.load(std::memory_order_acquire);
        return object != nullptr ? *object : make();
    }
    Object *operator->() { return &**this; }

private:
    Object &make() {
        const std::lock_guard<std::recursive_mutex> hold(dxForkLocks::creation);
        if (m_object.load(std::memory_order_relaxed) == nullptr)
            publish(new (m_memory) Object);
        return *m_object.load(std::memory_order_relaxed);
    }

    void publish(Object *object) {
        dxProcess::own(*object, m_member);
        m_object.store(object, std::memory_order_release);
    }

    alignas(Object) std::byte m_memory[sizeof(Object)] = {};  // goes with the library when it is unloaded
    std::atomic<Object *> m_object{nullptr};
    dxProcess::Member m_member{};
};
