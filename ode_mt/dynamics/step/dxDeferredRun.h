// Units that workers run out of order, and whose effects become visible in order: the islands of one step (dxDeferredIslands), or the worlds of one
// call (dxStepWorlds). The stages, in this order; WORKERS marks the parallel ones:
//
//   collectFeedback, forSharedFeedback    WORKERS, caller   units that write to one feedback structure: the later one wins
//   reserve                               caller            the random numbers of all units, as one block that is divided among them
//   run                                   WORKERS           each unit in a scope of its own (dxDeferredScope)
//   commit                                caller            reports and moved-notifications, up to a unit that ends it
//
// Invariants: the caller sees what a loop over the units would have shown it. An error interrupts a unit, and so does a message where the user
// has a handler, which may look at the world or never return. The unit has to be run again in order, so units after it need not run at all.
//
// Memory is kept from run to run.
//
// Threading: a worker writes its own record and the units that it runs; the caller writes everything else.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdarg>
#include <cstdint>
#include <string>
#include <vector>

#include "core/dxCacheLine.h"
#include "core/dxNoIndex.h"
#include "dynamics/step/islands/dxIslandSurvey.h"
#include "dynamics/step/random/dxRandom.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxUpstreamScope.h"

struct dxKeptReport {
    unsigned unit;
    dxReport kind;
    int number;
    std::string text;

    void deliver() const;  // calls dMessage, dDebug or dError
};

// The scope in which a worker runs a unit on behalf of the caller: random numbers come from the unit's part of the block, messages are kept,
// moved-notifications are deferred, dDebug and dError end the unit, and so does dMessage where the user has handlers.
class dxDeferredScope final : public dxUpstreamScope {
public:
    dxDeferredScope(unsigned unit, std::uint32_t seed, bool hasUserHandlers, std::vector<dxKeptReport> &reports)
        : m_unit(unit), m_seed(seed), m_hasUserHandlers(hasUserHandlers), m_reports(reports) {}

    std::uint32_t takeBlock(std::uint64_t draws) override;
    bool defersMoved() const override { return true; }
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override;

private:
    unsigned m_unit;
    std::uint32_t m_seed;
    bool m_hasUserHandlers;
    std::vector<dxKeptReport> &m_reports;
};

class dxDeferredRun {
public:
    // Throws std::bad_alloc.
    void begin(unsigned units, unsigned workers, bool hasUserHandlers);

    bool hasUserHandlers() const { return m_hasUserHandlers; }

    // Called by a worker for an island of the unit. Throws std::bad_alloc.
    void collectFeedback(const dxIsland &island, unsigned unit, unsigned worker) { dxCollectFeedback(island, unit, m_workers[worker].feedbacks); }

    // Calls visit(unit) for the first unit of each group that writes to one structure, or to structures that overlap. Throws std::bad_alloc.
    template <class Visit>
    void forSharedFeedback(const Visit &visit);

    // Takes drawsOf(unit) numbers for each of the first `end` units from the process's sequence, as one block, so that no step of another thread
    // draws in between (contract C7).
    template <class Draws>
    void reserve(unsigned end, const Draws &drawsOf);

    std::uint32_t seedOf(unsigned unit) const { return m_units[unit].seed; }  // the random sequence before its first draw
    std::uint32_t randomEnd() const { return m_randomEnd; }                   // the random sequence after the block

    // Calls work() in the unit's scope, on a worker. A unit may have two parts, one after the other; then it draws no random numbers.
    template <class Work>
    void run(unsigned unit, unsigned worker, const Work &work);

    // Called by a worker for a unit that cannot be run out of order.
    void interruptAt(unsigned unit);

    // Returns false if a unit before it was interrupted, so that it would be undone.
    bool isNeeded(unsigned unit) const { return unit <= m_interrupted.load(std::memory_order_relaxed); }

    // Returns the first unit that was interrupted, or the number of units if none was.
    unsigned interrupted() const { return m_interrupted.load(std::memory_order_relaxed); }

    // Delivers reports and calls notifyMoved(unit) for the units before `end`, in their order. Where the user has no handlers, unit `end` may have
    // been interrupted by an error: its reports come last, and the process ends with the error.
    template <class Notify>
    void commit(unsigned end, const Notify &notifyMoved) const;

    // Returns the time of work of all workers. Units: ns.
    void addBusy(unsigned worker, double ns) { m_workers[worker].busyNs += ns; }
    double busyNs() const;

private:
    struct Unit {
        std::uint32_t seed = 0;
        unsigned first = kNoIndex, last = kNoIndex;  // workers of its first and its last part
    };
    struct alignas(kCacheLine) Worker {
        std::vector<dxKeptReport> reports;
        std::vector<dxFeedbackUse> feedbacks;
        double busyNs = 0;
    };

    void sortFeedback();
    void deliverReports(unsigned unit) const;

    std::vector<Unit> m_units;
    std::vector<Worker> m_workers;
    std::vector<dxFeedbackUse> m_feedbacks;
    bool m_hasUserHandlers = false;
    std::uint32_t m_randomEnd = 0;
    std::atomic<unsigned> m_interrupted{0};
};

// Of structures of which each overlaps the one before it, the first unit writes first.
template <class Visit>
void dxDeferredRun::forSharedFeedback(const Visit &visit) {
    sortFeedback();
    const auto isEarlier = [](const dxFeedbackUse &a, const dxFeedbackUse &b) { return a.unit < b.unit; };
    for (auto begin = m_feedbacks.begin(); begin != m_feedbacks.end();) {
        auto end = begin + 1;
        while (end != m_feedbacks.end() && dxOverlap(end[-1], *end)) ++end;
        const auto [first, last] = std::minmax_element(begin, end, isEarlier);
        if (first->unit != last->unit) visit(first->unit);
        begin = end;
    }
}

template <class Draws>
void dxDeferredRun::reserve(unsigned end, const Draws &drawsOf) {
    std::uint64_t draws = 0;
    for (unsigned unit = 0; unit < end; ++unit) draws += drawsOf(unit);
    std::uint32_t seed = dxRandom::takeSharedBlock(draws);
    for (unsigned unit = 0; unit < end; ++unit) {
        m_units[unit].seed = seed;
        seed = dxRandom::jump(seed, drawsOf(unit));
    }
    m_randomEnd = seed;
}

template <class Work>
void dxDeferredRun::run(unsigned unit, unsigned worker, const Work &work) {
    Unit &one = m_units[unit];
    if (one.first == kNoIndex) one.first = worker;
    one.last = worker;
    try {
        const dxDeferredScope scope(unit, one.seed, m_hasUserHandlers, m_workers[worker].reports);
        work();
    } catch (const dxUpstreamInterrupted &) {
        dxPerturb(dxSchedulePoint::InterruptIsland);
        interruptAt(unit);
    }
}

template <class Notify>
void dxDeferredRun::commit(unsigned end, const Notify &notifyMoved) const {
    for (unsigned unit = 0; unit < end; ++unit) {
        deliverReports(unit);
        notifyMoved(unit);
    }
    if (end < m_units.size()) deliverReports(end);
}
