#include "collision/dxThreadTrimeshCache.h"

#include <pthread.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "threading/dxForkLocks.h"
#include "threading/dxProcessObject.h"

#include "config.h"
#include "collision_util.h"
#include "collision_trimesh_internal.h"

namespace {

class Registry {
public:
    Registry() { pthread_key_create(&m_key, threadEnded); }

    TrimeshCollidersCache *ofThisThread() {
        if (void *cache = pthread_getspecific(m_key)) return static_cast<TrimeshCollidersCache *>(cache);
        std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        m_caches.push_back(std::make_unique<TrimeshCollidersCache>());
        pthread_setspecific(m_key, m_caches.back().get());
        return m_caches.back().get();
    }

    // A new key is empty in every thread, so that none keeps the address of a freed cache, and the old
    // one no longer calls into a library that is being unloaded.
    void release() {
        std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        m_caches.clear();
        pthread_key_delete(m_key);
        pthread_key_create(&m_key, threadEnded);
    }

    void unload() {
        std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        m_caches.clear();
        pthread_key_delete(m_key);
    }

private:
    void forget(const void *cache) {
        std::lock_guard<dxForkSafeMutex> lock(m_mutex);
        m_caches.erase(std::remove_if(m_caches.begin(), m_caches.end(),
                                      [cache](const auto &own) { return own.get() == cache; }),
                       m_caches.end());
    }

    static void threadEnded(void *cache);

    dxForkSafeMutex m_mutex;
    std::vector<std::unique_ptr<TrimeshCollidersCache>> m_caches;
    pthread_key_t m_key;
};

dxProcessObject<Registry> registry;

void Registry::threadEnded(void *cache) { registry->forget(cache); }

}  // namespace

// Seam: takes the place of upstream's variable g_ccTrimeshCollidersCache.
TrimeshCollidersCache *dxThreadTrimeshCollidersCache() { return registry->ofThisThread(); }

void dxThreadTrimeshCache::release() { registry->release(); }

void dxThreadTrimeshCache::unload() { registry->unload(); }
