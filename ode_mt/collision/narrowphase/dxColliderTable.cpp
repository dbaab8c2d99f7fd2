#include "collision/narrowphase/dxColliderTable.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <utility>

#include "config.h"
#include "collision_kernel.h"
#include "seams/upstream.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace {

std::atomic<bool> overridden[dGeomNumClasses][dGeomNumClasses] = {};

// The entry of upstream's table for two classes, as far as it matters here. Upstream never overwrites a
// collider when a class is created: those of spaces, of geom transforms and those set by the user stay, and
// the class is not asked.
enum class Entry : std::uint8_t {
    none,       // no collider: a class that is created later and is one of the two will be asked
    other,      // a collider of upstream's or of the user's
    asksFirst,  // the first of the two classes will be asked when they meet
    asksSecond  // the second one will be asked
};

struct Dispatch {
    dxForkSafeMutex mutex;
    std::atomic<unsigned> classes{0};
    std::atomic<dGetColliderFnFn *> getters[dMaxUserClasses] = {};
    std::atomic<Entry> entries[dGeomNumClasses][dGeomNumClasses];

    Dispatch() { forget(); }

    void atClose() {
        dxColliderTable::forget();
        classes = 0;
    }

    void set(int type1, int type2, Entry entry, Entry reversed) {
        entries[type2][type1].store(reversed, std::memory_order_release);
        entries[type1][type2].store(entry, std::memory_order_release);
    }
    // Fills the table as upstream does, as far as user classes are concerned.
    void forget() {
        for (std::atomic<dGetColliderFnFn *> &getter : getters) getter = nullptr;
        const auto isFilled = [](int type) {
            return dIN_RANGE(type, dFirstSpaceClass, dLastSpaceClass + 1) || type == dGeomTransformClass;
        };
        for (int type1 = 0; type1 < dGeomNumClasses; ++type1)
            for (int type2 = 0; type2 < dGeomNumClasses; ++type2)
                entries[type1][type2] = isFilled(type1) || isFilled(type2) ? Entry::other : Entry::none;
    }
};

dxProcessObject<Dispatch> dispatch;

dGetColliderFnFn *getterOf(int type) {
    return type >= dFirstUserClass && type <= dLastUserClass
               ? dispatch->getters[type - dFirstUserClass].load(std::memory_order_acquire)
               : nullptr;
}

bool asks(Entry entry) { return entry == Entry::asksFirst || entry == Entry::asksSecond; }

void write(int type1, int type2, dColliderFn *collider) {
    const std::lock_guard<dxForkSafeMutex> lock(dispatch->mutex);
    if (!asks(dispatch->entries[type1][type2].load(std::memory_order_relaxed))) return;
    dxUpstreamSetColliderOverride(type1, type2, collider);
    const Entry entry = collider != nullptr ? Entry::other : Entry::none;
    dispatch->set(type1, type2, entry, entry);
}

// Upstream itself calls this function where its collider of spaces calls upstream's own dCollide for the geoms in them. So what upstream writes is
// known here, and is the same as what is written here.
template <int user>
dColliderFn *askForUpstream(int other) {
    constexpr int type = dFirstUserClass + user;
    dColliderFn *const collider = getterOf(type)(other);
    const bool otherIsUsers = getterOf(other) != nullptr && other != type;
    const bool othersTurnIsToCome =
        otherIsUsers && dispatch->entries[type][other].load(std::memory_order_acquire) == Entry::asksFirst;
    if (collider != nullptr || !othersTurnIsToCome) write(type, other, collider);
    return collider;
}

dGetColliderFnFn *const askers[dMaxUserClasses] = {&askForUpstream<0>, &askForUpstream<1>, &askForUpstream<2>,
                                                   &askForUpstream<3>};

bool areClasses(int type1, int type2) {
    return type1 >= 0 && type1 < dGeomNumClasses && type2 >= 0 && type2 < dGeomNumClasses;
}

}  // namespace

// The class that the table names is asked for the other one; then the other, if it is the
// user's: the same as upstream.
void dxColliderTable::resolve(int type1, int type2) {
    if (!areClasses(type1, type2)) return;
    const Entry entry = dispatch->entries[type1][type2].load(std::memory_order_acquire);
    if (!asks(entry)) return;
    if (entry == Entry::asksSecond) std::swap(type1, type2);
    dGetColliderFnFn *const first = getterOf(type1), *const other = getterOf(type2);
    if (dColliderFn *collider = first != nullptr ? first(type2) : nullptr) {
        write(type1, type2, collider);
        return;
    }
    write(type2, type1, other != nullptr ? other(type1) : nullptr);
}

int dxColliderTable::createClass(const dGeomClass *description) {
    // Without the lock: upstream reports an error to a handler that may never return.
    const bool wrong = description == nullptr || description->bytes < 0 || !description->collider ||
                       !description->aabb || dispatch->classes.load() >= dMaxUserClasses;
    if (wrong) return dxUpstreamCreateGeomClass(description);
    const std::lock_guard<dxForkSafeMutex> lock(dispatch->mutex);
    dGeomClass known = *description;
    known.collider = askers[dispatch->classes.load()];
    const int type = dxUpstreamCreateGeomClass(&known);
    dispatch->getters[type - dFirstUserClass].store(description->collider, std::memory_order_release);
    for (int other = 0; other < dGeomNumClasses; ++other)
        if (dispatch->entries[type][other].load(std::memory_order_relaxed) == Entry::none)
            dispatch->set(type, other, Entry::asksFirst,
                          other == type ? Entry::asksFirst : Entry::asksSecond);
    ++dispatch->classes;
    return type;
}

void dxColliderTable::setOverride(int type1, int type2, dColliderFn *collider) {
    dxUpstreamSetColliderOverride(type1, type2, collider);
    if (!areClasses(type1, type2)) return;
    overridden[type1][type2] = overridden[type2][type1] = true;
    const Entry entry = collider != nullptr ? Entry::other : Entry::none;
    dispatch->set(type1, type2, entry, entry);
}

void dxColliderTable::forget() {
    dispatch->forget();
    for (auto &row : overridden) {
        for (std::atomic<bool> &entry : row) entry.store(false, std::memory_order_relaxed);
    }
}

bool dxColliderOverrides::has(int type1, int type2) {
    return overridden[type1][type2].load(std::memory_order_relaxed);
}
