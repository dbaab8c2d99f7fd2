// Whether a space is walked as upstream does, because most of its geoms move: nothing that a walk does not need is brought up to date
// then, ranks least of all.
//
// One thread at a time begins, moves geoms and ends; several threads may ask in queries (dSpaceCollide2), of which one ends the walks when they
// have asked often enough to pay for the ranks.
#pragma once

#include <algorithm>
#include <atomic>
#include <climits>
#include <mutex>
#include <utility>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "core/dxPublished.h"

class dxWalking {
public:
    operator bool() const { return m_isOn; }
    void set(bool isOn) {
        if (!isOn) m_restedCalls = 0;
        m_isOn = isOn;
    }

    // So many of `all` geoms have been cleaned.
    void noteMoved(int geoms, int all) {
        m_moved = std::min(m_moved + geoms, all);
        if (geoms != 0) m_queries.store(0, std::memory_order_relaxed);
    }
    // Requires a call of each dSpaceCollide, before geoms are cleaned.
    void noteCollided() { m_isCollided = true; }
    // Requires a call of each cleaning. Returns whether it is one for a query of a space that has not been collided since the last one, of which that
    // many move that a list walk answers it the fastest.
    bool isForQuery(int moved, int all) {
        return !std::exchange(m_isCollided, false) && 4 * moved >= dxBroadphaseThresholds::kMovedOfFourQueried * all;
    }

    // Returns how many were since takeMoved() was last called, each counted as often as it was, at most all.
    int takeMoved() { return std::exchange(m_moved, 0); }
    // Requires a call of each dSpaceCollide, with the number of geoms that have moved since the last one. Returns whether walks are to end: few
    // have moved for some calls, which a program that collides a space twice a frame does not come to. `minMoved`: dxMinMovedToWalk().
    bool hasRested(int moved, int minMoved) {
        m_restedCalls = dxHaveFewMoved(moved, minMoved) ? m_restedCalls + 1 : 0;
        return minMoved == INT_MAX || m_restedCalls >= dxBroadphaseThresholds::kMinCallsRested;
    }

    // A query of a space that is walked: calls stop(), which has to end the walks, if there have been many since a geom moved. The other
    // threads walk once more meanwhile.
    template <class Stop>
    void query(Stop stop) {
        if (++m_queries <= dxBroadphaseThresholds::kMaxWalksUnranked) return;
        const std::unique_lock<std::mutex> alone(m_stopping, std::try_to_lock);
        if (alone && m_isOn) stop();
    }

private:
    std::atomic<int> m_queries{0};
    int m_moved = 0, m_restedCalls = 0;
    bool m_isCollided = false;
    dxPublished<bool> m_isOn{false};
    std::mutex m_stopping;  // only try_lock is used
};
