#include "threading/timeline/dxTimelineRings.h"

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <new>

#include "core/dxGuards.h"
#include "threading/process/dxProcessThreads.h"
#include "threading/timeline/dxTimeline.h"
#include "threading/timeline/dxTimelineFile.h"

namespace {

std::string nameOfThisThread() {
    char name[kThreadNameSize] = "";
    pthread_getname_np(pthread_self(), name, sizeof name);
    return name;
}

}  // namespace

class dxTimelineRings::Hold {
public:
    explicit Hold(dxTimelineRings &rings) : m_lock(rings.m_mutex) {}

private:
    const dxNoCancellation m_whole;
    const std::lock_guard<dxForkSafeMutex> m_lock;
};

int dxTimelineRings::start(const char *path) {
    const Hold hold(*this);
    forget();
    m_scale = dxTimelineScale();
    m_path = dxTimelineFile::absolute(path);
    const int error = write();
    if (error != 0) m_path.clear();
    if (error == 0 && !m_key) createKey();
    return error;
}

int dxTimelineRings::flush() {
    const Hold hold(*this);
    return write();
}

void dxTimelineRings::stop() {
    const Hold hold(*this);
    forget();
    m_path.clear();
}

void dxTimelineRings::startCounting() {
    const Hold hold(*this);
    m_isCounting = true;
    if (!m_key) createKey();
}

void dxTimelineRings::forget() {
    for (const Owned &owned : m_rings) owned.ring->forget();
    m_lost = 0;
    m_refused = 0;
}

dxTimelineRing *dxTimelineRings::give() {
    const Hold hold(*this);
    if (m_path.empty() && !m_isCounting) return nullptr;
    Owned *owned = m_rings.size() < kKeptRings ? nullptr : findEnded();
    if (owned == nullptr) owned = add();
    if (owned == nullptr) {
        ++m_refused;
        return nullptr;
    }
    m_lost += owned->ring->size();
    owned->name = nameOfThisThread();
    owned->number = ++m_given;
    owned->hasEnded = false;
    owned->ring->own(static_cast<std::uint32_t>(syscall(SYS_gettid)));
    if (m_key) pthread_setspecific(*m_key, owned->ring);
    return owned->ring;
}

dxTimelineRings::Owned *dxTimelineRings::findEnded() {
    Owned *first = nullptr;
    for (Owned &owned : m_rings)
        if (owned.hasEnded && (first == nullptr || owned.number < first->number)) first = &owned;
    return first;
}

// The system's memory is zero, and is touched as it is used.
dxTimelineRings::Owned *dxTimelineRings::add() {
    if (m_rings.size() == kMaxRings) return nullptr;
    m_rings.reserve(m_rings.size() + 1);
    void *const memory = mmap(nullptr, sizeof(dxTimelineRing), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    m_rings.push_back({new (memory) dxTimelineRing, {}, 0, false});
    return &m_rings.back();
}

void dxTimelineRings::createKey() {
    pthread_key_t key;
    if (pthread_key_create(&key, threadEnds) == 0) m_key = key;
}

void dxTimelineRings::threadEnds(void *ring) { dxTimeline::threadEnds(static_cast<dxTimelineRing *>(ring)); }

void dxTimelineRings::end(const dxTimelineRing *ring) {
    const Hold hold(*this);
    for (Owned &owned : m_rings) {
        if (owned.ring != ring) continue;
        owned.name = nameOfThisThread();
        owned.hasEnded = true;
    }
}

int dxTimelineRings::write() try {
    if (m_path.empty()) return dxTimeline::kNotRecording;
    m_scale.measure();
    dxTimelineFile file(m_path.c_str(), m_scale);
    std::uint64_t dropped = m_lost;
    for (Owned &owned : m_rings) {
        if (owned.ring->size() == 0) continue;
        // A thread is named by the one that starts it, which may come after its first event.
        if (!owned.hasEnded) dxReadThreadName(owned.ring->thread(), owned.name);
        const std::uint64_t ofThread = owned.ring->read(m_records);
        file.writeThread(owned.ring->thread(), owned.name, m_records, ofThread);
        dropped += ofThread;
    }
    return file.finish(dropped, m_refused);
} catch (const std::bad_alloc &) {
    return ENOMEM;
}

void dxTimelineRings::unload() {
    const Hold hold(*this);
    if (m_key) pthread_key_delete(*m_key);
    m_key.reset();
    for (const Owned &owned : m_rings)
        if (owned.hasEnded || dxTimeline::isOfThisThread(owned.ring)) munmap(owned.ring, sizeof *owned.ring);
    std::vector<Owned>().swap(m_rings);
    std::vector<dxTimelineRecord>().swap(m_records);
    std::string().swap(m_path);
}

void dxTimelineRings::copyPath(char *text, std::size_t size) {
    const Hold hold(*this);
    text[m_path.copy(text, size - 1)] = '\0';
}

// The others' rings belong to threads that do not exist here.
void dxTimelineRings::inForkedChild() {
    forget();
    m_path.clear();
    for (Owned &owned : m_rings)
        if (!dxTimeline::isOfThisThread(owned.ring)) owned.hasEnded = true;
    dxTimeline::inForkedChild();
}
