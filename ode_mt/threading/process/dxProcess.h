// What the library keeps for the process: pools, caches, measurements, settings. Each is a dxProcessObject beside the code that uses it. dxProcess
// knows those that have been made, and has them free what they keep when the library is closed or unloaded.
//
// They belong to the process because ODE's API has no context: neither dInitODE nor dWorldCreate says whose they are.
//
// Threading: any thread may make an object at any time.
//
// Dropped: static variables of functions. While a thread makes one, the compiler's guard is locked. A child forked at that moment inherits the locked
// guard, and its own first use waits for ever. Here a lock that is held across fork takes the guard's place.
#pragma once

#include <atomic>
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "threading/process/dxFork.h"

class dxProcess {
public:
    // Calls atClose() of each object that has it, the latest one first. Called by the last dCloseODE. Requires that no step and no collision is in
    // progress.
    static void close();

    // Calls atUnload() of each object that has it. Called before the library is unloaded, and when the process ends; then other threads may still
    // step and collide.
    static void unload();

private:
    template <class Object>
    friend class dxProcessObject;

    // An object that has something to free. `close` and `unload` are null where it has nothing.
    struct Member {
        void *object;
        void (*close)(void *);
        void (*unload)(void *);
        Member *next;
    };

    template <class Object, class = void>
    struct Closing : std::false_type {};
    template <class Object>
    struct Closing<Object, std::void_t<decltype(std::declval<Object &>().atClose())>> : std::true_type {};
    template <class Object, class = void>
    struct Unloading : std::false_type {};
    template <class Object>
    struct Unloading<Object, std::void_t<decltype(std::declval<Object &>().atUnload())>> : std::true_type {};

    // Requires dxForkLocks::creation.
    template <class Object>
    static void own(Object &object, Member &member) {
        member.object = &object;
        if constexpr (Closing<Object>::value) member.close = [](void *own) { static_cast<Object *>(own)->atClose(); };
        if constexpr (Unloading<Object>::value) member.unload = [](void *own) { static_cast<Object *>(own)->atUnload(); };
        if constexpr (Closing<Object>::value || Unloading<Object>::value) add(member);
    }

    static void add(Member &member);

    static std::atomic<Member *> s_latest;  // members are added and never removed
};

// An object of which the process has one. It is made at its first use, by whichever thread comes first, and never destroyed, since other threads may
// step and collide while the process ends.
//
// Usage: at namespace scope, `dxProcessObject<Object> object;` (constant-initialised, so usable before main); then `object->` and `*object`. A type
// may have `void atClose()` and `void atUnload()` (dxProcess). An object may use others while it is made, but must not wait for a thread that does.
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
