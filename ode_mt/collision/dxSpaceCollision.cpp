#include "collision/dxSpaceCollision.h"

#include <algorithm>
#include <cstdint>

#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxStopwatch.h"
#include "settings/dxProcessStatistics.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkersRunner.h"
#include "settings/dxWorldStatistics.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// Minimum number of geoms for workers; below it even reading the clock costs too much.
constexpr int kMinGeoms = 48;

constexpr dxTimelineEvent kCollide{"collide", "collision", {"geoms", "pairs", "threads"}};
constexpr dxTimelineEvent kCounters{"of a collision", "counter", {"pairs", "threads of collide"}, dxTimelineEvent::Kind::Counter};

// Returns the world of the first body that a geom of the space or of a nested space has; null: there is none.
const dxWorld *worldOf(const dxSpace &space) {
    for (const dxGeom *geom = space.first; geom != nullptr; geom = geom->next) {
        if (geom->body != nullptr) return geom->body->world;
        const dxWorld *const world = IS_SPACE(geom) ? worldOf(*static_cast<const dxSpace *>(geom)) : nullptr;
        if (world != nullptr) return world;
    }
    return nullptr;
}

// Records a collision on the timeline and for its world's statistics. Collisions within its near-callbacks belong to it. It is used on the thread
// that calls dSpaceCollide, or on a worker that runs a callback. A callback that leaves by longjmp leaves the depth too large: then collisions are
// not counted until the thread's next step.
class CollideSpan {
public:
    explicit CollideSpan(const dxOrderedSpace &space)
        : m_space(space), m_span(kCollide, space.isRecorded()) {
        if (m_span.ring() != nullptr) begin(*m_span.ring());
    }
    ~CollideSpan() {
        if (m_span.ring() != nullptr) end(*m_span.ring());
    }

    // Sets why the pairs, and why the callbacks, stay on the calling thread.
    void setReasons(dODE_MT_Reason reason, dODE_MT_Reason ofCallbacks) {
        m_record.reason = reason;
        m_record.callbackReason = ofCallbacks;
    }
    void setPrefetched(std::uint64_t computed, std::uint64_t used) {
        m_record.contactsAhead = computed;
        m_record.contactsAheadUsed = used;
    }

private:
    void begin(dxTimelineRing &ring) {
        m_begin = ring.lastReading();
        m_outerTimes = ring.times();
        m_outerDepth = ring.collisionDepth++;
        m_outerThreads = ring.takeThreads();
        m_pairsBefore = ring.pairs;
        ring.setTimes({});
    }

    void end(dxTimelineRing &ring) {
        const std::uint64_t now = ring.lastReading(), pairs = ring.pairs - m_pairsBefore, threads = ring.takeThreads();
        ring.add(kCounters, now, now, {pairs, threads});
        m_span.set(0, static_cast<std::uint64_t>(m_space.count));
        m_span.set(1, pairs);
        m_span.set(2, threads);
        m_span.endAdjoining();
        if (m_outerDepth == 0 && ring.caller().ring == &ring && dxTimeline::isCounted()) count(ring, pairs, static_cast<unsigned>(threads));
        ring.setTimes(m_outerTimes);
        ring.collisionDepth = m_outerDepth;
        ring.noteThreads(m_outerThreads);
    }

    void count(const dxTimelineRing &ring, std::uint64_t pairs, unsigned threads) {
        const dxWorld *const world = worldOf(m_space);
        if (world == nullptr) return;
        m_record.ticks = ring.lastReading() - m_begin;
        m_record.times = ring.times();
        m_record.pairs = pairs;
        m_record.threads = threads;
        if (threads < 2)
            for (dODE_MT_Reason *const reason : {&m_record.reason, &m_record.callbackReason})
                if (*reason == dODE_MT_REASON_PARALLEL) *reason = dODE_MT_REASON_LATE_WORKERS;
        dxWorldStatistics::add(world, m_record);
    }

    const dxOrderedSpace &m_space;
    dxTimelineSpan m_span;
    dxCollisionRecord m_record;
    std::uint64_t m_begin = 0, m_pairsBefore = 0;
    // Of the collision or step around this one.
    dxFrameTimes m_outerTimes;
    unsigned m_outerDepth = 0, m_outerThreads = 1;
};

// Returns why the call is not shared, or PARALLEL if it may be. A call from inside a callback of a shared call, of this space or another one, stays
// on its thread. The lock of the space is no sign of that: a callback may have left it locked by longjmp or an exception.
dODE_MT_Reason whyAlone(const dxOrderedSpace &space, dNearCallback *callback) {
    const dxSettings &settings = dxSettings::instance();
    if (space.ownThreads().inForce() <= 1) return dODE_MT_REASON_THREADS;
    if (settings.algorithm() == dxAlgorithm::Serial) return dODE_MT_REASON_ALGORITHM;
    if (callback == nullptr || space.count <= 1) return dODE_MT_REASON_FEW_GEOMS;
    if (dxContactLog::current() != nullptr || dxNarrowphasePrefetch::current() != nullptr) return dODE_MT_REASON_IN_CALLBACK;
    return dxTrapsFloatingPoint() ? dODE_MT_REASON_FLOAT_TRAPS : dODE_MT_REASON_PARALLEL;
}

void collideAlone(CollideSpan &span, dODE_MT_Reason reason, dxOrderedSpace &space, void *data, dNearCallback *callback) {
    span.setReasons(reason, reason);
    space.collide(data, callback);
}

void collideOnWorkers(CollideSpan &span, dxOrderedSpace &space, unsigned workers, void *data, dNearCallback *callback) {
    dxWorkersRunner runner(workers);
    const bool mayBeConcurrent = dxSettings::instance().callbackPolicy() != dxCallbackPolicy::Serial;
    if (mayBeConcurrent && dxCollideConcurrently(space, runner, data, callback)) return;
    span.setReasons(dODE_MT_REASON_PARALLEL, mayBeConcurrent ? dODE_MT_REASON_FEW_TASKS : dODE_MT_REASON_CALLBACK_POLICY);
    if (!space.collideOnWorkers(runner, mayBeConcurrent, data, callback)) {
        span.setReasons(dODE_MT_REASON_MEMORY, dODE_MT_REASON_MEMORY);
        return;
    }
    const dxNarrowphasePrefetch &prefetch = *space.narrowphasePrefetch();
    span.setPrefetched(prefetch.computed(), prefetch.used());
    dxProcessStatistics::instance().countSharedCollision(runner.tookPart(), prefetch.computed(), prefetch.used());
}

void collideMeasured(CollideSpan &span, dxOrderedSpace &space, void *data, dNearCallback *callback) {
    const unsigned workers = dxMaxCollisionThreads(space);
    const bool shared = workers > 1 && space.sharing().shouldShare();
    const dODE_MT_Reason reason = workers > 1 ? dODE_MT_REASON_MEASURED : dODE_MT_REASON_CORES;
    if (!shared && !space.sharing().shouldTimeAlone()) return collideAlone(span, reason, space, data, callback);
    const dxStopwatch stopwatch;
    if (shared)
        collideOnWorkers(span, space, workers, data, callback);
    else
        collideAlone(span, reason, space, data, callback);
    space.sharing().record(shared, stopwatch.ns());
}

}  // namespace

unsigned dxMaxCollisionThreads(const dxOrderedSpace &space) {
    const dxSettings &settings = dxSettings::instance();
    if (settings.algorithm() == dxAlgorithm::Serial) return 1;
    const unsigned allowed = std::max(space.ownThreads().inForce(), 1u);
    return settings.algorithm() == dxAlgorithm::Auto ? std::min(allowed, settings.cores()) : allowed;
}

void dxCollideSpace(dxOrderedSpace &space, void *data, dNearCallback *callback) {
    const dxSettings &settings = dxSettings::instance();
    const bool isAuto = settings.algorithm() == dxAlgorithm::Auto;
    CollideSpan span(space);
    const dODE_MT_Reason reason = whyAlone(space, callback);
    if (reason != dODE_MT_REASON_PARALLEL)
        collideAlone(span, reason, space, data, callback);
    else if (!isAuto)
        collideOnWorkers(span, space, dxMaxCollisionThreads(space), data, callback);
    else if (space.count < kMinGeoms)
        collideAlone(span, dODE_MT_REASON_FEW_GEOMS, space, data, callback);
    else
        collideMeasured(span, space, data, callback);
}
