// Is notified of fork(): in the child only the thread that forked exists, so there are no workers, and locks that
// others held stay locked. dxForkLocks.h has what follows from that for locks.
//
// The handlers are registered with pthread_atfork on behalf of this library; the C library drops them
// when the library is unloaded.
#pragma once

class dxForkListener {
public:
    dxForkListener() = default;
    dxForkListener(const dxForkListener &) = delete;
    dxForkListener &operator=(const dxForkListener &) = delete;

    // In the parent, on the thread that forks. Must neither start nor end to listen.
    virtual void beforeFork() {}

    // The same, after the fork.
    virtual void inForkingParent() {}

    // In the child, while it has one thread. Only memory may be touched.
    virtual void inForkedChild() = 0;

protected:
    ~dxForkListener() = default;

    // Last in the constructor and first in the destructor of the class that implements the above, because
    // another thread may fork meanwhile.
    void listenToForks();
    void ignoreForks();

private:
    friend struct dxForkListeners;
    dxForkListener *next = nullptr;
    dxForkListener **link = nullptr;  // what points to this one
};
