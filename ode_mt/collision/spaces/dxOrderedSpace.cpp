#include "collision/spaces/dxOrderedSpace.h"

#include <new>

#include "collision/narrowphase/dxHeightField.h"
#include "threading/timeline/dxTimeline.h"

#include "util.h"

namespace {

// Events on the timeline.
constexpr dxTimelineEvent kBroadPhase{"broad phase", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::BroadPhase};
constexpr dxTimelineEvent kNearCallbacks{"near-callbacks", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::NearCallbacks};

// A near-callback that counts its calls, which is the only way to know the number of pairs of a walk.
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

// Returns whether one of these two fields is still in use, for which upstream's spaces of two kinds refuse a geom.
bool hasExtraLinks(int spaceType, const dxGeom *geom) {
    const bool areRead = spaceType == dSweepAndPruneSpaceClass || spaceType == dQuadTreeSpaceClass;
    return areRead && (geom->tome_ex != nullptr || geom->next_ex != nullptr);
}

}  // namespace

dxOrderedSpace::dxOrderedSpace(dSpaceID parent, int spaceType, dxPairOrder kind, dxSpaceCleaner &cleaner, dxSpacePairOrder &order,
                               dxSpaceWalker &walker, bool mayKeep)
    : dxSpace(parent), m_geoms(*this, kind, cleaner), m_cleaner(cleaner), m_walker(walker), m_pairs(m_geoms, order, mayKeep) {
    type = spaceType;
}

// After this the geoms are in a space of upstream's, whose destructor removes or destroys them.
dxOrderedSpace::~dxOrderedSpace() { m_geoms.release(); }

// Upstream's checks precede all changes, with one exception: if a space around this one is locked, an assertion fails after the geom was added or
// removed.
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

// The last call may have had workers and been left by a jump.
void dxOrderedSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    m_geoms.forgetRunner();
    m_isPrefetching = false;
    if (m_prefetch != nullptr) m_prefetch->forgetPair();
    collideInStages(nullptr, data, callback);
}

bool dxOrderedSpace::collideOnWorkers(dxTaskRunner &runner, bool arraysStay, void *data, dNearCallback *callback) {
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

// Stage 3.
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
    //   list of geoms. Bounding-box functions of the user's may run. Workers compute boxes.
    // 2 Find: reads what 1 has written; writes pairs(). No code of the user's runs. Workers share the broad phase and the sort.
    const dxPairsFound found = runner != nullptr ? findPairsOnWorkers(*runner) : findPairs(isRecorded);
    if (runner != nullptr) m_isPrefetching = found == dxPairsFound::Kept;

    // 3 Call back: reads pairs() and enabled flags. The near-callback runs on this thread and may change everything that a locked space
    //   allows; what it changes is tested when upstream tests it. Workers compute contacts of later pairs (activePrefetch()).
    isRecorded ? callBackRecorded(found, data, callback) : callBack(found, data, callback);

    lock_count--;
}

// findPairs() on the timeline.
dxPairsFound dxOrderedSpace::findPairsRecorded() {
    dxTimelineSpan span(kBroadPhase, true, dxTimelineSpan::Begin::Adjoining);
    const dxPairsFound found = m_pairs.find(m_cleaner.cleanToCollide());
    span.set(0, pairs().size());
    return found;
}

// If the call is left by a jump, collide() forgets the runner, which nothing uses meanwhile.
dxPairsFound dxOrderedSpace::findPairsOnWorkers(dxTaskRunner &runner) {
    struct Scope {
        dxSpaceGeoms &geoms;
        ~Scope() { geoms.forgetRunner(); }
    };
    m_geoms.setRunner(runner);
    const Scope scope{m_geoms};
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
