#include "dxForkListener.h"

#include <pthread.h>

#include <mutex>

struct dxForkListeners {
    std::mutex lock;  // held across fork, so that the child finds the list whole
    dxForkListener *first = nullptr;
    bool registered = false;

    void add(dxForkListener &listener);
    static void remove(dxForkListener &listener);
    static void prepare();
    static void parent();
    static void child();
};

namespace {
dxForkListeners listeners;
}

void dxForkListeners::add(dxForkListener &listener) {
    if (!registered) registered = pthread_atfork(prepare, parent, child) == 0;
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
    listeners.lock.lock();
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->beforeFork();
}

void dxForkListeners::parent() {
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->inForkingParent();
    listeners.lock.unlock();
}

void dxForkListeners::child() {
    for (dxForkListener *l = listeners.first; l != nullptr; l = l->next) l->inForkedChild();
    listeners.lock.unlock();
}

void dxForkListener::listenToForks() {
    const std::lock_guard<std::mutex> hold(listeners.lock);
    listeners.add(*this);
}

void dxForkListener::ignoreForks() {
    const std::lock_guard<std::mutex> hold(listeners.lock);
    dxForkListeners::remove(*this);
}
