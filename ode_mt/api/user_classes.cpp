// dCollide and the calls that fill its table (ode/collision.h), guarded for several threads of the user.
//
// The first time that two classes meet of which one is the user's, upstream asks for their collider and
// writes it into a plain global table. Two threads that collide such geoms in worlds of their own would race
// for that entry. Here the entry is written under a lock before upstream looks at it; the user's functions
// run without the lock, so they may take their time, nest, or leave by longjmp (contract C7).
#include <ode/collision.h>

#include <atomic>
#include <mutex>
#include <utility>

#include "api/user_classes.h"
#include "collision/dxColliderOverrides.h"
#include "collision/dxContactLog.h"
#include "collision/dxContactsAhead.h"
#include "config.h"
#include "collision_kernel.h"
#include "threading/dxForkLocks.h"
#include "threading/dxProcessObject.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_kernel.h.
int dxUpstreamCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip);
int dxUpstreamCreateGeomClass(const dGeomClass *description);
void dxUpstreamSetColliderOverride(int i, int j, dColliderFn *collider);
}

namespace {

struct Dispatch {
    dxForkSafeMutex mutex;
    std::atomic<unsigned> classes{0};
    std::atomic<dGetColliderFnFn *> getters[dMaxUserClasses] = {};
    std::atomic<bool> resolved[dGeomNumClasses][dGeomNumClasses] = {};
};

dxProcessObject<Dispatch> dispatch;

dGetColliderFnFn *getterOf(int type) {
    return type >= dFirstUserClass && type <= dLastUserClass
               ? dispatch->getters[type - dFirstUserClass].load(std::memory_order_acquire)
               : nullptr;
}

void write(int type1, int type2, dColliderFn *collider) {
    const std::lock_guard<dxForkSafeMutex> lock(dispatch->mutex);
    if (dispatch->resolved[type1][type2].load(std::memory_order_relaxed)) return;
    dxUpstreamSetColliderOverride(type1, type2, collider);
    dispatch->resolved[type1][type2].store(true, std::memory_order_release);
    dispatch->resolved[type2][type1].store(true, std::memory_order_release);
}

// As upstream: the class created first is asked for the other one; then the other, if it is the user's.
void resolve(int type1, int type2) {
    if (getterOf(type1) == nullptr || (getterOf(type2) != nullptr && type2 < type1)) std::swap(type1, type2);
    if (dColliderFn *collider = getterOf(type1)(type2)) {
        write(type1, type2, collider);
        return;
    }
    dGetColliderFnFn *const other = getterOf(type2);
    write(type2, type1, other != nullptr ? other(type1) : nullptr);
}

bool isFirstMeeting(const dxGeom &o1, const dxGeom &o2) {
    return (getterOf(o1.type) != nullptr || getterOf(o2.type) != nullptr) && o1.type >= 0 && o2.type >= 0 &&
           !dispatch->resolved[o1.type][o2.type].load(std::memory_order_acquire);
}

// Upstream answers these without looking at the table.
bool isAnsweredEarly(const dxGeom &o1, const dxGeom &o2, int flags) {
    return (flags & NUMC_MASK) == 0 || &o1 == &o2 || (o1.body == o2.body && o1.body != nullptr);
}

}  // namespace

void dxForgetColliders() {
    for (std::atomic<dGetColliderFnFn *> &getter : dispatch->getters) getter = nullptr;
    dxColliderOverrides::forget();
    for (auto &row : dispatch->resolved) {
        for (std::atomic<bool> &resolved : row) resolved = false;
    }
}

void dxForgetUserClasses() {
    dxForgetColliders();
    dispatch->classes = 0;
}

extern "C" {

int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip) {
    if (dxContactsAhead *const ahead = dxContactsAhead::current()) {
        const int count = ahead->answer(o1, o2, flags, contact, skip);
        if (count >= 0) return count;
    } else if (dxContactLog *const log = dxContactLog::current()) {
        const bool isValid = o1 != nullptr && o2 != nullptr && contact != nullptr;
        if (isValid && !isAnsweredEarly(*o1, *o2, flags) && dxMayCollideAnywhere(*o1, *o2))
            return log->copies().collide(*o1, *o2, flags, contact, skip);
    }
    if (o1 != nullptr && o2 != nullptr && isFirstMeeting(*o1, *o2) && !isAnsweredEarly(*o1, *o2, flags)) {
        resolve(o1->type, o2->type);
    }
    return dxUpstreamCollide(o1, o2, flags, contact, skip);
}

int dCreateGeomClass(const dGeomClass *description) {
    // Upstream reports what is wrong, to a handler that may never return: without the lock.
    const bool wrong = description == nullptr || description->bytes < 0 || !description->collider ||
                       !description->aabb || dispatch->classes.load() >= dMaxUserClasses;
    if (wrong) return dxUpstreamCreateGeomClass(description);
    const std::lock_guard<dxForkSafeMutex> lock(dispatch->mutex);
    const int type = dxUpstreamCreateGeomClass(description);
    dispatch->getters[type - dFirstUserClass].store(description->collider, std::memory_order_release);
    ++dispatch->classes;
    return type;
}

void dSetColliderOverride(int i, int j, dColliderFn *collider) {
    dxUpstreamSetColliderOverride(i, j, collider);
    dxColliderOverrides::note(i, j);
    dispatch->resolved[i][j] = true;
    dispatch->resolved[j][i] = true;
}

}  // extern "C"
