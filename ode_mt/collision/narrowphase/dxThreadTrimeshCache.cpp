// The scratch data of upstream's mesh colliders, one for each thread that collides meshes.
//
// Upstream has one for the whole process, unless it is built with thread-local storage, which would change
// what callers see. The cache is made at a thread's first use and freed when the thread ends, when the
// library is closed by the last user, or when it is unloaded. It does not use a C++ thread_local object:
// that would keep the library from being unloaded.
#include <pthread.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

#include "config.h"
#include "collision_util.h"
#include "collision_trimesh_internal.h"

namespace {

class Registry {
public:
    Registry() { createKey(); }

    TrimeshCollidersCache *ofThisThread() {
        if (m_key)
            if (void *cache = pthread_getspecific(*m_key)) return static_cast<TrimeshCollidersCache *>(cache);
        const std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        TrimeshCollidersCache *const cache = findOrMake(pthread_self());
        if (m_key) pthread_setspecific(*m_key, cache);  // if it is refused, the cache is found by its thread
        return cache;
    }

    // A new key is empty in every thread, so that none keeps the address of a freed cache, and the old
    // one no longer calls into a library that is being unloaded.
    void atClose() {
        const std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        m_caches.clear();
        deleteKey();
        createKey();
    }

    // Caches of other threads stay: if the process ends, one of these may be in the middle of a collision.
    void atUnload() {
        const std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        dropIf([](const Owned &owned) { return pthread_equal(owned.thread, pthread_self()) != 0; });
        m_caches.shrink_to_fit();
        deleteKey();
    }

private:
    struct Owned {
        pthread_t thread;
        std::unique_ptr<TrimeshCollidersCache> cache;
    };

    // Finds the cache by the thread's number, so that a thread without a key has one too. A new thread may take over the cache of an ended one that
    // had the same number.
    TrimeshCollidersCache *findOrMake(pthread_t thread) {
        for (const Owned &owned : m_caches)
            if (pthread_equal(owned.thread, thread)) return owned.cache.get();
        m_caches.push_back({thread, std::make_unique<TrimeshCollidersCache>()});
        return m_caches.back().cache.get();
    }

    template <class Condition>
    void dropIf(Condition condition) {
        m_caches.erase(std::remove_if(m_caches.begin(), m_caches.end(), condition), m_caches.end());
    }

    void forget(const void *cache) {
        const std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        dropIf([cache](const Owned &owned) { return owned.cache.get() == cache; });
    }

    // Creates no key if the program has taken all that a process can have.
    void createKey() {
        pthread_key_t key;
        if (pthread_key_create(&key, threadEnded) == 0) m_key = key;
    }

    void deleteKey() {
        if (m_key) pthread_key_delete(*m_key);
        m_key.reset();
    }

    static void threadEnded(void *cache);

    dxForkSafeMutex m_mutex;
    std::vector<Owned> m_caches;
    std::optional<pthread_key_t> m_key;  // none: the caches are found under the lock, and stay until dCloseODE
};

dxProcessObject<Registry> registry;

void Registry::threadEnded(void *cache) { registry->forget(cache); }

}  // namespace

// Seam: takes the place of upstream's variable g_ccTrimeshCollidersCache.
TrimeshCollidersCache *dxThreadTrimeshCollidersCache() { return registry->ofThisThread(); }
