#include "collision/narrowphase/dxNarrowphasePrefetch.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <type_traits>

#include "collision/narrowphase/dxCcdQuery.h"
#include "collision/narrowphase/dxColliderTable.h"
#include "collision/pairs/dxPairPrefetch.h"
#include "collision/pairs/dxUnnoticedChanges.h"
#include "core/dxNoIndex.h"
#include "core/dxReserve.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxStackFrame.h"
#include "threading/dxUpstreamScope.h"

#include "collision_kernel.h"
#include "collision_std.h"
#include "collision_util.h"
#include "config.h"

namespace {

__attribute__((tls_model("initial-exec"))) thread_local dxNarrowphasePrefetch *t_current = nullptr;
__attribute__((tls_model("initial-exec"))) thread_local dxStackFrame t_frame;    // of the call that made it current
__attribute__((tls_model("initial-exec"))) thread_local std::uint64_t t_call = 0;  // its number

std::atomic<std::uint64_t> lastCall{0};

// Pairs computed at once: enough to pay for waking workers, few enough for their contacts to stay in a cache.
constexpr std::size_t kBatch = 2048;
// Number of pairs after which the flags are known, or are checked again.
constexpr std::size_t kUnjudgedBatch = 16;
// Number of pairs in a chunk. Consecutive pairs share geoms; but a convex pair may take twenty
// microseconds, and every worker should get some.
constexpr std::size_t kMinChunk = 8, kMaxChunk = 128;
constexpr std::size_t kChunksPerWorker = 4;

// Maximum number of contacts of a pair for which scratch memory is kept.
constexpr int kMaxContacts = 4096;

// Number of pairs after which it is decided whether the prefetched contacts are used.
constexpr std::uint64_t kJudgeThreshold = 256;
constexpr unsigned kMinPause = 16, kMaxPause = 1024;  // calls

// The pattern, no part of which a collider writes: a signalling NaN, which arithmetic never returns; no triangle's number; no geom's address.
using RealBits = std::conditional_t<sizeof(dReal) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
constexpr auto kNoReal =
    static_cast<RealBits>(sizeof(RealBits) == 8 ? UINT64_C(0x7ff4a5c3e1d2b697) : UINT64_C(0x7fa5c3e1));
constexpr int kNoSide = 0x5ac3b1e7;
char noGeom;

bool isUnwritten(const dReal &value) { return std::memcmp(&value, &kNoReal, sizeof value) == 0; }
void unwrite(dReal &value) { std::memcpy(&value, &kNoReal, sizeof value); }

dGeomID unwrittenGeom() { return reinterpret_cast<dGeomID>(&noGeom); }

void unwrite(dContactGeom &contact) {
    for (int i = 0; i < 4; ++i) {
        unwrite(contact.pos[i]);
        unwrite(contact.normal[i]);
    }
    unwrite(contact.depth);
    contact.g1 = contact.g2 = unwrittenGeom();
    contact.side1 = contact.side2 = kNoSide;
}

bool isUnwritten(const dContactGeom &contact) {
    for (int i = 0; i < 4; ++i)
        if (!isUnwritten(contact.pos[i]) || !isUnwritten(contact.normal[i])) return false;
    return isUnwritten(contact.depth) && contact.g1 == unwrittenGeom() && contact.g2 == unwrittenGeom() &&
           contact.side1 == kNoSide && contact.side2 == kNoSide;
}

// Returns false if the call asked only whether two shapes touch: some colliders return a contact without writing it,
// and dCollide negates the normal if the shapes were in the other order. The same holds if a ray of infinite length
// hits a convex geom at no distance: the collider computes with the position that it finds in the contact. A number that
// was computed from the pattern is a NaN, like the pattern.
bool isWritten(const dContactGeom &contact) {
    for (int i = 0; i < 3; ++i)
        if (std::isnan(contact.pos[i]) || std::isnan(contact.normal[i])) return false;
    return !std::isnan(contact.depth) && contact.g1 != unwrittenGeom() && contact.g2 != unwrittenGeom() &&
           contact.side1 != kNoSide && contact.side2 != kNoSide;
}

// The fourth number of a vector is padding, and some colliders keep a mark in its first byte
// (addUniqueContact in collision_libccd.cpp).
void copyWrittenPadding(const dReal &from, dReal &to) {
    unsigned char pattern[sizeof(dReal)], bytes[sizeof(dReal)];
    std::memcpy(pattern, &kNoReal, sizeof pattern);
    std::memcpy(bytes, &from, sizeof bytes);
    const bool isWhole = std::memcmp(bytes + 1, pattern + 1, sizeof bytes - 1) != 0;
    if (isWhole || bytes[0] != pattern[0]) std::memcpy(&to, bytes, isWhole ? sizeof bytes : 1);
}

void copyWritten(const dContactGeom &from, dContactGeom &to) {
    std::copy_n(from.pos, 3, to.pos);
    std::copy_n(from.normal, 3, to.normal);
    copyWrittenPadding(from.pos[3], to.pos[3]);
    copyWrittenPadding(from.normal[3], to.normal[3]);
    to.depth = from.depth;
    to.g1 = from.g1;
    to.g2 = from.g2;
    to.side1 = from.side1;
    to.side2 = from.side2;
}

}  // namespace

dxNarrowphasePrefetch *dxNarrowphasePrefetch::current() {
    if (t_current != nullptr && !t_frame.called(dxStackFrame::ofCaller())) forgetCurrent();
    return t_current;
}

void dxNarrowphasePrefetch::forgetCurrent() {
    if (t_current == nullptr) return;
    t_current->release();
    t_current = nullptr;
    t_call = 0;
}

dxNarrowphasePrefetch::Scope::Scope(dxNarrowphasePrefetch &prefetch, dxTaskRunner &runner, bool arraysStay)
    : m_number(lastCall.fetch_add(1, std::memory_order_relaxed) + 1), m_prefetch(prefetch) {
    forgetCurrent();
    prefetch.m_holders.fetch_add(1, std::memory_order_relaxed);
    prefetch.start(runner, arraysStay);
    t_current = &prefetch;
    t_frame = dxStackFrame::ofCaller();
    t_call = m_number;
}

dxNarrowphasePrefetch::Scope::~Scope() {
    m_prefetch.end();
    if (t_call == m_number) forgetCurrent();
}

void dxNarrowphasePrefetch::release() {
    if (m_holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

// Releases memory, because the remaining holders of the object get no further notifications.
void dxNarrowphasePrefetch::leaveSpace() {
    m_pair = nullptr;
    m_hasResults = false;
    std::vector<Result>().swap(m_results);
    std::vector<Worker>().swap(m_workers);
    std::vector<Requested>().swap(m_requested);
    m_convex = {};
    release();
}

// Any of these changes makes what was computed invalid.
std::uint64_t dxNarrowphasePrefetch::changesNoticed() {
    return dxSilentChanges.count() + dxMissedNotifications.count();
}

void dxNarrowphasePrefetch::reserveMemory(const dxTaskRunner &runner, std::size_t slots) {
    if (m_requested.size() < slots) m_requested.resize(slots);
    while (m_workers.size() < runner.workers()) m_workers.emplace_back();
}

void dxNarrowphasePrefetch::start(dxTaskRunner &runner, bool arraysStay) {
    ++m_call;
    m_runner = &runner;
    m_arraysStay = arraysStay;
    m_pair = nullptr;
    m_begin = m_end = 0;
    m_hasResults = false;
    m_computed = m_used = 0;
    if (m_callsWithout > 0) --m_callsWithout;
}

void dxNarrowphasePrefetch::end() {
    m_pair = nullptr;
    m_hasResults = false;
    m_computedSinceJudged += m_computed;
    m_usedSinceJudged += m_used;
    if (m_computedSinceJudged < kJudgeThreshold) return;
    const bool pays = 2 * m_usedSinceJudged >= m_computedSinceJudged;
    m_computedSinceJudged = m_usedSinceJudged = 0;
    if (pays) {
        m_nextPause = 0;
        return;
    }
    m_nextPause = std::clamp(2 * m_nextPause, kMinPause, kMaxPause);
    m_callsWithout = m_nextPause;
}

bool dxNarrowphasePrefetch::maySpend() const {
    const int contacts = m_flags & NUMC_MASK;
    if (m_callsWithout > 0 || contacts == 0 || contacts > kMaxContacts) return false;
    return m_computed < kJudgeThreshold || 2 * m_used >= m_computed;
}

void dxNarrowphasePrefetch::nextBatch(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    m_begin = index;
    m_hasResults = false;
    if (!maySpend()) {
        m_end = index + kUnjudgedBatch;
        return;
    }
    m_end = std::min(index + (m_computed < kJudgeThreshold ? kJudgeThreshold : kBatch), pairs.size());
    computeBatch(pairs);
}

void dxNarrowphasePrefetch::computeBatch(const std::vector<dxOrderedPair> &pairs) {
    m_batchFlags = m_flags;
    m_batchChanges = changesNoticed();
    m_batchMode = dxFloatMode();
    ++m_batch;
    const std::size_t size = m_end - m_begin;
    try {
        if (m_results.size() < size) m_results.resize(size);
    } catch (const std::bad_alloc &) {
        return;
    }
    m_hasResults = true;
    const std::size_t chunk =
        std::clamp(size / (kChunksPerWorker * m_runner->workers()), kMinChunk, kMaxChunk);
    m_runner->forChunks(dxParallelStage::NarrowphasePrefetch, size, chunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
        // A collider that reports a message, or may never end, is interrupted: dCollide runs it when the callback calls it.
        const dxInterruptingScope interrupting;
        const dxCcdQuery::Limit limit;
        m_workers[worker].enterBatch(m_batch);
        for (std::size_t i = begin; i < end; ++i) {
            dxPairPrefetch::forNarrowphase(pairs, m_begin + i);
            dxPerturb(dxSchedulePoint::ComputeContacts);
            compute(pairs[m_begin + i], m_results[i], worker);
        }
    });
    for (const Worker &worker : m_workers)
        if (worker.batch == m_batch) m_computed += worker.computed;
}

void dxNarrowphasePrefetch::compute(const dxOrderedPair &pair, Result &result, unsigned number) {
    Worker &worker = m_workers[number];
    result.count = kUnknown;
    if (!wasRequested(*pair.first, pair.slots[0]) || !wasRequested(*pair.second, pair.slots[1])) return;
    if (!dxMayCollideConcurrently(*pair.first, *pair.second)) return;
    if (!m_arraysStay && !dxKnowsArrays(*pair.first, *pair.second)) return;
    const auto most = static_cast<std::size_t>(m_batchFlags & NUMC_MASK);
    try {
        worker.reserveMemory(most + 1);
        dxReserveCapacity(worker.states, worker.states.size() + 1);
        const dxColliderCopies::Arrays arrays{m_convex.of(pair.slots[0]), m_convex.of(pair.slots[1])};
        result.count = worker.copies.collide(*pair.first, *pair.second, arrays, m_batchFlags,
                                             worker.contacts.data() + worker.used, sizeof(dContactGeom));
    } catch (const dxUpstreamInterrupted &) {
        worker.wipe(worker.used, worker.used + most);
        return;
    } catch (const std::bad_alloc &) {
        // The callback will get the error.
        worker.wipe(worker.used, std::min(worker.used + most, worker.contacts.size()));
        return;
    }
    const dContactGeom *const found = worker.contacts.data() + worker.used;
    if (!std::all_of(found, found + result.count, isWritten)) {
        result.count = kUnknown;
        worker.wipe(worker.used, worker.used + most);
        return;
    }
    result.worker = static_cast<std::uint16_t>(number);
    result.isUsed = false;
    result.first = static_cast<std::uint32_t>(worker.used);
    result.states = worker.keepStates({stateOf(*pair.first, pair.slots[0]), stateOf(*pair.second, pair.slots[1])});
    worker.used += static_cast<std::size_t>(result.count);
    ++worker.computed;
    worker.wipeDrafts();
}

// Clears what is left of the batch before.
void dxNarrowphasePrefetch::Worker::enterBatch(std::uint64_t newBatch) {
    if (batch == newBatch) return;
    batch = newBatch;
    wipe(0, used);
    used = 0;
    states.clear();
    computed = 0;
}

std::uint32_t dxNarrowphasePrefetch::Worker::keepStates(const States &both) {
    if (both.first == 0 && both.second == 0) return kNoIndex;
    states.push_back(both);
    return static_cast<std::uint32_t>(states.size() - 1);
}

void dxNarrowphasePrefetch::Worker::reserveMemory(std::size_t more) {
    const std::size_t have = contacts.size();
    if (have >= used + more) return;
    contacts.resize(used + 2 * more);
    wipe(have, contacts.size());
}

void dxNarrowphasePrefetch::Worker::wipe(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) unwrite(contacts[i]);
}

// Restores the pattern that colliders have overwritten behind the last contact.
void dxNarrowphasePrefetch::Worker::wipeDrafts() {
    for (std::size_t i = used; i < contacts.size() && !isUnwritten(contacts[i]); ++i) unwrite(contacts[i]);
}

void dxNarrowphasePrefetch::noteRequested(const dxOrderedPair &pair) {
    const dxGeom *const geoms[] = {pair.first, pair.second};
    for (int i = 0; i < 2; ++i) {
        m_requested[pair.slots[i]] = {m_call, dxSilentChanges.count()};
        if (geoms[i]->type == dConvexClass) m_convex.read(pair.slots[i], static_cast<const dxConvex &>(*geoms[i]));
    }
}

bool dxNarrowphasePrefetch::wasRequested(const dxGeom &geom, dxMembers::Slot slot) const {
    const Requested &asked = m_requested[slot];
    if (asked.call + 1 < m_call) return false;
    if (geom.type == dConvexClass) return m_convex.of(slot) != nullptr;
    return !dxHasDataOfProgram(geom) || asked.changes == dxSilentChanges.count();
}

std::uint64_t dxNarrowphasePrefetch::stateOf(const dxGeom &geom, dxMembers::Slot slot) const {
    if (geom.type != dConvexClass) return dxColliderState(geom);
    const dxConvexArrays::Copy *const copy = m_convex.of(slot);
    return copy != nullptr ? copy->number() : 0;
}

int dxNarrowphasePrefetch::answer(dGeomID o1, dGeomID o2, int flags, dContactGeom *contacts, int skip) {
    if (m_pair == nullptr) return kUnknown;
    if (o1 == m_pair->second && o2 == m_pair->first) noteRequested(*m_pair);
    if (o1 != m_pair->first || o2 != m_pair->second) return kUnknown;
    noteRequested(*m_pair);
    m_flags = flags;
    if (!m_hasResults || flags != m_batchFlags || contacts == nullptr) return kUnknown;
    if (m_batchChanges != changesNoticed() || m_batchMode != dxFloatMode()) return kUnknown;
    Result &result = m_results[m_index];
    if (result.count == kUnknown || skip < static_cast<int>(sizeof(dContactGeom))) return kUnknown;
    const Worker &worker = m_workers[result.worker];
    const States states = result.states == kNoIndex ? States{0, 0} : worker.states[result.states];
    if (states.first != stateOf(*o1, m_pair->slots[0]) || states.second != stateOf(*o2, m_pair->slots[1]) ||
        dxColliderOverrides::has(o1->type, o2->type))
        return kUnknown;
    dxPerturb(dxSchedulePoint::AnswerCollide);
    m_used += !result.isUsed;
    result.isUsed = true;
    const dContactGeom *const found = worker.contacts.data() + result.first;
    for (int i = 0; i < result.count; ++i) copyWritten(found[i], *CONTACT(contacts, i * skip));
    return result.count;
}
