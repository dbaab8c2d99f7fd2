// The functions that programs call in the place of ODE's own. Each calls that one, with the same arguments, and holds nothing
// meanwhile: it may call back, jump or throw.
#include "observed_calls.h"

#include <cerrno>
#include <chrono>

#include "observer.h"

namespace {

using observer::Call;
using observer::libraryOf;

// What the program sees of errno is ODE's.
class KeptErrno {
public:
    KeptErrno() : m_value(errno) {}
    ~KeptErrno() { errno = m_value; }
    KeptErrno(const KeptErrno &) = delete;
    KeptErrno &operator=(const KeptErrno &) = delete;

private:
    const int m_value;
};

int step(Call call, dxWorld *world, double stepSize, const void *caller) {
    using Clock = std::chrono::steady_clock;
    const observer::OdeLibrary &library = libraryOf(caller);
    const Clock::time_point start = Clock::now();
    const int result = library.real<int(dxWorld *, double)>(call)(world, stepSize);
    const Clock::time_point end = Clock::now();
    const KeptErrno kept;
    if (world != nullptr)
        observer::theObserver().stepped(library, world, {call == Call::WorldQuickStep, result, stepSize}, end - start);
    return result;
}

}  // namespace

extern "C" {

[[gnu::visibility("default")]] dxWorld *dWorldCreate() {
    const observer::OdeLibrary &library = libraryOf(__builtin_return_address(0));
    dxWorld *const world = library.real<dxWorld *()>(Call::WorldCreate)();
    const KeptErrno kept;
    observer::theObserver().worldCreated(library, world);
    return world;
}

[[gnu::visibility("default")]] void dWorldDestroy(dxWorld *world) {
    const observer::OdeLibrary &library = libraryOf(__builtin_return_address(0));
    observer::theObserver().worldDestroyed(world);  // before another one can have its address
    library.real<void(dxWorld *)>(Call::WorldDestroy)(world);
}

[[gnu::visibility("default")]] dxBody *dBodyCreate(dxWorld *world) {
    const observer::OdeLibrary &library = libraryOf(__builtin_return_address(0));
    dxBody *const body = library.real<dxBody *(dxWorld *)>(Call::BodyCreate)(world);
    const KeptErrno kept;
    if (body != nullptr) observer::theObserver().bodyCreated(library, world, body);
    return body;
}

[[gnu::visibility("default")]] void dBodyDestroy(dxBody *body) {
    const observer::OdeLibrary &library = libraryOf(__builtin_return_address(0));
    if (body != nullptr) observer::theObserver().bodyDestroyed(library.bodyGetWorld(body), body);
    library.real<void(dxBody *)>(Call::BodyDestroy)(body);
}

[[gnu::visibility("default")]] int dWorldStep(dxWorld *world, double stepSize) {
    return step(Call::WorldStep, world, stepSize, __builtin_return_address(0));
}

[[gnu::visibility("default")]] int dWorldQuickStep(dxWorld *world, double stepSize) {
    return step(Call::WorldQuickStep, world, stepSize, __builtin_return_address(0));
}

}  // extern "C"

namespace observer {

void *const kObservedCalls[kCalls] = {reinterpret_cast<void *>(dWorldCreate), reinterpret_cast<void *>(dWorldDestroy),
                                      reinterpret_cast<void *>(dBodyCreate),  reinterpret_cast<void *>(dBodyDestroy),
                                      reinterpret_cast<void *>(dWorldStep),   reinterpret_cast<void *>(dWorldQuickStep)};

}  // namespace observer
