// The heuristics of one (world, space) pair, by name.
//
// tick() is called once at the end of every frame and ticks the heuristics in the order in which they were
// added, so that callbacks come in the same order in every run. Heuristics may be added and removed inside
// callbacks: one that was added is ticked from the next frame on; one that was removed is out of reach at
// once, is not ticked any more, and is destroyed when the tick is over.
//
// Unlike the thesis's manager (figure A.5) this one knows no heuristic, world or cluster: what is observed
// and who acts upon it is the frame's business. There is no global state; several pairs have several
// managers.
//
// Threading: none, owned and used by the thread that runs the pair's frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "heuristics/dxHeuristicBase.h"

class dxHeuristicsManager {
public:
    dxHeuristicsManager() = default;
    dxHeuristicsManager(const dxHeuristicsManager &) = delete;
    dxHeuristicsManager &operator=(const dxHeuristicsManager &) = delete;

    // The heuristic, or null (and it is destroyed) if there is none or its name is taken or empty.
    template <class Heuristic>
    Heuristic *add(const std::string &name, std::unique_ptr<Heuristic> heuristic) {
        Heuristic *const typed = heuristic.get();
        return insert(name, std::move(heuristic)) ? typed : nullptr;
    }

    dxHeuristicBase *find(const std::string &name) const;  // null: there is none
    bool remove(const std::string &name);                  // false: there is none
    std::vector<std::string> names() const;                // in order

    bool tick();                                       // false: called from inside a tick, nothing done
    std::uint64_t frames() const { return m_frames; }  // ticks so far

    // Each returns how many heuristics could follow (dxMayFollow).
    unsigned startAll();
    unsigned pauseAll();
    unsigned resetAll();
    unsigned stopAll();

private:
    struct Entry {
        std::string name;
        std::unique_ptr<dxHeuristicBase> heuristic;  // null: removed
    };

    bool insert(const std::string &name, std::unique_ptr<dxHeuristicBase> heuristic);
    void sweep();
    unsigned forAll(bool (dxHeuristicBase::*change)());

    std::vector<Entry> m_entries;
    std::vector<std::unique_ptr<dxHeuristicBase>> m_removed;  // during a tick
    std::uint64_t m_frames = 0;
    bool m_ticking = false;
};
