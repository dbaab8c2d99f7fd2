#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>

#include "surroundings.h"

namespace {

std::atomic<int> threadsAllowed{1 << 20};

}  // namespace

// The system's, which the library's call would have gone to. (Root's processes are not bound by
// RLIMIT_NPROC.)
extern "C" int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*body)(void *),
                              void *context) {
    using Create = int(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    static Create *const systems = reinterpret_cast<Create *>(dlsym(RTLD_NEXT, "pthread_create"));
    return threadsAllowed.fetch_sub(1) > 0 ? systems(thread, attributes, body, context) : EAGAIN;
}

namespace faults {

std::uint64_t withoutThreads() {
    threadsAllowed = 0;
    const std::uint64_t hash = playFrames();
    if (threadsAllowed == 0 && hash != playFrames()) return 0;
    threadsAllowed = 1;
    return hash == playFrames() ? hash : 0;
}

}  // namespace faults
