#include "collision/dxSpaceCollision.h"

#include <algorithm>
#include <cstdint>

#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/callbacks/dxContactLog.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxStopwatch.h"
#include "settings/dxSettings.h"
#include "settings/dxStepStatistics.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/timeline/dxTimelineSpan.h"

namespace {

// Minimum number of geoms for workers, and even for reading the clock.
constexpr int kMinGeoms = 48;

// On the timeline; a call for fewer geoms takes longer to record than to do.
constexpr int kMinRecorded = 8;
constexpr dxTimelineEvent kCollide{"collide", "collision", {"geoms", "pairs", "threads"}};
constexpr dxTimelineEvent kCounters{"of a collision", "counter", {"pairs", "threads of collide"}, dxTimelineEvent::Kind::Counter};

class CollideSpan {
public:
    explicit CollideSpan(const dxOrderedSpace &space) : m_space(space), m_span(kCollide, space.count >= kMinRecorded) {}
    ~CollideSpan() {
        if (m_span.ring() != nullptr) end(*m_span.ring());
    }

private:
    void end(dxTimelineRing &ring) {
        const std::uint64_t now = ring.lastReading(), pairs = m_space.pairs().size(), threads = ring.takeThreads();
        ring.add(kCounters, now, now, {pairs, threads});
        m_span.set(0, static_cast<std::uint64_t>(m_space.count));
        m_span.set(1, pairs);
        m_span.set(2, threads);
        m_span.endAdjoining();
    }

    const dxOrderedSpace &m_space;
    dxTimelineSpan m_span;
};

// From inside a callback of a call that is shared, whether of this space or of another one, everything stays
// on its thread. That the space is locked says nothing: a callback may have left it so by longjmp or an
// exception.
bool mayShare(const dxOrderedSpace &space, dNearCallback *callback) {
    const dxSettings &settings = dxSettings::instance();
    return settings.threads() > 1 && settings.algorithm() != dxAlgorithm::Serial && callback != nullptr &&
           space.count > 1 && dxContactLog::current() == nullptr && dxNarrowphasePrefetch::current() == nullptr &&
           !dxTrapsFloatingPoint();
}

void collideOnWorkers(dxOrderedSpace &space, unsigned workers, void *data, dNearCallback *callback) {
    dxWorkersRunner runner(workers);
    const bool mayBeConcurrent = dxSettings::instance().callbackPolicy() != dxCallbackPolicy::Serial;
    if (mayBeConcurrent && dxCollideConcurrently(space, runner, data, callback)) return;
    if (!space.collideShared(runner, mayBeConcurrent, data, callback)) return;
    const dxNarrowphasePrefetch &ahead = *space.narrowphasePrefetch();
    dxStepStatistics::instance().countSharedCollision(runner.tookPart(), ahead.computed(), ahead.used());
}

void collideMeasured(dxOrderedSpace &space, void *data, dNearCallback *callback) {
    const dxSettings &settings = dxSettings::instance();
    const unsigned workers = std::min(settings.threads(), settings.cores());
    const bool shared = workers > 1 && space.sharing().shouldShare();
    const dxStopwatch stopwatch;
    if (shared)
        collideOnWorkers(space, workers, data, callback);
    else
        space.collide(data, callback);
    space.sharing().record(shared, stopwatch.ns());
}

}  // namespace

void dxCollideSpace(dxOrderedSpace &space, void *data, dNearCallback *callback) {
    const CollideSpan span(space);
    const dxSettings &settings = dxSettings::instance();
    if (!mayShare(space, callback))
        space.collide(data, callback);
    else if (settings.algorithm() != dxAlgorithm::Auto)
        collideOnWorkers(space, settings.threads(), data, callback);
    else if (space.count < kMinGeoms)
        space.collide(data, callback);
    else
        collideMeasured(space, data, callback);
}
