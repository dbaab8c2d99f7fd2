#include "threading/process/dxFork.h"

#include <chrono>
#include <new>
#include <thread>

namespace dxForkLocks {
std::recursive_mutex initialisation;
std::recursive_mutex creation;
}  // namespace dxForkLocks

struct dxForkListeners {
    std::mutex lock;
    dxForkListener *first = nullptr;

    void add(dxForkListener &listener);
    static void remove(dxForkListener &listener);
    static void prepare();
    static void parent();
    static void child();
};

namespace {

dxForkListeners listeners;

// A recursive lock knows its owner by a number that the thread no longer has in the child, where unlocking does nothing
// (EPERM) but let ThreadSanitizer know: it is made anew.
void renew(std::recursive_mutex &lock) {
    lock.unlock();
    new (&lock) std::recursive_mutex;
}

// Before any lock of this library can be held.
__attribute__((constructor)) void registerHandlers() {
    pthread_atfork(dxForkListeners::prepare, dxForkListeners::parent, dxForkListeners::child);
}

}  // namespace

void dxForkListeners::add(dxForkListener &listener) {
    listener.next = first;
    listener.link = &first;
    if (first != nullptr) first->link = &listener.next;
    first = &listener;
}

void dxForkListeners::remove(dxForkListener &listener) {
    *listener.link = listener.next;
    if (listener.next != nullptr) listener.next->link = listener.link;
}

void dxForkListeners::prepare() {
    dxForkLocks::initialisation.lock();
    dxForkLocks::creation.lock();
    listeners.lock.lock();
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->beforeFork();
}

void dxForkListeners::parent() {
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->inForkingParent();
    listeners.lock.unlock();
    dxForkLocks::creation.unlock();
    dxForkLocks::initialisation.unlock();
}

void dxForkListeners::child() {
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->inForkedChild();
    listeners.lock.unlock();
    renew(dxForkLocks::creation);
    renew(dxForkLocks::initialisation);
}

// Others hold it for moments. Whoever does not give it back in a second may wait for the thread that forks: a message of the library's is written
// under a lock of the C library's, for example.
void dxForkSafeMutex::beforeFork() {
    constexpr std::chrono::seconds kMost{1};
    constexpr std::chrono::microseconds kPause{20};
    const auto begin = std::chrono::steady_clock::now();
    while (!(m_isHeldToFork = m_mutex.try_lock()) && !isHeldHere() && std::chrono::steady_clock::now() - begin < kMost)
        std::this_thread::sleep_for(kPause);
}

void dxForkSafeMutex::inForkingParent() {
    if (m_isHeldToFork) m_mutex.unlock();
}

// One that another thread holds, which is not there, becomes a new one.
void dxForkSafeMutex::inForkedChild() {
    if (m_isHeldToFork)
        m_mutex.unlock();
    else if (!isHeldHere())
        new (&m_mutex) std::mutex;
}

void dxForkListener::listenToForks() {
    const std::lock_guard<std::mutex> hold(listeners.lock);
    listeners.add(*this);
}

void dxForkListener::ignoreForks() {
    const std::lock_guard<std::mutex> hold(listeners.lock);
    dxForkListeners::remove(*this);
}
