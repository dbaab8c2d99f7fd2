// The owner of what the library keeps for the process: pools, caches, measurements, settings. Each is a dxProcessObject beside the code that uses it;
// those that have been made are known here, and free what they keep when the library is closed or unloaded.
//
// They belong to the process because ODE's API has no context: neither dInitODE nor dWorldCreate says whose they are.
//
// Threading: any thread may make an object at any time.
#pragma once

#include <atomic>
#include <type_traits>
#include <utility>

template <class Object>
class dxProcessObject;

class dxProcess {
public:
    // The last dCloseODE: calls atClose() of each object that has it, the latest one first. Requires that no step and no collision is in progress.
    static void close();

    // The library is about to be unloaded, or the process ends: calls atUnload() of each object that has it. If the process ends, other threads may
    // still step and collide.
    static void unload();

private:
    template <class Object>
    friend class dxProcessObject;

    // An object that has something to free. `close` and `unload` are null where it has not.
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

    // Under dxForkLocks::creation.
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
