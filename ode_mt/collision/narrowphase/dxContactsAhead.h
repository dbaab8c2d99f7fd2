// Contacts of pairs whose callbacks are still to come, computed by workers.
//
// Callbacks run one at a time, in order, on the caller's thread. Before a window of them, workers call
// dCollide for its pairs; in the callback dCollide then hands out what is there, if it is asked for the same
// pair with the same flags, and nothing that colliders read has changed (dxColliderState, dxConvexArrays, dxSilentChanges,
// dxFloatMode; geoms of a locked space cannot be moved, and where an assertion about that fails all contacts are void).
// Else it computes anew. While a callback runs no worker does: it may write to whatever workers read. Pairs
// with a mesh, or with a height field whose samples are the program's, are not computed ahead
// (dxKnowsArrays), unless the program has promised to leave such arrays alone.
//
// What the callback will ask for is learned from the last call: with which flags, and for which geoms. A pair is
// computed ahead only if dCollide was called for both of its geoms in this call or the one before, be it in other
// pairs: a program may have reasons never to collide a geom, or not any more (points or samples that are gone). The points
// of a convex geom are read only when the program collides it (dxConvexArrays); samples of height fields and meshes only where
// no such data has been destroyed since.
// If less than half of what was computed is asked for, the rest of the call goes without, and so do the next calls.
//
// Colliders leave some bytes of dContactGeom as they are. Workers compute into memory that holds a pattern,
// and what still shows the pattern is not copied to the user's contacts.
//
// Belongs to one space, like its pairs. No contact outlives a call of dSpaceCollide: the user may change mesh
// vertices and convex points between two without telling. A callback may leave that call by a jump, and the
// program destroy the space: then this stays, empty, until the thread has been seen to be elsewhere.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "collision/narrowphase/dxConvexArrays.h"
#include "collision/narrowphase/dxSharedColliders.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxOrderedPair.h"
#include "core/dxNoIndex.h"
#include "threading/dxStackFrame.h"
#include "threading/dxTaskRunner.h"

class dxContactsAhead {
public:
    struct Release {
        void operator()(dxContactsAhead *ahead) const { ahead->leaveSpace(); }
    };
    using Owner = std::unique_ptr<dxContactsAhead, Release>;  // the space's

    // That of the pair whose callback this thread is in, or NULL. A callback may have left by longjmp, so
    // that a call made much deeper on the stack may still be told the last one.
    static dxContactsAhead *current();

    // Makes one current for as long as its frame is on the stack, or until a call elsewhere on the stack makes another one
    // current: where a program switches between stacks of its own (fibers) in callbacks, calls do not end in the reverse order
    // of their beginnings, and what is current does not belong to whoever ends. Calls are known by their numbers therefore.
    class Scope {
    public:
        // `arraysStay`: the program promises that no callback writes to the arrays of meshes and height
        // fields. makeRoom() comes first.
        Scope(dxContactsAhead &ahead, dxTaskRunner &runner, bool arraysStay);
        ~Scope();
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        const std::uint64_t m_number;
        dxContactsAhead &m_ahead;
    };

    // Memory for a call; `slots`: of the space's members. Throws std::bad_alloc; nothing else here does:
    // contacts for which there is none are left to the callbacks.
    void makeRoom(const dxTaskRunner &runner, std::size_t slots);

    // To be called before the callback of pairs[index], with rising indices.
    void beforePair(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
        m_pair = &pairs[index];
        if (index >= m_end) nextWindow(pairs, index);
        m_index = index - m_begin;
    }

    // The space is about to look for its pairs again.
    void forgetPair() { m_pair = nullptr; }
    // Another geom has the slot.
    void forgetGeom(dxMembers::Slot slot) {
        if (slot < m_asked.size()) m_asked[slot] = {};
        m_convex.forget(slot);
    }

    // dCollide asks. -1: nothing is known, upstream has to compute.
    int answer(dGeomID o1, dGeomID o2, int flags, dContactGeom *contacts, int skip);

    // Of the last call: pairs computed, and how many of them were asked for.
    std::uint64_t computed() const { return m_computed; }
    std::uint64_t used() const { return m_used; }

private:
    static constexpr int kUnknown = -1;

    // Small, because it goes from one core to another for every pair.
    struct Result {
        std::int32_t count;    // kUnknown
        std::uint32_t first;   // among the worker's contacts
        std::uint32_t states;  // kNoIndex, or a place among the worker's states
        std::uint16_t worker;  // a process has 1024 at most
        bool isUsed;
    };

    // Of both geoms (stateOf).
    struct States {
        std::uint64_t first, second;
    };

    struct alignas(64) Worker {
        std::vector<dContactGeom> contacts;  // of the window; from `used` on they hold the pattern
        std::size_t used = 0;
        std::vector<States> states;  // of pairs of which one is not 0
        std::uint64_t window = 0;    // whose contacts they are
        std::uint64_t computed = 0;  // pairs in it
        dxColliderCopies copies;

        void enterWindow(std::uint64_t window);
        void makeRoom(std::size_t contacts);
        std::uint32_t keepStates(const States &both);
        void wipe(std::size_t begin, std::size_t end);
        void wipeDrafts();
    };

    void leaveSpace();
    void release();
    static void forgetCurrent();
    void start(dxTaskRunner &runner, bool arraysStay);
    void end();
    void nextWindow(const std::vector<dxOrderedPair> &pairs, std::size_t index);
    bool maySpend() const;
    void computeWindow(const std::vector<dxOrderedPair> &pairs);
    void compute(const dxOrderedPair &pair, Result &result, unsigned worker);
    void noteAsked(const dxOrderedPair &pair);
    bool wasAsked(const dxGeom &geom, dxMembers::Slot slot) const;
    std::uint64_t stateOf(const dxGeom &geom, dxMembers::Slot slot) const;

    static std::uint64_t changesNoticed();

    // The space, and threads in a call with it, or that may have left one by a jump.
    std::atomic<unsigned> m_holders{1};
    dxTaskRunner *m_runner = nullptr;
    bool m_arraysStay = false;
    std::uint64_t m_windowChanges = 0;      // changesNoticed() when the window was computed
    std::uint32_t m_windowMode = 0;         // of floating point, then
    const dxOrderedPair *m_pair = nullptr;  // whose callback runs
    std::size_t m_begin = 0, m_end = 0;     // the window
    std::size_t m_index = 0;                // of the pair in the window
    std::vector<Result> m_results;          // the first ones are those of the window
    bool m_hasResults = false;
    std::uint64_t m_window = 0;  // its number
    std::vector<Worker> m_workers;
    std::uint64_t m_call = 1;               // its number
    // When a geom was collided last.
    struct Asked {
        std::uint64_t call = 0;     // 0: never
        std::uint64_t changes = 0;  // dxSilentChanges::count() then
    };
    std::vector<Asked> m_asked;             // by slot
    dxConvexArrays m_convex;                // of the geoms that were collided
    int m_flags = 0;  // of the last dCollide; 0: none yet
    int m_windowFlags = 0;
    std::uint64_t m_computed = 0, m_used = 0;  // in this call
    // In the calls since it was last told whether it pays.
    std::uint64_t m_computedUntold = 0, m_usedUntold = 0;
    unsigned m_callsWithout = 0;  // to come
    unsigned m_nextPause = 0;
};
