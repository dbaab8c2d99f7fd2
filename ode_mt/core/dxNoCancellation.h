// pthread_cancel does not end the calling thread while one of these lives.
//
// Upstream has no cancellation point in what it computes: a request stays pending until the program's own next one. Ours joins
// threads and sleeps, which are cancellation points, often where an object is destroyed, out of which nothing may unwind.
// Not to be held while user code runs.
#pragma once

#include <pthread.h>

class dxNoCancellation {
public:
    dxNoCancellation() { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &m_before); }
    ~dxNoCancellation() {
        int ours;
        pthread_setcancelstate(m_before, &ours);
    }
    dxNoCancellation(const dxNoCancellation &) = delete;
    dxNoCancellation &operator=(const dxNoCancellation &) = delete;

private:
    int m_before = PTHREAD_CANCEL_ENABLE;
};
