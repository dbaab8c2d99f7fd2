// Narrow-phase prefetch: workers compute the contacts of pairs before their callbacks.
//
// Callbacks run one at a time, in order, on the caller's thread. Before each batch of callbacks, workers call dCollide
// for its pairs; in the callback dCollide then returns these contacts, if it is called for the same pair with the same
// flags, and nothing that colliders read has changed (dxColliderState, dxConvexArrays, dxSilentChanges, dxFloatMode;
// geoms of a locked space cannot be moved, and if an assertion about that fails all contacts are invalid). Otherwise it
// computes the contacts. No worker runs during a callback, because a callback may write to whatever workers read. Pairs
// with a mesh, or with a height field whose samples are the program's, are not prefetched (dxKnowsArrays), unless the
// program has promised not to write to such arrays.
//
// The flags and geoms are predicted from the last call. A pair is prefetched only if dCollide was called for both of
// its geoms in this call or the one before, possibly in other pairs: a program may have reasons not to collide a geom
// (freed points or samples). The points of a convex geom are read only when the program collides it (dxConvexArrays);
// samples of height fields and meshes only where no such data has been destroyed since. If fewer than half of the
// prefetched contacts are used, the rest of the call has no prefetch, and neither have the next calls.
//
// Colliders leave some bytes of dContactGeom unwritten. Workers compute into memory that holds a pattern, and what
// still has the pattern is not copied to the user's contacts.
//
// The object belongs to one space. No contact outlives a call of dSpaceCollide: the user may change mesh vertices and
// convex points between two calls without a notification. A callback may leave the call by a jump, and the program may
// destroy the space: then this object remains, empty, until the thread is known to have left the call.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "collision/narrowphase/dxConvexArrays.h"
#include "collision/narrowphase/dxConcurrentColliders.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "core/dxCacheLine.h"
#include "threading/dxTaskRunner.h"

class dxNarrowphasePrefetch {
public:
    struct Release {
        void operator()(dxNarrowphasePrefetch *prefetch) const { prefetch->leaveSpace(); }
    };
    using Owner = std::unique_ptr<dxNarrowphasePrefetch, Release>;  // the space's

    // Returns the object of the pair whose callback runs on this thread, or NULL. A callback may have left by longjmp,
    // so a call much deeper on the stack may still get the last one.
    static dxNarrowphasePrefetch *current();

    // Makes one current for as long as its frame is on the stack, or until a call elsewhere on the stack makes another
    // one current: where a program switches between stacks of its own (fibers) in callbacks, calls do not end in the
    // reverse order of their beginnings, and the current object need not be that of the ending call. Therefore calls
    // have numbers.
    class Scope {
    public:
        // `arraysStay`: the program promises that no callback writes to the arrays of meshes and height
        // fields. reserveMemory() comes first.
        Scope(dxNarrowphasePrefetch &prefetch, dxTaskRunner &runner, bool arraysStay);
        ~Scope();
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        const std::uint64_t m_number;
        dxNarrowphasePrefetch &m_prefetch;
    };

    // Reserves memory for a call; `slots` is the number of slots of the space's members. Throws std::bad_alloc, as no
    // other function does: without memory contacts are computed in the callbacks.
    void reserveMemory(const dxTaskRunner &runner, std::size_t slots);

    // Requires a call before the callback of each pairs[index], with rising indices.
    void beforePair(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
        m_pair = &pairs[index];
        if (index >= m_end) nextBatch(pairs, index);
        m_index = index - m_begin;
    }

    // Requires a call before the space updates its pairs.
    void forgetPair() { m_pair = nullptr; }
    // Requires a call when another geom gets the slot.
    void forgetGeom(dxMembers::Slot slot) {
        if (slot < m_requested.size()) m_requested[slot] = {};
        m_convex.forget(slot);
    }

    // Returns the number of prefetched contacts for dCollide, or -1 if there are none and upstream has to compute.
    int answer(dGeomID o1, dGeomID o2, int flags, dContactGeom *contacts, int skip);

    // Return, for the last call, the number of pairs computed and how many of them were used.
    std::uint64_t computed() const { return m_computed; }
    std::uint64_t used() const { return m_used; }

private:
    static constexpr int kUnknown = -1;

    // It is small, because one is moved between caches for every pair.
    struct Result {
        std::int32_t count;    // kUnknown
        std::uint32_t first;   // among the worker's contacts
        std::uint32_t states;  // kNoIndex, or a place among the worker's states
        std::uint16_t worker;  // a process has 1024 at most
        bool isUsed;
    };

    // The states of both geoms (stateOf).
    struct States {
        std::uint64_t first, second;
    };

    struct alignas(kCacheLine) Worker {
        std::vector<dContactGeom> contacts;  // of the batch; from `used` on they hold the pattern
        std::size_t used = 0;
        std::vector<States> states;   // of pairs of which one is not 0
        std::uint64_t batch = 0;      // to which the contacts belong
        std::uint64_t computed = 0;   // number of pairs in it
        dxColliderCopies copies;

        void enterBatch(std::uint64_t batch);
        void reserveMemory(std::size_t contacts);
        std::uint32_t keepStates(const States &both);
        void wipe(std::size_t begin, std::size_t end);
        void wipeDrafts();
    };

    void leaveSpace();
    void release();
    static void forgetCurrent();
    void start(dxTaskRunner &runner, bool arraysStay);
    void end();
    void nextBatch(const std::vector<dxOrderedPair> &pairs, std::size_t index);
    bool maySpend() const;
    void computeBatch(const std::vector<dxOrderedPair> &pairs);
    void compute(const dxOrderedPair &pair, Result &result, unsigned worker);
    void noteRequested(const dxOrderedPair &pair);
    bool wasRequested(const dxGeom &geom, dxMembers::Slot slot) const;
    std::uint64_t stateOf(const dxGeom &geom, dxMembers::Slot slot) const;

    static std::uint64_t changesNoticed();

    // Number of holders: the space, and threads that are in a call with it or may have left one by a jump.
    std::atomic<unsigned> m_holders{1};
    dxTaskRunner *m_runner = nullptr;
    bool m_arraysStay = false;
    std::uint64_t m_batchChanges = 0;       // changesNoticed() when the batch was computed
    std::uint32_t m_batchMode = 0;          // of floating point, then
    const dxOrderedPair *m_pair = nullptr;  // whose callback runs
    std::size_t m_begin = 0, m_end = 0;     // the batch
    std::size_t m_index = 0;                // of the pair in the batch
    std::vector<Result> m_results;          // the first ones are those of the batch
    bool m_hasResults = false;
    std::uint64_t m_batch = 0;  // its number
    std::vector<Worker> m_workers;
    std::uint64_t m_call = 1;               // its number
    // The last collision of a geom.
    struct Requested {
        std::uint64_t call = 0;     // 0: never
        std::uint64_t changes = 0;  // dxSilentChanges.count() then
    };
    std::vector<Requested> m_requested;             // by slot
    dxConvexArrays m_convex;                // of the geoms that were collided
    int m_flags = 0;  // of the last dCollide; 0: none yet
    int m_batchFlags = 0;
    std::uint64_t m_computed = 0, m_used = 0;  // in this call
    // Counters of the calls since it was last decided whether the prefetch pays.
    std::uint64_t m_computedSinceJudged = 0, m_usedSinceJudged = 0;
    unsigned m_callsWithout = 0;  // to come
    unsigned m_nextPause = 0;
};
