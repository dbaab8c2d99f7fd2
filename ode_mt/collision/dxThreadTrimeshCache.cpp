#include "collision/dxThreadTrimeshCache.h"

#include <pthread.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "config.h"
#include "collision_util.h"
#include "collision_trimesh_internal.h"

namespace {

class Registry {
public:
    // Never destroyed itself: threads may end after the process has begun to.
    static Registry &instance() {
        static Registry *const registry = new Registry;
        return *registry;
    }

    TrimeshCollidersCache *ofThisThread() {
        if (void *cache = pthread_getspecific(m_key)) return static_cast<TrimeshCollidersCache *>(cache);
        std::lock_guard<std::mutex> lock(m_mutex);
        m_caches.push_back(std::make_unique<TrimeshCollidersCache>());
        pthread_setspecific(m_key, m_caches.back().get());
        return m_caches.back().get();
    }

    // A new key is empty in every thread, so that none keeps the address of a freed cache, and the old
    // one no longer calls into a library that is being unloaded.
    void release() {
        std::lock_guard<std::mutex> lock(m_mutex);
        m_caches.clear();
        pthread_key_delete(m_key);
        pthread_key_create(&m_key, threadEnded);
    }

    void unload() {
        std::lock_guard<std::mutex> lock(m_mutex);
        m_caches.clear();
        pthread_key_delete(m_key);
    }

private:
    Registry() { pthread_key_create(&m_key, threadEnded); }

    static void threadEnded(void *cache) {
        Registry &self = instance();
        std::lock_guard<std::mutex> lock(self.m_mutex);
        self.m_caches.erase(std::remove_if(self.m_caches.begin(), self.m_caches.end(),
                                           [cache](const auto &own) { return own.get() == cache; }),
                            self.m_caches.end());
    }

    std::mutex m_mutex;
    std::vector<std::unique_ptr<TrimeshCollidersCache>> m_caches;
    pthread_key_t m_key;
};

}  // namespace

// Seam: takes the place of upstream's variable g_ccTrimeshCollidersCache.
TrimeshCollidersCache *dxThreadTrimeshCollidersCache() { return Registry::instance().ofThisThread(); }

void dxThreadTrimeshCache::release() { Registry::instance().release(); }

void dxThreadTrimeshCache::unload() { Registry::instance().unload(); }
