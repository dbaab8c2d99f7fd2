// dCollide and dCreateGeomClass (ode/collision.h), guarded for several threads of the user.
//
// The first time that two classes meet of which one is the user's, upstream asks for the collider and
// writes it into a plain global table. Two threads colliding such geoms in worlds of their own would race
// for that entry, so the first meeting of a pair of classes happens under a lock; every later one, and
// every pair of built-in classes, goes straight through (contract C7).
#include <ode/collision.h>

#include <atomic>
#include <mutex>

#include "api/user_classes.h"
#include "config.h"
#include "collision_kernel.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_kernel.h.
int dxUpstreamCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip);
int dxUpstreamCreateGeomClass(const dGeomClass *description);
}

namespace {

struct Dispatch {
    std::recursive_mutex mutex;  // recursive: a collider of the user may call dCollide for its parts
    std::atomic<bool> resolved[dGeomNumClasses][dGeomNumClasses];
};

Dispatch &dispatch() {
    static Dispatch *const instance = new Dispatch{};  // never destroyed: threads may collide at exit
    return *instance;
}

bool isUserClass(int type) { return type >= dFirstUserClass && type <= dLastUserClass; }

bool isFirstMeeting(dGeomID o1, dGeomID o2) {
    return (isUserClass(o1->type) || isUserClass(o2->type)) && o1->type >= 0 && o2->type >= 0 &&
           o1->type < dGeomNumClasses && o2->type < dGeomNumClasses &&
           !dispatch().resolved[o1->type][o2->type].load(std::memory_order_acquire);
}

// Upstream answers these without looking at the table.
bool isAnsweredEarly(dGeomID o1, dGeomID o2, int flags) {
    return (flags & NUMC_MASK) == 0 || o1 == o2 || (o1->body == o2->body && o1->body != nullptr);
}

int collideFirstTime(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip) {
    std::lock_guard<std::recursive_mutex> lock(dispatch().mutex);
    const int count = dxUpstreamCollide(o1, o2, flags, contact, skip);
    if (!isAnsweredEarly(o1, o2, flags)) {
        dispatch().resolved[o1->type][o2->type].store(true, std::memory_order_release);
        dispatch().resolved[o2->type][o1->type].store(true, std::memory_order_release);
    }
    return count;
}

}  // namespace

void dxForgetUserClasses() {
    for (auto &row : dispatch().resolved) {
        for (std::atomic<bool> &resolved : row) resolved.store(false, std::memory_order_relaxed);
    }
}

extern "C" {

int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip) {
    if (o1 != nullptr && o2 != nullptr && isFirstMeeting(o1, o2)) {
        return collideFirstTime(o1, o2, flags, contact, skip);
    }
    return dxUpstreamCollide(o1, o2, flags, contact, skip);
}

int dCreateGeomClass(const dGeomClass *description) {
    std::lock_guard<std::recursive_mutex> lock(dispatch().mutex);
    return dxUpstreamCreateGeomClass(description);
}

}  // extern "C"
