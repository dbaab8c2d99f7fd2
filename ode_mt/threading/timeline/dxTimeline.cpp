#include "threading/timeline/dxTimeline.h"

#include <cerrno>
#include <cstring>
#include <new>

#include "core/dxEnvironment.h"
#include "core/dxLog.h"
#include "threading/process/dxProcess.h"
#include "threading/timeline/dxTimelineRings.h"

namespace {

struct Rings : dxTimelineRings {
    void atClose() { dxTimeline::flushAtClose(); }
    void atUnload() { dxTimeline::unload(); }
};

dxProcessObject<Rings> rings;

__attribute__((tls_model("initial-exec"))) thread_local dxTimelineRing *t_ring = nullptr;
__attribute__((tls_model("initial-exec"))) thread_local bool t_isRefused = false;  // a ring

void report(int error, const char *path) {
    if (error > 0) dxLog(dxLogLevel::warning, "the trace '%.800s' cannot be written: %s", path, std::strerror(error));
}

// Where no call of the program's has asked for the file just now.
void flushAndReport() {
    char path[800];
    rings->copyPath(path, sizeof path);
    report(rings->flush(), path);
}

}  // namespace

std::atomic<unsigned char> dxTimeline::s_state{kUnread};
std::atomic<bool> dxTimeline::s_flushIsRequested{false};

// A ring that a thread has got stays its own, also while nothing is recorded.
dxTimelineRing *dxTimeline::findRing() try {
    if (s_state.load(std::memory_order_relaxed) == kUnread) readEnvironment();
    if (s_state.load(std::memory_order_acquire) == kOff || t_isRefused) return nullptr;
    if (t_ring == nullptr) t_ring = rings->give();
    t_isRefused = t_ring == nullptr;
    return t_ring;
} catch (const std::bad_alloc &) {
    return nullptr;
}

// Of threads that come first at the same time one starts the trace. The others record nothing until it has.
void dxTimeline::readEnvironment() {
    const char *const path = dxEnvironment(dxVariable::Trace);
    unsigned char unread = kUnread;
    if (!s_state.compare_exchange_strong(unread, kOff)) return;
    if (path != nullptr) report(start(path), path);
    if (dxGetLogLevel() >= dxLogLevel::info || dxEnvironment(dxVariable::Statistics) != nullptr) startCounting();
}

// What the environment says comes first.
void dxTimeline::startCounting() {
    if (isCounted()) return;
    if (s_state.load(std::memory_order_relaxed) == kUnread) readEnvironment();
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

void dxTimeline::end() {
    s_state.fetch_and(kCounted, std::memory_order_relaxed);
    s_flushIsRequested.store(false, std::memory_order_relaxed);
    rings->stop();
}

void dxTimeline::copyPath(char *text, std::size_t size) { rings->copyPath(text, size); }

void dxTimeline::flushAsRequested() {
    s_flushIsRequested.store(false, std::memory_order_relaxed);
    if (isTraced()) flushAndReport();
}

void dxTimeline::flushAtClose() {
    if (isTraced()) flushAndReport();
}

void dxTimeline::unload() {
    flushAtClose();
    s_state.store(kOff, std::memory_order_relaxed);
    rings->unload();
    t_ring = nullptr;
}

bool dxTimeline::isOfThisThread(const dxTimelineRing *ring) { return ring == t_ring; }

void dxTimeline::threadEnds(dxTimelineRing *ring) {
    t_ring = nullptr;
    rings->end(ring);
}

void dxTimeline::inForkedChild() {
    s_state.fetch_and(static_cast<unsigned char>(~kTraced), std::memory_order_relaxed);
    s_flushIsRequested.store(false, std::memory_order_relaxed);
    t_isRefused = false;
}
