#include "threading/timeline/dxTimeline.h"

#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "core/dxEnvironment.h"
#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"
#include "threading/process/dxProcessThreads.h"
#include "threading/timeline/dxTimelineFile.h"

// All rings of the process, and the file of its trace.
class dxTimelineRings final : private dxForkListener {
public:
    dxTimelineRings() { listenToForks(); }

    // These return 0 or an error number of the system. start() and stop() forget what was recorded before.
    int start(const char *path);
    int flush();
    void stop();

    // Threads get rings from here on, also if there is no file.
    void startCounting();

    // Returns null if nothing is recorded, there is no memory, or there are too many threads.
    dxTimelineRing *give();

    void copyPath(char *text, std::size_t size);

    void atClose() { dxTimeline::flushAtClose(); }

    // Nothing is recorded afterwards, and nothing of the library is called when a thread ends. A ring stays if its thread may be in the middle of an
    // event.
    void atUnload();

private:
    static constexpr std::size_t kKeptRings = 64;

    // Further threads are not recorded: where the program has taken all keys, nothing tells that a thread has ended.
    static constexpr std::size_t kMaxRings = 2048;

    struct Owned {
        dxTimelineRing *ring;
        std::string name;      // of its thread
        std::uint64_t number;  // of the thread, in the order of their first events
        bool hasEnded;
    };

    class Hold {
    public:
        explicit Hold(dxTimelineRings &rings) : m_lock(rings.m_mutex) {}

    private:
        const dxNoCancellation m_whole;
        const std::lock_guard<dxForkSafeMutex> m_lock;
    };

    void forget();
    void createKey();
    Owned *findEnded();
    Owned *add();
    int write();
    static void threadEnds(void *ring);
    void inForkedChild() override;

    dxForkSafeMutex m_mutex;
    std::vector<Owned> m_rings;
    std::vector<dxTimelineRecord> m_records;  // of one thread, while the file is written
    std::string m_path;                       // empty: there is no trace
    bool m_isCounting = false;
    dxTimelineScale m_scale;
    std::uint64_t m_given = 0;
    std::uint64_t m_lost = 0;  // events of threads whose rings were given to others
    unsigned m_refused = 0;    // threads without a ring
    std::optional<pthread_key_t> m_key;
};

namespace {

dxProcessObject<dxTimelineRings> rings;

__attribute__((tls_model("initial-exec"))) thread_local dxTimelineRing *t_ring = nullptr;
__attribute__((tls_model("initial-exec"))) thread_local bool t_isRefused = false;  // a ring

std::string nameOfThisThread() {
    char name[kThreadNameSize] = "";
    pthread_getname_np(pthread_self(), name, sizeof name);
    return name;
}

void report(int error, const char *path) {
    if (error > 0) dxLog(dxLogLevel::Warning, "the trace '%.800s' cannot be written: %s", path, std::strerror(error));
}

// For a file that no call of the program's has asked for just now.
void flushAndReport() {
    char path[800];
    rings->copyPath(path, sizeof path);
    report(rings->flush(), path);
}

}  // namespace

// --- rings -------------------------------------------------------------------------------------------------

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

// Called by the thread of the ring when it ends.
void dxTimelineRings::threadEnds(void *ring) {
    t_ring = nullptr;
    const Hold hold(*rings);
    for (Owned &owned : rings->m_rings) {
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
        // The thread that starts one names it, perhaps after its first event.
        if (!owned.hasEnded) dxReadThreadName(owned.ring->thread(), owned.name);
        const std::uint64_t ofThread = owned.ring->read(m_records);
        file.writeThread(owned.ring->thread(), owned.name, m_records, ofThread);
        dropped += ofThread;
    }
    return file.finish(dropped, m_refused);
} catch (const std::bad_alloc &) {
    return ENOMEM;
}

void dxTimelineRings::atUnload() {
    dxTimeline::flushAtClose();
    dxTimeline::s_state.store(dxTimeline::kOff, std::memory_order_relaxed);
    const Hold hold(*this);
    if (m_key) pthread_key_delete(*m_key);
    m_key.reset();
    for (const Owned &owned : m_rings)
        if (owned.hasEnded || owned.ring == t_ring) munmap(owned.ring, sizeof *owned.ring);
    std::vector<Owned>().swap(m_rings);
    std::vector<dxTimelineRecord>().swap(m_records);
    std::string().swap(m_path);
    t_ring = nullptr;
}

void dxTimelineRings::copyPath(char *text, std::size_t size) {
    const Hold hold(*this);
    text[m_path.copy(text, size - 1)] = '\0';
}

// Other rings belong to threads that do not exist in the child.
void dxTimelineRings::inForkedChild() {
    forget();
    m_path.clear();
    for (Owned &owned : m_rings)
        if (owned.ring != t_ring) owned.hasEnded = true;
    dxTimeline::s_state.fetch_and(static_cast<unsigned char>(~dxTimeline::kTraced), std::memory_order_relaxed);
    dxTimeline::s_flushIsRequested.store(false, std::memory_order_relaxed);
    t_isRefused = false;
}

// --- the timeline ------------------------------------------------------------------------------------------

std::atomic<unsigned char> dxTimeline::s_state{kUnread};
std::atomic<bool> dxTimeline::s_flushIsRequested{false};

// A thread keeps its ring, also while nothing is recorded.
dxTimelineRing *dxTimeline::findRing() try {
    if (s_state.load(std::memory_order_relaxed) == kUnread) readEnvironment(dxEnvironment(dxVariable::Trace));
    if (s_state.load(std::memory_order_acquire) == kOff || t_isRefused) return nullptr;
    if (t_ring == nullptr) t_ring = rings->give();
    t_isRefused = t_ring == nullptr;
    return t_ring;
} catch (const std::bad_alloc &) {
    return nullptr;
}

// If several threads are the first at the same time, one starts the trace. The others record nothing until it has.
void dxTimeline::readEnvironment(const char *tracePath) {
    unsigned char unread = kUnread;
    if (!s_state.compare_exchange_strong(unread, kOff)) return;
    if (tracePath != nullptr) report(start(tracePath), tracePath);
    if (dxGetLogLevel() >= dxLogLevel::Info || dxEnvironment(dxVariable::Statistics) != nullptr) startCounting();
}

// The environment is read first.
void dxTimeline::startCounting() {
    if (isCounted()) return;
    if (s_state.load(std::memory_order_relaxed) == kUnread) readEnvironment(dxEnvironment(dxVariable::Trace));
    rings->startCounting();
    s_state.fetch_or(kCounted, std::memory_order_release);
}

int dxTimeline::start(const char *path) try {
    flushAtClose();
    end();
    const int error = rings->start(path);
    if (error == 0) s_state.fetch_or(kTraced, std::memory_order_release);
    return error;
} catch (const std::bad_alloc &) {
    return ENOMEM;
}

int dxTimeline::flush() { return rings->flush(); }

int dxTimeline::stop() {
    const int result = rings->flush();
    end();
    return result;
}

// Whoever starts or stops a trace before the first event decides in place of ODE_MT_TRACE. Statistics are recorded as the environment says.
void dxTimeline::end() {
    if (s_state.load(std::memory_order_relaxed) == kUnread) readEnvironment(nullptr);
    s_state.fetch_and(kCounted, std::memory_order_relaxed);
    s_flushIsRequested.store(false, std::memory_order_relaxed);
    rings->stop();
}

void dxTimeline::copyPath(char *text, std::size_t size) { rings->copyPath(text, size); }

void dxTimeline::flushAsRequested() {
    s_flushIsRequested.store(false, std::memory_order_relaxed);
    flushAtClose();
}

void dxTimeline::flushAtClose() {
    if (isTraced()) flushAndReport();
}
