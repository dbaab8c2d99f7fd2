#include "settings/dxWorldStatistics.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <memory>
#include <new>

#include "core/dxLog.h"
#include "settings/dxSerialReason.h"
#include "settings/dxStatisticsFile.h"
#include "settings/dxWorldState.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"
#include "threading/timeline/dxTimelineClock.h"

namespace dxWorldStatistics {

namespace {

// Why each part of a frame ran on one thread: of the collision, its near-callbacks, and the step.
using Reasons = std::array<int, 3>;

// What ODE_MT_LOG=info has reported of a world. A change is reported when it has lasted for kLasting frames: the cost model tries several threads
// now and then, for some frames.
class Announcement {
public:
    // Returns whether to report these now.
    bool isDue(const Reasons &reasons) {
        if (reasons != m_reasons) m_frames = 0;
        m_reasons = reasons;
        if (++m_frames < kLasting && m_isSaid) return false;
        if (m_isSaid && reasons == m_said) return false;
        m_said = reasons;
        return m_isSaid = true;
    }

private:
    static constexpr unsigned kLasting = 60;

    Reasons m_reasons{}, m_said{};
    bool m_isSaid = false;
    unsigned m_frames = 0;  // with the same reasons, the last ones
};

struct Entry final : dxWorldPart {
    ~Entry() override;

    dODE_MT_WorldStatistics last{};  // frame
    std::uint64_t lastStepEnd = 0;   // ticks
    dxCollisionRecord collision{};   // sums of those since; the last one's reasons
    unsigned collisions = 0, parallelCollisions = 0;
    Announcement announcement;
    dxStatisticsSlot *slot = nullptr;
    unsigned generation = 0;  // of the process that has the slot; 0: none yet
};

// In the child of a fork each world gets a slot of the child's own.
class Keeper final : private dxForkListener {
public:
    Keeper() { listenToForks(); }

    // Under the lock of the states:
    dxStatisticsSharing sharing;
    unsigned worlds = 0;

    double secondsOf(std::uint64_t ticks) const { return 1e-9 * m_scale.nsOf(ticks); }
    void measure() { m_scale.measure(); }
    unsigned generation() const { return m_generation.load(std::memory_order_relaxed); }

    void atUnload() {
        forgetSlots();
        dxWorldState::forAll([](dxWorldState &state) { state.frames.reset(); });
        const std::lock_guard<dxForkSafeMutex> hold(dxWorldState::lock());
        sharing.close();
    }

private:
    void inForkedChild() override { forgetSlots(); }

    // Called when slots no longer belong to this process, or are no longer in memory.
    void forgetSlots() { m_generation.fetch_add(1, std::memory_order_relaxed); }

    dxTimelineScale m_scale;
    std::atomic<unsigned> m_generation{1};
};

dxProcessObject<Keeper> keeper;

Entry::~Entry() {
    if (generation == keeper->generation()) dxStatisticsSharing::giveBack(slot);
}

void setTimes(dODE_MT_WorldStatistics &frame, const Entry &entry, const dxStepRecord &step) {
    const dxFrameTimes &ofCollisions = entry.collision.times;
    const auto seconds = [](std::uint64_t ticks) { return keeper->secondsOf(ticks); };
    frame.frameTime = entry.lastStepEnd != 0 ? seconds(step.end - entry.lastStepEnd) : 0;
    frame.collisionTime = seconds(entry.collision.ticks);
    frame.broadPhaseTime = seconds(ofCollisions[dxFrameStage::BroadPhase]);
    frame.callbackTime = seconds(ofCollisions[dxFrameStage::NearCallbacks]);
    frame.prefetchTime = seconds(ofCollisions[dxFrameStage::NarrowphasePrefetch]);
    frame.stepTime = seconds(step.end - step.begin);
    frame.islandSearchTime = seconds(step.times[dxFrameStage::IslandSearch]);
    frame.islandPreparationTime = seconds(step.times[dxFrameStage::IslandPreparation]);
    frame.islandsTime = seconds(step.times[dxFrameStage::Islands]);
    frame.commitTime = seconds(step.times[dxFrameStage::Commit]);
    frame.waitTime = seconds(ofCollisions[dxFrameStage::Wait] + step.times[dxFrameStage::Wait]);
    frame.sharedTime = seconds(ofCollisions[dxFrameStage::Shared] + step.times[dxFrameStage::Shared]);
    frame.workTime = seconds(ofCollisions[dxFrameStage::Work] + step.times[dxFrameStage::Work]);
    const double alone = std::max(frame.collisionTime + frame.stepTime - frame.sharedTime, 0.0);
    frame.serialShare = frame.workTime > 0 ? alone / (alone + frame.workTime) : 1;
}

void setCounts(dODE_MT_WorldStatistics &frame, const Entry &entry, const dxStepRecord &step) {
    const dxCollisionRecord &collision = entry.collision;
    frame.threads = step.threadsInForce;
    frame.bodies = step.bodies;
    frame.contacts = step.contacts;
    frame.islands = step.islands;
    frame.rows = step.rows;
    frame.collisions = entry.collisions;
    frame.pairs = collision.pairs;
    frame.contactsAhead = collision.contactsAhead;
    frame.contactsAheadUnused = collision.contactsAhead - collision.contactsAheadUsed;
    frame.hitRate = collision.contactsAhead != 0
                        ? static_cast<double>(collision.contactsAheadUsed) / static_cast<double>(collision.contactsAhead)
                        : 0;
    frame.stepThreads = step.threads;
    frame.stepReason = step.reason;
    frame.remoteWorkers = step.remote.workers;
    frame.remoteWorkersLost = step.remote.lostWorkers;
    frame.remoteIslands = step.remote.solved;
    frame.returnedIslands = step.remote.returned;
    frame.collisionThreads = entry.collisions != 0 ? collision.threads : 0;
    frame.collisionReason = entry.collisions != 0 ? collision.reason : dODE_MT_REASON_NOTHING;
    frame.callbackReason = entry.collisions != 0 ? collision.callbackReason : dODE_MT_REASON_NOTHING;
}

void addToSums(dODE_MT_WorldStatistics &frame, const Entry &entry) {
    ++frame.frames;
    frame.parallelSteps += frame.stepThreads > 1;
    frame.parallelCollisions += entry.parallelCollisions;
    frame.allCollisions += entry.collisions;
    frame.allFrameTime += frame.frameTime;
    frame.allCollisionTime += frame.collisionTime;
    frame.allStepTime += frame.stepTime;
    frame.allRemoteIslands += frame.remoteIslands;
    frame.allReturnedIslands += frame.returnedIslands;
}

void setNumber(dODE_MT_WorldStatistics &frame) {
    if (frame.number == 0) frame.number = ++keeper->worlds;
}

void finishFrame(Entry &entry, const dxStepRecord &step) {
    dODE_MT_WorldStatistics &frame = entry.last;
    keeper->measure();
    setTimes(frame, entry, step);
    setCounts(frame, entry, step);
    addToSums(frame, entry);
    setNumber(frame);
    frame.size = sizeof frame;
    entry.lastStepEnd = step.end;
    entry.collision = {};
    entry.collisions = entry.parallelCollisions = 0;
}

void share(Entry &entry) {
    if (entry.generation != keeper->generation()) {
        entry.slot = keeper->sharing.claim();
        entry.generation = keeper->generation();
    }
    if (entry.slot != nullptr) entry.slot->write(entry.last);
}

// "the step on several threads", "the step on one thread, as REASON".
void describe(char (&text)[160], const char *what, int reason) {
    if (reason == dODE_MT_REASON_PARALLEL)
        std::snprintf(text, sizeof text, "%s on several threads", what);
    else
        std::snprintf(text, sizeof text, "%s on one thread, as %s", what, dxTextOfReason(reason));
}

void announce(const dODE_MT_WorldStatistics &frame) {
    char collision[160] = "no collision", callbacks[160] = "", step[160];
    if (frame.collisions != 0) {
        const bool isOneReason = frame.collisionReason == frame.callbackReason;
        describe(collision, isOneReason ? "pairs and near-callbacks" : "pairs", frame.collisionReason);
        if (!isOneReason) describe(callbacks, "; near-callbacks", frame.callbackReason);
    }
    describe(step, "step", frame.stepReason);
    dxLog(dxLogLevel::Info, "world %u, frame %llu: %u bodies, %llu pairs, %u islands, %llu rows, %u threads at most; %s%s; %s", frame.number,
          frame.frames, frame.bodies, frame.pairs, frame.islands, frame.rows, std::max(frame.threads, 1u), collision, callbacks, step);
}

Entry *entryOf(const dxWorldState &state) { return static_cast<Entry *>(state.frames.get()); }

template <class Change>
void change(const dxWorld *world, const Change &change) try {
    keeper->generation();  // it is made before a lock is held
    dxWorldState &state = dxWorldState::of(world);
    const std::lock_guard<dxForkSafeMutex> hold(dxWorldState::lock());
    if (state.frames == nullptr) state.frames = std::make_unique<Entry>();
    change(*entryOf(state));
} catch (const std::bad_alloc &) {  // not counted
}

}  // namespace

void add(const dxWorld *world, const dxCollisionRecord &collision) {
    change(world, [&collision](Entry &entry) {
        dxCollisionRecord &sum = entry.collision;
        sum.ticks += collision.ticks;
        sum.times += collision.times;
        sum.pairs += collision.pairs;
        sum.contactsAhead += collision.contactsAhead;
        sum.contactsAheadUsed += collision.contactsAheadUsed;
        sum.threads = std::max(sum.threads, collision.threads);
        sum.reason = collision.reason;
        sum.callbackReason = collision.callbackReason;
        ++entry.collisions;
        entry.parallelCollisions += collision.threads > 1;
    });
}

// The log is written without the lock.
void add(const dxWorld *world, const dxStepRecord &step) {
    dODE_MT_WorldStatistics said{};
    const char *complaint = "";
    const bool isTold = dxGetLogLevel() >= dxLogLevel::Info;
    change(world, [&](Entry &entry) {
        finishFrame(entry, step);
        share(entry);
        complaint = keeper->sharing.takeComplaint();
        const dODE_MT_WorldStatistics &frame = entry.last;
        if (isTold && entry.announcement.isDue({frame.collisionReason, frame.callbackReason, frame.stepReason})) said = frame;
    });
    if (*complaint != '\0') dxLog(dxLogLevel::Warning, "%s", complaint);
    if (said.number != 0) announce(said);
}

void enrol(const dxWorld *world) {
    change(world, [](Entry &entry) { setNumber(entry.last); });
}

bool read(const dxWorld *world, dODE_MT_WorldStatistics &statistics) {
    const dxWorldState *const state = dxWorldState::find(world);
    if (state == nullptr) return false;
    const std::lock_guard<dxForkSafeMutex> hold(dxWorldState::lock());
    const Entry *const entry = entryOf(*state);
    if (entry == nullptr || entry->last.frames == 0) return false;
    statistics = entry->last;
    return true;
}

}  // namespace dxWorldStatistics
