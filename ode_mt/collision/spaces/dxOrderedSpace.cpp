#include "collision/spaces/dxOrderedSpace.h"

#include <new>

#include "collision/narrowphase/dxTransformedGeom.h"
#include "threading/timeline/dxTimelineSpan.h"

#include "collision_space_internal.h"
#include "util.h"

namespace {

// On the timeline.
constexpr dxTimelineEvent kBroadPhase{"broad phase", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::BroadPhase};
constexpr dxTimelineEvent kNearCallbacks{"near-callbacks", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::NearCallbacks};

// A near-callback whose calls are counted: nothing else knows the pairs of a walk.
struct CountedCallback {
    void *data;
    dNearCallback *callback;
    std::uint64_t &calls;

    static void call(void *counted, dGeomID geom1, dGeomID geom2) {
        const CountedCallback &self = *static_cast<const CountedCallback *>(counted);
        ++self.calls;
        self.callback(self.data, geom1, geom2);
    }
};

// Upstream's spaces of two kinds refuse a geom to which either of these fields still belongs.
bool hasExtraLinks(int spaceType, const dxGeom *geom) {
    const bool looksAtThem = spaceType == dSweepAndPruneSpaceClass || spaceType == dQuadTreeSpaceClass;
    return looksAtThem && (geom->tome_ex != nullptr || geom->next_ex != nullptr);
}

}  // namespace

dxOrderedSpace::dxOrderedSpace(dSpaceID parent, int spaceType, dxPairOrder kind, dxSpaceCleaner &cleaner, dxSpacePairOrder &order,
                               dxSpaceWalker &walker, bool mayKeep)
    : dxSpace(parent), m_geoms(*this, kind, cleaner), m_cleaner(cleaner), m_walker(walker), m_pairs(m_geoms, order, mayKeep) {
    type = spaceType;
}

// From here on the geoms are in a space of upstream's, whose destructor removes or destroys them.
dxOrderedSpace::~dxOrderedSpace() { m_geoms.release(); }

// What upstream refuses, it refuses before it has changed anything; but the spaces around this one may be
// locked, and then an assertion fails after the geom is in, or out.
void dxOrderedSpace::add(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(!hasExtraLinks(type, geom) && geom->parent_space == nullptr && geom->next == nullptr, "geom is already in a space");
    const Slot slot = m_geoms.add(geom);
    if (m_prefetch != nullptr) m_prefetch->forgetGeom(slot);
    dxOrderedSpace *const inner = IS_SPACE(geom) ? from(static_cast<dxSpace *>(geom)) : nullptr;
    if (inner != nullptr && inner->hasStaleGeoms()) dxMissedNotifications.add();
    dxSpace::add(geom);
}

void dxOrderedSpace::remove(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(geom->parent_space == this, "object is not in this space");
    m_geoms.remove(geom);
    dxSpace::remove(geom);
}

// A call before may have been left by a jump, with workers.
void dxOrderedSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    m_geoms.forgetRunner();
    m_isPrefetching = false;
    if (m_prefetch != nullptr) m_prefetch->forgetPair();
    collideInStages(nullptr, data, callback);
}

bool dxOrderedSpace::collideShared(dxTaskRunner &runner, bool arraysStay, void *data, dNearCallback *callback) {
    if (!preparePrefetch(runner)) {
        collide(data, callback);
        return false;
    }
    const dxNarrowphasePrefetch::Scope scope(*m_prefetch, runner, arraysStay);
    collideInStages(&runner, data, callback);
    return true;
}

bool dxOrderedSpace::preparePrefetch(const dxTaskRunner &runner) {
    try {
        if (m_prefetch == nullptr) m_prefetch.reset(new dxNarrowphasePrefetch);
        m_prefetch->reserveMemory(runner, m_geoms.members().end());
        return true;
    } catch (const std::bad_alloc &) {
        return false;
    }
}

// Calls the callbacks of what has been found.
inline void dxOrderedSpace::callBack(dxPairsFound found, void *data, dNearCallback *callback) {
    switch (found) {
    case dxPairsFound::Kept:
        return m_walker.deliver(data, callback);
    case dxPairsFound::RowByRow:
        return m_walker.deliverAnew(data, callback);
    case dxPairsFound::None:
        return m_walker.walk(data, callback, nullptr);
    }
}

// Stages 1 and 2.
inline dxPairsFound dxOrderedSpace::findPairs(bool isRecorded) {
    return isRecorded ? findPairsRecorded() : m_pairs.find(m_cleaner.cleanToCollide());
}

// A call of dSpaceCollide. `runner`: the workers of a parallel call, or null.
void dxOrderedSpace::collideInStages(dxTaskRunner *runner, void *data, dNearCallback *callback) {
    dxTransformedGeom::noticeLeft();
    lock_count++;
    const bool isRecorded = this->isRecorded();

    // 1 Clean: reads poses, shapes and enabled flags of the geoms that have changed; writes their boxes, ranks and filters, and upstream's
    //   list of geoms. Bounding-box functions of the user's may run. Boxes on workers.
    // 2 Find: reads what 1 has written; writes pairs(). No code of the user's runs. The broad phase and the sort on workers.
    const dxPairsFound found = runner != nullptr ? findPairsOnWorkers(*runner) : findPairs(isRecorded);
    if (runner != nullptr) m_isPrefetching = found == dxPairsFound::Kept;

    // 3 Call back: reads pairs() and enabled flags. The near-callback runs on this thread and may change everything that a locked space
    //   allows; what it changes is tested when upstream tests it. The narrow phase of later pairs on workers (ahead()).
    isRecorded ? callBackRecorded(found, data, callback) : callBack(found, data, callback);

    lock_count--;
}

// On the timeline.
dxPairsFound dxOrderedSpace::findPairsRecorded() {
    dxTimelineSpan span(kBroadPhase, true, dxTimelineSpan::Begin::Adjoining);
    const dxPairsFound found = m_pairs.find(m_cleaner.cleanToCollide());
    span.set(0, pairs().size());
    return found;
}

// The runner is given back unless the call is left by a jump. Then it is not in use, and collide() forgets it.
dxPairsFound dxOrderedSpace::findPairsOnWorkers(dxTaskRunner &runner) {
    struct Borrowed {
        dxSpaceGeoms &geoms;
        ~Borrowed() { geoms.forgetRunner(); }
    };
    m_geoms.lend(runner);
    const Borrowed borrowed{m_geoms};
    return findPairs(isRecorded());
}

// callBack() on the timeline.
void dxOrderedSpace::callBackRecorded(dxPairsFound found, void *data, dNearCallback *callback) {
    dxTimelineSpan span(kNearCallbacks, true, dxTimelineSpan::Begin::Adjoining);
    dxTimelineRing *const ring = span.ring();
    if (ring == nullptr) return callBack(found, data, callback);
    const std::uint64_t before = ring->pairs;
    if (found == dxPairsFound::Kept) {
        ring->pairs += pairs().size();
        callBack(found, data, callback);
    } else {
        CountedCallback counted{data, callback, ring->pairs};
        callBack(found, &counted, CountedCallback::call);
    }
    span.set(0, ring->pairs - before);
}

void dxOrderedSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    dAASSERT(geom && callback);
    dxTransformedGeom::noticeLeft();
    m_geoms.lock();
    cleanGeoms();
    geom->recomputeAABB();
    m_walker.collideWith(data, geom, callback);
    m_geoms.unlock();
}
